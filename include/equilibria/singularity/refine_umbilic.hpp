/// \file
/// Umbilics, the points of corank 2 in three parameters, by Newton's method in
///
///     F(q, p) = 0,    C = 0,    J X = W C,    W^T X = I,
///
/// where the reduced 2 x 2 Hessian C is that of the bordering by an orthonormal basis W of the weakest plane. What
/// names them is the cubic of the potential on the null space. Where it fails: singularity_newton.hpp.
/// Source: Arnold, Gusein-Zade and Varchenko, Singularities of Differentiable Maps I (D_4).
#pragma once

#include <cmath>
#include <vector>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_evidence.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria {

namespace detail {

/// The discriminant of a x^3 + 3 b x^2 y + 3 c x y^2 + d y^3, over 27 and the rotation-invariant norm^4.
template <class S>
double cubic_discriminant(const Array<S, 4>& cubic) {
    const auto [a, b, c, d] = to_double(cubic).elements;
    const double square = a * a + 3 * b * b + 3 * c * c + d * d;
    if (!(square > 0)) return 0;
    return (3 * b * b * c * c - 4 * a * c * c * c - 4 * b * b * b * d - a * a * d * d + 6 * a * b * c * d) /
           (square * square);
}

/// F and the three entries of C, with W, in y = (q, p_X, p_Y, p_Z).
template <PotentialModel M, class S, int X, int Y, int Z>
class UmbilicSystem {
public:
    static constexpr int n = n_unknowns<M>, size = n + 3;
    using Vector = Array<S, size>;
    using Plane = Array<Unknowns<M, S>, 2>;

    UmbilicSystem(const Parameters<M, S>& p, const Array<Unknowns<M>, 2>& weakest) : p_(p) {
        for (int c = 0; c < 2; ++c) w_[c] = in_digits_of<S>(weakest[c]);
    }

    Vector packed(const Unknowns<M, S>& q) const {
        Vector y;
        for (int i = 0; i < n; ++i) y[i] = q[i];
        y[n] = p_[X], y[n + 1] = p_[Y], y[n + 2] = p_[Z];
        return y;
    }
    Parameters<M, S> parameters(const Vector& y) const { return lifted_with_active<X, Y, Z>(p_, y, n); }

    /// The equations r and their Jacobian at y; the plane W becomes that of X there.
    bool operator()(const Vector& y, Vector& r, SquareArray<S, size>& jacobian) {
        using D = Dual<S, size>;
        const Array<D, size> u = independent(y);
        Unknowns<M, D> q;
        for (int i = 0; i < n; ++i) q[i] = u[i];
        const auto p = lifted_with_active<X, Y, Z>(p_, u, n);
        const auto force = equations<M, D>(q, p);
        const DenseFactorization<D, n + 2> factors(bordered<D>(q, p));
        if (!factors.regular()) return false;
        Array<Array<D, n + 2>, 2> x_and_c;  // X over C, by columns
        for (int c = 0; c < 2; ++c) {
            x_and_c[c][n + c] = D(1.0);
            x_and_c[c] = factors.solve(x_and_c[c]);
        }
        Array<D, size> f;
        for (int i = 0; i < n; ++i) f[i] = force[i];
        f[n] = x_and_c[0][n], f[n + 1] = x_and_c[1][n], f[n + 2] = x_and_c[1][n + 1];
        split_duals(f, r, jacobian);
        jacobian_ = jacobian;
        for (int c = 0; c < 2; ++c)
            for (int i = 0; i < n; ++i) w_[c][i] = x_and_c[c][i].value;
        orthonormalize();
        return true;
    }

    const Plane& plane() const { return w_; }
    double versality() const {
        const std::vector<RuntimeArray<double>> w{runtime_array(to_double(w_[0])), runtime_array(to_double(w_[1]))};
        RuntimeMatrix<double> j(size);
        for (int r = 0; r < size; ++r)
            for (int c = 0; c < size; ++c) j[r][c] = to_double(jacobian_[r][c]);
        return detail::versality(j, n, w, w);
    }

private:
    /// [ J  -W ]
    /// [ W^T 0 ]
    template <class D>
    SquareArray<D, n + 2> bordered(const Unknowns<M, D>& q, const Parameters<M, D>& p) const {
        const auto hessian = equilibria::jacobian<M, D>(q, p);
        SquareArray<D, n + 2> y;
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) y[i][j] = hessian(i, j);
            for (int c = 0; c < 2; ++c) y[i][n + c] = D(-w_[c][i]), y[n + c][i] = D(w_[c][i]);
        }
        return y;
    }
    void orthonormalize() {
        w_[0] = normalized(w_[0]);
        const S along = dot(w_[0], w_[1]);
        for (int i = 0; i < n; ++i) w_[1][i] = w_[1][i] - along * w_[0][i];
        w_[1] = normalized(w_[1]);
    }

    Parameters<M, S> p_;
    Plane w_;
    SquareArray<S, size> jacobian_;
};

/// The cubic on the plane of v and w, its discriminant, the nullity, and the kind.
template <PotentialModel M, class S>
void name_umbilic(Singularity<M, S>& at) {
    const auto vv = directional_derivative<2, M, S>(at.q, at.v, at.p);
    const auto ww = directional_derivative<2, M, S>(at.q, at.w, at.p);
    at.cubic = {dot(vv, at.v), dot(vv, at.w), dot(ww, at.v), dot(ww, at.w)};
    at.discriminant = cubic_discriminant(at.cubic);
    at.nullity = nullity<M>(jacobian<M>(to_double(at.q), to_double(at.p)), to_double(largest(at.cubic)));
    if (at.converged && at.nullity == 2 && std::abs(at.discriminant) > 1e-8)
        at.kind = at.discriminant > 0 ? SingularityKind::elliptic_umbilic : SingularityKind::hyperbolic_umbilic;
}

}  // namespace detail

/// The umbilic near q (radians, coordinates) and p, corank 2, in the parameters number X, Y and Z; named by the
/// discriminant of its cubic. Throws InvalidArgument for arguments that are not finite. Source:
/// Arnold, Gusein-Zade and Varchenko, Singularities of Differentiable Maps I (D_4).
template <PotentialModel M, int X, int Y, int Z, class S = double>
requires(n_unknowns<M> >= 2)
Singularity<M, S> refine_umbilic(const Unknowns<M>& q, const Parameters<M, S>& p) {
    require_finite(q, "q");
    require_finite(p, "p");
    auto at = singularity_at<M, X, Y, Z>(SingularityKind::undecided, detail::in_digits_of<S>(q), p);
    using System = detail::UmbilicSystem<M, S, X, Y, Z>;
    System system(p, null_vectors<2, M>(jacobian<M>(q, detail::to_double(p))));
    auto y = system.packed(at.q);
    detail::newton_method(y, at, system);
    if (!(at.correction < S(1e3))) return at;
    const double versality = system.versality();
    typename System::Vector r;
    detail::SquareArray<S, System::size> jacobian;
    if (!system(y, r, jacobian)) at.converged = false;
    at.residual = detail::largest(r);
    for (int i = 0; i < System::n; ++i) at.q[i] = y[i];
    at.p = system.parameters(y);
    at.v = system.plane()[0];
    at.w = system.plane()[1];
    detail::name_umbilic(at);
    at.versality = versality;
    return at;
}

}  // namespace equilibria
