/// \file
/// What a model is: compile-time numbers of angles, of plain coordinates and of parameters, and one generic member
/// function over any scalars. Nothing is registered: a model is a struct of the user's.
///
/// \code
/// struct Pendulum {
///     static constexpr int n_angles = 1;
///     enum Parameter { torque, n_parameters };                       // or static constexpr int n_parameters = 1;
///     constexpr auto equations(const auto& theta, const auto& p) const {
///         return std::array{sin(theta[0]) - p[torque]};
///     }
/// };
/// \endcode
///
/// - `n_angles`: unknown angles, in radians; they come as `theta[i]` and enter through sin and cos alone.
/// - `n_coordinates` (optional, 0): plain unknowns; they come as `x[j]`, a second argument: `potential(theta, x, p)`.
/// - `n_parameters`: `p[k]`.
/// - `potential(theta, p)`: a scalar whose critical points are the equilibria; or, where no potential exists,
///   `equations(theta, p)`: a std::array of n_angles + n_coordinates scalars that vanish there.
///
/// The function is `constexpr` and const, and draws no conclusions from values: it is called with polynomials, with
/// duals, with packs of complex numbers. `equilibria::scalar_of<decltype(theta)>` names the type to start a sum with.
#pragma once

#include <array>
#include <concepts>
#include <type_traits>
#include <utility>

#include <equilibria/core/array.hpp>
#include <equilibria/model/angle.hpp>

namespace equilibria {

namespace detail {
template <class M>
concept HasAngles = requires {
    { static_cast<int>(M::n_angles) } -> std::same_as<int>;
};
template <class M>
concept HasCoordinates = requires {
    { static_cast<int>(M::n_coordinates) } -> std::same_as<int>;
};
template <class M>
concept HasParameters = requires {
    { static_cast<int>(M::n_parameters) } -> std::same_as<int>;
};
template <class M>
constexpr int angles_of() {
    if constexpr (HasAngles<M>) return static_cast<int>(M::n_angles);
    return 0;
}
template <class M>
constexpr int coordinates_of() {
    if constexpr (HasCoordinates<M>) return static_cast<int>(M::n_coordinates);
    return 0;
}
template <class M>
constexpr int parameters_of() {
    if constexpr (HasParameters<M>) return static_cast<int>(M::n_parameters);
    return 0;
}
}  // namespace detail

/// Number of unknown angles of the model M; 0 where it names none.
template <class M>
inline constexpr int n_angles = detail::angles_of<M>();
/// Number of plain unknowns of the model M; 0 where it names none.
template <class M>
inline constexpr int n_coordinates = detail::coordinates_of<M>();
/// Number of parameters of the model M; 0 where it names none.
template <class M>
inline constexpr int n_parameters = detail::parameters_of<M>();
/// Angles first, plain coordinates after them.
template <class M>
inline constexpr int n_unknowns = n_angles<M> + n_coordinates<M>;

/// The sizes of a model.
template <class M>
concept ModelSizes = detail::HasAngles<M> && detail::HasParameters<M> && std::is_default_constructible_v<M>;

namespace detail {
constexpr auto scalar_of_unknown(const auto& unknown) {
    if constexpr (requires { cos(unknown); })
        return cos(unknown);
    else
        return unknown;
}
}  // namespace detail

/// The scalar that sines and cosines of these angles have, or that these coordinates are: the type to start a sum with,
/// `scalar_of<decltype(theta)> v{}`.
template <class Unknowns>
using scalar_of = decltype(detail::scalar_of_unknown(std::declval<const std::remove_cvref_t<Unknowns>&>()[0]));

namespace detail {
template <class M, class Theta, class X, class P>
concept PotentialOf = requires(const M& m, const Theta& theta, const X& x, const P& p) {
    requires n_coordinates<M> == 0 || requires { m.potential(theta, x, p); };
    requires n_coordinates<M> != 0 || requires { m.potential(theta, p); };
};
template <class M, class Theta, class X, class P>
concept EquationsOf = requires(const M& m, const Theta& theta, const X& x, const P& p) {
    requires n_coordinates<M> == 0 || requires { m.equations(theta, x, p); };
    requires n_coordinates<M> != 0 || requires { m.equations(theta, p); };
};

template <class M, class Theta, class X, class P>
constexpr auto call_potential(const M& model, const Theta& theta, const X& x, const P& p) {
    const auto value = [&] {
        if constexpr (n_coordinates<M> == 0)
            return model.potential(theta, p);
        else
            return model.potential(theta, x, p);
    }();
    static_assert(!AngleLike<decltype(value)>,
                  "equilibria: potential must return a scalar, and angles enter it only inside sin and cos: this one "
                  "returns an angle");
    return value;
}

/// The number of entries of a std::array or of an Array; -1 of anything else.
template <class A>
constexpr int entries_of() {
    if constexpr (requires {
                      std::tuple_size<A>::value;
                      std::declval<A>()[0];
                  })
        return static_cast<int>(std::tuple_size<A>::value);
    else if constexpr (requires { std::integral_constant<int, A::size()>::value; })
        return A::size();
    return -1;
}
template <class M, class Theta, class X, class P>
constexpr auto call_equations(const M& model, const Theta& theta, const X& x, const P& p) {
    const auto values = [&] {
        if constexpr (n_coordinates<M> == 0)
            return model.equations(theta, p);
        else
            return model.equations(theta, x, p);
    }();
    static_assert(
        entries_of<std::remove_cvref_t<decltype(values)>>() == n_unknowns<M>,
        "equilibria: equations must return a std::array with one entry for each unknown angle and coordinate");
    return values;
}

template <class M, class S>
using AnglesOf = Array<CircleAngle<S>, n_angles<M>>;
template <class M, class S>
using CoordinatesOf = Array<S, n_coordinates<M>>;
}  // namespace detail

/// A value for each parameter of the model, in the order of its enumeration.
template <class M, class S = double>
using Parameters = Array<S, n_parameters<M>>;

/// A model that gives a potential, checked with real scalars.
template <class M>
concept PotentialModel =
    ModelSizes<M> &&
    detail::PotentialOf<M, detail::AnglesOf<M, double>, detail::CoordinatesOf<M, double>, Parameters<M>>;

/// A model that gives its equations.
template <class M>
concept EquationsModel =
    ModelSizes<M> && !PotentialModel<M> &&
    detail::EquationsOf<M, detail::AnglesOf<M, double>, detail::CoordinatesOf<M, double>, Parameters<M>>;

/// Anything that the library accepts as a model; `check_model` says in a sentence why something is not one.
template <class M>
concept Model = PotentialModel<M> || EquationsModel<M>;

/// Fails to compile, with a sentence that says what to change, unless M is a model.
template <class M>
constexpr void check_model() {
    constexpr bool sizes = detail::HasAngles<M> && detail::HasParameters<M>;
    constexpr bool empty = std::is_default_constructible_v<M> && std::is_empty_v<M>;
    static_assert(detail::HasAngles<M>,
                  "equilibria: a model needs `static constexpr int n_angles`, its number of unknown angles");
    static_assert(detail::HasParameters<M>,
                  "equilibria: a model needs its number of parameters, `n_parameters`: the last name of an enumeration "
                  "of them, or a static constexpr int");
    static_assert(!sizes || (n_angles<M> >= 0 && n_coordinates<M> >= 0 && n_parameters<M> >= 0),
                  "equilibria: n_angles, n_coordinates and n_parameters must not be negative");
    static_assert(!sizes || n_unknowns<M> != 0, "equilibria: a model needs at least one unknown angle or coordinate");
    static_assert(empty, "equilibria: a model holds no data: what varies belongs into its parameters p");
    static_assert(!sizes || !empty || Model<M>,
                  "equilibria: a model needs `constexpr auto potential(const auto& theta, const auto& p) const`, or "
                  "`equations` with the same arguments (and `x` between them where n_coordinates > 0)");
}

}  // namespace equilibria
