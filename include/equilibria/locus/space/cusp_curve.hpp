/// \file
/// Curves of cusps in a space of three parameters x, y, z of a model, followed by arc length both ways:
///
///     const auto curve = trace_cusp_curve<Chain, Chain::alpha, Chain::omega, Chain::ratio>(p, q, box);
///     for (const auto& t : curve.transitions) std::cout << t.z << ' ' << to_string(t.at.kind) << '\n';
///
/// What is continued in the parameter z: cusp_problem.hpp. On the way what the cusp turns into is located
/// (singularity.hpp) and named: swallowtails, where the reduced fourth derivative b vanishes and the curve turns in z
/// as well; umbilics, where a second eigenvalue of J does; lips and beak-to-beak, where the curve is tangent to a plane
/// z = const with b away from 0.
/// Where it fails: next to a symmetric point (theta -> -theta) the problem is nearly singular. There the three even
/// derivatives phi'', phi'''' and phi^(6) vanish together; the curve is taken to that point by its own equations, and
/// ends: on the other side it is its mirror image.
/// Two transitions of one kind within one step of the curve are not seen.
/// Source: Arnold, Catastrophe Theory, chapter 9 (metamorphoses); Poston and Stewart, Catastrophe Theory and Its
/// Applications, 9.3 and 9.5.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/continuation/event_function.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/locus/space/cusp_curve_result.hpp>
#include <equilibria/locus/space/cusp_problem.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/reduced_series.hpp>
#include <equilibria/singularity/refine_cusp_tangency.hpp>
#include <equilibria/singularity/refine_singularity.hpp>
#include <equilibria/singularity/refine_umbilic.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria {

namespace detail {

template <PotentialModel M, int X, int Y, int Z>
class CuspTracer {
public:
    using Problem = CuspProblem<M, X, Y, Z>;
    using Point = BranchPoint<Problem>;
    static constexpr int n = n_unknowns<M>;

    CuspTracer(const Parameters<M>& p, const Box& box, const CuspCurveOptions& options)
        : box_(box), options_(options), problem_(p, box.x.high - box.x.low, box.y.high - box.y.low),
          stepper_(problem_, branch_options(box, options)), symmetric_(is_symmetric(p)) {}

    CuspCurve<M> run(const Unknowns<M>& q, const Parameters<M>& p) {
        CuspCurve<M> curve;
        auto start = start_at(q, p);
        if (!start) return curve;
        for (std::size_t side = 0; side < 2; ++side) {
            BranchStepper<Problem>::flip(start->tangent);
            Half half;
            half.points.push_back(*start);
            curve.ends[side] = follow(half);
            append(curve, half, side);
            if (curve.ends[0] == CurveEnd::closed) {
                curve.ends[1] = CurveEnd::closed;
                break;
            }
        }
        return curve;
    }

private:
    struct Half {
        std::vector<Point> points;
        std::vector<CuspTransition<M>> transitions;
    };

    static BranchOptions branch_options(const Box& box, const CuspCurveOptions& options) {
        BranchOptions branch = options.branch;
        branch.parameter_weight = 1 / (box.z.high - box.z.low);
        return branch;
    }

    /// Whether F(-theta) = -F(theta) whatever x, y and z are, at points and parameters without a pattern.
    bool is_symmetric(Parameters<M> p) const {
        if (n_coordinates<M> != 0) return false;
        Generator generator(1);
        for (int trial = 0; trial < 3; ++trial) {
            p[X] = uniform(generator, box_.x.low, box_.x.high);
            p[Y] = uniform(generator, box_.y.low, box_.y.high);
            p[Z] = uniform(generator, box_.z.low, box_.z.high);
            Unknowns<M> q, mirrored;
            for (int i = 0; i < n; ++i) q[i] = uniform(generator, 0.3, 2.8), mirrored[i] = -q[i];
            const auto f = equations<M>(q, p), g = equations<M>(mirrored, p);
            for (int i = 0; i < n; ++i)
                if (!(std::abs(f[i] + g[i]) <= 1e-12 * largest(f))) return false;
        }
        return true;
    }

    std::optional<Point> start_at(const Unknowns<M>& q, const Parameters<M>& p) {
        const auto cusp = refine_singularity<M, SingularityKind::cusp, X, Y>(q, p);
        const bool found = cusp.converged && cusp.nullity == 1;
        const Unknowns<M> v = found ? cusp.v : equilibria::null_vector<M>(jacobian<M, double>(q, p));
        const auto at =
            found ? Problem::packed(cusp.q, cusp.v, cusp.p[X], cusp.p[Y]) : Problem::packed(q, v, p[X], p[Y]);
        auto start = stepper_.start(at, p[Z], 1);
        if (!start) {
            // where z turns back Newton's method at a fixed z fails
            start = stepper_.assess(at, p[Z], std::nullopt);
            if (!start || !(start->residual < 1e-6)) return std::nullopt;
            start->proposed_step = options_.branch.first_step;
        }
        if (!contains(*start)) return std::nullopt;
        return start;
    }

    static double x(const Point& at) { return at.q(2 * n); }
    static double y(const Point& at) { return at.q(2 * n + 1); }
    bool contains(const Point& at) const { return box_.contains(x(at), y(at), at.p); }
    bool at_face(const Point& at) const {
        const auto near = [](double value, double low, double high) {
            return std::min(value - low, high - value) < 1e-6 * (high - low);
        };
        return near(x(at), box_.x.low, box_.x.high) || near(y(at), box_.y.low, box_.y.high) ||
               near(at.p, box_.z.low, box_.z.high);
    }
    bool contains(const Singularity<M>& at) const { return box_.contains(at.p[X], at.p[Y], at.p[Z]); }
    Parameters<M> parameters(const Point& at) const { return problem_.parameters(at.q, at.p); }

    double fourth(const Point& at) const {
        const auto series = reduced_series<M, 3>(Problem::unknowns(at.q), Problem::null_vector(at.q), parameters(at));
        return series.derivative(4);
    }
    /// The product of the eigenvalues of J but for that of v: 0 where a second null vector joins.
    double others(const Point& at) const {
        Eigen::Matrix<double, n + 1, n + 1> bordered = Eigen::Matrix<double, n + 1, n + 1>::Zero();
        bordered.template topLeftCorner<n, n>() = jacobian<M, double>(Problem::unknowns(at.q), parameters(at));
        for (int i = 0; i < n; ++i) bordered(i, n) = at.q(n + i), bordered(n, i) = -at.q(n + i);
        return bordered.determinant();
    }

    CurveEnd follow(Half& half) {
        const Point first = half.points.front();
        while (static_cast<int>(half.points.size()) < options_.most_points) {
            const Point& last = half.points.back();
            auto next = stepper_.advance(last);
            if (symmetric_ && meets_mirror_image(half, next)) return CurveEnd::symmetric;
            if (!next) return given_up(half);
            const bool leaves = !contains(*next);
            if (leaves) next = at_border(last, *next);
            note_transitions(half, last, *next);
            if (!leaves && closes(first, last, *next)) {
                half.points.push_back(first);
                return CurveEnd::closed;
            }
            half.points.push_back(std::move(*next));
            if (leaves) return CurveEnd::border;
        }
        return CurveEnd::length;
    }

    /// Next to a face the last points, taken in ever smaller steps, are rounding.
    CurveEnd given_up(Half& half) const {
        if (!at_face(half.points.back())) return CurveEnd::step;
        const auto is_noise = [&](const Point& at) { return at_face(at) && at.step < options_.branch.first_step; };
        while (half.points.size() > 1 && is_noise(half.points.back())) half.points.pop_back();
        std::erase_if(half.transitions, [&](const auto& t) { return t.step + 1 >= half.points.size(); });
        return CurveEnd::degenerate;
    }

    /// Back at the first point: between `last` and `now` the curve passes the plane through it that is normal to its
    /// tangent, in its direction. Angles modulo 2 pi, the null vector up to its sign.
    bool closes(const Point& first, const Point& last, const Point& now) const {
        const double sign = first.q.segment(n, n).dot(now.q.segment(n, n)) < 0 ? -1 : 1;
        const auto from_first = [&](const Point& at) {
            Direction d = stepper_.difference(first, at.q, at.p);
            for (int i = 0; i < n_angles<M>; ++i) d.q(i) = wrap(d.q(i));
            d.q.segment(n, n) = sign * at.q.segment(n, n) - first.q.segment(n, n);
            return d;
        };
        const Direction d = from_first(now);
        if (!(stepper_.length(d) < 1.5 * options_.branch.largest_step)) return false;
        Direction along = now.tangent;
        along.q.segment(n, n) *= sign;
        return stepper_.dot(first.tangent, along) > 0.95 && stepper_.dot(first.tangent, from_first(last)) < 0 &&
               stepper_.dot(first.tangent, d) >= 0;
    }

    /// `at`: what Newton's method found from `near`, a point of the curve.
    void note(Half& half, const Point& near, Singularity<M> at) {
        const double x_off = (at.p[X] - x(near)) / (box_.x.high - box_.x.low);
        const double y_off = (at.p[Y] - y(near)) / (box_.y.high - box_.y.low);
        const double z_off = (at.p[Z] - near.p) / (box_.z.high - box_.z.low);
        double off = std::max({std::abs(x_off), std::abs(y_off), std::abs(z_off)});
        for (int i = 0; i < n; ++i) off = std::max(off, std::abs(at.q[i] - near.q(i)));
        if (!at.converged || !(off < 1e-4)) {
            at = singularity_at<M, X, Y, Z>(SingularityKind::undecided, Problem::unknowns(near.q), parameters(near),
                                            Problem::null_vector(near.q));
            at.residual = near.residual;
            at.nullity = nullity<M>(jacobian<M, double>(at.q, at.p), 0);
        }
        half.transitions.push_back({half.points.size() - 1, at});
    }

    /// What changes sign between two points of the curve.
    void note_transitions(Half& half, const Point& last, const Point& next) {
        const EventFunction<Problem> corank{"other eigenvalues", [&](const Point& at) { return others(at); }};
        // b has a pole where the other eigenvalues have a zero
        const EventFunction<Problem> quartic{"fourth derivative",
                                             [&](const Point& at) { return fourth(at) * others(at); }};
        const EventFunction<Problem> turn{"dz/ds", [](const Point& at) { return at.tangent.p; }};
        const auto zero = [&](const EventFunction<Problem>& function) -> std::optional<Point> {
            if (std::signbit(function.value(last)) == std::signbit(function.value(next))) return std::nullopt;
            return zero_between(stepper_, function, last, next);
        };
        const std::size_t before = half.transitions.size();
        const auto swallowtail = zero(quartic);
        if (swallowtail)
            note(
                half, *swallowtail,
                refine_singularity<M, SingularityKind::swallowtail, X, Y, Z>(
                    Problem::unknowns(swallowtail->q), parameters(*swallowtail), Problem::null_vector(swallowtail->q)));
        if constexpr (n >= 2)
            if (const auto at = zero(corank))
                note(half, *at, refine_umbilic<M, X, Y, Z>(Problem::unknowns(at->q), parameters(*at)));
        if (const auto at = zero(turn)) {
            const bool known = swallowtail && stepper_.length(stepper_.difference(*swallowtail, at->q, at->p)) < 1e-5;
            if (!known)
                note(half, *at,
                     refine_cusp_tangency<M, X, Y, Z>(Problem::unknowns(at->q), parameters(*at),
                                                      Problem::null_vector(at->q)));
        }
        const auto along = [&](const CuspTransition<M>& t) {
            const auto d = stepper_.difference(last, Problem::packed(t.at.q, t.at.v, t.at.x(), t.at.y()), t.at.z());
            double sum = d.p * last.tangent.p * stepper_.parameter_weight() * stepper_.parameter_weight();
            for (int i = 0; i < n; ++i) sum += d.q(i) * last.tangent.q(i);
            for (int i = 2 * n; i < 2 * n + 2; ++i) sum += d.q(i) * last.tangent.q(i) * stepper_.metric()(i);
            return sum;
        };
        std::sort(half.transitions.begin() + static_cast<std::ptrdiff_t>(before), half.transitions.end(),
                  [&](const auto& a, const auto& b) { return along(a) < along(b); });
    }

    static double sines(const Point& at) {
        double sum = 0;
        for (int i = 0; i < n; ++i) sum += std::sin(at.q(i)) * std::sin(at.q(i));
        return sum;
    }

    /// Whether the curve runs into a point of a symmetric branch ahead of its last point; it and the transition are
    /// appended. Parameters are even along the curve, p = p* + c |sin q|^2 + .., which two points extrapolate.
    bool meets_mirror_image(Half& half, const std::optional<Point>& next) {
        if constexpr (n_coordinates<M> == 0) {
            const Point& last = half.points.back();
            const double before = sines(last);
            if (before > 0.1) return false;
            bool passes = !next;
            if (next) {
                double dot = 0;
                for (int i = 0; i < n; ++i) dot += std::sin(last.q(i)) * std::sin(next->q(i));
                passes = dot <= 1e-4 * before;
                if (!passes && !(sines(*next) < before)) return false;
            }
            const Point& near = passes ? last : *next;
            const auto at = refine_singularity<M, SingularityKind::tetracritical_pitchfork, X, Y, Z>(
                Problem::unknowns(near.q), parameters(near), Problem::null_vector(near.q));
            if (at.kind != SingularityKind::tetracritical_pitchfork || !contains(at)) return false;
            const double scales[] = {box_.x.high - box_.x.low, box_.y.high - box_.y.low, box_.z.high - box_.z.low};
            const double there[] = {at.p[X], at.p[Y], at.p[Z]}, here[] = {x(near), y(near), near.p};
            const Point& other =
                passes ? half.points[half.points.size() - std::min<std::size_t>(2, half.points.size())] : last;
            const double from[] = {x(other), y(other), other.p};
            const double share = sines(near) / (sines(other) - sines(near));
            double off = 0, way = 0;
            for (int k = 0; k < 3; ++k) {
                const double predicted = here[k] + share * (here[k] - from[k]);
                off = std::max(off, std::abs(predicted - there[k]) / scales[k]);
                way = std::max(way, std::abs(there[k] - here[k]) / scales[k]);
            }
            if (!(off <= (passes ? 0.3 : 0.05) * way + 1e-9)) return false;
            Unknowns<M> q = Problem::unknowns(near.q), way_there = displacement<M>(q, at.q);
            for (int i = 0; i < n; ++i) q[i] += way_there[i];  // the turn of the last point
            Point end = near;
            end.q = Problem::packed(q, at.v, at.p[X], at.p[Y]);
            end.p = at.p[Z];
            if (!passes) {
                note_transitions(half, last, *next);
                half.points.push_back(*next);
            }
            half.transitions.push_back({half.points.size() - 1, at});
            half.points.push_back(std::move(end));
            return true;
        }
        return false;
    }

    /// The point of the curve near `from` (+) chord at which the parameter of the axis is that of the chord's end.
    std::optional<Point> where(const Point& from, const Direction& chord, int axis) {
        Direction normal{Eigen::VectorXd::Zero(chord.q.size()), axis == 2 ? 1.0 : 0.0};
        if (axis < 2) normal.q(2 * n + axis) = 1;
        return stepper_.onto(from.q, from.p, chord, normal, from.tangent);
    }

    /// Where the segment from a (inside) to b (outside) leaves the box: on the curve if Newton's method finds it there,
    /// else on the chord.
    Point at_border(const Point& a, const Point& b) {
        const double from[] = {x(a), y(a), a.p}, to[] = {x(b), y(b), b.p};
        const double low[] = {box_.x.low, box_.y.low, box_.z.low}, high[] = {box_.x.high, box_.y.high, box_.z.high};
        double part = 1, value = 0;
        int axis = 0;
        for (int k = 0; k < 3; ++k)
            for (const double bound : {low[k], high[k]}) {
                if (!((from[k] - bound) * (to[k] - bound) <= 0) || from[k] == to[k]) continue;
                const double share = (bound - from[k]) / (to[k] - from[k]);
                if (share <= part && (bound == low[k]) == (to[k] < from[k])) part = share, axis = k, value = bound;
            }
        Direction chord = stepper_.difference(a, b.q, b.p);
        BranchStepper<Problem>::scale(chord, part);
        (axis < 2 ? chord.q(2 * n + axis) : chord.p) = value - from[axis];
        auto found = where(a, chord, axis);
        if (found) {
            Direction d = stepper_.difference(a, found->q, found->p);
            d.q -= chord.q;
            d.p -= chord.p;
            if (!(stepper_.length(d) < 0.1)) found.reset();
        }
        if (!found) {
            found = b;
            found->q = a.q + chord.q;
            found->p = a.p + chord.p;
        }
        (axis < 2 ? found->q(2 * n + axis) : found->p) = value;
        found->arc_length = a.arc_length + stepper_.dot(a.tangent, stepper_.difference(a, found->q, found->p));
        return *found;
    }

    void append(CuspCurve<M>& curve, const Half& half, std::size_t side) const {
        std::vector<Singularity<M>> points;
        for (const Point& at : half.points) {
            points.push_back(singularity_at<M, X, Y, Z>(SingularityKind::cusp, Problem::unknowns(at.q), parameters(at),
                                                        Problem::null_vector(at.q)));
            points.back().nullity = 1;
            points.back().derivatives[1] = fourth(at);
        }
        if (side == 0) {
            curve.points.assign(points.rbegin(), points.rend());
            for (auto t = half.transitions.rbegin(); t != half.transitions.rend(); ++t) {
                curve.transitions.push_back(*t);
                curve.transitions.back().step = points.size() - 2 - t->step;
            }
        } else {
            const std::size_t before = curve.points.size() - 1;
            curve.points.insert(curve.points.end(), points.begin() + 1, points.end());
            for (const auto& t : half.transitions) {
                curve.transitions.push_back(t);
                curve.transitions.back().step += before;
            }
        }
    }

    Box box_;
    CuspCurveOptions options_;
    Problem problem_;
    BranchStepper<Problem> stepper_;
    bool symmetric_;
};

}  // namespace detail

/// The curve of cusps through the one near q at the parameters p, in the space of the parameters number X, Y and Z,
/// within the box; the other parameters are those of p. Without points where no cusp is found near q and p in the box.
///
/// Throws InvalidArgument for a box that is empty or not finite, for arguments that are not finite and for options out
/// of range.
template <PotentialModel M, int X, int Y, int Z>
CuspCurve<M> trace_cusp_curve(const Parameters<M>& p, const Unknowns<M>& q, const Box& box,
                              const CuspCurveOptions& options = {}) {
    detail::check_active<M, X, Y, Z>();
    require_finite(p, "p");
    require_finite(q, "q");
    box.validate();
    options.validate();
    return detail::CuspTracer<M, X, Y, Z>(p, box, options).run(q, p);
}

}  // namespace equilibria
