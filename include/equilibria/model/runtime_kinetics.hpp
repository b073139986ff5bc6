/// \file
/// Models at run time (runtime_model.hpp) that move: beside `potential` they have the functions of kinetics.hpp, with
/// the arguments that are theirs there. Coordinates x follow theta where the model has a function `coordinates()`. v
/// has as many entries as there are unknowns; `generalised_forces` returns anything with `size()` and `[i]`, one an
/// unknown.
///
/// \code
/// struct Row {  // of equal pendulums with friction
///     int n;
///     int angles() const { return n; }
///     int parameters() const { return 1; }
///     auto potential(const auto& theta, const auto&) const {
///         equilibria::scalar_of<decltype(theta)> u{};
///         for (int i = 0; i < n; ++i) u -= cos(theta[i]);
///         return u;
///     }
///     auto kinetic_energy(const auto&, const auto& v, const auto&) const {
///         auto t = 0.5 * v[0] * v[0];
///         for (int i = 1; i < n; ++i) t += 0.5 * v[i] * v[i];
///         return t;
///     }
///     auto dissipation(const auto&, const auto& v, const auto& p) const { return p[0] * v[0] * v[0]; }
/// };
/// const auto motion = integrate_motion(LagrangeSecondKind<RuntimeUnknowns>(kinetic_functions(Row{3}), {0.1}), ...);
/// \endcode
#pragma once

#include <memory>
#include <string>

#include <Eigen/Core>

#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/local_array.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/kinetic_functions.hpp>
#include <equilibria/model/kinetics.hpp>
#include <equilibria/model/runtime_model.hpp>

namespace equilibria {

/// A model at run time with a potential and a kinetic energy.
template <class T>
concept RuntimeDynamicModel = RuntimePotentialModel<T> && detail::has_kinetic_energy<T>();

namespace detail {

/// Rates as variables, as many at once as there are directions.
template <class S>
struct DirectedRates {
    static constexpr int directions = 4;
    using D = Dual<S, directions>;
    LocalArray<D> v;

    explicit DirectedRates(const LocalArray<S>& rates) : v(rates.size()) {
        for (int i = 0; i < v.size(); ++i) v[i].value = rates[i];
    }
    /// Rate number first + d becomes the variable of direction d, and those before it variables no longer.
    void vary(int first) {
        for (int d = 0; d < directions; ++d) {
            if (const int u = first - directions + d; u >= 0) v[u].derivative[d] = S(0.0);
            if (const int u = first + d; u < v.size()) v[u].derivative[d] = S(1.0);
        }
    }
};

/// A place whose unknowns are constants of the scalar D.
template <class D, class S>
RuntimeModelPoint<D> constant_point(const RuntimeModelPoint<S>& at) {
    RuntimeModelPoint<D> y(RuntimeSizes(at.theta.size(), at.x.size()));
    for (int i = 0; i < y.theta.size(); ++i) y.theta[i] = {D(at.theta[i].c), D(at.theta[i].s)};
    for (int j = 0; j < y.x.size(); ++j) y.x[j] = D(at.x[j]);
    return y;
}
template <class D, class Values>
LocalArray<D> constants_of(const Values& values) {
    LocalArray<D> y(values.size());
    for (int i = 0; i < y.size(); ++i) y[i] = D(values[i]);
    return y;
}

}  // namespace detail

/// The functions of a model of type T.
template <RuntimeDynamicModel T>
class RuntimeKineticFunctions final : public KineticFunctions {
    using Array = RuntimeArray<double>;
    using Vector = Eigen::VectorXd;
    using Matrix = Eigen::MatrixXd;
    using Directed = detail::DirectedRates<double>::D;

public:
    /// The model is copied. Throws InvalidArgument as sizes_of does.
    explicit RuntimeKineticFunctions(const T& model)
        : KineticFunctions(sizes_of(model), model.parameters()), model_(model) {}

    /// As of KineticFunctions; derivatives by duals of four directions at a time.
    /// \{
    double potential(const Array& q, const Array& p) const override {
        const RuntimeModelPoint<double> at(q.begin(), sizes());
        return static_cast<double>(detail::call_runtime_potential(model_, at.theta, at.x, p));
    }
    Vector gradient(const Array& q, const Array& p) const override {
        const RuntimeModelPoint<double> at(q.begin(), sizes());
        Vector y(unknowns());
        equations_at(model_, at.theta, at.x, p, y.data());
        return y;
    }
    Matrix hessian(const Array& q, const Array& p) const override {
        const RuntimeModelPoint<double> at(q.begin(), sizes());
        Vector f(unknowns());
        Matrix y(unknowns(), unknowns());  // symmetric: rows or columns first
        equations_and_jacobian(model_, at.theta, at.x, p, f.data(), y.data());
        return y;
    }
    double kinetic_energy(const Array& q, const Array& v, const Array& p) const override {
        return kinetic<double>(RuntimeModelPoint<double>(q.begin(), sizes()), detail::constants_of<double>(v), p);
    }
    Vector momenta(const Array& q, const Array& v, const Array& p) const override {
        return by_rates<double>(RuntimeModelPoint<double>(q.begin(), sizes()), detail::constants_of<double>(v),
                                [&](const auto& at, const auto& rates) { return kinetic<Directed>(at, rates, p); });
    }
    Vector kinetic_gradient(const Array& q, const Array& v, const Array& p) const override {
        const RuntimeModelPoint<double> at(q.begin(), sizes());
        const auto rates = detail::constants_of<Directed>(v);
        detail::DirectedUnknowns<double> directed(at.theta, at.x);
        Vector y(unknowns());
        for (int first = 0; first < unknowns(); first += directed.directions) {
            directed.vary(first);
            const Directed energy = kinetic<Directed>(directed, rates, p);
            for (int d = 0; d < directed.directions && first + d < unknowns(); ++d) y[first + d] = energy.derivative[d];
        }
        return y;
    }
    Vector convective_forces(const Array& q, const Array& v, const Array& p) const override {
        using Along = Dual<double, 1>;  // along the motion: q + e v
        using D = detail::DirectedRates<Along>::D;
        LocalArray<Along> moved(unknowns());
        for (int i = 0; i < unknowns(); ++i) moved[i] = Along(q[i]), moved[i].derivative[0] = v[i];
        Vector y = -kinetic_gradient(q, v, p);
        by_rates<Along>(
            RuntimeModelPoint<Along>(moved.begin(), sizes()), detail::constants_of<Along>(v),
            [&](const auto& at, const auto& rates) { return kinetic<D>(at, rates, p); },
            [&](int i, const Along& momentum) { y[i] += momentum.derivative[0]; });
        return y;
    }
    Vector dissipation_gradient(const Array& q, const Array& v, const Array& p) const override {
        if constexpr (!detail::has_dissipation<T>())
            return Vector::Zero(unknowns());
        else
            return by_rates<double>(
                RuntimeModelPoint<double>(q.begin(), sizes()), detail::constants_of<double>(v),
                [&](const auto& at, const auto& rates) { return dissipated<Directed>(at, rates, p); });
    }
    Vector generalised_forces(double t, const Array& q, const Array& v, const Array& p) const override {
        Vector y = Vector::Zero(unknowns());
        forces<double>(t, RuntimeModelPoint<double>(q.begin(), sizes()), detail::constants_of<double>(v), p,
                       [&](int i, double force) { y[i] = force; });
        return y;
    }
    void linearize_forces(double t, const Array& q, const Array& p, Matrix& damping, Matrix& slope) const override {
        const int n = unknowns();
        const RuntimeModelPoint<double> at(q.begin(), sizes());
        damping = slope = Matrix::Zero(n, n);
        const auto fixed = detail::constant_point<Directed>(at);
        const LocalArray<Directed> rest(n);
        detail::DirectedRates<double> rates((LocalArray<double>(n)));
        detail::DirectedUnknowns<double> directed(at.theta, at.x);
        for (int first = 0; first < n; first += directed.directions) {
            const auto for_each = [&](const auto& write) {
                for (int d = 0; d < directed.directions && first + d < n; ++d) write(first + d, d);
            };
            rates.vary(first);
            directed.vary(first);
            forces<Directed>(t, fixed, rates.v, p, [&](int i, const Directed& force) {
                for_each([&](int k, int d) { damping(i, k) -= force.derivative[d]; });
            });
            forces<Directed>(t, directed, rest, p, [&](int i, const Directed& force) {
                for_each([&](int k, int d) { slope(i, k) = force.derivative[d]; });
            });
            if constexpr (detail::has_dissipation<T>()) {
                using D = detail::DirectedRates<Directed>::D;
                by_rates<Directed>(
                    fixed, rates.v, [&](const auto& place, const auto& v) { return dissipated<D>(place, v, p); },
                    [&](int i, const Directed& force) {
                        for_each([&](int k, int d) { damping(i, k) += force.derivative[d]; });
                    });
            }
        }
    }
    /// \}

private:
    /// f(theta, ..), or f(theta, x, ..) where the model says that it has coordinates.
    template <class At, class F>
    static auto called(const At& at, const F& f) {
        if constexpr (detail::HasRuntimeCoordinates<T>)
            return f(at.theta, at.x);
        else
            return f(at.theta);
    }
    template <class S, class At, class P>
    S kinetic(const At& at, const LocalArray<S>& v, const P& p) const {
        return called(at, [&](const auto&... place) {
            static_assert(
                requires { model_.kinetic_energy(place..., v, p); },
                "equilibria: kinetic_energy must be callable as kinetic_energy(theta, v, p), with the "
                "coordinates x after theta where the model has coordinates()");
            return S(model_.kinetic_energy(place..., v, p));
        });
    }
    template <class S, class At, class P>
    S dissipated(const At& at, const LocalArray<S>& v, const P& p) const {
        return called(at, [&](const auto&... place) {
            static_assert(
                requires { model_.dissipation(place..., v, p); },
                "equilibria: dissipation must be callable as dissipation(theta, v, p), with the coordinates "
                "x after theta where the model has coordinates()");
            return S(model_.dissipation(place..., v, p));
        });
    }
    /// take(i, force) of each unknown; not called for models without forces.
    template <class S, class At, class P, class Take>
    void forces(double t, const At& at, const LocalArray<S>& v, const P& p, const Take& take) const {
        if constexpr (detail::has_generalised_forces<T>()) {
            const auto values = called(at, [&](const auto&... place) {
                static_assert(
                    requires { model_.generalised_forces(t, place..., v, p); },
                    "equilibria: generalised_forces must be callable as generalised_forces(t, theta, v, p), "
                    "with the coordinates x after theta where the model has coordinates()");
                return model_.generalised_forces(t, place..., v, p);
            });
            require(static_cast<int>(values.size()) == unknowns(), "model.generalised_forces(..).size()", values.size(),
                    "must be one for each unknown angle and coordinate");
            for (int i = 0; i < unknowns(); ++i) take(i, S(values[static_cast<decltype(values.size())>(i)]));
        }
    }
    /// take(i, df/dv_i) of each unknown.
    template <class S, class F, class Take>
    void by_rates(const RuntimeModelPoint<S>& at, const LocalArray<S>& v, const F& f, const Take& take) const {
        using Rates = detail::DirectedRates<S>;
        const auto fixed = detail::constant_point<typename Rates::D>(at);
        Rates rates(v);
        for (int first = 0; first < unknowns(); first += Rates::directions) {
            rates.vary(first);
            const typename Rates::D value = f(fixed, rates.v);
            for (int d = 0; d < Rates::directions && first + d < unknowns(); ++d) take(first + d, value.derivative[d]);
        }
    }
    template <class S, class F>
    Vector by_rates(const RuntimeModelPoint<S>& at, const LocalArray<S>& v, const F& f) const {
        Vector y(unknowns());
        by_rates(at, v, f, [&](int i, const S& derivative) { y[i] = derivative; });
        return y;
    }

    T model_;
};

/// The functions of a model that moves, for the formulations of its motion.
template <RuntimeDynamicModel T>
std::shared_ptr<const KineticFunctions> kinetic_functions(const T& model) {
    return std::make_shared<const RuntimeKineticFunctions<T>>(model);
}

}  // namespace equilibria
