/// \file
/// Models whose numbers of angles, coordinates and parameters are known at run time alone. They are objects: what a
/// Model says by constants of its type, they say by functions, and they may hold data.
///
/// \code
/// struct Row {  // of equal pendulums, coupled to their neighbours
///     int n;
///     int angles() const { return n; }
///     int parameters() const { return 1; }
///     auto potential(const auto& theta, const auto& p) const {
///         equilibria::scalar_of<decltype(theta)> v{};
///         for (int i = 0; i < n; ++i) v -= cos(theta[i]);
///         for (int i = 1; i < n; ++i) v -= p[0] * cos(theta[i] - theta[i - 1]);
///         return v;
///     }
/// };
/// \endcode
///
/// - `angles()`, `parameters()`: how many there are, the same in each call.
/// - `coordinates()` (optional, 0): plain unknowns; they come as `x[j]`, a second argument.
/// - `potential(theta, p)`; or `equations(theta, p)`: anything with `size()` and `[i]`, of as many scalars as there are
///   unknowns.
///
/// The function is const and draws no conclusions from values, as a Model's, but need not be constexpr: what it is, is
/// found out when it is called.
#pragma once

#include <cmath>
#include <concepts>
#include <iterator>
#include <type_traits>

#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/local_array.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/angle.hpp>
#include <equilibria/model/model.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

namespace detail {

template <class T>
concept HasRuntimeCoordinates = requires(const T& model) {
    { model.coordinates() } -> std::convertible_to<int>;
};
template <class T, class Theta, class X, class P>
concept RuntimePotentialOf = requires(const T& model, const Theta& theta, const X& x, const P& p) {
    requires HasRuntimeCoordinates<T> || requires { model.potential(theta, p); };
    requires !HasRuntimeCoordinates<T> || requires { model.potential(theta, x, p); };
};
template <class T, class Theta, class X, class P>
concept RuntimeEquationsOf = requires(const T& model, const Theta& theta, const X& x, const P& p) {
    requires HasRuntimeCoordinates<T> || requires { model.equations(theta, p); };
    requires !HasRuntimeCoordinates<T> || requires { model.equations(theta, x, p); };
};
template <class T>
concept RuntimeModelSizes = requires(const T& model) {
    { model.angles() } -> std::convertible_to<int>;
    { model.parameters() } -> std::convertible_to<int>;
};

}  // namespace detail

/// A model at run time that gives a potential, checked with real scalars.
template <class T>
concept RuntimePotentialModel =
    detail::RuntimeModelSizes<T> &&
    detail::RuntimePotentialOf<T, RuntimeArray<CircleAngle<double>>, RuntimeArray<double>, RuntimeArray<double>>;
/// One that gives its equations.
template <class T>
concept RuntimeEquationsModel =
    detail::RuntimeModelSizes<T> && !RuntimePotentialModel<T> &&
    detail::RuntimeEquationsOf<T, RuntimeArray<CircleAngle<double>>, RuntimeArray<double>, RuntimeArray<double>>;
/// Anything that the library accepts as a model at run time.
template <class T>
concept RuntimeModel = RuntimePotentialModel<T> || RuntimeEquationsModel<T>;

/// The numbers of unknowns of a model at run time. Throws InvalidArgument where one of them is negative, or all are 0.
template <RuntimeModel T>
RuntimeSizes sizes_of(const T& model) {
    const int angles = model.angles();
    int coordinates = 0;
    if constexpr (detail::HasRuntimeCoordinates<T>) coordinates = model.coordinates();
    require(angles >= 0, "model.angles()", angles, "must not be negative");
    require(coordinates >= 0, "model.coordinates()", coordinates, "must not be negative");
    require(model.parameters() >= 0, "model.parameters()", model.parameters(), "must not be negative");
    require(angles + coordinates > 0, "model", "no unknowns", "needs at least one unknown angle or coordinate");
    return {angles, coordinates};
}

namespace detail {

template <class T, class Theta, class X, class P>
auto call_runtime_potential(const T& model, const Theta& theta, const X& x, const P& p) {
    const auto value = [&] {
        if constexpr (HasRuntimeCoordinates<T>)
            return model.potential(theta, x, p);
        else
            return model.potential(theta, p);
    }();
    static_assert(!AngleLike<decltype(value)>,
                  "equilibria: potential must return a scalar, and angles enter it only inside sin and cos: this one "
                  "returns an angle");
    return value;
}
/// Throws InvalidArgument where there are not as many equations as unknowns.
template <class T, class Theta, class X, class P>
auto call_runtime_equations(const T& model, const Theta& theta, const X& x, const P& p) {
    auto values = [&] {
        if constexpr (HasRuntimeCoordinates<T>)
            return model.equations(theta, x, p);
        else
            return model.equations(theta, p);
    }();
    require(static_cast<int>(values.size()) == theta.size() + x.size(), "model.equations(..).size()", values.size(),
            "must be one for each unknown angle and coordinate");
    return values;
}

/// Unknowns as variables, as many at once as there are directions.
template <class S>
struct DirectedUnknowns {
    static constexpr int directions = 4;
    using D = Dual<S, directions>;
    LocalArray<CircleAngle<D>> theta;
    LocalArray<D> x;

    DirectedUnknowns(const LocalArray<CircleAngle<S>>& angles, const LocalArray<S>& coordinates)
        : theta(angles.size()), x(coordinates.size()) {
        for (int i = 0; i < theta.size(); ++i) theta[i].c.value = angles[i].c, theta[i].s.value = angles[i].s;
        for (int j = 0; j < x.size(); ++j) x[j].value = coordinates[j];
    }
    /// Unknown number first + d becomes the variable of direction d, and those before it variables no longer.
    void vary(int first) {
        const int angles = theta.size(), n = angles + x.size();
        for (int d = 0; d < directions; ++d) {
            if (const int u = first - directions + d; u >= 0) set(u, d, S(0.0), S(0.0), S(0.0));
            if (const int u = first + d; u < n)
                u < angles ? set(u, d, -theta[u].s.value, theta[u].c.value, S(0.0)) : set(u, d, S(0.0), S(0.0), S(1.0));
        }
    }

private:
    void set(int u, int d, const S& of_cosine, const S& of_sine, const S& of_coordinate) {
        if (u < theta.size())
            theta[u].c.derivative[d] = of_cosine, theta[u].s.derivative[d] = of_sine;
        else
            x[u - theta.size()].derivative[d] = of_coordinate;
    }
};

/// Parameters as a scalar of the function has to be: plain numbers, and what is such a scalar, as they are.
template <class S, class P>
decltype(auto) lifted(const P& p) {
    using Number = std::remove_cvref_t<decltype(p[0])>;
    if constexpr (std::is_arithmetic_v<Number> || std::is_same_v<Number, S>) {
        return (p);
    } else {
        LocalArray<S> y(p.size());
        for (int k = 0; k < p.size(); ++k) y[k] = S(p[k]);
        return y;
    }
}

}  // namespace detail

/// Unknowns, angles in radians and then coordinates, as points of the circles and coordinates.
template <class S>
struct RuntimeModelPoint {
    LocalArray<CircleAngle<S>> theta;  ///< points of the angles
    LocalArray<S> x;                   ///< coordinates

    /// Room for so many unknowns, value-initialised.
    explicit RuntimeModelPoint(const RuntimeSizes& sizes) : theta(sizes.angles), x(sizes.coordinates) {}
    /// Of the unknowns q, as many as sizes.unknowns.
    RuntimeModelPoint(const S* q, const RuntimeSizes& sizes) : RuntimeModelPoint(sizes) {
        using std::cos, std::sin;
        for (int i = 0; i < sizes.angles; ++i) theta[i] = {S(cos(q[i])), S(sin(q[i]))};
        for (int j = 0; j < sizes.coordinates; ++j) x[j] = q[sizes.angles + j];
    }
};

/// The equations at points (c, s) of the circles and coordinates: the gradient of the potential, by automatic
/// differentiation, where there is one. p: an array of numbers, or of scalars S. f: an entry an unknown, written.
template <RuntimeModel T, class S, class P>
void equations_at(const T& model, const LocalArray<CircleAngle<S>>& theta, const LocalArray<S>& x, const P& p, S* f) {
    const int n = theta.size() + x.size();
    if constexpr (RuntimePotentialModel<T>) {
        using Directed = detail::DirectedUnknowns<S>;
        const auto& parameters = detail::lifted<typename Directed::D>(p);
        Directed at(theta, x);
        for (int first = 0; first < n; first += Directed::directions) {
            at.vary(first);
            const typename Directed::D v = detail::call_runtime_potential(model, at.theta, at.x, parameters);
            for (int d = 0; d < Directed::directions && first + d < n; ++d) f[first + d] = v.derivative[d];
        }
    } else {
        const auto values = detail::call_runtime_equations(model, theta, x, p);
        for (int i = 0; i < n; ++i) f[i] = S(std::begin(values)[i]);
    }
}

/// F and its Jacobian, row after row, written: jacobian[r n + c] = dF_r / dq_c.
template <RuntimeModel T, class S, class P>
void equations_and_jacobian(const T& model, const LocalArray<CircleAngle<S>>& theta, const LocalArray<S>& x, const P& p,
                            S* f, S* jacobian) {
    using Directed = detail::DirectedUnknowns<S>;
    const auto& parameters = detail::lifted<typename Directed::D>(p);
    const int n = theta.size() + x.size();
    LocalArray<typename Directed::D> values(n);
    Directed at(theta, x);
    for (int first = 0; first < n; first += Directed::directions) {
        at.vary(first);
        equations_at(model, at.theta, at.x, parameters, values.begin());
        for (int r = 0; r < n; ++r) {
            f[r] = values[r].value;
            for (int d = 0; d < Directed::directions && first + d < n; ++d)
                jacobian[r * n + first + d] = values[r].derivative[d];
        }
    }
}

}  // namespace equilibria
