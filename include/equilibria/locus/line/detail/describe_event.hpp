/// \file
/// What follows from where an event is: its evidence, its kind, what it does to the equilibria.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Core>

#include <equilibria/core/dense_solvers.hpp>
#include <equilibria/core/eigen_copies.hpp>
#include <equilibria/core/symmetric_eigen.hpp>
#include <equilibria/locus/line/line_event.hpp>
#include <equilibria/model/model_functions.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/reduced_coefficients.hpp>

namespace equilibria::detail {

/// By what a branch moves with the parameter, across the null vector v, whose left one is `left`: J w = -dF/dp, v . w =
/// 0.
inline Eigen::VectorXd motion(const Eigen::MatrixXd& j, const Eigen::VectorXd& left, const Eigen::VectorXd& v,
                              const Eigen::VectorXd& f_p) {
    const Eigen::Index n = v.size();
    Eigen::MatrixXd bordered(n + 1, n + 1);
    bordered << j, left, v.transpose(), 0.0;
    Eigen::VectorXd right(n + 1);
    right << -f_p, 0.0;
    return equilibria::detail::solve(bordered, right).head(n);
}

/// The derivatives at an event.
struct EventDerivatives {
    RuntimeArray<double> p;  ///< with the event's value
    Eigen::MatrixXd j, j_p;  ///< J, dJ/dp
    Eigen::VectorXd v, left, f_p, moving;

    EventDerivatives(const ModelFunctions<>& model, const LineEvent<RuntimeUnknowns>& event, RuntimeArray<double> at,
                     int active)
        : p(std::move(at)), v(eigen_vector(event.v)) {
        p[active] = event.value;
        const auto jacobian_there = jacobian(model, event.q, p);
        j = eigen_matrix(jacobian_there);
        left = eigen_vector(left_null_vector(jacobian_there, event.v, model.has_potential()));
        const auto [by_p, change] = parameter_derivatives(model, event.q, p, active);
        f_p = eigen_vector(by_p);
        j_p = eigen_matrix(change);
        moving = motion(j, left, v, f_p);
    }
    /// dJ along a direction of the unknowns.
    Eigen::MatrixXd j_along(const ModelFunctions<>& model, const LineEvent<RuntimeUnknowns>& event,
                            const Eigen::VectorXd& direction) const {
        return eigen_matrix(jacobian_derivative(model, event.q, runtime_array(direction), p));
    }
};

/// Where there is a potential: how many eigenvalues are negative, and what the event does to the counts by index.
inline void count_change(LineEvent<RuntimeUnknowns>& event, const Eigen::MatrixXd& j) {
    auto values = symmetric_eigenvalues(j).eval();
    Eigen::Index zero = 0;
    values.cwiseAbs().minCoeff(&zero);
    for (Eigen::Index k = 0; k < values.size(); ++k) event.index += k != zero && values(k) < 0;
    const auto k = static_cast<std::size_t>(event.index);
    event.change.assign(static_cast<std::size_t>(j.rows()) + 1, 0);
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

/// Fills in what follows from kind, value, q and v.
inline void describe(LineEvent<RuntimeUnknowns>& event, const ModelFunctions<>& model, const RuntimeArray<double>& p,
                     int active) {
    const EventDerivatives at(model, event, p, active);
    event.residual = (at.j * at.v).cwiseAbs().maxCoeff();
    for (const double f : equations(model, event.q, at.p)) event.residual = std::max(event.residual, std::abs(f));
    event.reduced = reduced_coefficients(model, event.q, event.v, at.p);
    // without a fourth derivative the pair of branches is not decided
    if (event.kind == CriticalKind::pitchfork && std::abs(event.reduced.fourth) < 1e-9 * at.j.cwiseAbs().maxCoeff())
        event.kind = CriticalKind::hilltop;
    if (event.kind == CriticalKind::fold) {
        event.slope = at.left.dot(at.f_p);
    } else {
        const Eigen::MatrixXd change = at.j_p + at.j_along(model, event, at.moving);
        event.slope = at.left.dot(change * at.v) / at.left.dot(at.v);
    }
    if (event.kind == CriticalKind::fold)
        event.change_in_number = event.slope * event.reduced.third < 0 ? 2 : -2;
    else if (event.kind == CriticalKind::pitchfork)
        event.change_in_number = event.slope * at.left.dot(at.v) * event.reduced.fourth < 0 ? 2 : -2;
    else if (event.kind == CriticalKind::transcritical)
        event.change_in_number = 0;
    if (model.has_potential()) count_change(event, at.j);
}

/// d2F/dp2.
inline Eigen::VectorXd second_parameter_derivative(const ModelFunctions<>& model,
                                                   const LineEvent<RuntimeUnknowns>& event, RuntimeArray<double> p,
                                                   int active) {
    RuntimeArray<Jet<double>> at(event.q.size()), along(p.size());
    for (int i = 0; i < at.size(); ++i) at[i] = Jet<double>(event.q[i]);
    for (int k = 0; k < p.size(); ++k) along[k] = k == active ? Jet<double>::variable(p[k], 1, 2) : Jet<double>(p[k]);
    const auto f = model.equations(at, along);
    Eigen::VectorXd y(f.size());
    for (int i = 0; i < f.size(); ++i) y(i) = 2 * f[i].value(2);
    return y;
}

/// The kind of an event, by the bifurcation equation a x^2 + 2 b x y + c y^2 = 0, y the change of the parameter in
/// units of its size.
inline CriticalKind bifurcation_kind(const LineEvent<RuntimeUnknowns>& event, const ModelFunctions<>& model,
                                     const RuntimeArray<double>& p, int active) {
    const EventDerivatives at(model, event, p, active);
    const Eigen::MatrixXd jv = at.j_along(model, event, at.v), jw = at.j_along(model, event, at.moving);
    const Eigen::VectorXd g_pp = second_parameter_derivative(model, event, at.p, active);
    const double unit = 1 + std::abs(event.value);
    const double a = at.left.dot(jv * at.v), b = unit * at.left.dot((at.j_p + jw) * at.v),
                 c = unit * unit * at.left.dot(g_pp + 2 * at.j_p * at.moving + jw * at.moving),
                 mu = unit * at.left.dot(at.f_p);
    const double size = std::max({std::abs(a), std::abs(b), std::abs(c)});
    if (std::abs(mu) > 1e-6 * size) return std::abs(a) <= 1e-6 * std::abs(mu) ? CriticalKind::cusp : CriticalKind::fold;
    if (std::abs(b * b - a * c) <= 1e-5 * size * size) return CriticalKind::hilltop;
    if (b * b < a * c) return CriticalKind::isola_center;
    return std::abs(a) < 1e-5 * size ? CriticalKind::pitchfork : CriticalKind::transcritical;
}

}  // namespace equilibria::detail
