/// \file
/// See formula/formula_builder.hpp and formula/formula_steps.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/formula/formula_builder.hpp>

namespace equilibria {

namespace detail {

inline constexpr std::string_view angle_rule =
    "an angle may enter a model only inside sin and cos, as a sum of angles, integer multiples of angles and constant "
    "phases (for a half angle take the half angle as the unknown, for a torsion spring use its potential in sin and "
    "cos or a coordinate, for a constant torque give equations instead of a potential)";

[[noreturn]] inline void refuse_formula(std::string_view what, std::string_view allowed) {
    throw InvalidArgument("formula", what, allowed);
}
inline void require_number_like(const Formula& a, std::string_view what) {
    if (a.kind == FormulaKind::angle) refuse_formula(what, angle_rule);
}
inline bool has_unknowns(const Formula& a) {
    return a.kind == FormulaKind::polynomial || a.kind == FormulaKind::motion;
}
inline FormulaKind joint_kind(FormulaKind a, FormulaKind b) {
    if (a == FormulaKind::motion || b == FormulaKind::motion) return FormulaKind::motion;
    return a == FormulaKind::constant && b == FormulaKind::constant ? FormulaKind::constant : FormulaKind::polynomial;
}

}  // namespace detail

// what is there already is looked for from the end: it is near, and formulas are short
EQUILIBRIA_INLINE int FormulaSteps::add(FormulaStep step) {
    constexpr std::size_t near = 1000;
    const std::size_t first = steps_.size() > near ? steps_.size() - near : 0;
    for (std::size_t k = steps_.size(); k-- > first;)
        if (steps_[k] == step) return static_cast<int>(k);
    require(steps_.size() < FormulaBuilder::most_steps, "formula", steps_.size(), "must have at most 1000000 steps");
    steps_.push_back(step);
    return static_cast<int>(steps_.size()) - 1;
}
EQUILIBRIA_INLINE int FormulaSteps::add(const AngleCombination& angle) {
    const auto found = std::find(angles_.begin(), angles_.end(), angle);
    if (found != angles_.end()) return static_cast<int>(found - angles_.begin());
    angles_.push_back(angle);
    return static_cast<int>(angles_.size()) - 1;
}

EQUILIBRIA_INLINE std::vector<bool> FormulaSteps::needed_by(const std::vector<int>& results) const {
    std::vector<bool> needed(steps_.size(), false);
    const auto need = [&](int k) {
        if (k >= 0) needed[static_cast<std::size_t>(k)] = true;
    };
    for (const int k : results) need(k);
    for (std::size_t k = steps_.size(); k-- > 0;) {
        if (!needed[k]) continue;
        const FormulaStep& step = steps_[k];
        if (detail::has_first_step(step.operation)) need(step.a);
        if (detail::has_second_step(step.operation)) need(step.b);
        if (step.operation == FormulaOperation::sine_of_angle || step.operation == FormulaOperation::cosine_of_angle)
            need(angles_[static_cast<std::size_t>(step.a)].phase);
    }
    return needed;
}
EQUILIBRIA_INLINE FormulaSteps FormulaSteps::reached(std::vector<int>& results) const {
    const std::vector<bool> needed = needed_by(results);
    std::vector<int> now(steps_.size(), -1), angle_now(angles_.size(), -1);
    FormulaSteps y;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        if (!needed[k]) continue;
        FormulaStep step = steps_[k];
        if (step.operation == FormulaOperation::sine_of_angle || step.operation == FormulaOperation::cosine_of_angle) {
            int& number = angle_now[static_cast<std::size_t>(step.a)];
            if (number < 0) {
                AngleCombination angle = angles_[static_cast<std::size_t>(step.a)];
                if (angle.phase >= 0) angle.phase = now[static_cast<std::size_t>(angle.phase)];
                number = static_cast<int>(y.angles_.size());
                y.angles_.push_back(std::move(angle));
            }
            step.a = number;
        }
        if (detail::has_first_step(step.operation)) step.a = now[static_cast<std::size_t>(step.a)];
        if (detail::has_second_step(step.operation)) step.b = now[static_cast<std::size_t>(step.b)];
        now[k] = static_cast<int>(y.steps_.size());
        y.steps_.push_back(step);
    }
    for (int& k : results) k = now[static_cast<std::size_t>(k)];
    return y;
}
EQUILIBRIA_INLINE bool FormulaSteps::depends_on(int step, FormulaOperation operation) const {
    const std::vector<bool> needed = needed_by({step});
    for (std::size_t k = 0; k < steps_.size(); ++k)
        if (needed[k] && steps_[k].operation == operation) return true;
    return false;
}

EQUILIBRIA_INLINE Formula FormulaBuilder::number(double value) {
    require(std::isfinite(value), "number", value, "must be finite");
    return {FormulaKind::constant, steps_.add({.operation = FormulaOperation::number, .value = value}), {}};
}
EQUILIBRIA_INLINE Formula FormulaBuilder::parameter(int k) {
    require(k >= 0 && k < parameters_, "parameter", k, "must be the number of a parameter");
    return {FormulaKind::constant, steps_.add({.operation = FormulaOperation::parameter, .a = k}), {}};
}
EQUILIBRIA_INLINE Formula FormulaBuilder::angle(int i) const {
    require(i >= 0 && i < angles_, "angle", i, "must be the number of an angle");
    return {FormulaKind::angle, -1, {{{i, 1}}, -1}};
}
EQUILIBRIA_INLINE Formula FormulaBuilder::coordinate(int j) {
    require(j >= 0 && j < coordinates_, "coordinate", j, "must be the number of a coordinate");
    return {FormulaKind::polynomial,
            steps_.add({.operation = FormulaOperation::coordinate, .a = j, .of_parameters = false}),
            {}};
}
EQUILIBRIA_INLINE Formula FormulaBuilder::rate(int i) {
    require(i >= 0 && i < angles_ + coordinates_, "rate", i, "must be the number of an unknown");
    has_motion_ = true;
    return {FormulaKind::motion, steps_.add({.operation = FormulaOperation::rate, .a = i, .of_parameters = false}), {}};
}
EQUILIBRIA_INLINE Formula FormulaBuilder::time() {
    has_motion_ = true;
    return {FormulaKind::motion, steps_.add({.operation = FormulaOperation::time, .of_parameters = false}), {}};
}

EQUILIBRIA_INLINE void FormulaBuilder::require_fit(const Formula& a) const {
    if (!moves() && a.kind == FormulaKind::motion)
        detail::refuse_formula("a formula of a motion",
                               "rates, the time and other functions of unknowns than "
                               "polynomials must not stand in a potential or an equation");
}

EQUILIBRIA_INLINE bool FormulaBuilder::is_number(const Formula& a) const {
    return a.kind == FormulaKind::constant &&
           steps_.steps()[static_cast<std::size_t>(a.step)].operation == FormulaOperation::number;
}
EQUILIBRIA_INLINE double FormulaBuilder::number_of(const Formula& a) const {
    return steps_.steps()[static_cast<std::size_t>(a.step)].value;
}
EQUILIBRIA_INLINE Formula FormulaBuilder::of_step(FormulaOperation operation, const Formula& a, const Formula& b) {
    require_fit(a);
    require_fit(b);
    const FormulaKind kind = detail::joint_kind(a.kind, b.kind);
    return {
        kind,
        steps_.add({.operation = operation, .a = a.step, .b = b.step, .of_parameters = kind == FormulaKind::constant}),
        {}};
}
EQUILIBRIA_INLINE Formula FormulaBuilder::of_step(FormulaOperation operation, const Formula& a) {
    require_fit(a);
    return {a.kind,
            steps_.add({.operation = operation, .a = a.step, .of_parameters = a.kind == FormulaKind::constant}),
            {}};
}

/// a + times b, of angles and phases.
EQUILIBRIA_INLINE Formula FormulaBuilder::combined(const Formula& a, const Formula& b, int times) {
    Formula y{FormulaKind::angle, -1, a.angle};
    const auto phase_of = [](const Formula& f) {
        return Formula{FormulaKind::constant, f.kind == FormulaKind::angle ? f.angle.phase : f.step, {}};
    };
    for (const auto& [number, multiple] : b.angle.multiples) {
        const auto same = std::find_if(y.angle.multiples.begin(), y.angle.multiples.end(),
                                       [number = number](const auto& m) { return m.first == number; });
        if (same == y.angle.multiples.end())
            y.angle.multiples.emplace_back(number, times * multiple);
        else
            same->second += times * multiple;
    }
    std::erase_if(y.angle.multiples, [](const auto& m) { return m.second == 0; });
    std::sort(y.angle.multiples.begin(), y.angle.multiples.end());
    for (const auto& m : y.angle.multiples)
        require(std::abs(m.second) <= largest_multiple, "multiple of an angle", m.second, "must be at most 1000");
    const Formula pa = phase_of(a), pb = phase_of(b);
    if (pb.step < 0)
        y.angle.phase = pa.step;
    else if (pa.step < 0)
        y.angle.phase = times < 0 ? negative(pb).step : pb.step;
    else
        y.angle.phase = (times < 0 ? difference(pa, pb) : sum(pa, pb)).step;
    if (y.angle.multiples.empty()) {  // the angles have cancelled
        y.kind = FormulaKind::constant;
        y.step = y.angle.phase < 0 ? number(0).step : y.angle.phase;
        y.angle = {};
    }
    return y;
}

EQUILIBRIA_INLINE Formula FormulaBuilder::sum(const Formula& a, const Formula& b) {
    const bool angles = a.kind == FormulaKind::angle || b.kind == FormulaKind::angle;
    if (angles && (detail::has_unknowns(a) || detail::has_unknowns(b)))
        detail::refuse_formula("an angle + an expression of unknowns", detail::angle_rule);
    if (angles) return combined(a, b, 1);
    if (is_number(a) && is_number(b)) return number(number_of(a) + number_of(b));
    return of_step(FormulaOperation::sum, a, b);
}
EQUILIBRIA_INLINE Formula FormulaBuilder::difference(const Formula& a, const Formula& b) {
    const bool angles = a.kind == FormulaKind::angle || b.kind == FormulaKind::angle;
    if (angles && (detail::has_unknowns(a) || detail::has_unknowns(b)))
        detail::refuse_formula("an angle - an expression of unknowns", detail::angle_rule);
    if (angles) return combined(a, b, -1);
    if (is_number(a) && is_number(b)) return number(number_of(a) - number_of(b));
    return of_step(FormulaOperation::difference, a, b);
}
EQUILIBRIA_INLINE Formula FormulaBuilder::negative(const Formula& a) {
    if (a.kind == FormulaKind::angle) return combined({}, a, -1);
    if (is_number(a)) return number(-number_of(a));
    return of_step(FormulaOperation::negative, a);
}
EQUILIBRIA_INLINE Formula FormulaBuilder::product(const Formula& a, const Formula& b) {
    if (b.kind == FormulaKind::angle && a.kind != FormulaKind::angle) return product(b, a);
    if (a.kind == FormulaKind::angle) {
        if (!is_number(b) || number_of(b) != std::round(number_of(b)))
            detail::refuse_formula("an angle * what is no integer", detail::angle_rule);
        const double times = number_of(b);
        require(std::abs(times) <= largest_multiple, "multiple of an angle", times, "must be at most 1000");
        Formula y;
        const int k = static_cast<int>(std::abs(times));
        Formula phase{FormulaKind::constant, a.angle.phase, {}};
        if (k == 0) return number(0);
        y.kind = FormulaKind::angle;
        y.angle.multiples = a.angle.multiples;
        for (auto& m : y.angle.multiples) {
            m.second *= static_cast<int>(times);
            require(std::abs(m.second) <= largest_multiple, "multiple of an angle", m.second, "must be at most 1000");
        }
        if (phase.step >= 0) y.angle.phase = product(phase, b).step;
        return y;
    }
    if (is_number(a) && is_number(b)) return number(number_of(a) * number_of(b));
    return of_step(FormulaOperation::product, a, b);
}
EQUILIBRIA_INLINE Formula FormulaBuilder::quotient(const Formula& a, const Formula& b) {
    detail::require_number_like(b, "division by an angle");
    detail::require_number_like(a, "an angle / something");
    if (moves() && detail::has_unknowns(b)) {
        Formula y = of_step(FormulaOperation::quotient, a, b);
        y.kind = FormulaKind::motion;
        return y;
    }
    if (detail::has_unknowns(b))
        detail::refuse_formula(
            "division by an expression of unknowns",
            "a divisor may hold parameters and numbers alone: multiply the equations out, or make the "
            "quotient a coordinate with an equation of its own");
    if (is_number(b)) {
        require(number_of(b) != 0, "divisor", number_of(b), "must not be 0");
        if (is_number(a)) return number(number_of(a) / number_of(b));
    }
    return of_step(FormulaOperation::quotient, a, b);
}
EQUILIBRIA_INLINE Formula FormulaBuilder::power(const Formula& a, const Formula& b) {
    detail::require_number_like(a, "a power of an angle");
    detail::require_number_like(b, "a power by an angle");
    const bool integer =
        is_number(b) && number_of(b) == std::round(number_of(b)) && std::abs(number_of(b)) <= largest_power;
    if (moves() && (detail::has_unknowns(b) || (detail::has_unknowns(a) && (!integer || number_of(b) < 0))))
        return motion_power(a, b, integer);
    if (detail::has_unknowns(a) || detail::has_unknowns(b)) {
        require_fit(a);
        if (detail::has_unknowns(b) || !integer || number_of(b) < 0)
            detail::refuse_formula(detail::has_unknowns(b) ? "a power by an expression of unknowns"
                                   : is_number(b)          ? "the power " + to_text(number_of(b))
                                                           : std::string("a power by a parameter"),
                                   "the exponent of what holds unknowns must be an integer from 0 to 1000");
    } else if (!integer) {
        return exponential(product(b, logarithm(a)));
    }
    const int k = static_cast<int>(number_of(b));
    if (k == 0) return number(1);
    if (k == 1) return a;
    if (is_number(a)) return number(std::pow(number_of(a), k));
    return {a.kind,
            steps_.add({.operation = FormulaOperation::integer_power,
                        .a = a.step,
                        .b = k,
                        .of_parameters = a.kind == FormulaKind::constant}),
            {}};
}

EQUILIBRIA_INLINE Formula FormulaBuilder::motion_power(const Formula& a, const Formula& b, bool integer) {
    if (integer) return quotient(number(1), power(a, negative(b)));
    if (is_number(b) && number_of(b) == 0.5) return square_root(a);
    return exponential(product(b, logarithm(a)));
}

EQUILIBRIA_INLINE Formula FormulaBuilder::of_angle(FormulaOperation operation, const Formula& a) {
    return {FormulaKind::polynomial,
            steps_.add({.operation = operation, .a = steps_.add(a.angle), .of_parameters = false}),
            {}};
}
EQUILIBRIA_INLINE Formula FormulaBuilder::of_constant(FormulaOperation operation, const char* name, const Formula& a) {
    detail::require_number_like(a, std::string(name) + " of an angle");
    if (moves() && detail::has_unknowns(a)) {
        Formula y = of_step(operation, a);
        y.kind = FormulaKind::motion;
        return y;
    }
    if (detail::has_unknowns(a))
        detail::refuse_formula(std::string(name) + " of an expression of unknowns",
                               "unknowns may enter by polynomials of their sines, cosines and values alone, parameters "
                               "by any function");
    if (is_number(a)) return number(detail::formula_function(operation, number_of(a)));
    return of_step(operation, a);
}
EQUILIBRIA_INLINE Formula FormulaBuilder::sine(const Formula& a) {
    return a.kind == FormulaKind::angle ? of_angle(FormulaOperation::sine_of_angle, a)
                                        : of_constant(FormulaOperation::sine, "sin", a);
}
EQUILIBRIA_INLINE Formula FormulaBuilder::cosine(const Formula& a) {
    return a.kind == FormulaKind::angle ? of_angle(FormulaOperation::cosine_of_angle, a)
                                        : of_constant(FormulaOperation::cosine, "cos", a);
}
EQUILIBRIA_INLINE Formula FormulaBuilder::tangent(const Formula& a) {
    if (!moves()) detail::require_number_like(a, "tan of an angle");
    return quotient(sine(a), cosine(a));
}
EQUILIBRIA_INLINE Formula FormulaBuilder::square_root(const Formula& a) {
    return of_constant(FormulaOperation::square_root, "sqrt", a);
}
EQUILIBRIA_INLINE Formula FormulaBuilder::exponential(const Formula& a) {
    return of_constant(FormulaOperation::exponential, "exp", a);
}
EQUILIBRIA_INLINE Formula FormulaBuilder::logarithm(const Formula& a) {
    return of_constant(FormulaOperation::logarithm, "log", a);
}

EQUILIBRIA_INLINE const std::vector<std::string>& FormulaBuilder::functions() {
    static const std::vector<std::string> names{"sin", "cos", "tan", "sqrt", "exp", "log"};
    return names;
}
EQUILIBRIA_INLINE Formula FormulaBuilder::function(const std::string& name, const Formula& a) {
    if (name == "sin") return sine(a);
    if (name == "cos") return cosine(a);
    if (name == "tan") return tangent(a);
    if (name == "sqrt") return square_root(a);
    if (name == "exp") return exponential(a);
    if (name == "log") return logarithm(a);
    throw InvalidArgument("function", name, "must be sin, cos, tan, sqrt, exp or log");
}

}  // namespace equilibria
