/// \file
/// The angles that a model's function receives. An angle is not a number: it may be added to angles and to constant
/// phases, multiplied by integers, and put into sin and cos. That is what keeps the function a trigonometric
/// polynomial, whatever the scalars are, and it makes sin and cos free where the point of the circle is at hand.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace equilibria {

namespace detail {
template <class>
inline constexpr bool never = false;

template <class A>
concept Integer = std::is_integral_v<A>;
}  // namespace detail

/// What both kinds of angle refuse, each with a sentence. Derived angles befriend nothing: overload resolution
/// prefers their own operators, which match exactly.
struct AngleBase {};

/// Angles of any scalar and of both kinds, references included.
template <class A>
concept AngleLike = std::is_base_of_v<AngleBase, std::remove_cvref_t<A>>;

/// The sentence with which the overloads below refuse; undefined after them.
// clang-format off
#define EQUILIBRIA_REFUSE_ANGLE                                                                                     \
    static_assert(detail::never<A>,                                                                                 \
        "equilibria: an angle may enter a model only inside sin and cos, as a sum of angles, integer multiples "    \
        "of angles and constant phases: this expression is not a trigonometric polynomial (for a half angle take "  \
        "the half angle as the unknown, for a torsion spring use its potential in sin and cos or a coordinate, for "  \
        "a constant torque give equations instead of a potential)")
// clang-format on
/// Refused with a sentence at compile time: no operation of angles.
/// \{
template <AngleLike A, class B>
requires(!detail::Integer<std::remove_cvref_t<B>>)
constexpr auto operator*(const A& a, const B&) {
    EQUILIBRIA_REFUSE_ANGLE;
    return a;
}
template <class B, AngleLike A>
requires(!AngleLike<B> && !detail::Integer<std::remove_cvref_t<B>>)
constexpr auto operator*(const B&, const A& a) {
    EQUILIBRIA_REFUSE_ANGLE;
    return a;
}
template <AngleLike A, class B>
constexpr auto operator/(const A& a, const B&) {
    EQUILIBRIA_REFUSE_ANGLE;
    return a;
}
template <AngleLike A>
constexpr auto tan(const A& a) {
    EQUILIBRIA_REFUSE_ANGLE;
    return a;
}
template <AngleLike A>
constexpr auto exp(const A& a) {
    EQUILIBRIA_REFUSE_ANGLE;
    return a;
}
template <AngleLike A>
constexpr auto sqrt(const A& a) {
    EQUILIBRIA_REFUSE_ANGLE;
    return a;
}
template <AngleLike A, class B>
constexpr auto pow(const A& a, const B&) {
    EQUILIBRIA_REFUSE_ANGLE;
    return a;
}
/// \}
#undef EQUILIBRIA_REFUSE_ANGLE

/// An angle known by its point (c, s) = (cos, sin) on the circle, over any scalar S: real, complex (then c^2 + s^2 = 1
/// is the complex circle, and the angle may have an imaginary part), dual, interval, lanes.
template <class S>
struct CircleAngle : AngleBase {
    S c;  ///< cosine
    S s;  ///< sine

    constexpr CircleAngle() = default;
    /// From a point with cosine^2 + sine^2 = 1, which is not checked.
    constexpr CircleAngle(const S& cosine, const S& sine) : c(cosine), s(sine) {}

    friend constexpr const S& cos(const CircleAngle& a) { return a.c; }  ///< the cosine at hand
    friend constexpr const S& sin(const CircleAngle& a) { return a.s; }  ///< the sine at hand

    /// Sums and integer multiples, by the addition formulas.
    /// \{
    friend constexpr CircleAngle operator+(const CircleAngle& a) { return a; }
    friend constexpr CircleAngle operator-(const CircleAngle& a) { return {a.c, -a.s}; }
    friend constexpr CircleAngle operator+(const CircleAngle& a, const CircleAngle& b) {
        return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s};
    }
    friend constexpr CircleAngle operator-(const CircleAngle& a, const CircleAngle& b) { return a + (-b); }
    template <class B>
    constexpr CircleAngle& operator+=(const B& b) {
        return *this = *this + b;
    }
    template <class B>
    constexpr CircleAngle& operator-=(const B& b) {
        return *this = *this - b;
    }
    template <detail::Integer I>
    friend constexpr CircleAngle operator*(I multiple, const CircleAngle& a) {
        CircleAngle y(S(1.0) + 0.0 * a.c, 0.0 * a.s);
        for (I k = 0; k < (multiple < 0 ? -multiple : multiple); ++k) y = y + a;
        return multiple < 0 ? -y : y;
    }
    template <detail::Integer I>
    friend constexpr CircleAngle operator*(const CircleAngle& a, I multiple) {
        return multiple * a;
    }
    /// \}
    /// Sums with a constant phase in radians.
    /// \{
    template <class P>
    requires(!AngleLike<P>)
    friend constexpr CircleAngle operator+(const CircleAngle& a, const P& phase) {
        using std::cos, std::sin;
        const auto pc = cos(phase), ps = sin(phase);
        return {a.c * pc - a.s * ps, a.s * pc + a.c * ps};
    }
    template <class P>
    requires(!AngleLike<P>)
    friend constexpr CircleAngle operator+(const P& phase, const CircleAngle& a) {
        return a + phase;
    }
    template <class P>
    requires(!AngleLike<P>)
    friend constexpr CircleAngle operator-(const CircleAngle& a, const P& phase) {
        return a + (-phase);
    }
    template <class P>
    requires(!AngleLike<P>)
    friend constexpr CircleAngle operator-(const P& phase, const CircleAngle& a) {
        return (-a) + phase;
    }
    /// \}
};

}  // namespace equilibria
