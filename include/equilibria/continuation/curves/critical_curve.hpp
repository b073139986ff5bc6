/// \file
/// Curves of critical points in two parameters, as continuation problems of their own: what follows a branch follows
/// them, and folds of a fold curve are its cusps.
///
/// `problems`, a parametric problem, gives for each value of the second parameter r a problem in the first, p.
///
/// Fold curve, unknowns (p, q):            Curve of bifurcation points, unknowns (p, gamma, q):
///     [ sigma(q, p; r) ]                      [ sigma(q, p; r)             ]
///     [ g(q, p; r)     ] = 0                  [ mu(q, p; r)                ] = 0
///                                             [ g(q, p; r) + gamma e_j     ]
/// sigma and mu are those of bordered.hpp, with a border that is chosen anew after each step. Their derivatives are
///     d sigma = -psi^T dK r        d mu = psi^T (dK s + d(dg/dp)),        psi the left null vector,
/// exact where the problem's tangent_derivative is, those of folds by r where the family is differentiable; otherwise
/// five-point differences, error O(eps^(4/5)). Source: Govaerts, Numerical Methods for Bifurcations of Dynamical
/// Equilibria, chapters 3, 4 and 8.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/continuation/curves/bordered_tangent.hpp>
#include <equilibria/continuation/member_derivatives.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

namespace detail {
/// A derivative at 0 by the five-point difference: error O(eps^(4/5)) for a function of unknowns of size 1.
template <class Function>
auto five_point_difference(const Function& f, double size) {
    const double h = std::pow(std::numeric_limits<double>::epsilon(), 0.2) / size;
    auto near = f(h), far = f(2 * h);
    near -= f(-h);
    far -= f(-2 * h);
    near *= 8 / (12 * h);
    far *= 1 / (12 * h);
    near -= far;
    return near;
}

/// dK along v, with more digits than tangent_derivative where that is a difference: it becomes part of a tangent matrix
/// whose own derivative is one.
template <ContinuationProblem P>
TangentMatrix<P> accurate_tangent_derivative(const P& problem, const Configuration<P>& q, double p,
                                             const Eigen::VectorXd& v) {
    if constexpr (requires { problem.tangent_derivative(q, p, v); }) {
        return problem.tangent_derivative(q, p, v);
    } else {
        const double size = v.lpNorm<Eigen::Infinity>();
        return five_point_difference(
            [&](double t) -> TangentMatrix<P> {
                return problem.tangent(equilibria::retract(problem, q, Eigen::VectorXd(t * v)), p);
            },
            size > 0 ? size : 1.0);
    }
}

template <class F>
using MemberOf = std::remove_cvref_t<std::invoke_result_t<const F&, double>>;
}  // namespace detail

/// Gives a problem in p for each value of the second parameter.
template <class F>
concept ParametricProblem = std::invocable<const F&, double> && ContinuationProblem<detail::MemberOf<F>>;

/// One with exact derivatives by the second parameter, MemberDerivatives member_derivatives(q, p, r, v).
template <class F>
concept DifferentiableFamily =
    ParametricProblem<F> &&
    requires(const F& problems, const Configuration<detail::MemberOf<F>>& q, const Eigen::VectorXd& v) {
        { problems.member_derivatives(q, 0.0, 0.0, v) } -> std::convertible_to<MemberDerivatives>;
    };

/// Base of both curves: extra unknowns first, then q.
template <ParametricProblem F, int extra>
class CriticalCurve {
public:
    using Problem = detail::MemberOf<F>;                                              ///< a member of the family
    using Configuration = CriticalConfiguration<equilibria::Configuration<Problem>>;  ///< p, gamma and the member's q
    using Matrix = TangentMatrix<Problem>;    ///< dense or sparse, as the member's
    static constexpr bool symmetric = false;  ///< its tangent is not symmetric

    /// r: a value at which a problem is defined; p_scale: a change of p that counts as much as one of 1 in the
    /// unknowns.
    CriticalCurve(F problems, double r, double p_scale)
        : problems_(std::move(problems)), any_(problems_(r)), p_scale_(p_scale) {
        require(p_scale > 0 && std::isfinite(p_scale), "p_scale", p_scale, "must be positive and finite");
    }

    Problem problem(double r) const { return problems_(r); }  ///< the member at r
    double p_scale() const { return p_scale_; }               ///< a change of p that counts as one of 1 in the unknowns

    /// As the member's, the extra unknowns in front of q.
    Configuration retract(const Configuration& y, const Eigen::VectorXd& d) const {
        Configuration moved = y;
        moved.q = equilibria::retract(any_, y.q, Eigen::VectorXd(d.tail(d.size() - extra)));
        moved.p += d(0);
        if constexpr (extra == 2) moved.gamma += d(1);
        return moved;
    }
    /// As the member's, the extra unknowns in front of q.
    Eigen::VectorXd difference(const Configuration& y, const Configuration& near) const {
        Eigen::VectorXd dq = equilibria::difference(any_, y.q, near.q), d(dq.size() + extra);
        d(0) = near.p - y.p;
        if constexpr (extra == 2) d(1) = near.gamma - y.gamma;
        d.tail(dq.size()) = dq;
        return d;
    }
    /// As the member's; the extra unknowns stay as they are.
    Eigen::VectorXd transport(const Configuration& y, const Eigen::VectorXd& d, const Eigen::VectorXd& v) const {
        const Eigen::Index n = v.size() - extra;
        Eigen::VectorXd moved = v;
        moved.tail(n) = equilibria::transport(any_, y.q, Eigen::VectorXd(d.tail(n)), Eigen::VectorXd(v.tail(n)));
        return moved;
    }
    int multipliers() const { return equilibria::multipliers(any_); }  ///< as the member's
    /// As the member's, with 1 / p_scale^2 for the extra unknowns.
    Eigen::VectorXd weights(const Configuration& y) const {
        const Eigen::VectorXd own = equilibria::weights(any_, y.q, any_.residual(y.q, y.p).size());
        Eigen::VectorXd w(own.size() + extra);
        w.head(extra).setConstant(1 / (p_scale_ * p_scale_));
        w.tail(own.size()) = own;
        return w;
    }

    /// With the border chosen anew, where the null vectors are largest.
    Configuration rebase(const Configuration& y, double r) const { return with_best_border(problems_(r), y); }

protected:
    /// `size` times NaN: the residual where the bordered tangent is singular.
    static Eigen::VectorXd not_a_number(Eigen::Index size) {
        return Eigen::VectorXd::Constant(size, std::numeric_limits<double>::quiet_NaN());
    }
    /// K below and to the right of `extra` rows and columns.
    static Matrix bordered(const Matrix& k, const Eigen::MatrixXd& rows, const Eigen::MatrixXd& columns) {
        const Eigen::Index n = k.rows();
        if constexpr (detail::is_sparse<Problem>) {
            std::vector<Eigen::Triplet<double>> entries;
            for (Eigen::Index c = 0; c < k.outerSize(); ++c)
                for (typename Matrix::InnerIterator entry(k, c); entry; ++entry)
                    entries.emplace_back(static_cast<int>(entry.row()) + extra, static_cast<int>(entry.col()) + extra,
                                         entry.value());
            for (int i = 0; i < extra; ++i) {
                for (int j = 0; j < n + extra; ++j) entries.emplace_back(i, j, rows(i, j));
                for (int j = 0; j < n; ++j)
                    if (columns(j, i) != 0) entries.emplace_back(j + extra, i, columns(j, i));
            }
            Matrix y(n + extra, n + extra);
            y.setFromTriplets(entries.begin(), entries.end());
            return y;
        } else {
            Matrix y(n + extra, n + extra);
            y << rows, columns, k;
            return y;
        }
    }
    /// The derivative of the curve's equations by r, from five-point differences.
    template <class Curve>
    static Eigen::VectorXd by_second_parameter(const Curve& curve, const Configuration& y, double r) {
        return detail::five_point_difference([&](double t) -> Eigen::VectorXd { return curve.residual(y, r + t); },
                                             1 / std::max(1e-3, std::abs(r)));
    }

    F problems_;      ///< gives the member at r
    Problem any_;     ///< for what does not depend on r
    double p_scale_;  ///< see p_scale()
};

/// The folds of a parametric problem; parameter r, unknowns (p, q).
template <ParametricProblem F>
class FoldCurve : public CriticalCurve<F, 1> {
    using Base = CriticalCurve<F, 1>;

public:
    using typename Base::Configuration;
    using typename Base::Matrix;
    using typename Base::Problem;
    using Base::Base;

    /// A function of a continuation problem (problem.hpp); NaN where the bordered tangent is singular.
    /// \{
    Eigen::VectorXd residual(const Configuration& y, double r) const {
        return residual(y, BorderedTangent<Problem>(this->problems_(r), y));
    }
    Matrix tangent(const Configuration& y, double r) const {
        const Problem problem = this->problems_(r);
        return tangent(problem, y, BorderedTangent<Problem>(problem, y));
    }
    Eigen::VectorXd parameter_derivative(const Configuration& y, double r) const {
        if constexpr (DifferentiableFamily<F>)
            return parameter_derivative(y, r, BorderedTangent<Problem>(this->problems_(r), y));
        else
            return Base::by_second_parameter(*this, y, r);
    }
    Linearization<Matrix> linearization(const Configuration& y, double r) const {
        const Problem problem = this->problems_(r);
        const BorderedTangent<Problem> b(problem, y);
        Linearization<Matrix> all{residual(y, b), tangent(problem, y, b), {}};
        if constexpr (DifferentiableFamily<F>)
            all.parameter_derivative = parameter_derivative(y, r, b);
        else
            all.parameter_derivative = parameter_derivative(y, r);
        return all;
    }
    /// \}

private:
    static Eigen::VectorXd residual(const Configuration& y, const BorderedTangent<Problem>& b) {
        if (!b.regular) return Base::not_a_number(b.g.size() + 1);
        Eigen::VectorXd f(b.g.size() + 1);
        f << y.sign * b.sigma(), b.g;
        return f;
    }
    static Matrix tangent(const Problem& problem, const Configuration& y, const BorderedTangent<Problem>& b) {
        const Eigen::Index n = b.g.size();
        Eigen::MatrixXd row(1, n + 1);
        if (b.regular) {
            row(0, 0) = -b.left.x.dot(parameter_derivative_along(problem, y.q, y.p, b.null.x));
            const Matrix along_null = detail::accurate_tangent_derivative(problem, y.q, y.p, b.null.x);
            row.rightCols(n) = -(along_null.transpose() * b.left.x).transpose();
            row *= y.sign;
        } else {
            row.setConstant(std::numeric_limits<double>::quiet_NaN());
        }
        return Base::bordered(b.k(), row, b.g_p);
    }
    Eigen::VectorXd parameter_derivative(const Configuration& y, double r, const BorderedTangent<Problem>& b) const {
        if (!b.regular) return Base::not_a_number(b.g.size() + 1);
        Eigen::VectorXd f(b.g.size() + 1);
        const MemberDerivatives by_r = this->problems_.member_derivatives(y.q, y.p, r, b.null.x);
        f << -y.sign * b.left.x.dot(by_r.tangent_of_v), by_r.residual;
        return f;
    }
};
/// Of a function object or a lambda.
template <class F>
FoldCurve(F, double, double) -> FoldCurve<F>;

/// The simple bifurcation points of a parametric problem; parameter r, unknowns (p, gamma, q). gamma, the load in row j
/// that would keep the bifurcation perfect, is 0 along the whole curve where a symmetry does that.
template <ParametricProblem F>
class BifurcationCurve : public CriticalCurve<F, 2> {
    using Base = CriticalCurve<F, 2>;

public:
    using typename Base::Configuration;
    using typename Base::Matrix;
    using typename Base::Problem;
    using Base::Base;

    /// A function of a continuation problem (problem.hpp); NaN where the bordered tangent is singular.
    /// \{
    Eigen::VectorXd residual(const Configuration& y, double r) const {
        const Problem problem = this->problems_(r);
        const BorderedTangent<Problem> b(problem, y);
        if (!b.regular) return Base::not_a_number(b.g.size() + 2);
        Eigen::VectorXd f(b.g.size() + 2);
        f << y.sign * b.sigma(), y.sign * b.mu(), b.g;
        f(y.border.row + 2) += y.gamma;
        return f;
    }
    Matrix tangent(const Configuration& y, double r) const {
        const Problem problem = this->problems_(r);
        const BorderedTangent<Problem> b(problem, y);
        const Eigen::Index n = b.g.size();
        Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2, n + 2), columns = Eigen::MatrixXd::Zero(n, 2);
        columns.col(0) = b.g_p;
        columns(y.border.row, 1) = 1;
        if (b.regular) {
            const Eigen::VectorXd &phi = b.null.x, &psi = b.left.x, &s = b.slope.x;
            const Eigen::VectorXd gp_s = parameter_derivative_along(problem, y.q, y.p, s);
            const Matrix k_p = detail::five_point_difference(
                [&](double t) -> Matrix { return problem.tangent(y.q, y.p + t); }, 1 / std::max(1e-3, std::abs(y.p)));
            rows(0, 0) = -psi.dot(parameter_derivative_along(problem, y.q, y.p, phi));
            const Matrix along_null = detail::accurate_tangent_derivative(problem, y.q, y.p, phi);
            const Matrix along_slope = detail::accurate_tangent_derivative(problem, y.q, y.p, s);
            rows.row(0).tail(n) = -(along_null.transpose() * psi).transpose();
            rows(1, 0) = psi.dot(second_parameter_derivative(problem, y.q, y.p) + gp_s);
            rows.row(1).tail(n) = (along_slope.transpose() * psi + k_p.transpose() * psi).transpose();
            rows *= y.sign;
        } else {
            rows.setConstant(std::numeric_limits<double>::quiet_NaN());
        }
        return Base::bordered(b.k(), rows, columns);
    }
    Eigen::VectorXd parameter_derivative(const Configuration& y, double r) const {
        return Base::by_second_parameter(*this, y, r);
    }
    /// \}
};
/// Of a function object or a lambda.
template <class F>
BifurcationCurve(F, double, double) -> BifurcationCurve<F>;

}  // namespace equilibria
