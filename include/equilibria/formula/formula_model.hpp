/// \file
/// A model as data: names, values of parameters, and the formulas of its potential or its equations. It is made by a
/// reader (io/read_model.hpp), or by operators of another language; `visit` hands it on as a model at run time
/// (model/runtime_model.hpp), and studies/formula_model/ has everything that is done with models, compiled once.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/local_array.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/formula/formula_builder.hpp>

namespace equilibria {

/// A function that is formulas, evaluated together.
struct FormulaFunction {
    std::shared_ptr<const FormulaSteps> steps;  ///< none: there is no such function
    std::vector<int> results;                   ///< the step of each of its values

    /// Whether there is such a function.
    explicit operator bool() const { return steps != nullptr; }
};

/// What a model that moves has beside its potential (model/kinetics.hpp); with_kinetics checks it.
struct FormulaKinetics {
    std::vector<std::string> rates;      ///< names of the rates of the unknowns, angles' first
    std::string time;                    ///< name of the time; empty: it has none
    FormulaFunction kinetic_energy;      ///< a quadratic form in the rates
    FormulaFunction dissipation;         ///< Rayleigh's function, where there is damping
    FormulaFunction generalised_forces;  ///< one an unknown, where there are other forces
};

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
    std::shared_ptr<const FormulaKinetics> kinetics{};  ///< shared by all copies; none: the model does not move

    /// Number of angles and coordinates.
    int unknowns() const { return static_cast<int>(angles.size() + coordinates.size()); }
};

/// The number of a name among these; throws InvalidArgument, which calls it `argument`, where it is none of them.
int number_of_name(const std::vector<std::string>& names, const std::string& name, const std::string& argument);

/// The model of these formulas, a potential alone or one equation for each unknown. Throws InvalidArgument where a
/// formula is an angle, where there are more or fewer of them, a name is no identifier, is used twice or is one of a
/// function, and values are not finite or not as many as parameters.
FormulaModel formula_model(FormulaModel named, const FormulaBuilder& builder, const std::vector<Formula>& formulas);

/// The formulas of a model that moves, made under the rules of a motion.
struct KineticFormulas {
    std::vector<std::string> rates;             ///< names, one for each unknown, angles' first
    std::string time{};                         ///< name of the time; empty: it has none
    Formula kinetic_energy{};                   ///< of unknowns, rates and parameters
    std::optional<Formula> dissipation{};       ///< of the same
    std::vector<Formula> generalised_forces{};  ///< of the same and of the time; none, or one an unknown
};

/// The same model with these, of the builder of its potential. Throws InvalidArgument where it has no potential, for
/// names as formula_model does and where they are not as many as unknowns, where a formula is an angle, one of an
/// energy holds the time, forces are not as many as unknowns, and where the kinetic energy is no quadratic form in the
/// rates, as far as some random places and the model's values of the parameters tell: `integrate_motion` asks again
/// where it begins.
FormulaModel with_kinetics(FormulaModel model, const FormulaBuilder& builder, const KineticFormulas& kinetics);

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
/// A model that moves; see RuntimeDynamicModel.
class FormulaDynamics : public FormulaPotential {
public:
    /// Of a model with kinetics.
    explicit FormulaDynamics(const FormulaModel& model) : FormulaPotential(model), kinetics_(model.kinetics) {}

    /// As of a model's functions; 0 of what the model does not have.
    /// \{
    auto kinetic_energy(const auto& theta, const auto& x, const auto& v, const auto& p) const {
        return value(kinetics_->kinetic_energy, theta, x, v, p);
    }
    auto dissipation(const auto& theta, const auto& x, const auto& v, const auto& p) const {
        return value(kinetics_->dissipation, theta, x, v, p);
    }
    auto generalised_forces(double t, const auto& theta, const auto& x, const auto& v, const auto& p) const {
        LocalArray<Scalar<decltype(v)>> y(angles_ + coordinates_);
        if (const FormulaFunction& f = kinetics_->generalised_forces)
            f.steps->evaluate(theta, x, v, t, p, f.results, y.begin());
        return y;
    }
    /// \}

private:
    auto value(const FormulaFunction& f, const auto& theta, const auto& x, const auto& v, const auto& p) const {
        Scalar<decltype(v)> y{};
        if (f) f.steps->evaluate(theta, x, v, 0, p, f.results, &y);
        return y;
    }

    std::shared_ptr<const FormulaKinetics> kinetics_;
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
