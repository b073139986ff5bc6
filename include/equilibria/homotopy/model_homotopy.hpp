/// \file
/// The homotopy from a start to a model at given parameters, as data.
#pragma once

#include <complex>
#include <cstring>
#include <memory>
#include <utility>

#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/model/runtime_model.hpp>
#include <equilibria/start/total_degree_start.hpp>
#include <equilibria/system/model_system.hpp>
#include <equilibria/system/runtime_formulation.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

namespace detail {

/// Numbers of OwnEquations::at, at points number `first` on, as many as R has lanes.
struct PointNumbers {
    int width, first;

    template <class R>
    void read(const double* from, int i, Complex<R>& z) const {
        std::memcpy(&z.re, from + 2 * i * width + first, sizeof(R));
        std::memcpy(&z.im, from + (2 * i + 1) * width + first, sizeof(R));
    }
    template <class R>
    void write(const Complex<R>& z, double* to, int i) const {
        std::memcpy(to + 2 * i * width + first, &z.re, sizeof(R));
        std::memcpy(to + (2 * i + 1) * width + first, &z.im, sizeof(R));
    }
};

/// Of a model `Of`: point<Z>() makes a point (theta, x) of it, values(point) are its equations there.
template <class Of>
class OwnEquationsOf final : public OwnEquations {
public:
    explicit OwnEquationsOf(Of of) : of_(std::move(of)) {}

    void at(int width, const double* c, const double* s, const double* x, double* f) const override {
        const auto some = [&]<class R>(R, int first) {
            const PointNumbers numbers{width, first};
            auto point = of_.template point<Complex<R>>();
            const int angles = point.theta.size(), coordinates = point.x.size();
            for (int i = 0; i < angles; ++i) numbers.read(c, i, point.theta[i].c), numbers.read(s, i, point.theta[i].s);
            for (int j = 0; j < coordinates; ++j) numbers.read(x, j, point.x[j]);
            const auto values = of_.values(point);
            for (int i = 0; i < angles + coordinates; ++i) numbers.write(values[i], f, i);
        };
        int k = 0;
        for (; k + native_lanes <= width; k += native_lanes) some(Lanes<native_lanes>{}, k);
        for (; k < width; ++k) some(0.0, k);
    }

private:
    Of of_;
};

template <Model M>
struct ModelValues {
    Parameters<M> p;

    template <class Z>
    struct Point {
        AnglesOf<M, Z> theta;
        CoordinatesOf<M, Z> x;
    };
    template <class Z>
    Point<Z> point() const {
        return {};
    }
    template <class Z>
    Unknowns<M, Z> values(const Point<Z>& at) const {
        return equations_at<M, Z>(at.theta, at.x, p);
    }
};
template <RuntimeModel T>
struct RuntimeModelValues {
    T model;
    RuntimeSizes sizes;
    RuntimeArray<double> p;

    template <class Z>
    RuntimeModelPoint<Z> point() const {
        return RuntimeModelPoint<Z>(sizes);
    }
    template <class Z>
    LocalArray<Z> values(const RuntimeModelPoint<Z>& at) const {
        LocalArray<Z> f(sizes.unknowns);
        equations_at(model, at.theta, at.x, p, f.begin());
        return f;
    }
};

}  // namespace detail

/// From a start of the model (TotalDegree, Reflected, Moving). What is polished is a solution of the model's own
/// function, the equations that the user wrote, not of its polynomial form.
template <Model M, class StartSystem>
PolynomialHomotopy model_homotopy(const ModelSystem<M>& target, const StartSystem& start) {
    PolynomialHomotopy::Parts parts{.sizes = Sizes<M>(), .terms = {}, .from = {}, .forms = {}, .scale = {}};
    parts.terms.reserve(Formulation<M>::terms);
    for (int k = 0; k < Formulation<M>::terms; ++k) {
        const auto& term = Formulation<M>::support[k];
        parts.terms.push_back({term.equation, sparse_monomial(term.monomial), target.coefficients[k]});
        if constexpr (StartSystem::moving) parts.from.push_back(start.from(k));
    }
    if constexpr (!StartSystem::moving) parts.forms.terms = start.system().terms();
    parts.scale.assign(target.scale.begin(), target.scale.end());
    // with a potential the Jacobian is complex symmetric
    parts.symmetric = Formulation<M>::has_potential;
    parts.own =
        std::make_shared<detail::OwnEquationsOf<detail::ModelValues<M>>>(detail::ModelValues<M>{target.parameters});
    parts.degrees.assign(Formulation<M>::degrees.begin(), Formulation<M>::degrees.end());
    return PolynomialHomotopy(std::move(parts));
}

/// The same of a model at run time, from a start of such a model.
template <RuntimeModel T>
PolynomialHomotopy model_homotopy(const T& model, const RuntimeModelSystem& target, const TotalDegreeStart& start) {
    return PolynomialHomotopy(
        {.sizes = target.formulation->sizes(),
         .terms = target.terms,
         .from = {},
         .forms = {.terms = start.system().terms(), .products = {}},
         .scale = target.scale,
         .symmetric = target.formulation->has_potential(),
         .own = std::make_shared<detail::OwnEquationsOf<detail::RuntimeModelValues<T>>>(
             detail::RuntimeModelValues<T>{model, target.formulation->sizes(), target.parameters}),
         .degrees = target.formulation->degrees()});
}

}  // namespace equilibria
