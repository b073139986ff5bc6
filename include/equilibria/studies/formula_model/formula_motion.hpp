/// \file
/// The motion of models that are data (formula/formula_model.hpp), and how stable their equilibria are: compiled once,
/// as formula_searches.hpp is. The model must have kinetics: a kinetic energy, and what else it has of
/// model/kinetics.hpp.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/compiled.hpp>
#include <equilibria/dynamics/motion.hpp>
#include <equilibria/formula/formula_model.hpp>
#include <equilibria/model/kinetic_functions.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/stability/pole_count.hpp>

namespace equilibria {

/// Which equations of motion are integrated; the motion is the same.
enum class FormulaFormulation {
    lagrange,  ///< LagrangeSecondKind, covariant
    hamilton,  ///< HamiltonEquations
};

/// Its functions of real numbers, for the formulations of dynamics/ with RuntimeUnknowns. Throws InvalidArgument where
/// the model does not move.
std::shared_ptr<const KineticFunctions> kinetic_functions(const FormulaModel& model);

/// The motion from `start` at the time 0, at `times`, none below 0, none below the one before it. run: progress, in
/// points of all, and cancel. Throws InvalidArgument as the function of the same name for formulations does, and where
/// the model does not move; all else that may happen is a status.
Motion<RuntimeUnknowns> integrate_motion(const FormulaModel& model, const RuntimeArray<double>& p,
                                         const MotionState<RuntimeUnknowns>& start, const std::vector<double>& times,
                                         const MotionOptions& options = {}, const RunOptions& run = {},
                                         FormulaFormulation formulation = FormulaFormulation::lagrange);

/// The poles of the motion about an equilibrium q, linearised at time 0. Throws InvalidArgument where the model does
/// not move, and where its mass matrix is not positive definite there.
PoleCount<Eigen::MatrixXd> count_poles(const FormulaModel& model, const RuntimeArray<double>& q,
                                       const RuntimeArray<double>& p);

/// The same where q is a place of rest, as an equilibrium of the potential is as long as the other forces vanish there;
/// nothing where they do not, at one of a few times, nor where the mass matrix is not positive definite.
std::optional<PoleCount<Eigen::MatrixXd>> count_poles_at_rest(const FormulaModel& model, const RuntimeArray<double>& q,
                                                              const RuntimeArray<double>& p);

/// The kinetic energy at unknowns and rates.
double kinetic_energy_of(const FormulaModel& model, const RuntimeArray<double>& q, const RuntimeArray<double>& v,
                         const RuntimeArray<double>& p);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/studies/formula_model/detail/formula_motion_definitions.hpp>
#endif
