/// \file
/// A model as data: names, values of parameters, and the formulas of its potential or its equations. It is made by a
/// reader (io/read_model.hpp), or by operators of another language; `visit` hands it on as a model at run time
/// (model/runtime_model.hpp), and studies/formula_model/ has everything that is done with models, compiled once.
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/local_array.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/formula/formula_builder.hpp>

namespace equilibria {

/// Names, values and steps; formula_model checks them.
struct FormulaModel {
    std::string name;                           ///< of the model
    std::vector<std::string> angles;            ///< names of the unknown angles
    std::vector<std::string> coordinates;       ///< names of the plain unknowns
    std::vector<std::string> parameters;        ///< names of the parameters
    RuntimeArray<double> values;                ///< of the parameters
    bool has_potential = true;                  ///< one formula is given, a potential, and not equations
    std::shared_ptr<const FormulaSteps> steps;  ///< shared by all copies
    std::vector<int> results;                   ///< the step of the potential, or one for each equation: angles' first

    /// Number of angles and coordinates.
    int unknowns() const { return static_cast<int>(angles.size() + coordinates.size()); }
};

/// The number of a name among these; throws InvalidArgument, which calls it `argument`, where it is none of them.
int number_of_name(const std::vector<std::string>& names, const std::string& name, const std::string& argument);

/// The model of these formulas, a potential alone or one equation for each unknown. Throws InvalidArgument where a
/// formula is an angle, where there are more or fewer of them, a name is no identifier, is used twice or is one of a
/// function, and values are not finite or not as many as parameters.
FormulaModel formula_model(FormulaModel named, const FormulaBuilder& builder, const std::vector<Formula>& formulas);

namespace detail {

/// What both kinds of model have in common.
class FormulaModelBase {
public:
    explicit FormulaModelBase(const FormulaModel& model)
        : angles_(static_cast<int>(model.angles.size())), coordinates_(static_cast<int>(model.coordinates.size())),
          parameters_(static_cast<int>(model.parameters.size())), steps_(model.steps), results_(model.results) {}

    int angles() const { return angles_; }
    int coordinates() const { return coordinates_; }
    int parameters() const { return parameters_; }

protected:
    template <class X>
    using Scalar = std::remove_cvref_t<decltype(std::declval<const std::remove_cvref_t<X>&>()[0])>;

    int angles_, coordinates_, parameters_;
    std::shared_ptr<const FormulaSteps> steps_;
    std::vector<int> results_;
};

}  // namespace detail

/// A model by its potential; see RuntimePotentialModel.
class FormulaPotential : public detail::FormulaModelBase {
public:
    using FormulaModelBase::FormulaModelBase;

    /// As of a model's function.
    auto potential(const auto& theta, const auto& x, const auto& p) const {
        Scalar<decltype(x)> y;
        steps_->evaluate(theta, x, p, results_, &y);
        return y;
    }
};
/// A model by its equations; see RuntimeEquationsModel.
class FormulaEquations : public detail::FormulaModelBase {
public:
    using FormulaModelBase::FormulaModelBase;

    /// As of a model's function; one entry an unknown.
    auto equations(const auto& theta, const auto& x, const auto& p) const {
        LocalArray<Scalar<decltype(x)>> y(static_cast<int>(results_.size()));
        steps_->evaluate(theta, x, p, results_, y.begin());
        return y;
    }
};

/// take(model), the model being a FormulaPotential or FormulaEquations.
template <class Take>
auto visit(const FormulaModel& model, const Take& take) {
    return model.has_potential ? take(FormulaPotential(model)) : take(FormulaEquations(model));
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/formula/detail/formula_model_definitions.hpp>
#endif
