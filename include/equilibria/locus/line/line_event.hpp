/// \file
/// An event on a line of the parameter space: a degenerate equilibrium, its kind, and what it does to the equilibria by
/// index.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/core/symmetric_eigen.hpp>
#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/reduced_coefficients.hpp>

namespace equilibria {

/// A degenerate equilibrium on a line.
template <Model M>
struct LineEvent {
    CriticalKind kind = CriticalKind::fold;
    double value = 0;     ///< of the active parameter
    Unknowns<M> q;        ///< angles in (-pi, pi]
    Unknowns<M> v;        ///< the unit null vector
    double residual = 0;  ///< the largest |entry| of F and J v
    /// Of the last step of Newton's method: about the error. NaN of kinds other than fold and pitchfork.
    double correction = 0;
    ReducedCoefficients reduced;
    /// Of folds u . dF/dp, u the unit left null vector (v where there is a potential); else the derivative by p of the
    /// eigenvalue that vanishes, along the branch.
    double slope = 0;
    int index = 0;  ///< negative eigenvalues beside the one that vanishes
    /// By how much the numbers of equilibria of index 0, 1, .. n change as the parameter grows; of folds, pitchforks
    /// and trans-critical points of models with a potential. Else empty.
    std::vector<std::int64_t> change;
    std::size_t interval = 0;  ///< the first one above the event
};

namespace detail {

template <Model M>
using UnknownColumn = Eigen::Matrix<double, n_unknowns<M>, 1>;

template <Model M>
UnknownColumn<M> column(const Unknowns<M>& q) {
    return Eigen::Map<const UnknownColumn<M>>(q.elements);
}

/// By what a branch moves with the parameter, across the null vector v, whose left one is `left`: J w = -dF/dp, v . w =
/// 0.
template <Model M>
Unknowns<M> motion(const UnknownMatrix<M>& j, const UnknownColumn<M>& left, const UnknownColumn<M>& v,
                   const UnknownColumn<M>& f_p) {
    constexpr int n = n_unknowns<M>;
    Eigen::Matrix<double, n + 1, n + 1> bordered;
    bordered << j, left, v.transpose(), 0.0;
    Eigen::Matrix<double, n + 1, 1> right;
    right << -f_p, 0.0;
    const Eigen::Matrix<double, n + 1, 1> w = bordered.partialPivLu().solve(right);
    Unknowns<M> y;
    for (int i = 0; i < n; ++i) y[i] = w(i);
    return y;
}

/// Fills in what follows from kind, value, q and v.
template <Model M>
void describe(LineEvent<M>& event, Parameters<M> p, int active) {
    constexpr int n = n_unknowns<M>;
    p[active] = event.value;
    const UnknownMatrix<M> j = jacobian<M, double>(event.q, p);
    const UnknownColumn<M> v = column<M>(event.v);
    event.residual = (j * v).cwiseAbs().maxCoeff();
    for (const double f : equations<M, double>(event.q, p)) event.residual = std::max(event.residual, std::abs(f));
    event.reduced = reduced_coefficients<M>(event.q, event.v, p);
    const UnknownColumn<M> left = column<M>(left_null_vector<M>(j, event.v)),
                           f_p = column<M>(parameter_derivative<M, double>(event.q, p, active));
    if (event.kind == CriticalKind::fold) {
        event.slope = left.dot(f_p);
    } else {
        const UnknownMatrix<M> change = jacobian_parameter_derivative<M, double>(event.q, p, active) +
                                        jacobian_derivative<M, double>(event.q, motion<M>(j, left, v, f_p), p);
        event.slope = left.dot(change * v) / left.dot(v);
    }
    if constexpr (PotentialModel<M>) {
        auto values = symmetric_eigenvalues(j).eval();
        Eigen::Index zero = 0;
        values.cwiseAbs().minCoeff(&zero);
        for (Eigen::Index k = 0; k < values.size(); ++k) event.index += k != zero && values(k) < 0;
        const auto k = static_cast<std::size_t>(event.index);
        event.change.assign(n + 1, 0);
        if (event.kind == CriticalKind::fold) {
            // slope dp + third x^2 / 2 = 0
            const int born = event.slope * event.reduced.third < 0 ? 1 : -1;
            event.change[k] += born;
            event.change[k + 1] += born;
        } else if (event.kind == CriticalKind::pitchfork) {
            // x (slope dp + fourth x^2 / 6) = 0: the pair lives where slope dp has the other sign than fourth
            const int born = event.slope * event.reduced.fourth < 0 ? 1 : -1;
            const bool falls = event.slope < 0;  // the branch's eigenvalue
            event.change[falls ? k + 1 : k] += 1;
            event.change[falls ? k : k + 1] -= 1;
            event.change[event.reduced.fourth > 0 ? k : k + 1] += 2 * born;
        } else if (event.kind != CriticalKind::transcritical) {
            event.change.clear();
        }
    }
}

/// The kind of an event, by the bifurcation equation a x^2 + 2 b x y + c y^2 = 0, y the change of the parameter in
/// units of its size.
template <Model M, int Active>
CriticalKind bifurcation_kind(const LineEvent<M>& event, Parameters<M> p) {
    using Vector = UnknownColumn<M>;
    using Problem = ModelProblem<M, Active>;
    const Problem problem(p);
    p[Active] = event.value;
    const UnknownMatrix<M> j = jacobian<M, double>(event.q, p);
    const Vector v = column<M>(event.v), left = column<M>(left_null_vector<M>(j, event.v)),
                 f_p = column<M>(parameter_derivative<M, double>(event.q, p, Active));
    const Unknowns<M> moving = motion<M>(j, left, v, f_p);
    const Vector w = column<M>(moving);
    const UnknownMatrix<M> jv = jacobian_derivative<M, double>(event.q, event.v, p),
                           jw = jacobian_derivative<M, double>(event.q, moving, p),
                           jp = jacobian_parameter_derivative<M, double>(event.q, p, Active);
    const Vector g_pp = equilibria::second_parameter_derivative(problem, Problem::vector(event.q), event.value);
    const double unit = 1 + std::abs(event.value);
    const double a = left.dot(jv * v), b = unit * left.dot((jp + jw) * v),
                 c = unit * unit * left.dot(g_pp + 2 * jp * w + jw * w), mu = unit * left.dot(f_p);
    const double size = std::max({std::abs(a), std::abs(b), std::abs(c)});
    if (std::abs(mu) > 1e-6 * size) return std::abs(a) <= 1e-6 * std::abs(mu) ? CriticalKind::cusp : CriticalKind::fold;
    if (std::abs(b * b - a * c) <= 1e-5 * size * size) return CriticalKind::hilltop;
    if (b * b < a * c) return CriticalKind::isola_center;
    return std::abs(a) < 1e-5 * size ? CriticalKind::pitchfork : CriticalKind::transcritical;
}

}  // namespace detail

}  // namespace equilibria
