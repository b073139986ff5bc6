// The solvers that body_beam has a unit for each number of modes of, so that they compile side by side:
// solve_1_mode.cpp, solve_2_mode.cpp.
#pragma once

#include <equilibria/studies/rotating_body_beam/body_beam_solver.hpp>

inline constexpr int most_solved_modes = 2;

extern template class equilibria::mechanisms::BodyBeamSolver<1, equilibria::mechanisms::BeamControl::speed>;
extern template class equilibria::mechanisms::BodyBeamSolver<1, equilibria::mechanisms::BeamControl::momentum>;
extern template class equilibria::mechanisms::BodyBeamSolver<2, equilibria::mechanisms::BeamControl::speed>;
extern template class equilibria::mechanisms::BodyBeamSolver<2, equilibria::mechanisms::BeamControl::momentum>;
