#include <equilibria/studies/rotating_body_beam/body_beam_solver.hpp>

template class equilibria::mechanisms::BodyBeamSolver<1, equilibria::mechanisms::BeamControl::speed>;
template class equilibria::mechanisms::BodyBeamSolver<1, equilibria::mechanisms::BeamControl::momentum>;
