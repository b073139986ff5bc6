/// \file
/// The curves of folds and of pitchforks in a plane of two parameters, as systems for the arc-length stepper, and the
/// normal-form coefficients that tell what kind a point is.
///
/// Fold curve, y = (q, v, p_x, p_y):        Pitchfork curve of a symmetric branch q = const, y = (v, p_x, p_y):
///     [ F(q, p)        ]                       [ J(q, p) v      ]
///     [ J(q, p) v      ] = 0                   [ (v . v - 1) / 2 ] = 0
///     [ (v . v - 1) / 2 ]
/// The fold curve is smooth at cusps, which are folds of its projection onto the plane.
/// Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria; math of the reduction in
/// `reduced_coefficients`.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/model/derivatives.hpp>

namespace equilibria {

template <Model M, int X, int Y>
struct FoldCurve {
    static constexpr int n = n_unknowns<M>;
    static constexpr int unknowns = 2 * n + 2;
    using Vector = Eigen::Matrix<double, unknowns, 1>;

    Parameters<M> parameters;  ///< entries X and Y are not read

    Unknowns<M> q(const Vector& y) const { return part(y, 0); }
    Unknowns<M> v(const Vector& y) const { return part(y, n); }
    Parameters<M> p(const Vector& y) const {
        Parameters<M> values = parameters;
        values[X] = y(2 * n);
        values[Y] = y(2 * n + 1);
        return values;
    }

    Eigen::Matrix<double, unknowns - 1, 1> residual(const Vector& y) const {
        Eigen::Matrix<double, unknowns - 1, 1> r;
        const auto f = equations<M, double>(q(y), p(y));
        for (int i = 0; i < n; ++i) r(i) = f[i];
        r.template segment<n>(n) = equilibria::jacobian<M, double>(q(y), p(y)) * y.template segment<n>(n);
        r(2 * n) = 0.5 * (y.template segment<n>(n).squaredNorm() - 1);
        return r;
    }
    Eigen::Matrix<double, unknowns - 1, unknowns> jacobian(const Vector& y) const {
        Eigen::Matrix<double, unknowns - 1, unknowns> j = Eigen::Matrix<double, unknowns - 1, unknowns>::Zero();
        const auto own = equilibria::jacobian<M, double>(q(y), p(y));
        const Eigen::Matrix<double, n, 1> null = y.template segment<n>(n);
        j.template block<n, n>(0, 0) = own;
        j.template block<n, n>(n, 0) = jacobian_derivative<M, double>(q(y), v(y), p(y));
        j.template block<n, n>(n, n) = own;
        j.template block<1, n>(2 * n, n) = null.transpose();
        const int active[2] = {X, Y};
        for (int a = 0; a < 2; ++a) {
            const auto fp = parameter_derivative<M, double>(q(y), p(y), active[a]);
            for (int i = 0; i < n; ++i) j(i, 2 * n + a) = fp[i];
            j.template block<n, 1>(n, 2 * n + a) =
                jacobian_parameter_derivative<M, double>(q(y), p(y), active[a]) * null;
        }
        return j;
    }

private:
    static Unknowns<M> part(const Vector& y, int first) {
        Unknowns<M> u;
        for (int i = 0; i < n; ++i) u[i] = y(first + i);
        return u;
    }
};

template <Model M, int X, int Y>
struct PitchforkCurve {
    static constexpr int n = n_unknowns<M>;
    static constexpr int unknowns = n + 2;
    using Vector = Eigen::Matrix<double, unknowns, 1>;

    Parameters<M> parameters;  ///< entries X and Y are not read
    Unknowns<M> branch;        ///< the symmetric equilibrium

    Parameters<M> p(const Vector& y) const {
        Parameters<M> values = parameters;
        values[X] = y(n);
        values[Y] = y(n + 1);
        return values;
    }
    Unknowns<M> v(const Vector& y) const {
        Unknowns<M> u;
        for (int i = 0; i < n; ++i) u[i] = y(i);
        return u;
    }

    Eigen::Matrix<double, unknowns - 1, 1> residual(const Vector& y) const {
        Eigen::Matrix<double, unknowns - 1, 1> r;
        r.template head<n>() = equilibria::jacobian<M, double>(branch, p(y)) * y.template head<n>();
        r(n) = 0.5 * (y.template head<n>().squaredNorm() - 1);
        return r;
    }
    Eigen::Matrix<double, unknowns - 1, unknowns> jacobian(const Vector& y) const {
        Eigen::Matrix<double, unknowns - 1, unknowns> j = Eigen::Matrix<double, unknowns - 1, unknowns>::Zero();
        const Eigen::Matrix<double, n, 1> null = y.template head<n>();
        j.template block<n, n>(0, 0) = equilibria::jacobian<M, double>(branch, p(y));
        j.template block<n, 1>(0, n) = jacobian_parameter_derivative<M, double>(branch, p(y), X) * null;
        j.template block<n, 1>(0, n + 1) = jacobian_parameter_derivative<M, double>(branch, p(y), Y) * null;
        j.template block<1, n>(n, 0) = null.transpose();
        return j;
    }
};

/// The Taylor coefficients of the reduced potential along the null vector v at a degenerate equilibrium (splitting
/// lemma): third = V'''[v,v,v], fourth = V''''[v^4] - 3 <V'''[v,v,.], J^+ V'''[v,v,.]>. For models with equations
/// only, the same with F and the left null vector in place of the last v.
///
/// third != 0: fold (A2). third = 0, fourth != 0: cusp (A3), or pitchfork where v is odd on a symmetric branch.
struct ReducedCoefficients {
    double third = 0, fourth = 0;
};

template <Model M>
ReducedCoefficients reduced_coefficients(const Unknowns<M>& q, const Unknowns<M>& v, const Parameters<M>& p) {
    constexpr int n = n_unknowns<M>;
    using Vector = Eigen::Matrix<double, n, 1>;
    const UnknownMatrix<M> j = jacobian<M, double>(q, p);
    Vector null, left;
    for (int i = 0; i < n; ++i) null(i) = v[i];
    // the bordered matrix [J, l; v^T, 0] is regular at a simple null space
    const auto bordered_solve = [&](const UnknownMatrix<M>& matrix, const Vector& l, const Vector& r, const Vector& b,
                                    double last) {
        Eigen::Matrix<double, n + 1, n + 1> m;
        m.template topLeftCorner<n, n>() = matrix;
        m.template topRightCorner<n, 1>() = l;
        m.template bottomLeftCorner<1, n>() = r.transpose();
        m(n, n) = 0;
        Eigen::Matrix<double, n + 1, 1> right;
        right << b, last;
        const Eigen::Matrix<double, n + 1, 1> y = m.partialPivLu().solve(right);
        return Vector(y.template head<n>());
    };
    if constexpr (PotentialModel<M>)
        left = null;
    else
        left = bordered_solve(j.transpose(), null, null, Vector::Zero(), 1).normalized();
    const auto second = directional_derivative<2, M, double>(q, v, p);
    const auto third = directional_derivative<3, M, double>(q, v, p);
    Vector f2, f3;
    for (int i = 0; i < n; ++i) f2(i) = second[i], f3(i) = third[i];
    const Vector projected = f2 - left.dot(f2) / left.squaredNorm() * left;
    const Vector z = bordered_solve(j, left, null, projected, 0);  // J z = f2 in the range, z orthogonal to v
    const UnknownMatrix<M> jv = jacobian_derivative<M, double>(q, v, p);
    return {left.dot(f2), left.dot(f3) - 3 * left.dot(jv * z)};
}

}  // namespace equilibria
