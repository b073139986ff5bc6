#include "body_beam/solve_definition.hpp"

template class BodyBeamSolver<2, equilibria::mechanisms::BeamControl::speed>;
template class BodyBeamSolver<2, equilibria::mechanisms::BeamControl::momentum>;
