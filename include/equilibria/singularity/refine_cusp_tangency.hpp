/// \file
/// Lips and beak-to-beak: where a curve of cusps in three parameters x, y, z is tangent to a plane z = const, by
/// Newton's method in Y = (q, v, x, y), z and mu,
///
///     G = (F, J v, (v . v - 1) / 2) = 0,    mu^T dG/dY = 0,    mu . mu = 1.
///
/// The equations say that z is stationary on the surface of folds G = 0; its second-order form there,
///
///     d2 z [t, t] = -mu^T G_YY[t, t] / mu^T G_z,    t in the kernel of dG/dY,
///
/// names the point. Where it fails: singularity_newton.hpp. Where the third derivative is not 0, or the fourth is 0
/// (swallowtails, at which the curve turns in z as well), the kind is `undecided`. Sources: Arnold, Catastrophe Theory,
/// chapter 9; Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/singular_values.hpp>
#include <equilibria/core/taylor.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_evidence.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria {

namespace detail {

/// The stationary points of z on the surface of folds: unknowns (q, v, x, y, z), of which Y is all but z, then mu.
template <PotentialModel M, class S, int X, int Y, int Z>
class CuspTangencySystem {
public:
    static constexpr int n = n_unknowns<M>;
    static constexpr int rows = 2 * n + 1;      ///< of G, and entries of mu
    static constexpr int unknowns = 2 * n + 3;  ///< Y and z
    static constexpr int z = unknowns - 1;      ///< the number of z, and how many entries Y has
    static constexpr int size = unknowns + rows;
    using Vector = Array<S, size>;
    /// G with its first and second derivatives by Y and z.
    using D = Dual<S, unknowns>;
    using Surface = Array<Dual<D, unknowns>, rows>;

    explicit CuspTangencySystem(const Parameters<M, S>& p) : p_(p) {}

    /// Unknowns at q, v and the parameters, mu the left singular vector of the smallest singular value of dG/dY.
    Vector start(const Unknowns<M, S>& q, const Unknowns<M>& v) const {
        Vector y;
        for (int i = 0; i < n; ++i) y[i] = q[i], y[n + i] = S(v[i]);
        y[2 * n] = p_[X], y[2 * n + 1] = p_[Y], y[2 * n + 2] = p_[Z];
        const auto mu = transposed_slope(surface(y)).right(rows - 1);
        for (int i = 0; i < rows; ++i) y[unknowns + i] = S(mu[static_cast<std::size_t>(i)].real());
        return y;
    }
    Parameters<M, S> parameters(const Vector& y) const { return lifted_with_active<X, Y, Z>(p_, y, 2 * n); }

    /// G at y, by the power series of F along v, whose first coefficient is J v.
    Surface surface(const Vector& y) const {
        using D2 = Dual<D, unknowns>;
        using Series = Taylor<D2, 1>;
        Array<D2, unknowns> u;
        for (int j = 0; j < unknowns; ++j) {
            u[j] = D2(D::variable(y[j], j));
            u[j].derivative[j] = D(1.0);
        }
        const auto parameters = lifted_with_active<X, Y, Z>(p_, u, 2 * n);
        Unknowns<M, Series> along;
        Parameters<M, Series> constant;
        for (int i = 0; i < n; ++i) along[i] = Series::variable(u[i], u[n + i]);
        for (int k = 0; k < constant.size(); ++k) constant[k] = Series(parameters[k]);
        const auto f = equations<M, Series>(along, constant);
        Surface g;
        g[2 * n] = D2(-0.5);
        for (int i = 0; i < n; ++i) {
            g[i] = f[i].coefficient[0];
            g[n + i] = f[i].coefficient[1];
            g[2 * n] = g[2 * n] + 0.5 * u[n + i] * u[n + i];
        }
        return g;
    }

    /// The equations r = (G, mu^T dG/dY, (mu . mu - 1) / 2) and their Jacobian.
    bool operator()(const Vector& y, Vector& r, SquareArray<S, size>& jacobian) const {
        const Surface g = surface(y);
        const int last = size - 1;
        r = Vector{};
        jacobian = SquareArray<S, size>{};
        r[last] = S(-0.5);
        for (int i = 0; i < rows; ++i) {
            const S& mu = y[unknowns + i];
            r[i] = g[i].value.value;
            r[last] = r[last] + 0.5 * mu * mu;
            jacobian[last][unknowns + i] = mu;
            for (int j = 0; j < unknowns; ++j) {
                jacobian[i][j] = g[i].value.derivative[j];
                if (j == z) continue;
                r[rows + j] = r[rows + j] + mu * g[i].value.derivative[j];
                jacobian[rows + j][unknowns + i] = g[i].value.derivative[j];
                for (int k = 0; k < unknowns; ++k)
                    jacobian[rows + j][k] = jacobian[rows + j][k] + mu * g[i].derivative[j].derivative[k];
            }
        }
        return true;
    }

    /// The eigenvalues, ascending, of d2 z on the kernel of dG/dY, a plane.
    Array<double, 2> second_order_form(const Vector& y) const {
        const Surface g = surface(y);
        const SingularValues values = slope(g);
        const SingularValues::Vector t[] = {values.right(rows), values.right(rows - 1)};
        const double mu_g_z = along_mu(y, [&](int i) { return to_double(g[i].value.derivative[z]); });
        Array<Array<double, 2>, 2> form;
        for (int j = 0; j < z; ++j)
            for (int k = 0; k < z; ++k) {
                const double mu_g_yy = along_mu(y, [&](int i) { return to_double(g[i].derivative[j].derivative[k]); });
                for (int a = 0; a < 2; ++a)
                    for (int b = 0; b < 2; ++b)
                        form[a][b] -= t[a][static_cast<std::size_t>(j)].real() * mu_g_yy *
                                      t[b][static_cast<std::size_t>(k)].real() / mu_g_z;
            }
        const double mean = (form[0][0] + form[1][1]) / 2;
        const double radius = std::hypot((form[0][0] - form[1][1]) / 2, form[0][1]);
        return {mean - radius, mean + radius};
    }

private:
    static double along_mu(const Vector& y, const auto& entry) {
        double sum = 0;
        for (int i = 0; i < rows; ++i) sum += to_double(y[unknowns + i]) * entry(i);
        return sum;
    }
    static double finite_slope(const Surface& g, int i, int j) {
        const double a = to_double(g[i].value.derivative[j]);
        return std::isfinite(a) ? a : 0;
    }
    /// Of dG/dY, with a row of zeros below.
    static SingularValues slope(const Surface& g) {
        SingularValues::Vector a;
        for (int j = 0; j < z; ++j)
            for (int i = 0; i <= rows; ++i) a.emplace_back(i < rows ? finite_slope(g, i, j) : 0.0);
        return SingularValues(rows + 1, z, std::move(a));
    }
    /// Of its transpose.
    static SingularValues transposed_slope(const Surface& g) {
        SingularValues::Vector a;
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < z; ++j) a.emplace_back(finite_slope(g, i, j));
        return SingularValues(z, rows, std::move(a));
    }

    Parameters<M, S> p_;
};

/// Lips where the form is definite, beak-to-beak where it is not, of a cusp that is one.
template <class S>
void name_tangency(const ModelFunctions<S>& functions, RuntimeSingularity<S>& at) {
    const double least = std::min(std::abs(at.form[0]), std::abs(at.form[1]));
    const double mean = (at.form[0] + at.form[1]) / 2, radius = (at.form[1] - at.form[0]) / 2;
    const double scale = scale_of(functions, at);
    const bool cusp = at.nullity == 1 && !decides(at, 3, scale) && decides(at, 4, scale);
    if (at.converged && cusp && least > 1e-6 * (std::abs(mean) + radius))
        at.kind = at.form[0] * at.form[1] > 0 ? SingularityKind::lips : SingularityKind::beak_to_beak;
}

}  // namespace detail

/// The cusp near q (radians, coordinates) and p at which the curve of cusps in the parameters number X, Y and Z is
/// tangent to the plane z = const: lips or beak-to-beak, named by the second-order form. v as in refine_singularity.
/// Throws InvalidArgument for arguments that are not finite. Source: Arnold, Catastrophe Theory, chapter 9.
template <PotentialModel M, int X, int Y, int Z, class S = double>
Singularity<M, S> refine_cusp_tangency(const Unknowns<M>& q, const Parameters<M, S>& p,
                                       const std::optional<Unknowns<M>>& v = std::nullopt) {
    require_finite(q, "q");
    require_finite(p, "p");
    if (v) require_finite(*v, "v");
    auto at = singularity_at<M, X, Y, Z>(SingularityKind::undecided, detail::in_digits_of<S>(q), p);
    const Unknowns<M> null = v ? detail::normalized(*v) : null_vector<M>(jacobian<M>(q, detail::to_double(p)));
    require_finite(null, "v");

    using System = detail::CuspTangencySystem<M, S, X, Y, Z>;
    const System system(p);
    auto y = system.start(at.q, null);
    detail::newton_method(y, at, system);
    if (!(at.correction < S(1e3))) return at;
    typename System::Vector r;
    detail::SquareArray<S, System::size> jacobian;
    system(y, r, jacobian);
    at.residual = detail::largest(r);
    Unknowns<M> border;
    for (int i = 0; i < System::n; ++i) at.q[i] = y[i], border[i] = detail::to_double(y[System::n + i]);
    at.p = system.parameters(y);
    at.form = system.second_order_form(y);
    const auto& functions = functions_of<M, S>();
    auto named = runtime_singularity(at);
    if (!detail::fill_evidence(functions, named, runtime_array(detail::normalized(border)))) named.converged = false;
    detail::name_tangency(functions, named);
    return typed<M>(named);
}

}  // namespace equilibria
