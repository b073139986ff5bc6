/// \file
/// Special pitchforks of the symmetric branches in a plane of two parameters, as solutions of a polynomial system:
/// where a curve of pitchforks has an extremal parameter, and where its pitchforks turn from super- to subcritical
/// (degenerate pitchforks, in which fold curves end).
///
/// On a branch theta in {0, pi}^n the equations are fulfilled. Unknowns: w (n - 1 numbers), then the active parameters
/// x, as in critical_system.hpp. Equations:
///     J v = 0,    v = B (1, w),    slice + sum_k extremal_k v . dJ/dx_k v + fourth V''''[v, v, v, v] = 0,
/// slice = s_0 + s_1 x_1 + s_2 x_2. The third derivatives of V vanish there, so that V'''' is the reduced fourth
/// derivative. At extremal_2 = 1 x_1 is extremal on the curve; the slice alone gives the pitchforks of a line.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/system/critical_system.hpp>
#include <equilibria/system/model_polynomials.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// The systems on the symmetric branches of a model with a potential, in the plane of the active parameters of its
/// critical system.
class SymmetricSystem {
public:
    /// The critical system, which has two active parameters, has to outlive it.
    explicit SymmetricSystem(const CriticalSystem& plane)
        : plane_(&plane), n_(plane.model().sizes().unknowns), sizes_(0, n_ + 1), grouping_(at(n_ + 1)) {
        for (int k = 0; k < 2; ++k) grouping_[at(first_active() + k)] = (n_ > 1 ? 1 : 0) + k;
    }

    /// What the equations depend on.
    struct Numbers {
        CriticalSystem::Numbers plane;     ///< parameters, scales and basis
        RuntimeArray<double> cosine;       ///< of the branch: 1 or -1
        std::array<double, 3> slice{};     ///< s_1, s_2, s_0
        std::array<double, 2> extremal{};  ///< weights of v . dJ/dx_k v
        double fourth = 0;                 ///< weight of V''''[v, v, v, v]
    };

    const CriticalSystem& plane() const { return *plane_; }  ///< the critical system that it was made from
    const RuntimeSizes& sizes() const { return sizes_; }     ///< no angles; the coordinates are w and x
    int first_active() const { return n_ - 1; }              ///< the coordinate x_1
    /// {w}, {x_1}, {x_2}
    const std::vector<int>& grouping() const { return grouping_; }

    /// The numbers for the branch theta = `branch`, of entries 0 or pi: random B and weights 0. scales: of the active
    /// parameters, positive.
    Numbers numbers(const RuntimeArray<double>& p, std::vector<double> scales, const RuntimeArray<double>& branch,
                    Generator& generator) const;

    /// The equations over the numbers C, from the model's (see CriticalSystem::equations).
    template <class C>
    RuntimePolynomials<C> equations(const Numbers& numbers, RuntimePolynomials<C> model) const {
        using Polynomial = RuntimePolynomial<C>;
        const int model_active = most_angles + plane_->first_active();
        const auto v = null_vector_polynomials<C>(numbers.plane.basis, 0);
        const auto f = plane_->entry().in_powers(std::move(model), plane_->first_active());
        RuntimePolynomials<C> y;
        Polynomial last(C(numbers.slice[2]));
        for (int k = 0; k < 2; ++k)
            if (numbers.slice[at(k)] != 0)
                last += Polynomial(C(numbers.slice[at(k)])) * coordinate_polynomial<C>(first_active() + k);
        for (int i = 0; i < n_; ++i) {
            const auto& equation = f[at(i)];
            const auto times_v = [&](const Polynomial& g, int order) {
                return order_along<C>(g, order, numbers.cosine, v) * v[at(i)];
            };
            y.push_back(plane_->entry().divided(order_along<C>(equation, 1, numbers.cosine, v), i, first_active()));
            if (numbers.fourth != 0) last += Polynomial(C(6 * numbers.fourth)) * times_v(equation, 3);
            for (int k = 0; k < 2; ++k)
                if (numbers.extremal[at(k)] != 0)
                    last += Polynomial(C(numbers.extremal[at(k)])) * times_v(derivative(equation, model_active + k), 1);
        }
        y.push_back(last);
        return y;
    }
    /// The same over doubles, from the model's polynomials at the numbers' parameters.
    RuntimePolynomials<> equations(const Numbers& numbers) const;
    /// The system to be solved.
    SparseSystem system(const Numbers& numbers) const { return sparse_system(equations(numbers), sizes_); }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    /// The coefficient of t^order of f at the branch + t v.
    template <class C>
    RuntimePolynomial<C> order_along(const RuntimePolynomial<C>& f, int order, const RuntimeArray<double>& cosine,
                                     const RuntimePolynomials<C>& v) const {
        RuntimePolynomial<C> sum;
        for (const auto& term : f.terms()) {
            RuntimePolynomials<C> series(at(order + 1));
            series[0] = RuntimePolynomial<C>(term.coefficient);
            for (int k = 0; k < 2; ++k)
                for (int m = 0; m < term.monomial.code(most_angles + plane_->first_active() + k); ++m)
                    series[0] *= coordinate_polynomial<C>(first_active() + k);
            for (int i = 0; i < n_; ++i)
                if (const int code = term.monomial.code(i); code != 0)
                    series = times_factor<C>(series, code, cosine[i], v[at(i)]);
            sum += series.back();
        }
        return sum;
    }
    /// The series in t times cos k(theta + v t), or sin, k = |code|, theta being 0 or pi with the given cosine.
    template <class C>
    static RuntimePolynomials<C> times_factor(const RuntimePolynomials<C>& series, int code, double cosine,
                                              const RuntimePolynomial<C>& v) {
        using Polynomial = RuntimePolynomial<C>;
        const int k = code < 0 ? -code : code, order = static_cast<int>(series.size()) - 1;
        RuntimePolynomials<C> product(series.size());
        Polynomial power(C(cosine < 0 && k % 2 == 1 ? -1.0 : 1.0));
        for (int m = 0; m <= order; ++m) {
            if (m > 0) power = power * v * Polynomial(C(k) / C(m));
            if ((m % 2 == 1) != (code < 0)) continue;
            for (int l = 0; l + m <= order; ++l) {
                const Polynomial part = series[at(l)] * power;
                product[at(l + m)] += m / 2 % 2 == 1 ? -part : part;
            }
        }
        return product;
    }

    const CriticalSystem* plane_;
    int n_;
    RuntimeSizes sizes_;
    std::vector<int> grouping_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/system/detail/symmetric_system_definitions.hpp>
#endif
