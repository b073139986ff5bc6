/// \file
/// The homotopy from a start to a model at given parameters, as data.
#pragma once

#include <complex>
#include <cstring>
#include <memory>
#include <utility>

#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/system/model_system.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

namespace detail {

/// The model's own function at points, in lanes and alone.
template <Model M>
class ModelEquations : public OwnEquations {
public:
    explicit ModelEquations(const Parameters<M>& p) : p_(p) {}

    void at(int width, const double* c, const double* s, const double* x, double* f) const override {
        using Pack = Lanes<native_lanes>;
        int k = 0;
        for (; k + native_lanes <= width; k += native_lanes) evaluate<Pack>(width, k, c, s, x, f);
        for (; k < width; ++k) evaluate<double>(width, k, c, s, x, f);
    }

private:
    /// At points number k to k + (lanes of R).
    template <class R>
    void evaluate(int width, int k, const double* c, const double* s, const double* x, double* f) const {
        const auto number = [&](const double* from, int i) {
            Complex<R> z;
            std::memcpy(&z.re, from + 2 * i * width + k, sizeof(R));
            std::memcpy(&z.im, from + (2 * i + 1) * width + k, sizeof(R));
            return z;
        };
        AnglesOf<M, Complex<R>> theta;
        CoordinatesOf<M, Complex<R>> coordinates;
        for (int i = 0; i < n_angles<M>; ++i) theta[i] = {number(c, i), number(s, i)};
        for (int j = 0; j < n_coordinates<M>; ++j) coordinates[j] = number(x, j);
        const auto values = equations_at<M, Complex<R>>(theta, coordinates, p_);
        for (int i = 0; i < n_unknowns<M>; ++i) {
            const Complex<R> value = values[i];
            std::memcpy(f + 2 * i * width + k, &value.re, sizeof(R));
            std::memcpy(f + (2 * i + 1) * width + k, &value.im, sizeof(R));
        }
    }
    Parameters<M> p_;
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
    parts.own = std::make_shared<detail::ModelEquations<M>>(target.parameters);
    parts.degrees.assign(Formulation<M>::degrees.begin(), Formulation<M>::degrees.end());
    return PolynomialHomotopy(std::move(parts));
}

}  // namespace equilibria
