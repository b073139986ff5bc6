/// \file
/// See continuation/events.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include <equilibria/continuation/detail/branch_changes.hpp>
#include <equilibria/continuation/detail/multiple_point.hpp>
#include <equilibria/continuation/detail/predicted_zeros.hpp>
#include <equilibria/continuation/detail/real_eigenvalues.hpp>
#include <equilibria/continuation/events.hpp>

namespace equilibria {

namespace detail {

template <class Matrix>
class StepEventFinder {
public:
    using Point = BranchPoint<Erased>;
    using Critical = CriticalPoint<Erased>;
    using Events = StepEvents<Erased>;

    StepEventFinder(AnyBranchStepper<Matrix>& stepper, const CriticalPointOptions& options)
        : stepper_(&stepper), options_(options) {}

    Events between(const Point& a, const Point& b) {
        Events out;
        resolution_ = std::min(stepper_->options().resolution, 1e-4 * std::abs(b.arc_length));
        locate(a, b, 0, out);
        return out;
    }

private:
    /// Number 0: the weakest one; then the next ones that are watched.
    static double eigenvalue(const Point& at, Eigen::Index k) {
        return k == 0 ? at.weak_eigenvalue : at.next_eigenvalues(k - 1);
    }
    static Eigen::VectorXd direction(const Point& at, Eigen::Index k) {
        return k == 0 ? at.weak_direction : Eigen::VectorXd(at.next_directions.col(k - 1));
    }
    static Eigen::Index watched(const Point& a, const Point& b) {
        return 1 + std::min(a.next_eigenvalues.size(), b.next_eigenvalues.size());
    }

    /// The eigenvalues that head for 0 within the step, though none changed: the weakest, seen from one of its ends, or
    /// next ones, which may change places between them, seen from both.
    std::vector<Eigen::Index> suspicious(const Point& a, const Point& b) const {
        const double h = b.arc_length - a.arc_length;
        const auto predicted = [&](const Point& from, double ahead, Eigen::Index k) {
            return eigenvalue(from, k) * (eigenvalue(from, k) + ahead * slope(from, k)) < 0;
        };
        std::vector<Eigen::Index> y;
        if (predicted(a, h, 0) || predicted(b, -h, 0)) y.push_back(0);
        bool from_a = false, from_b = false;
        std::vector<Eigen::Index> next;
        for (Eigen::Index k = 1; k < watched(a, b); ++k) {
            const bool at_a = predicted(a, h, k), at_b = predicted(b, -h, k);
            from_a = from_a || at_a;
            from_b = from_b || at_b;
            if (at_a || at_b) next.push_back(k);
        }
        if (from_a && from_b) y.insert(y.end(), next.begin(), next.end());
        return y;
    }
    /// One eigenvalue may have risen through 0 and another one fallen: both are within reach at both ends. Eigenvalues
    /// of a symmetric K move by no more than the norm of K's change (Weyl).
    bool two_may_cross(const Point& a, const Point& b) const {
        const auto on_both_sides = [](const Point& at) {
            return !at.eigenvalues.empty() && *at.negative > 0 && *at.negative < at.eigenvalues.size();
        };
        if (!on_both_sides(a) || !on_both_sides(b)) return false;
        Matrix change = stepper_->problem().tangent(b.q, b.p);
        change -= stepper_->problem().tangent(a.q, a.p);
        const double reach = change.norm();
        const auto within_reach = [reach](const EigenvalueCounts& of) {
            const int negative = of.below(0);
            return of.below(-reach) < negative && negative < of.below(reach);
        };
        return within_reach(a.eigenvalues) && within_reach(b.eigenvalues);
    }
    /// Whether two real eigenvalues of an unsymmetric K may cross 0 within one step, which the determinant does not
    /// show. They are counted, as far as K is small; a pair that becomes complex changes their number, too.
    bool pair_may_cross(const Point& a, const Point& b) const {
        if (symmetric()) return false;
        const int at_a = negative_real_eigenvalues(*stepper_, a), at_b = negative_real_eigenvalues(*stepper_, b);
        return at_a >= 0 && at_b >= 0 && at_a != at_b;
    }
    /// Of eigenvalue k along the branch.
    double slope(const Point& from, Eigen::Index k) const {
        if (from.weak_slopes.size() == 0) from.weak_slopes = slopes(from);
        return from.weak_slopes(k);
    }
    Eigen::VectorXd slopes(const Point& from) const {
        const Eigen::MatrixXd v = from.weak_directions();
        Eigen::MatrixXd left = v;
        if (!symmetric()) left.col(0) = from.weak_left;
        return left.cwiseProduct(derivative_along(*stepper_, from, v)).colwise().sum().transpose();
    }
    /// Where eigenvalue k only touches 0 between a and b.
    std::optional<Critical> touching(const Point& a, const Point& b, Eigen::Index k) {
        const EventFunction<Erased> approach{"approach", [this, k](const Point& at) {
                                                 if (k > at.next_eigenvalues.size()) return 0.0;
                                                 return eigenvalue(at, k) < 0 ? -slope(at, k) : slope(at, k);
                                             }};
        if (eigenvalue(a, k) * eigenvalue(b, k) < 0 || !(approach.value(a) < 0 && approach.value(b) > 0))
            return std::nullopt;
        const auto nearest = zero_between(*stepper_, approach, a, b);
        if (!nearest || k > nearest->next_eigenvalues.size()) return std::nullopt;
        const double far = std::max(std::abs(eigenvalue(a, k)), std::abs(eigenvalue(b, k)));
        if (!(std::abs(eigenvalue(*nearest, k)) < 1e-6 * far)) return std::nullopt;
        // it does not cross 0 there, to be crossed by another one next to it; at such a point itself the tangent is
        // any, and the slope with it
        const double at = (nearest->arc_length - a.arc_length) / (b.arc_length - a.arc_length), margin = 0.002;
        const auto left = stepper_->between(a, b, at - margin), right = stepper_->between(a, b, at + margin);
        if (!left || !right || changes(a, *left) != 0 || changes(*left, *right) != 0) return std::nullopt;
        Critical y = critical_at(*nearest, a, b, direction(*nearest, k));
        if (!symmetric()) y.left_null_vector = nearest->weak_left;
        const Eigen::Index own = y.null_vector.size() - stepper_->problem().multipliers();
        const bool of_multipliers = y.null_vector.head(own).norm() < 1e-4 * y.null_vector.norm();
        y.kind = of_multipliers ? CriticalKind::kinematic : CriticalKind::hilltop;
        return y;
    }

    /// Of the next eigenvalues that rise along the branch (sign 1), or fall (-1), the one nearest to 0; 0 where none
    /// does.
    double moving(const Point& at, int sign) const {
        double y = std::numeric_limits<double>::infinity();
        for (Eigen::Index k = 1; k <= at.next_eigenvalues.size(); ++k)
            if (sign * slope(at, k) > 0 && std::abs(eigenvalue(at, k)) < std::abs(y)) y = eigenvalue(at, k);
        return std::isfinite(y) ? y : 0;
    }
    /// Where two eigenvalues cross 0 in opposite directions in one point between a and b, as at a dead point of a
    /// mechanism: there one null vector is of multipliers alone.
    std::optional<Critical> crossing_both_ways(const Point& a, const Point& b) {
        const double at_a = moving(a, 1), at_b = moving(b, 1), far = std::max(-at_a, at_b);
        if (!(at_a < 0 && at_b > 0 && moving(a, -1) > 0 && moving(b, -1) < 0)) return std::nullopt;
        const auto nearest =
            zero_between(*stepper_, {"rising", [this](const Point& at) { return moving(at, 1); }}, a, b);
        // two of them vanish there; which rises is not to be told at the point itself, where the tangent is noise
        if (!nearest || nearest->next_eigenvalues.size() != 2 ||
            !(nearest->next_eigenvalues.cwiseAbs().maxCoeff() < 1e-5 * far))
            return std::nullopt;
        const Eigen::Index own = a.weak_direction.size() - stepper_->problem().multipliers();
        const Eigen::MatrixXd both = nearest->next_directions.colwise().normalized();
        // the combination that moves least
        const Eigen::MatrixXd moves = both.topRows(own);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> least(moves.transpose() * moves);
        const Eigen::VectorXd null = (both * least.eigenvectors().col(0)).normalized();
        if (!(null.head(own).norm() < 1e-4)) return std::nullopt;
        Critical y = critical_at(*nearest, a, b, null);
        y.kind = CriticalKind::kinematic;
        return y;
    }
    /// What is known of a point between a and b at which K has this null vector, but for its kind.
    static Critical critical_at(const Point& at, const Point& a, const Point& b, const Eigen::VectorXd& null) {
        Critical y;
        y.q = at.q;
        y.p = at.p;
        y.null_vector = y.left_null_vector = null;
        y.residual = at.residual;
        y.sigma = at.sigma;
        y.negative_before = a.negative;
        y.negative_after = b.negative;
        return y;
    }

    /// Where between a and b a function that changes sign is 0, were it linear: dp/ds at a fold, else the weakest
    /// eigenvalue.
    Point interpolated(const Point& a, const Point& b, bool fold) const {
        const double at_a = fold ? a.tangent.p : a.weak_eigenvalue, at_b = fold ? b.tangent.p : b.weak_eigenvalue;
        const double share = (at_a < 0) != (at_b < 0) ? at_a / (at_a - at_b) : 0.5;
        Point y = along(a, b, share * (b.arc_length - a.arc_length));
        y.border = share < 0.5 ? a.border : b.border;
        return y;
    }

    /// near: where an eigenvalue is predicted to vanish, with its direction.
    void locate(const Point& a, const Point& b, int depth, Events& out, const Point* near = nullptr) {
        const int count = changes(a, b);
        const bool turned = folds(a, b);
        const double h = b.arc_length - a.arc_length;
        if (count == 0 && !turned) {
            const std::vector<Eigen::Index> heading = suspicious(a, b);
            if (!heading.empty())
                if (auto point = crossing_both_ways(a, b)) {
                    out.points.push_back(std::move(*point));
                    return;
                }
            for (const Eigen::Index k : heading)
                if (auto point = touching(a, b, k)) {
                    out.points.push_back(std::move(*point));
                    return;
                }
            const bool pair = pair_may_cross(a, b);
            if (depth < (pair ? 10 : 6) && (pair || !heading.empty() || two_may_cross(a, b)))
                halve(a, b, depth, out);
            else if (pair)  // at one point, or it became complex, which is none
                together(a, b, 2, depth, out);
            return;
        }
        if (count <= 1) {
            // from where an interpolation has it, or from the end at which K is closer to singular
            const bool first = std::abs(a.weak_eigenvalue) < std::abs(b.weak_eigenvalue);
            const Point guess = near ? *near : interpolated(a, b, turned);
            // longer steps do not come back between a and b; next to `near` there are other points
            CriticalPointOptions within = options_;
            within.reach = (near ? 10 : 100) * stepper_->length(stepper_->difference(a, b.q, b.p));
            struct Start {
                const Point* from;
                bool fold;
            };
            const bool fold = near && turned;
            const Point *nearer = first ? &a : &b, *farther = first ? &b : &a;
            std::vector<Start> starts{{&guess, fold}, {nearer, fold}, {farther, fold}};
            // so near to it the load's work may look like none, though the branch turns and one eigenvalue changes
            if (turned && count == 1 && !fold && h <= 20 * resolution_)
                starts.insert(starts.end(), {{&guess, true}, {nearer, true}, {farther, true}});
            for (const auto& [from, expects_fold] : starts) {
                auto point = critical_point_near(
                    stepper_->problem(), from->q, from->p, within, from->border, &stepper_->solver(),
                    near && from == &guess ? near->weak_direction : Eigen::VectorXd(), expects_fold);
                if (!point) continue;
                const std::optional<double> share = share_of(a, b, *point);
                if (!share) continue;
                // what happens close to it must be what its kind does
                const auto [left, right] = beside(a, b, *share);
                if (!left || !right || !share_of(*left, *right, *point) || !agrees(*left, *right, *point)) continue;
                note(a, *left, std::move(*point), *right, b, depth, out);
                return;
            }
        }
        if (count >= 2 && (separate(a, b, depth, out) || together(a, b, count, depth, out))) return;
        // next to two null vectors the branch is known to few digits
        if (count <= 1 && h <= 20 * resolution_ && vanishing(a, b) == 2 && together(a, b, 2, depth, out)) return;
        if (h > (count >= 2 ? 1e-3 : 1.0) * resolution_ && depth < 40) {
            halve(a, b, depth, out);
            return;
        }
        out.explained = false;
        out.reason = std::to_string(count) + " eigenvalues changed sign" + (turned ? ", dp/ds too" : "") +
                     " between p = " + to_text(a.p) + " and " + to_text(b.p) +
                     ", and no critical point was found there";
    }

    /// Whether so many eigenvalues vanish between a and b at one point, which is noted then.
    bool together(const Point& a, const Point& b, int count, int depth, Events& out) {
        const double h = b.arc_length - a.arc_length;
        Point near = stepper_->between(a, b, 0.5).value_or(a);
        auto point = multiple_point(*stepper_, a, b, near, count, options_);
        if (!point) return false;
        const std::optional<double> share = share_of(a, b, *point);
        if (!share) return false;
        const auto [left, right] = beside(a, b, *share);
        if (left && right && changes(*left, *right) == changes(a, b) && changes(a, *left) == 0) {
            note(a, *left, std::move(*point), *right, b, depth, out);
            return true;
        }
        // close to it the branch is ill determined
        if (h > 20 * resolution_) return false;
        note(a, a, std::move(*point), b, b, depth, out);
        return true;
    }

    /// The points of the branch a 50th of the step before and behind the share of it; a and b where these are as near.
    std::pair<std::optional<Point>, std::optional<Point>> beside(const Point& a, const Point& b, double share) {
        constexpr double margin = 0.02;
        return {share > 2 * margin ? stepper_->between(a, b, share - margin) : a,
                share < 1 - 2 * margin ? stepper_->between(a, b, share + margin) : b};
    }
    /// Lists a point between left and right, and what is found in the rest of the step, which is searched on its own.
    void note(const Point& a, const Point& left, Critical point, const Point& right, const Point& b, int depth,
              Events& out) {
        point.negative_before = left.negative;
        point.negative_after = right.negative;
        if (left.arc_length != a.arc_length) locate(a, left, depth + 1, out);
        out.points.push_back(std::move(point));
        if (right.arc_length != b.arc_length) locate(right, b, depth + 1, out);
    }

    /// Searches between points that stand one in each gap between neighbouring zeros of the eigenvalues that change
    /// sign, as far as their first derivatives in the middle tell. Large structures have many close to each other, of
    /// which halving would part one at a time, and of which the weakest at one end is not that at the other. False
    /// where other numbers are predicted than are seen, and where zeros are not apart.
    bool separate(const Point& a, const Point& b, int depth, Events& out) {
        if (!BorderedSolver<Matrix>::sparse || !symmetric() || depth > 2) return false;
        const auto middle = stepper_->between(a, b, 0.5);
        if (!middle) return false;
        const double h = b.arc_length - a.arc_length;
        const std::vector<PredictedZero> zeros = predicted_zeros(*stepper_, *middle, changes(a, b), h / 2);
        const auto before = std::count_if(zeros.begin(), zeros.end(), [](const PredictedZero& z) { return z.s < 0; });
        if (before != changes(a, *middle) || static_cast<int>(zeros.size()) - before != changes(*middle, b))
            return false;
        std::vector<Point> between{a};
        for (std::size_t k = 1; k < zeros.size(); ++k) {
            if (zeros[k].s - zeros[k - 1].s < 1e-3 * h) return false;
            auto point = stepper_->between(a, b, 0.5 + (zeros[k - 1].s + zeros[k].s) / (2 * h));
            if (!point || changes(a, *point) != static_cast<int>(k)) return false;
            between.push_back(std::move(*point));
        }
        between.push_back(b);
        for (std::size_t k = 0; k < zeros.size(); ++k) {
            const Point &left = between[k], &right = between[k + 1];
            Point at = along(left, right, middle->arc_length + zeros[k].s - left.arc_length);
            at.border = stepper_->border_of(zeros[k].direction);
            at.weak_direction = zeros[k].direction;
            locate(left, right, depth + 1, out, &at);
        }
        return true;
    }
    /// The point between a and b that is so far along, as far as their tangents tell.
    Point along(const Point& a, const Point& b, double h) const {
        const Direction to = stepper_->through(a, b, h);
        Point y;
        y.q = stepper_->problem().retract(a.q, to.q);
        y.p = a.p + to.p;
        return y;
    }

    void halve(const Point& a, const Point& b, int depth, Events& out) {
        // the middle may be the very point at which the branch is ill determined
        for (const double share : {0.5, 0.37, 0.71})
            if (const auto middle = stepper_->between(a, b, share)) {
                locate(a, *middle, depth + 1, out);
                locate(*middle, b, depth + 1, out);
                return;
            }
        if (changes(a, b) == 0 && !folds(a, b)) return;
        out.explained = false;
        out.reason = "the branch was lost between p = " + to_text(a.p) + " and " + to_text(b.p);
    }

    /// Where the point lies between a and b, from 0 to 1, as far as a chord tells; nothing if it does not.
    std::optional<double> share_of(const Point& a, const Point& b, const Critical& point) const {
        const Direction chord = stepper_->difference(a, b.q, b.p), to = stepper_->difference(a, point.q, point.p);
        const double length2 = stepper_->dot(chord, chord), share = stepper_->dot(chord, to) / length2;
        Direction off = to;
        off.q -= share * chord.q;
        off.p -= share * chord.p;
        if (!(share >= 0 && share <= 1 && stepper_->dot(off, off) < 0.01 * length2)) return std::nullopt;
        return share;
    }

    /// A fold turns the branch and changes one eigenvalue; a bifurcation changes one, but where the branch runs along
    /// its null vector: there it turns it and changes none.
    bool agrees(const Point& a, const Point& b, const Critical& point) const {
        const int count = changes(a, b);
        const bool turned = folds(a, b);
        if (!is_bifurcation(point.kind)) return turned && count == 1;
        if (turned == (count == 1)) return false;
        if (!turned) return true;
        const Direction chord = stepper_->difference(a, b.q, b.p), null{point.null_vector, 0};
        return std::abs(stepper_->dot(chord, null)) > 0.5 * stepper_->length(chord) * stepper_->length(null);
    }

    /// How many of the two weakest eigenvalues, where these are known, may vanish about a short step: at both its ends
    /// so many are as near to 0 as they change within ten such steps.
    int vanishing(const Point& a, const Point& b) const {
        const double reach = 10 * std::abs(b.arc_length - a.arc_length);
        const auto at_end = [&](const Point& at) {
            int y = 0;
            for (Eigen::Index k = 1; k <= at.next_eigenvalues.size(); ++k)
                y += std::abs(eigenvalue(at, k)) <= reach * std::abs(slope(at, k));
            return y;
        };
        return std::min(at_end(a), at_end(b));
    }

    bool symmetric() const { return stepper_->problem().properties().symmetric; }

    AnyBranchStepper<Matrix>* stepper_;
    CriticalPointOptions options_;
    double resolution_ = 0;  ///< of the present step
};

}  // namespace detail

template <class Matrix>
StepEvents<Erased> events_between(AnyBranchStepper<Matrix>& stepper, const CriticalPointOptions& options,
                                  const BranchPoint<Erased>& a, const BranchPoint<Erased>& b) {
    return detail::StepEventFinder<Matrix>(stepper, options).between(a, b);
}

}  // namespace equilibria
