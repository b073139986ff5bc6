/// \file
/// A point of a branch with several null vectors, between two of the branch's points.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/continuation/detail/branch_changes.hpp>
#include <equilibria/continuation/detail/multiple_point_newton.hpp>
#include <equilibria/continuation/factorization/orthonormalize.hpp>

namespace equilibria::detail {

/// The point between a and b, neighbours on a branch, with so many null vectors; nothing where Newton's method does not
/// come to one, or where the eigenvalues do not vanish together to 1e-7 of a length along the branch. near: a place
/// between them.
template <class Matrix>
std::optional<CriticalPoint<Erased>> multiple_point(AnyBranchStepper<Matrix>& stepper, const BranchPoint<Erased>& a,
                                                    const BranchPoint<Erased>& b, const BranchPoint<Erased>& near,
                                                    int nullity, const CriticalPointOptions& options) {
    const Eigen::MatrixXd basis = stepper.weak_directions(near.q, near.p, nullity);
    if (basis.size() == 0) return std::nullopt;
    MultiplePointNewton<Matrix> newton(stepper.problem(), stepper.solver(), stepper.metric(), basis);
    if (!newton.possible()) return std::nullopt;
    const double h = stepper.length(stepper.difference(a, b.q, b.p));
    auto found = newton.solve(near.q, near.p, options, 10 * h + 1e-6, stepper.parameter_weight());
    if (!found) return std::nullopt;
    const double largest = largest_entry(stepper.solver().matrix());
    const auto before = newton.singular_at(a.q, a.p);
    if (!before) return std::nullopt;
    const double way = stepper.length(stepper.difference(a, found->q, found->p));
    const double rounding = 1e4 * std::numeric_limits<double>::epsilon() * largest;
    if (!(found->singular <= std::max(rounding, *before * std::min(1e-3, 1e-7 / way)))) return std::nullopt;
    CriticalPoint<Erased> y;
    y.q = std::move(found->q);
    y.p = found->p;
    y.nullity = nullity;
    y.kind = found->load.norm() > 1e-3 ? CriticalKind::hilltop : CriticalKind::multiple;
    Eigen::Index largest_row = 0;
    found->null_vectors.col(0).cwiseAbs().maxCoeff(&largest_row);
    y.null_vector = found->null_vectors.col(0) / found->null_vectors(largest_row, 0);
    y.left_null_vector = found->left.col(0);
    y.null_vectors = std::move(found->null_vectors);
    orthonormalize(y.null_vectors, stepper.metric());
    y.residual = found->residual;
    y.sigma = found->singular;
    y.transversality = found->load.norm();
    y.history = std::move(found->history);
    return y;
}

}  // namespace equilibria::detail
