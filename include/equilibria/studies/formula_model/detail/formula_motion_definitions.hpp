/// \file
/// See studies/formula_model/formula_motion.hpp.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Cholesky>

#include <equilibria/core/error.hpp>
#include <equilibria/dynamics/hamilton.hpp>
#include <equilibria/dynamics/lagrange_second_kind.hpp>
#include <equilibria/model/runtime_kinetics.hpp>
#include <equilibria/stability/linearise.hpp>
#include <equilibria/studies/formula_model/formula_motion.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::shared_ptr<const KineticFunctions> kinetic_functions(const FormulaModel& model) {
    require(model.kinetics != nullptr, "model", "without a kinetic energy", "must have one: it does not move");
    return kinetic_functions(FormulaDynamics(model));
}

EQUILIBRIA_INLINE Motion<RuntimeUnknowns> integrate_motion(const FormulaModel& model, const RuntimeArray<double>& p,
                                                           const MotionState<RuntimeUnknowns>& start,
                                                           const std::vector<double>& times,
                                                           const MotionOptions& options, const RunOptions& run,
                                                           FormulaFormulation formulation) {
    const auto functions = kinetic_functions(model);
    if (formulation == FormulaFormulation::hamilton)
        return integrate_motion(HamiltonEquations<RuntimeUnknowns>(functions, p), start, times, options, 0, run);
    return integrate_motion(LagrangeSecondKind<RuntimeUnknowns>(functions, p), start, times, options, 0, run);
}

EQUILIBRIA_INLINE PoleCount<Eigen::MatrixXd> count_poles(const FormulaModel& model, const RuntimeArray<double>& q,
                                                         const RuntimeArray<double>& p) {
    return count_poles(linearise(*kinetic_functions(model), q, p));
}

EQUILIBRIA_INLINE std::optional<PoleCount<Eigen::MatrixXd>> count_poles_at_rest(const FormulaModel& model,
                                                                                const RuntimeArray<double>& q,
                                                                                const RuntimeArray<double>& p) {
    const auto functions = kinetic_functions(model);
    const auto system = linearise(*functions, q, p);
    const RuntimeArray<double> rest(functions->unknowns());
    const double rounding = 1e-12 * functions->hessian(q, p).cwiseAbs().maxCoeff();
    for (const double t : {0., 0.7345, 12.34, 345.6})
        if (!(functions->generalised_forces(t, q, rest, p).cwiseAbs().maxCoeff() <= rounding)) return {};
    if (!system.mass.allFinite() || !system.damping.allFinite() ||
        Eigen::LLT<Eigen::MatrixXd>(system.mass).info() != Eigen::Success)
        return {};
    return count_poles(system);
}

EQUILIBRIA_INLINE double kinetic_energy_of(const FormulaModel& model, const RuntimeArray<double>& q,
                                           const RuntimeArray<double>& v, const RuntimeArray<double>& p) {
    const auto functions = kinetic_functions(model);
    const std::string one_each = "must be one for each unknown: " + std::to_string(functions->unknowns());
    require(q.size() == functions->unknowns(), "number of entries of q", q.size(), one_each);
    require(v.size() == functions->unknowns(), "number of entries of v", v.size(), one_each);
    require(p.size() == functions->parameters(), "parameters", p.size(),
            "must be as many as the model's: " + std::to_string(functions->parameters()));
    return functions->kinetic_energy(q, v, p);
}

}  // namespace equilibria
