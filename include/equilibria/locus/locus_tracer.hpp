/// \file
/// Traces the curves of a locus from the events on lines, until every event is on a curve.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <equilibria/continuation/critical_curve.hpp>
#include <equilibria/continuation/event_function.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/line_events.hpp>
#include <equilibria/locus/locus_result.hpp>
#include <equilibria/locus/pitchfork_curve.hpp>
#include <equilibria/locus/reduced_coefficients.hpp>
#include <equilibria/locus/region_counts.hpp>

namespace equilibria {

struct LocusOptions {
    int lines = 12;            ///< lines in each direction that are solved for seeds, at least 2
    int checks = 20;           ///< points in each direction whose count is compared with their region's; 0: none
    std::uint64_t seed = 1;    ///< of every enumeration
    /// Of the curves, in angles and in parts of the window; parameter_weight is set by it.
    PathOptions path{.first_step = 1e-3, .largest_step = 0.006, .largest_angle = 0.15};
    int most_points = 20000;   ///< of one curve

    void validate() const {
        require(lines >= 2 && lines <= 10000, "lines", lines, "must be 2 to 10000");
        require(checks >= 0 && checks <= 10000, "checks", checks, "must be 0 to 10000");
        require(most_points > 1, "most_points", most_points, "must be more than 1");
        path.validate();
    }
};

namespace detail {

template <Model M, int X, int Y>
class LocusTracer {
public:
    static constexpr int n = n_unknowns<M>;

    LocusTracer(const Parameters<M>& p, const PlaneWindow& window, const LocusOptions& options)
        : options_(options), symmetric_(symmetric_branches<M>()) {
        enumerate_options_.seed = options.seed;
        locus_.window = window;
        locus_.parameters = p;
    }

    Locus<M> run() {
        const auto begin = std::chrono::steady_clock::now();
        const PlaneWindow& w = locus_.window;
        solve_lines<X, Y>(w.x_low, w.x_high, w.y_low, w.y_high);
        solve_lines<Y, X>(w.y_low, w.y_high, w.x_low, w.x_high);
        for (Seed& seed : seeds_)
            if (!seed.traced) trace_from(seed);
        for (const Seed& seed : seeds_) locus_.evidence.untraced_seeds += !seed.traced;
        count_regions<M, X, Y>(locus_, options_.checks, enumerate_options_);
        locus_.evidence.seconds = seconds_since(begin);
        return std::move(locus_);
    }

private:
    /// An event on a line: where the parameter number `fixed` has the value `line`.
    struct Seed {
        LocusKind kind;
        int fixed;
        double line;
        LocusPoint<M> at;
        bool traced = false;
    };

    template <int Active, int Fixed>
    void solve_lines(double active_low, double active_high, double low, double high) {
        const LineSolver<M, Active> solver(locus_.parameters, Fixed, low, high, enumerate_options_);
        locus_.evidence.failed_paths += solver.paths().failed;
        for (int k = 0; k < options_.lines; ++k) {
            // off the centre of the cells, where special values (alpha = 1/2) would sit
            const double line = low + (high - low) * (k + 0.4713) / options_.lines;
            const auto add = [&](const LineEvent<M>& event) {
                if (!(event.value >= active_low && event.value <= active_high)) return;
                LocusPoint<M> at{0, 0, event.q, event.v};
                (Active == X ? at.x : at.y) = event.value;
                (Active == X ? at.y : at.x) = line;
                if (is_family(at)) return;
                for (const Seed& other : seeds_)  // the mirror image
                    if (other.fixed == Fixed && other.line == line && other.kind == event.kind && same(other.at, at)) return;
                seeds_.push_back({event.kind, Fixed, line, at});
            };
            for (const auto& event : solver.folds(line, locus_.evidence.failed_paths)) add(event);
            for (const auto& event : solver.pitchforks(line, active_low, active_high)) add(event);
            ++locus_.evidence.lines;
        }
        locus_.evidence.seeds = seeds_.size();
    }

    Parameters<M> parameters_at(double x, double y) const {
        Parameters<M> p = locus_.parameters;
        p[X] = x;
        p[Y] = y;
        return p;
    }

    /// Equilibria that are degenerate along with all their neighbours are no event: a row of J vanishes, as that of a
    /// massless link does, measured against the same row in the middle of the window.
    bool is_family(const LocusPoint<M>& at) const {
        const PlaneWindow& w = locus_.window;
        const auto here = jacobian<M, double>(at.q, parameters_at(at.x, at.y));
        const auto there = jacobian<M, double>(
            at.q, parameters_at(0.5 * (w.x_low + w.x_high), 0.5 * (w.y_low + w.y_high)));
        for (int i = 0; i < n; ++i)
            if (!(here.row(i).norm() > 1e-9 * there.row(i).norm())) return true;
        return false;
    }

    /// The same event, or its mirror image; angles modulo 2 pi, null vectors up to sign.
    bool same(const LocusPoint<M>& a, const LocusPoint<M>& b, double tolerance = 1e-5) const {
        if (std::abs(a.x - b.x) > tolerance * locus_.window.width()) return false;
        if (std::abs(a.y - b.y) > tolerance * locus_.window.height()) return false;
        for (const int mirror : {1, -1}) {
            if (mirror < 0 && symmetric_.empty()) break;
            double q = 0, dot = 0;
            for (int i = 0; i < n; ++i) {
                const double d = a.q[i] - (i < n_angles<M> ? mirror : 1) * b.q[i];
                q = std::max(q, i < n_angles<M> ? std::abs(std::remainder(d, 2 * std::numbers::pi)) : std::abs(d));
                dot += a.v[i] * b.v[i];
            }
            if (q < 100 * tolerance && std::abs(std::abs(dot) - 1) < 100 * tolerance) return true;
        }
        return false;
    }

    bool is_symmetric(const Unknowns<M>& q) const {
        if (symmetric_.empty()) return false;
        for (int i = 0; i < n; ++i)
            if (std::abs(std::sin(q[i])) > 1e-6) return false;
        return true;
    }

    using Family = ModelFamily<M, X, Y>;
    using Folds = FoldCurve<Family>;
    using Pitchforks = PitchforkCurve<M, X, Y>;
    /// Of both kinds of curves: q, x and the border.
    using At = Configuration<Folds>;

    /// The unit null vector, with the sign of `before` where that is given.
    Eigen::VectorXd null_vector(const At& at, double y, const Eigen::VectorXd* before = nullptr) const {
        const BorderedTangent<ModelProblem<M, X>> b(Family{locus_.parameters}(y), at);
        Eigen::VectorXd v = b.regular ? b.null.x.normalized().eval() : Eigen::VectorXd::Zero(n).eval();
        if (before && v.dot(*before) < 0) v = -v;
        return v;
    }
    LocusPoint<M> point_of(const At& at, double y) const {
        using Problem = ModelProblem<M, X>;
        return {at.p, y, Problem::unknowns(at.q), Problem::unknowns(null_vector(at, y))};
    }

    void trace_from(const Seed& seed) {
        At at;
        at.q = ModelProblem<M, X>::vector(seed.at.q);
        at.p = seed.at.x;
        ModelProblem<M, X>::vector(seed.at.v).cwiseAbs().maxCoeff(&at.border.column);
        at.border.row = at.border.column;
        const Family family{locus_.parameters};
        at = with_best_border(family(seed.at.y), at);
        if (seed.kind == LocusKind::fold)
            trace(Folds(family, seed.at.y, locus_.window.width()), at, seed);
        else
            trace(Pitchforks(family, locus_.window.width()), at, seed);
    }

    template <class Curve>
    void trace(const Curve& system, const At& at, const Seed& seed) {
        PathOptions path = options_.path;
        path.parameter_weight = 1 / locus_.window.height();
        PathStepper<Curve> stepper(system, path);
        auto start = stepper.start(at, seed.at.y, 1);
        if (!start) {
            // where y turns back Newton's method at a fixed y fails, and the seed is exact
            start = stepper.assess(at, seed.at.y, std::nullopt);
            if (!start) return;
            start->proposed_step = path.first_step;
        }
        LocusCurve<M> curve{seed.kind, {}, {CurveEnd::step, CurveEnd::step}};
        std::vector<BranchPoint<Curve>> whole;
        for (int side = 0; side < 2; ++side) {
            PathStepper<Curve>::flip(start->tangent);
            std::vector<BranchPoint<Curve>> half{*start};
            curve.ends[static_cast<std::size_t>(side)] = follow(stepper, half);
            if (side == 0) {
                whole.assign(half.rbegin(), half.rend());
                if (curve.ends[0] == CurveEnd::closed) {
                    curve.ends[1] = CurveEnd::closed;
                    break;
                }
            } else {
                whole.insert(whole.end(), half.begin() + 1, half.end());
            }
        }
        for (const CurveEnd end : curve.ends)
            locus_.evidence.broken_curves += end == CurveEnd::step || end == CurveEnd::length;
        for (const auto& point : whole) curve.points.push_back(point_of(point.q, point.p));
        if (curve.points.size() < 2) return;
        claim_seeds(stepper, whole, seed.kind);
        locus_.curves.push_back(std::move(curve));
    }

    /// Follows a curve from its only point, appending to it, to the border of the window or where it ends within.
    template <class Curve>
    CurveEnd follow(PathStepper<Curve>& stepper, std::vector<BranchPoint<Curve>>& points) {
        constexpr bool folds = std::is_same_v<Curve, Folds>;
        const BranchPoint<Curve> first = points.front();
        BranchPoint<Curve> last = first;
        while (static_cast<int>(points.size()) < options_.most_points) {
            auto next = stepper.advance(last);
            if (!next) return CurveEnd::step;
            if (!locus_.window.contains(next->q.p, next->p)) {
                points.push_back(at_border(stepper, last, *next));
                return CurveEnd::window;
            }
            if constexpr (folds) {
                const Eigen::VectorXd v = null_vector(last.q, last.p);
                const EventFunction<Curve> third{"third derivative", [&](const BranchPoint<Curve>& at) {
                                                     return third_at(at, v);
                                                 }};
                std::optional<BranchPoint<Curve>> cusp;
                if (std::signbit(third.value(last)) != std::signbit(third.value(*next)))
                    cusp = zero_between(stepper, third, last, *next);
                if (cusp) {
                    points.push_back(*cusp);
                    if (note_cusp(*cusp)) return CurveEnd::symmetric;
                }
            }
            if (points.size() > 10 && closes(stepper, first, *next)) {
                points.push_back(first);
                return CurveEnd::closed;
            }
            points.push_back(*next);
            last = std::move(*next);
        }
        return CurveEnd::length;
    }

    /// The reduced third derivative along the null vector on the side of `before`.
    double third_at(const BranchPoint<Folds>& at, const Eigen::VectorXd& before) const {
        using Problem = ModelProblem<M, X>;
        return reduced_coefficients<M>(Problem::unknowns(at.q.q), Problem::unknowns(null_vector(at.q, at.p, &before)),
                                       parameters_at(at.q.p, at.p))
            .third;
    }

    /// Back at the first point, in the same direction; angles modulo 2 pi.
    template <class Curve>
    bool closes(const PathStepper<Curve>& stepper, const BranchPoint<Curve>& first, const BranchPoint<Curve>& now) const {
        Direction d = stepper.difference(first, now.q, now.p);
        for (int i = 0; i + 1 < d.q.size() && i < n_angles<M>; ++i)
            d.q(i + 1) = std::remainder(d.q(i + 1), 2 * std::numbers::pi);
        return stepper.length(d) < 1.5 * options_.path.largest_step && stepper.dot(first.tangent, now.tangent) > 0.95;
    }

    /// The point of the curve near `from` (+) chord at which x (axis 0) or y (axis 1) is that of the chord's end.
    template <class Curve>
    std::optional<BranchPoint<Curve>> where(PathStepper<Curve>& stepper, const BranchPoint<Curve>& from,
                                            const Direction& chord, int axis) const {
        Direction normal{Eigen::VectorXd::Zero(chord.q.size()), axis == 1 ? 1.0 : 0.0};
        if (axis == 0) normal.q(0) = 1;
        return stepper.onto(from.q, from.p, chord, normal, from.tangent);
    }
    static double& entry(Direction& d, int axis) { return axis == 0 ? d.q(0) : d.p; }

    /// Where the segment from a (inside) to b (outside) leaves the window: on the curve if Newton's method finds it
    /// there, else on the chord.
    template <class Curve>
    BranchPoint<Curve> at_border(PathStepper<Curve>& stepper, const BranchPoint<Curve>& a,
                                 const BranchPoint<Curve>& b) const {
        const PlaneWindow& w = locus_.window;
        const double from[] = {a.q.p, a.p}, to[] = {b.q.p, b.p};
        double part = 1;
        int axis = 0;
        double value = to[0];
        const auto clip = [&](int k, double bound) {
            if ((from[k] - bound) * (to[k] - bound) < 0 || to[k] == bound) {
                const double s = (bound - from[k]) / (to[k] - from[k]);
                if (s < part) part = s, axis = k, value = bound;
            }
        };
        clip(0, w.x_low);
        clip(0, w.x_high);
        clip(1, w.y_low);
        clip(1, w.y_high);
        Direction chord = stepper.difference(a, b.q, b.p);
        PathStepper<Curve>::scale(chord, part);
        entry(chord, axis) = value - from[axis];
        const auto exactly = [&](BranchPoint<Curve> point) {
            (axis == 0 ? point.q.p : point.p) = value;
            return point;
        };
        const auto near = [&](const std::optional<BranchPoint<Curve>>& point) {
            if (!point) return false;
            Direction d = stepper.difference(a, point->q, point->p);
            d.q -= chord.q;
            d.p -= chord.p;
            return stepper.length(d) < 0.1;
        };
        if (const auto point = where(stepper, a, chord, axis); near(point)) return exactly(*point);
        // the border itself may be degenerate (a massless link): close to it in quarters of the way, then along the
        // tangent
        BranchPoint<Curve> y = a;
        const double size = axis == 0 ? w.width() : w.height();
        const auto at = [&](const BranchPoint<Curve>& point) { return axis == 0 ? point.q.p : point.p; };
        const auto ahead = [&](double share) {
            Direction d = y.tangent;
            PathStepper<Curve>::scale(d, share * (value - at(y)) / entry(d, axis));
            return d;
        };
        while (std::abs(at(y) - value) > 1e-6 * size) {
            auto closer = where(stepper, y, ahead(0.75), axis);
            if (!near(closer)) break;
            y = std::move(*closer);
        }
        const Direction end = entry(y.tangent, axis) != 0 ? ahead(1) : chord;
        y.q = retract(stepper.problem(), y.q, end.q);
        y.p += end.p;
        return exactly(std::move(y));
    }

    /// A zero of the third derivative; true if it is a symmetric point, where the curve turns into its mirror image.
    bool note_cusp(const BranchPoint<Folds>& cusp) {
        const LocusPoint<M> at = point_of(cusp.q, cusp.p);
        if (is_symmetric(at.q)) {
            locus_.degenerate_pitchforks.push_back(at);
            return true;
        }
        for (const Cusp<M>& other : locus_.cusps)
            if (same(other.at, at)) return false;
        const Parameters<M> p = parameters_at(at.x, at.y);
        const auto coefficients = reduced_coefficients<M>(at.q, at.v, p);
        const Eigen::Matrix<double, n, 1> v = ModelProblem<M, X>::vector(at.v);
        const double residual = std::max({cusp.residual, (jacobian<M, double>(at.q, p) * v).cwiseAbs().maxCoeff(),
                                          std::abs(coefficients.third)});
        locus_.cusps.push_back({at, residual, coefficients.fourth});
        return false;
    }

    /// Marks the seeds that a traced curve passes, and counts its crossings of lines that are no seed.
    template <class Curve>
    void claim_seeds(PathStepper<Curve>& stepper, const std::vector<BranchPoint<Curve>>& curve, LocusKind kind) {
        const PlaneWindow& w = locus_.window;
        for (const int axis : {0, 1}) {
            const double low = axis == 0 ? w.x_low : w.y_low, size = axis == 0 ? w.width() : w.height();
            const auto value = [&](std::size_t i) { return axis == 0 ? curve[i].q.p : curve[i].p; };
            for (int l = 0; l < options_.lines; ++l) {
                const double line = low + size * (l + 0.4713) / options_.lines;
                for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
                    const double before = value(i) - line, after = value(i + 1) - line;
                    if (!(before * after < 0) && before != 0) continue;
                    Direction chord = stepper.difference(curve[i], curve[i + 1].q, curve[i + 1].p);
                    PathStepper<Curve>::scale(chord, before == 0 ? 0 : before / (before - after));
                    entry(chord, axis) = -before;
                    const auto point = where(stepper, curve[i], chord, axis);
                    if (!point || !w.contains(point->q.p, point->p)) continue;
                    const LocusPoint<M> at = point_of(point->q, point->p);
                    bool known = false;
                    for (Seed& seed : seeds_)
                        if (seed.kind == kind && seed.fixed == (axis == 0 ? X : Y) && seed.line == line &&
                            same(seed.at, at))
                            known = seed.traced = true;
                    locus_.evidence.unseeded_crossings += !known;
                }
            }
        }
    }

    LocusOptions options_;
    EnumerateOptions enumerate_options_;
    std::vector<Unknowns<M>> symmetric_;
    std::vector<Seed> seeds_;
    Locus<M> locus_;
};

}  // namespace detail

}  // namespace equilibria
