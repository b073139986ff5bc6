/// \file
/// Formulas put together operation by operation, by a parser or by operators of another language, under the rules of
/// models: an angle may be added to angles and to constant phases, multiplied by integers, and put into sin and cos;
/// unknowns enter by polynomials of their sines, cosines and values; parameters by any function. What breaks a rule is
/// refused in a sentence, where it happens.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/formula/formula_steps.hpp>

namespace equilibria {

/// What a formula may be used for.
enum class FormulaKind {
    constant,    ///< of parameters alone
    angle,       ///< a combination of angles, which is no number
    polynomial,  ///< in sines, cosines and coordinates
};

/// A formula of a builder: a step, or a combination of angles.
struct Formula {
    FormulaKind kind = FormulaKind::constant;
    int step = -1;
    AngleCombination angle;
};

/// Makes formulas of the unknowns and the parameters of one model. Each function throws InvalidArgument where the rule
/// of its operation is broken.
class FormulaBuilder {
public:
    FormulaBuilder(int angles, int coordinates, int parameters)
        : angles_(angles), coordinates_(coordinates), parameters_(parameters) {}

    int angles() const { return angles_; }
    int coordinates() const { return coordinates_; }
    int parameters() const { return parameters_; }

    Formula number(double value);
    Formula parameter(int k);
    Formula angle(int i) const;
    Formula coordinate(int j);

    Formula sum(const Formula& a, const Formula& b);
    Formula difference(const Formula& a, const Formula& b);
    Formula product(const Formula& a, const Formula& b);
    Formula quotient(const Formula& a, const Formula& b);
    Formula negative(const Formula& a);
    /// b must be an integer from 0 to 100 where a has unknowns in it, and of parameters alone elsewhere.
    Formula power(const Formula& a, const Formula& b);
    Formula sine(const Formula& a);
    Formula cosine(const Formula& a);
    Formula tangent(const Formula& a);
    Formula square_root(const Formula& a);
    Formula exponential(const Formula& a);
    Formula logarithm(const Formula& a);
    /// Of one of the functions above by its name: sin, cos, tan, sqrt, exp, log.
    Formula function(const std::string& name, const Formula& a);
    static const std::vector<std::string>& functions();

    const FormulaSteps& steps() const { return steps_; }

    static constexpr int largest_power = 100;
    static constexpr int largest_multiple = 100;  ///< of an angle
    static constexpr int most_steps = 1'000'000;

private:
    bool is_number(const Formula& a) const;
    double number_of(const Formula& a) const;
    Formula of_step(FormulaOperation operation, const Formula& a, const Formula& b);
    Formula of_step(FormulaOperation operation, const Formula& a);
    Formula of_constant(FormulaOperation operation, const char* name, const Formula& a);
    Formula of_angle(FormulaOperation operation, const Formula& a);
    Formula combined(const Formula& a, const Formula& b, int times);

    int angles_, coordinates_, parameters_;
    FormulaSteps steps_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/formula/detail/formula_builder_definitions.hpp>
#endif
