/// \file
/// Formulas as data: what a model's function is where it is read from text or traced in another language. They are
/// steps, each an operation on earlier ones, so that what two formulas share is computed once; any scalar goes through
/// them that goes through a function of C++.
///
/// What depends on parameters alone is kept apart: it may take any function that is analytic, and is computed on plain
/// numbers where the parameters are. Angles are no steps: a sine or a cosine names the integer combination that it is
/// of. Formulas of a motion hold rates and the time as well, and may take any function of anything.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/core/local_array.hpp>

namespace equilibria {

/// What a step does with earlier steps, or what it takes from outside.
enum class FormulaOperation {
    number,           ///< a constant
    parameter,        ///< parameter number a
    coordinate,       ///< coordinate number a
    rate,             ///< of a motion: the rate of unknown number a
    time,             ///< of a motion
    sine_of_angle,    ///< sine of the combination number a
    cosine_of_angle,  ///< cosine of the combination number a
    sum,              ///< a + b
    difference,       ///< a - b
    product,          ///< a b
    quotient,         ///< a / b, where b is of parameters alone but in a motion
    negative,         ///< -a
    integer_power,    ///< a^b, b being the exponent
    square_root,      ///< of parameters alone but in a motion
    exponential,      ///< of parameters alone but in a motion
    logarithm,        ///< of parameters alone but in a motion
    sine,             ///< of parameters alone but in a motion, in radians
    cosine,           ///< of parameters alone but in a motion, in radians
};

/// One operation, and what it is applied to.
struct FormulaStep {
    FormulaOperation operation = FormulaOperation::number;  ///< what is done
    int a = -1;        ///< an earlier step; of a parameter, a coordinate, a rate or a combination of angles its number
    int b = -1;        ///< an earlier step; of an integer power the exponent
    double value = 0;  ///< of a number
    bool of_parameters = true;  ///< no unknown is in it

    friend bool operator==(const FormulaStep&, const FormulaStep&) = default;  ///< the same operation on the same steps
};

/// The sum of multiples of unknown angles and a phase.
struct AngleCombination {
    std::vector<std::pair<int, int>> multiples;  ///< number of the angle, by which integer; none twice, none by 0
    int phase = -1;                              ///< the step, of parameters alone; -1: none

    friend bool operator==(const AngleCombination&, const AngleCombination&) = default;  ///< the same, term by term
};

namespace detail {

/// Whether the operation has an earlier step, or two, for its arguments.
/// \{
inline bool has_first_step(FormulaOperation operation) { return operation >= FormulaOperation::sum; }
inline bool has_second_step(FormulaOperation operation) {
    return operation >= FormulaOperation::sum && operation <= FormulaOperation::quotient;
}
/// \}

/// Rates and time of what does not move.
struct AtRest {
    static constexpr bool moves = false;
};
/// Of a motion.
template <class V>
struct Moving {
    static constexpr bool moves = true;
    const V& rates;
    double time;
};

/// A function of parameters that not every scalar has.
template <class S>
S formula_function(FormulaOperation operation, const S& a) {
    using std::cos, std::exp, std::log, std::sin, std::sqrt;
    const auto lacking = [](const char* name) -> S {
        throw InvalidArgument("formula", std::string(name) + " of parameters",
                              "must not be asked of proofs, which know + - * / and powers alone");
    };
    switch (operation) {
        case FormulaOperation::square_root:
            if constexpr (requires { S(sqrt(a)); })
                return S(sqrt(a));
            else
                return lacking("sqrt");
        case FormulaOperation::exponential:
            if constexpr (requires { S(exp(a)); })
                return S(exp(a));
            else
                return lacking("exp");
        case FormulaOperation::logarithm:
            if constexpr (requires { S(log(a)); })
                return S(log(a));
            else
                return lacking("log");
        case FormulaOperation::sine:
            if constexpr (requires { S(sin(a)); })
                return S(sin(a));
            else
                return lacking("sin");
        default:
            if constexpr (requires { S(cos(a)); })
                return S(cos(a));
            else
                return lacking("cos");
    }
}

/// a^k by products; a quotient where k is negative.
template <class S>
S formula_power(const S& a, int k) {
    S y(1.0), square = a;
    bool one = true;
    for (int left = k < 0 ? -k : k; left > 0; left /= 2) {
        if (left % 2 == 1) y = one ? square : S(y * square), one = false;
        if (left > 1) square = square * square;
    }
    return k < 0 ? S(S(1.0) / y) : y;
}

}  // namespace detail

/// All steps of a model's formulas, in an order in which they can be evaluated.
class FormulaSteps {
public:
    /// The number of a step; of one that is there already, of that one.
    int add(FormulaStep step);
    /// The number of a combination of angles; of one that is there already, of that one.
    int add(const AngleCombination& angle);

    const std::vector<FormulaStep>& steps() const { return steps_; }  ///< in the order in which they are evaluated
    const std::vector<AngleCombination>& angles() const { return angles_; }  ///< of which there are sines or cosines

    /// The steps that these are made of, in their order, and these as steps of them.
    FormulaSteps reached(std::vector<int>& results) const;
    /// Whether the step, or one that it is made of, is such an operation.
    bool depends_on(int step, FormulaOperation operation) const;

    /// The values of the steps of these numbers.
    template <class Theta, class X, class P, class S>
    void evaluate(const Theta& theta, const X& x, const P& p, const std::vector<int>& results, S* values) const {
        evaluate(theta, x, detail::AtRest(), p, results, values);
    }
    /// The same in a motion: v holds the rates of the unknowns.
    template <class Theta, class X, class V, class P, class S>
    void evaluate(const Theta& theta, const X& x, const V& v, double time, const P& p, const std::vector<int>& results,
                  S* values) const {
        evaluate(theta, x, detail::Moving<V>{v, time}, p, results, values);
    }

private:
    std::vector<bool> needed_by(const std::vector<int>& results) const;

    template <class Theta, class X, class Motion, class P, class S>
    void evaluate(const Theta& theta, const X& x, const Motion& motion, const P& p, const std::vector<int>& results,
                  S* values) const {
        using C = std::remove_cvref_t<decltype(p[0])>;  // a number, or S
        const int n = static_cast<int>(steps_.size());
        LocalArray<C> constant(n);
        LocalArray<S> value(n);
        for (int k = 0; k < n; ++k) {
            const FormulaStep& step = steps_[static_cast<std::size_t>(k)];
            if (step.of_parameters)
                constant[k] = of_parameters<C>(step, constant, p);
            else
                value[k] = of_unknowns<S>(step, constant, value, theta, x, motion);
        }
        for (std::size_t r = 0; r < results.size(); ++r)
            values[r] = steps_[static_cast<std::size_t>(results[r])].of_parameters ? S(constant[results[r]])
                                                                                   : value[results[r]];
    }

    template <class C, class P>
    C of_parameters(const FormulaStep& step, const LocalArray<C>& v, const P& p) const {
        switch (step.operation) {
            case FormulaOperation::number: return C(step.value);
            case FormulaOperation::parameter: return p[step.a];
            case FormulaOperation::sum: return v[step.a] + v[step.b];
            case FormulaOperation::difference: return v[step.a] - v[step.b];
            case FormulaOperation::product: return v[step.a] * v[step.b];
            case FormulaOperation::quotient: return v[step.a] / v[step.b];
            case FormulaOperation::negative: return -v[step.a];
            case FormulaOperation::integer_power: return detail::formula_power(v[step.a], step.b);
            default: return detail::formula_function(step.operation, v[step.a]);
        }
    }
    template <class S, class C, class Theta, class X, class Motion>
    S of_unknowns(const FormulaStep& step, const LocalArray<C>& constant, const LocalArray<S>& value,
                  const Theta& theta, const X& x, const Motion& motion) const {
        const auto is_constant = [this](int k) { return steps_[static_cast<std::size_t>(k)].of_parameters; };
        const auto both = [&](auto operation) -> S {
            if (is_constant(step.a)) return operation(constant[step.a], value[step.b]);
            if (is_constant(step.b)) return operation(value[step.a], constant[step.b]);
            return operation(value[step.a], value[step.b]);
        };
        switch (step.operation) {
            case FormulaOperation::coordinate: return x[step.a];
            case FormulaOperation::sine_of_angle: return sin_cos<S>(step.a, true, constant, theta);
            case FormulaOperation::cosine_of_angle: return sin_cos<S>(step.a, false, constant, theta);
            case FormulaOperation::sum: return both([](const auto& a, const auto& b) -> S { return a + b; });
            case FormulaOperation::difference: return both([](const auto& a, const auto& b) -> S { return a - b; });
            case FormulaOperation::product: return both([](const auto& a, const auto& b) -> S { return a * b; });
            case FormulaOperation::quotient:
                if constexpr (Motion::moves)
                    return both([](const auto& a, const auto& b) -> S { return S(a) / S(b); });
                else
                    return value[step.a] / constant[step.b];
            case FormulaOperation::negative: return -value[step.a];
            default: break;
        }
        if constexpr (Motion::moves) {
            if (step.operation == FormulaOperation::rate) return motion.rates[step.a];
            if (step.operation == FormulaOperation::time) return S(motion.time);
            if (step.operation != FormulaOperation::integer_power)
                return detail::formula_function(step.operation, value[step.a]);
        }
        return detail::formula_power(value[step.a], step.b);
    }
    template <class S, class C, class Theta>
    S sin_cos(int number, bool sine, const LocalArray<C>& constant, const Theta& theta) const {
        using std::cos, std::sin;
        const AngleCombination& angle = angles_[static_cast<std::size_t>(number)];
        const auto of = [sine](const auto& a) -> S { return sine ? S(sin(a)) : S(cos(a)); };
        const auto [first, by] = angle.multiples[0];
        if (angle.multiples.size() == 1 && by == 1 && angle.phase < 0) return of(theta[first]);
        auto sum = by == 1 ? theta[first] : by * theta[first];
        for (std::size_t k = 1; k < angle.multiples.size(); ++k)
            sum = sum + angle.multiples[k].second * theta[angle.multiples[k].first];
        if (angle.phase >= 0) return of(sum + constant[angle.phase]);
        return of(sum);
    }

    std::vector<FormulaStep> steps_;
    std::vector<AngleCombination> angles_;
};

}  // namespace equilibria
