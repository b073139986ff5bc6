/// \file
/// The fold system of a model on a line of its parameter space, as a model of its own: what `enumerate` does for
/// equilibria it does for folds, all of them, with every path accounted for.
///
/// Unknowns: the model's, then w (n - 1 numbers), then the active parameter. Equations:
///     F(q, p) = 0,    J(q, p) v = 0,    v = B (1, w),
/// with a random basis B, so that no null vector is at infinity in w. Pitchforks on symmetric branches are singular
/// solutions of it; they are found on those branches (line_events.hpp). Source: math of Govaerts, Numerical Methods
/// for Bifurcations of Dynamical Equilibria, and Baillieul's section 3 for the example.
#pragma once

#include <vector>

#include <equilibria/algebra/symbolic.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// Active: the number of the parameter that becomes an unknown. Parameters p: the model's own (the active one is not
/// read), then the n x n entries of B, row by row.
template <Model M, int Active>
struct FoldModel {
    static_assert(Active >= 0 && Active < equilibria::n_parameters<M>, "equilibria: no such parameter");
    static constexpr int n = n_unknowns<M>;
    static constexpr int n_angles = equilibria::n_angles<M>;
    static constexpr int n_coordinates = equilibria::n_coordinates<M> + n;
    static constexpr int first_basis = equilibria::n_parameters<M>;
    static constexpr int n_parameters = first_basis + n * n;

    constexpr auto equations(const auto& theta, const auto& x, const auto& p) const {
        using S = scalar_of<decltype(theta)>;
        using D = Dual<S, 1>;
        Array<S, n> v;
        for (int i = 0; i < n; ++i) {
            v[i] = S(p[first_basis + i * n]);
            for (int k = 1; k < n; ++k)
                v[i] = v[i] + p[first_basis + i * n + k] * x[equilibria::n_coordinates<M> + k - 1];
        }
        detail::AnglesOf<M, D> angle;
        detail::CoordinatesOf<M, D> coordinate;
        for (int i = 0; i < n_angles; ++i) {
            angle[i].c.value = cos(theta[i]);
            angle[i].s.value = sin(theta[i]);
            angle[i].c.derivative[0] = -(angle[i].s.value * v[i]);
            angle[i].s.derivative[0] = angle[i].c.value * v[i];
        }
        for (int j = 0; j < equilibria::n_coordinates<M>; ++j) {
            coordinate[j].value = S(x[j]);
            coordinate[j].derivative[0] = v[n_angles + j];
        }
        Parameters<M, D> q;
        for (int k = 0; k < equilibria::n_parameters<M>; ++k) q[k].value = S(p[k]);
        q[Active].value = S(x[n_coordinates - 1]);
        const Unknowns<M, D> f = detail::equations_at<M, D>(angle, coordinate, q);
        Array<S, 2 * n> y;
        for (int i = 0; i < n; ++i) {
            y[i] = f[i].value;
            y[n + i] = f[i].derivative[0];
        }
        return y;
    }

    /// The same equations as polynomials, by symbolic differentiation of the model's own.
    template <class C>
    static constexpr auto polynomials(const Array<C, n_parameters>& p) {
        using Scalar = SymbolicScalar<n_angles, n_coordinates, C>;
        using Angle = SymbolicAngle<n_angles, n_coordinates, C>;
        using Polynomial = TrigonometricPolynomial<n_angles, n_coordinates, C>;
        const auto coordinate = [](int j) {
            return Polynomial(Polynomial::Basis::single(n_angles + j, 1), C(1));
        };
        typename Scalar::Pool pool;
        Array<Angle, n_angles> theta;
        Array<Scalar, equilibria::n_coordinates<M>> x;
        Array<Scalar, equilibria::n_parameters<M>> q;
        for (int i = 0; i < n_angles; ++i) theta[i] = Angle(&pool, i);
        for (int j = 0; j < x.size(); ++j) x[j] = Scalar(&pool, coordinate(j));
        for (int k = 0; k < q.size(); ++k) q[k] = Scalar(p[k]);
        q[Active] = Scalar(&pool, coordinate(n_coordinates - 1));
        std::vector<Polynomial> f;
        if constexpr (PotentialModel<M>) {
            const Polynomial v = Scalar(detail::call_potential(M{}, theta, x, q)).polynomial();
            for (int i = 0; i < n; ++i) f.push_back(derivative(v, i));
        } else {
            const auto values = detail::call_equations(M{}, theta, x, q);
            for (const auto& value : values) f.push_back(Scalar(value).polynomial());
        }
        std::vector<Polynomial> v;
        for (int i = 0; i < n; ++i) {
            Polynomial entry(p[first_basis + i * n]);
            for (int k = 1; k < n; ++k)
                entry += Polynomial(p[first_basis + i * n + k]) * coordinate(equilibria::n_coordinates<M> + k - 1);
            v.push_back(entry);
        }
        for (int i = 0; i < n; ++i) {
            Polynomial row;
            for (int k = 0; k < n; ++k)
                row += derivative(f[static_cast<std::size_t>(i)], k) * v[static_cast<std::size_t>(k)];
            f.push_back(row);
        }
        return f;
    }
};

}  // namespace equilibria
