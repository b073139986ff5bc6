/// \file
/// Points of the other branches through a bifurcation: predicted to second order, found by the corrector.
///
/// A branch that leaves along the direction t has the points q (+) (s t_q + s^2 (z + w p'') / 2), p + s t_p + s^2 p''/2
/// with K z = -(g_qq[t, t] + 2 t_p g_qp t + t_p^2 g_pp) and K w = -dg/dp, both without a part along the null vectors.
/// In structures that are stiff against some motions z is what keeps them unstrained, and no corrector gets there from
/// a start without it. Source: Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems (1977).
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/continuation/detail/multiple_point_newton.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>

namespace equilibria::detail {

/// Finds the branches that leave a bifurcation, other than the one by which it was reached.
template <class Matrix>
class BranchSwitch {
public:
    using Point = BranchPoint<Erased>;

    /// All must outlive it. incoming: the tangent of the branch that is left.
    BranchSwitch(AnyBranchStepper<Matrix>& stepper, const CriticalPoint<Erased>& point, const Direction& incoming,
                 double amplitude)
        : stepper_(stepper), problem_(stepper.problem()), point_(point), incoming_(incoming), amplitude_(amplitude) {
        center_.q = point.q;
        center_.p = point.p;
    }

    std::vector<Point> run() {
        if (point_.null_vectors.cols() >= 2) {
            prepare(point_.null_vectors);
            search_around();
        } else if (point_.tangents.size() == 2) {
            prepare(point_.null_vector);
            // the other one than the branch that is left
            const bool first =
                std::abs(cosine(point_.tangents[0], incoming_)) < std::abs(cosine(point_.tangents[1], incoming_));
            const Direction& t = point_.tangents[first ? 0 : 1];
            const double phi2 = point_.null_vector.dot(stepper_.metric().cwiseProduct(point_.null_vector));
            const bool pitchfork = point_.kind == CriticalKind::pitchfork && t.p == 0;
            const double p2 =
                pitchfork && point_.curvature_error < std::abs(point_.curvature) ? point_.curvature / phi2 : 0;
            attempt(way_of(t, p2), {1, .5, .25, .125, .0625, .016, .004, .001, 2, 4});
        } else if (point_.kind == CriticalKind::hilltop && point_.null_vector.size() > 0) {
            prepare(point_.null_vector);
            attempt(way_of({point_.null_vector, 0}, 0), {1, .5, .25, .125, .03, .008, .002, 2, 4});
        }
        return std::move(found_);
    }

private:
    /// A direction of length 1 in which a branch may leave, p'', and z + w p'', where that is known.
    struct Way {
        Direction t;
        double p_curvature = 0;
        std::optional<Eigen::VectorXd> bend;
    };

    double cosine(const Direction& a, const Direction& b) const {
        return stepper_.dot(a, b) / (stepper_.length(a) * stepper_.length(b));
    }
    static Direction sum(const Direction& a, double by, const Direction& b) { return {a.q + by * b.q, a.p + by * b.p}; }

    /// Factors K at the point, with borders at the null vectors.
    void prepare(const Eigen::MatrixXd& null_vectors) {
        const std::vector<Eigen::Index> rows =
            rows_of_null_vectors(null_vectors, stepper_.metric(), problem_.multipliers());
        if (rows.empty()) return;
        Linearization<Matrix> here = problem_.linearization(point_.q, point_.p);
        borders_.emplace(stepper_.solver(), std::move(here.tangent), rows);
        if (!borders_->factored()) {
            borders_.reset();
            return;
        }
        const Eigen::Index n = null_vectors.rows(), k = null_vectors.cols();
        const auto zero = Eigen::MatrixXd::Zero(k, 1);
        by_load_ = borders_->solve(-here.parameter_derivative, zero, false).x;
        left_ =
            borders_
                ->solve(Eigen::MatrixXd::Zero(n, k), Eigen::MatrixXd::Identity(k, k), !problem_.properties().symmetric)
                .x;
        load_ = left_.transpose() * here.parameter_derivative;
    }
    /// g_qq[t, t] + 2 t_p g_qp t + t_p^2 g_pp.
    Eigen::VectorXd second(const Direction& t) const {
        Eigen::VectorXd y = problem_.tangent_derivative(point_.q, point_.p, t.q) * t.q;
        if (t.p != 0)
            y += 2 * t.p * problem_.parameter_derivative_along(point_.q, point_.p, t.q) +
                 t.p * t.p * problem_.second_parameter_derivative(point_.q, point_.p);
        return y;
    }

    /// The way along t, of any length, with p'' by that length.
    Way way_of(Direction t, double p_curvature) {
        Way y{std::move(t), p_curvature, {}};
        const double size = stepper_.length(y.t);
        if (!(size > 0)) return y;
        AnyBranchStepper<Matrix>::scale(y.t, 1 / size);
        y.p_curvature /= size * size;
        if (!borders_) return y;
        Eigen::VectorXd z = borders_->solve(-second(y.t), Eigen::MatrixXd::Zero(left_.cols(), 1), false).x.col(0) +
                            y.p_curvature * by_load_;
        if (z.allFinite()) y.bend = std::move(z);
        return y;
    }
    /// The way along a combination of the null vectors, with the load that the bifurcation equations give it: at a
    /// hilltop p'' = -l.q / l.l, l = W^T dg/dp, q = W^T g_qq[v, v]; else t_p = -b.q / (2 b.b), b = W^T (dK along the
    /// branch that is left) v.
    Way way_along(const Eigen::VectorXd& v) {
        Direction t{v, 0};
        if (!borders_) return way_of(t, 0);
        const Eigen::VectorXd turned = second(t), quadratic = left_.transpose() * turned;
        // noise, where the symmetry makes the quadratic terms 0
        if (!(quadratic.norm() > 1e-6 * left_.norm() * turned.norm())) return way_of(t, 0);
        if (point_.kind == CriticalKind::hilltop) return way_of(t, -load_.dot(quadratic) / load_.squaredNorm());
        if (!slope_) return way_of(t, 0);
        const Eigen::VectorXd b =
            left_.transpose() * (*slope_ * v + problem_.parameter_derivative_along(point_.q, point_.p, v));
        const double share = -b.dot(quadratic) / (2 * b.squaredNorm());
        if (std::isfinite(share)) {
            t.p = share;
            t.q += share * by_load_;
        }
        return way_of(t, 0);
    }

    /// Directions between null vectors, all around, until some amplitude leads to a branch.
    void search_around() {
        if (std::abs(incoming_.p) * stepper_.parameter_weight() > 1e-3 * stepper_.length(incoming_))
            slope_ = problem_.tangent_derivative(point_.q, point_.p, incoming_.q / incoming_.p);
        const Eigen::Index k = point_.null_vectors.cols();
        // all of them first: the factors that they are solved with are the stepper's own
        std::vector<Way> ways;
        // several more than the lines of the symmetries of plates and rings
        const Eigen::Index count = k == 2 ? 24 : 20 * k;
        for (Eigen::Index i = 0; i < count; ++i) {
            Eigen::VectorXd c(k);
            if (k == 2) {
                const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
                c << std::cos(angle), std::sin(angle);
            } else {
                c = i < k ? Eigen::VectorXd(Eigen::VectorXd::Unit(k, i)) : generic_vector(k, 31 * i).normalized();
            }
            ways.push_back(way_along(point_.null_vectors * c));
        }
        // close to the point all directions between branches are nearly equilibria, far from it branches are missed
        std::vector<Point> best;
        int more = 3;
        for (const double share : {1.0, 0.25, 4.0, 0.06, 2.0, 8.0, 0.015, 0.004}) {
            found_.clear();
            directions_.clear();
            // where there are more than any discrete symmetry has, all others are turns of these
            for (const Way& way : ways) {
                if (leave_in_every_direction(static_cast<int>(k), found_.size())) break;
                attempt(way, {share});
            }
            if (found_.size() > best.size()) best.swap(found_);
            // of a symmetry of order three, and its mirror images
            if (best.size() >= 6 || (!best.empty() && more-- == 0)) break;
        }
        found_ = std::move(best);
    }

    /// Both half branches along a way, by the first of these shares of the amplitude that leads to one.
    void attempt(const Way& way, std::initializer_list<double> shares) {
        if (!(stepper_.length(way.t) > 0)) return;
        for (const double sign : {1.0, -1.0})
            for (const double share : shares)
                if (leave(way, sign, share * amplitude_)) break;
    }

    /// Whether a branch was found a length s along the way.
    bool leave(const Way& way, double sign, double s) {
        // the plane's normal has no share of the branch that is left: the corrector cannot fall back onto it
        const Direction normal =
            sum(way.t, -stepper_.dot(way.t, incoming_) / stepper_.dot(incoming_, incoming_), incoming_);
        Direction along = way.t, straight = way.t;
        AnyBranchStepper<Matrix>::scale(along, sign);
        AnyBranchStepper<Matrix>::scale(straight, sign * s);
        straight.p += way.p_curvature * s * s / 2;
        Direction bent = straight;
        if (way.bend) bent.q += s * s / 2 * *way.bend;
        // so far the second order says nothing
        const bool bends = way.bend && stepper_.length(sum(bent, -1, straight)) < 0.5 * s;
        for (const Direction* increment : {&bent, &straight}) {
            if (increment == &bent && !bends) continue;
            auto start = stepper_.onto(point_.q, point_.p, *increment, normal, along);
            if (!start) continue;
            const Direction to = stepper_.difference(center_, start->q, start->p);
            // somewhere else, or on the branch that is left
            if (stepper_.length(sum(to, -1, *increment)) > most_off * stepper_.length(*increment)) continue;
            const double with_incoming = std::abs(cosine(to, incoming_));
            if (with_incoming > std::max(0.99, (1 + std::abs(cosine(way.t, incoming_))) / 2)) continue;
            if (std::none_of(directions_.begin(), directions_.end(),
                             [&](const Direction& other) { return cosine(to, other) > 0.995; })) {
                directions_.push_back(to);
                found_.push_back(std::move(*start));
            }
            return true;
        }
        return false;
    }

    static constexpr double most_off = 0.9;  ///< of a start's prediction, over its length

    AnyBranchStepper<Matrix>& stepper_;
    const AnyProblem<Matrix>& problem_;
    const CriticalPoint<Erased>& point_;
    const Direction& incoming_;
    double amplitude_;
    Point center_;
    std::optional<SeveralBorders<Matrix>> borders_;
    Eigen::MatrixXd left_;
    Eigen::VectorXd by_load_, load_;
    std::optional<Matrix> slope_;  ///< dK along the branch that is left, by p, without its own part by p
    std::vector<Point> found_;
    std::vector<Direction> directions_;  ///< from the critical point to what was found
};

}  // namespace equilibria::detail
