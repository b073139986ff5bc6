/// \file
/// See formula/formula_model.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/local_array.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/formula/formula_model.hpp>

namespace equilibria {

EQUILIBRIA_INLINE int number_of_name(const std::vector<std::string>& names, const std::string& name,
                                     const std::string& argument) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    std::string allowed = names.empty() ? "must be a name, of which there are none" : "must be ";
    for (std::size_t k = 0; k < names.size(); ++k)
        allowed += (k == 0 ? "" : k + 1 == names.size() ? " or " : ", ") + names[k];
    throw InvalidArgument(argument, name, allowed);
}

namespace detail {

/// Throws InvalidArgument where one of these is no identifier, is used twice or is that of a function.
inline void require_names(const std::vector<std::vector<std::string>>& lists) {
    std::vector<std::string> known = FormulaBuilder::functions();
    known.push_back("pi");
    const auto is_identifier = [](const std::string& name) {
        const auto letter = [](char c) { return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
        return !name.empty() && letter(name[0]) &&
               std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
    };
    for (const auto& names : lists)
        for (const std::string& name : names) {
            require(is_identifier(name), "name", name, "must be letters, digits and _, a letter first");
            require(std::find(known.begin(), known.end(), name) == known.end(), "name", name,
                    "must not be used twice, nor be sin, cos, tan, sqrt, exp, log or pi");
            known.push_back(name);
        }
}

/// Throws InvalidArgument where the parallelogram law of a quadratic form, f(u + w) + f(u - w) = 2 f(u) + 2 f(w), does
/// not hold of the kinetic energy at one of a few random places, nor its homogeneity, f(2 u) = 4 f(u). Places where it
/// is not finite are left to the motion.
inline void require_quadratic_form(const FormulaModel& model) {
    const FormulaDynamics dynamics(model);
    const int n = model.unknowns(), angles = static_cast<int>(model.angles.size());
    Generator random(1);
    for (int place = 0; place < 3; ++place) {
        LocalArray<double> theta(angles), x(n - angles), u(n), w(n);
        for (auto* numbers : {&theta, &x, &u, &w})
            for (double& number : *numbers) number = uniform(random, 0.2, 1.2);
        const auto energy = [&](double of_u, double of_w) {
            LocalArray<double> v(n);
            for (int i = 0; i < n; ++i) v[i] = of_u * u[i] + of_w * w[i];
            return dynamics.kinetic_energy(theta, x, v, model.values);
        };
        const double fu = energy(1, 0), fw = energy(0, 1), sum = energy(1, 1), difference = energy(1, -1),
                     twice = energy(2, 0);
        const double size = std::abs(fu) + std::abs(fw) + std::abs(sum) + std::abs(difference) + std::abs(twice);
        if (!std::isfinite(size)) continue;
        require(
            std::abs(sum + difference - 2 * fu - 2 * fw) <= 1e-9 * size && std::abs(twice - 4 * fu) <= 1e-9 * size,
            "kinetic_energy", "no quadratic form",
            "must be a quadratic form in the rates: a sum of products of two rates each, times anything without rates");
    }
}

/// The steps that a function of these formulas takes; none where there are none.
inline FormulaFunction function_of(const FormulaBuilder& builder, const std::vector<Formula>& formulas) {
    FormulaFunction y;
    if (formulas.empty()) return y;
    for (const Formula& formula : formulas) {
        require_number_like(formula, "a whole formula that is an angle");
        y.results.push_back(formula.step);
    }
    y.steps = std::make_shared<const FormulaSteps>(builder.steps().reached(y.results));
    return y;
}

}  // namespace detail

EQUILIBRIA_INLINE FormulaModel formula_model(FormulaModel named, const FormulaBuilder& builder,
                                             const std::vector<Formula>& formulas) {
    detail::require_names({named.angles, named.coordinates, named.parameters});
    require(named.unknowns() > 0, "model", "no unknowns", "needs at least one unknown angle or coordinate");
    require(named.values.size() == static_cast<int>(named.parameters.size()), "number of values", named.values.size(),
            "must be as many as parameters: " + std::to_string(named.parameters.size()));
    for (int k = 0; k < named.values.size(); ++k)
        require(std::isfinite(named.values[k]), named.parameters[static_cast<std::size_t>(k)], named.values[k],
                "must be finite");
    const std::size_t needed = named.has_potential ? 1 : static_cast<std::size_t>(named.unknowns());
    require(formulas.size() == needed, named.has_potential ? "number of potentials" : "number of equations",
            formulas.size(),
            named.has_potential ? "must be 1" : "must be one for each unknown: " + std::to_string(needed));
    named.results.clear();
    for (const Formula& formula : formulas) {
        detail::require_number_like(formula, "a whole formula that is an angle");
        if (formula.kind == FormulaKind::motion)
            detail::refuse_formula("a formula of a motion", "must not be a potential or an equation");
        named.results.push_back(formula.step);
    }
    named.steps = std::make_shared<const FormulaSteps>(builder.has_motion() ? builder.steps().reached(named.results)
                                                                            : builder.steps());
    named.kinetics = nullptr;
    return named;
}

EQUILIBRIA_INLINE FormulaModel with_kinetics(FormulaModel model, const FormulaBuilder& builder,
                                             const KineticFormulas& formulas) {
    require(model.has_potential, "kinetic_energy", "beside equations",
            "must stand beside a potential: a model of equations has no potential energy");
    const auto n = static_cast<std::size_t>(model.unknowns());
    const std::string one_each = "must be one for each unknown: " + std::to_string(n);
    require(formulas.rates.size() == n, "number of rates", formulas.rates.size(), one_each);
    std::vector<std::vector<std::string>> names{model.angles, model.coordinates, model.parameters, formulas.rates};
    if (!formulas.time.empty()) names.push_back({formulas.time});
    detail::require_names(names);
    const std::size_t forces = formulas.generalised_forces.size();
    require(forces == 0 || forces == n, "number of generalised_forces", forces, one_each);
    auto kinetics = std::make_shared<FormulaKinetics>();
    kinetics->rates = formulas.rates;
    kinetics->time = formulas.time;
    kinetics->kinetic_energy = detail::function_of(builder, {formulas.kinetic_energy});
    if (formulas.dissipation) kinetics->dissipation = detail::function_of(builder, {*formulas.dissipation});
    kinetics->generalised_forces = detail::function_of(builder, formulas.generalised_forces);
    for (const FormulaFunction* f : {&kinetics->kinetic_energy, &kinetics->dissipation})
        require(!*f || !f->steps->depends_on(f->results[0], FormulaOperation::time),
                f == &kinetics->dissipation ? "dissipation" : "kinetic_energy", "a formula of the time",
                "must not depend on the time, which generalised_forces alone may");
    model.kinetics = std::move(kinetics);
    detail::require_quadratic_form(model);
    return model;
}

}  // namespace equilibria
