/// \file
/// Formulas put together operation by operation, by a parser or by operators of another language, under the rules of
/// models: an angle may be added to angles and to constant phases, multiplied by integers, and put into sin and cos;
/// unknowns enter by polynomials of their sines, cosines and values; parameters by any function. In formulas of a
/// motion, the kinetic energy and forces, unknowns, their rates and the time enter by any function as well. What breaks
/// a rule is refused in a sentence, where it happens.
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
    motion,      ///< of rates, of the time, or no polynomial: of no use for equilibria
};

/// What the formulas are for that are being made.
enum class FormulaRules {
    equilibria,  ///< a potential or equations: unknowns enter by polynomials of their sines, cosines and values
    motion,      ///< kinetic energy, dissipation, forces: unknowns, rates and the time enter by any function
};

/// A formula of a builder: a step, or a combination of angles.
struct Formula {
    FormulaKind kind = FormulaKind::constant;  ///< what it may be used for
    int step = -1;                             ///< number of its step; -1 of an angle
    AngleCombination angle;                    ///< of a formula that is an angle
};

/// Makes formulas of the unknowns and the parameters of one model. Each function throws InvalidArgument where the rule
/// of its operation is broken.
class FormulaBuilder {
public:
    /// Numbers of the model's unknowns and parameters.
    FormulaBuilder(int angles, int coordinates, int parameters)
        : angles_(angles), coordinates_(coordinates), parameters_(parameters) {}

    int angles() const { return angles_; }            ///< number of unknown angles
    int coordinates() const { return coordinates_; }  ///< number of plain unknowns
    int parameters() const { return parameters_; }    ///< number of parameters

    /// The rules for formulas made from now on; those for equilibria at first.
    void set_rules(FormulaRules rules) {
        rules_ = rules;
        has_motion_ = has_motion_ || rules == FormulaRules::motion;
    }
    FormulaRules rules() const { return rules_; }  ///< for formulas made from now on

    Formula number(double value);  ///< a constant, which must be finite
    Formula parameter(int k);      ///< parameter number k
    Formula angle(int i) const;    ///< unknown angle number i
    Formula coordinate(int j);     ///< unknown coordinate number j
    Formula rate(int i);           ///< of a motion: the rate of unknown number i, coordinates behind the angles
    Formula time();                ///< of a motion

    /// Of numbers; sums and differences also of angles and constant phases, products and negatives also of an angle and
    /// an integer. Divisors are of parameters alone, but for formulas of a motion.
    /// \{
    Formula sum(const Formula& a, const Formula& b);
    Formula difference(const Formula& a, const Formula& b);
    Formula product(const Formula& a, const Formula& b);
    Formula quotient(const Formula& a, const Formula& b);
    Formula negative(const Formula& a);
    /// \}
    /// b must be an integer from 0 to 1000 where a has unknowns in it, and of parameters alone elsewhere; for formulas
    /// of a motion it may be any number.
    Formula power(const Formula& a, const Formula& b);
    /// Of an angle, or of parameters alone; the tangent of parameters alone. For formulas of a motion of anything.
    /// \{
    Formula sine(const Formula& a);
    Formula cosine(const Formula& a);
    Formula tangent(const Formula& a);
    /// \}
    /// Of parameters alone; for formulas of a motion of any number.
    /// \{
    Formula square_root(const Formula& a);
    Formula exponential(const Formula& a);
    Formula logarithm(const Formula& a);
    /// \}
    /// Of one of the functions above by its name: sin, cos, tan, sqrt, exp, log.
    Formula function(const std::string& name, const Formula& a);
    static const std::vector<std::string>& functions();  ///< the names of those functions

    const FormulaSteps& steps() const { return steps_; }  ///< what has been made so far
    bool has_motion() const { return has_motion_; }       ///< whether any of it may be of a motion

    static constexpr int largest_power = 1000;     ///< exponent of what has unknowns in it
    static constexpr int largest_multiple = 1000;  ///< of an angle
    static constexpr int most_steps = 1'000'000;   ///< of all formulas of a builder

private:
    bool is_number(const Formula& a) const;
    double number_of(const Formula& a) const;
    void require_fit(const Formula& a) const;
    bool moves() const { return rules_ == FormulaRules::motion; }
    Formula motion_power(const Formula& a, const Formula& b, bool integer);
    Formula of_step(FormulaOperation operation, const Formula& a, const Formula& b);
    Formula of_step(FormulaOperation operation, const Formula& a);
    Formula of_constant(FormulaOperation operation, const char* name, const Formula& a);
    Formula of_angle(FormulaOperation operation, const Formula& a);
    Formula combined(const Formula& a, const Formula& b, int times);

    int angles_, coordinates_, parameters_;
    FormulaRules rules_ = FormulaRules::equilibria;
    bool has_motion_ = false;
    FormulaSteps steps_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/formula/detail/formula_builder_definitions.hpp>
#endif
