/// \file
/// A point of a branch with several null vectors, from the branch's points next to it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/core/interpolated.hpp>

namespace equilibria::detail {

/// Whether p turns back between two points of a branch.
inline bool folds(const BranchPoint<Erased>& a, const BranchPoint<Erased>& b) {
    return (a.tangent.p < 0) != (b.tangent.p < 0);
}
/// How many eigenvalues change sign between them, as far as it is known.
inline int changes(const BranchPoint<Erased>& a, const BranchPoint<Erased>& b) {
    if (a.negative && b.negative) return std::abs(*b.negative - *a.negative);
    return a.determinant_sign != b.determinant_sign ? 1 : 0;
}

/// Whether the load does work along null vectors, which makes a fold of them; next to the point, as it is known.
template <class Matrix>
bool load_works(const AnyBranchStepper<Matrix>& stepper, const BranchPoint<Erased>& near,
                const Eigen::MatrixXd& null_vectors) {
    if (null_vectors.size() == 0) return true;
    const Eigen::VectorXd root = stepper.metric().cwiseSqrt(),
                          load = stepper.problem().parameter_derivative(near.q, near.p);
    return (null_vectors.transpose() * load).norm() > 0.1 * load.cwiseQuotient(root).norm();
}

/// A point with several null vectors.
struct MultiplePoint {
    CriticalPoint<Erased> point;
    bool sure = false;  ///< the sum of the two weakest eigenvalues vanishes there, to 1e-2 of what it is nearby
};
/// So many eigenvalues change sign, or touch 0, within the resolution. There the branch is ill determined; its
/// points some way off are not: it is interpolated where the weakest eigenvalue, or, where that but touches 0 and p
/// turns back, dp/ds vanishes.
template <class Matrix>
MultiplePoint multiple_point(AnyBranchStepper<Matrix>& stepper, const BranchPoint<Erased>& a,
                             const BranchPoint<Erased>& b, int nullity, double resolution) {
    const bool nearer = std::abs(a.weak_eigenvalue) < std::abs(b.weak_eigenvalue);
    const BranchPoint<Erased>& close = nearer ? a : b;
    MultiplePoint found;
    CriticalPoint<Erased>& y = found.point;
    y.nullity = nullity;
    y.negative_before = a.negative;
    y.negative_after = b.negative;
    y.q = close.q;
    y.p = close.p;
    y.null_vector = close.weak_direction;
    y.left_null_vector = stepper.problem().properties().symmetric ? close.weak_direction : close.weak_left;
    y.residual = close.residual;
    y.sigma = close.sigma;
    y.null_vectors = stepper.weak_directions(close.q, close.p, y.nullity);
    y.kind = folds(a, b) && load_works(stepper, close, y.null_vectors) ? CriticalKind::hilltop : CriticalKind::multiple;
    const bool by_turn = changes(a, b) < 2 && folds(a, b);
    std::vector<double> value;      // what vanishes there
    std::vector<double> way;        // along the tangent at `close`
    std::vector<double> sum;        // of the two weakest eigenvalues
    std::vector<Direction> offset;  // from `close`
    const double h = std::max(10 * resolution, b.arc_length - a.arc_length);
    for (const int k : {-3, -2, -1, 1, 2, 3}) {
        const auto point = stepper.step(k < 0 ? a : b, k * h);
        if (!point || changes(a, *point) != (k < 0 ? 0 : changes(a, b))) return found;
        value.push_back(by_turn ? point->tangent.p : point->weak_eigenvalue);
        offset.push_back(stepper.difference(close, point->q, point->p));
        way.push_back(stepper.dot(close.tangent, offset.back()));
        if (point->next_eigenvalues.size() == 2) sum.push_back(point->next_eigenvalues.sum());
    }
    // where it vanishes, and the branch there
    const double there = equilibria::interpolated(0, value, way);
    std::vector<double> p;
    for (const Direction& d : offset) p.push_back(d.p);
    y.p = close.p + equilibria::interpolated(there, way, p);
    std::vector<Eigen::VectorXd> q;
    for (Direction& d : offset) q.push_back(std::move(d.q));
    y.q = stepper.problem().retract(close.q, equilibria::interpolated(there, way, std::move(q)));
    y.residual = stepper.problem().residual(y.q, y.p).template lpNorm<Eigen::Infinity>();
    double largest = 0;
    for (const double x : sum) largest = std::max(largest, std::abs(x));
    found.sure = sum.size() == way.size() && std::abs(equilibria::interpolated(there, way, sum)) < 1e-2 * largest;
    return found;
}

}  // namespace equilibria::detail
