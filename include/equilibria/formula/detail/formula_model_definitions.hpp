/// \file
/// See formula/formula_model.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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

EQUILIBRIA_INLINE FormulaModel formula_model(FormulaModel named, const FormulaBuilder& builder,
                                             const std::vector<Formula>& formulas) {
    std::vector<std::string> known = FormulaBuilder::functions();
    known.push_back("pi");
    const auto is_identifier = [](const std::string& name) {
        const auto letter = [](char c) { return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
        return !name.empty() && letter(name[0]) &&
               std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
    };
    for (const auto& names : {named.angles, named.coordinates, named.parameters})
        for (const std::string& name : names) {
            require(is_identifier(name), "name", name, "must be letters, digits and _, a letter first");
            require(std::find(known.begin(), known.end(), name) == known.end(), "name", name,
                    "must not be used twice, nor be sin, cos, tan, sqrt, exp, log or pi");
            known.push_back(name);
        }
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
        named.results.push_back(formula.step);
    }
    named.steps = std::make_shared<const FormulaSteps>(builder.steps());
    return named;
}

}  // namespace equilibria
