/// \file
/// Formulas of Python: what a model's function is given for its unknowns and parameters, whose operators build steps.
#pragma once

#include <memory>
#include <vector>

#include <equilibria/formula/formula_builder.hpp>

namespace equilibria::python {

using SharedBuilder = std::shared_ptr<FormulaBuilder>;

struct Expression {
    SharedBuilder builder;
    Formula formula;
};

/// The formulas of expressions of this builder; throws InvalidArgument for those of another one.
std::vector<Formula> formulas_of(const std::vector<Expression>& expressions, const FormulaBuilder& builder);

}  // namespace equilibria::python
