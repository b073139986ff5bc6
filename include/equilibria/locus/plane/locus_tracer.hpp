/// \file
/// Traces the curves of a locus from its points on lines, its cusps and its extremal points, until each is on a curve.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <equilibria/continuation/curves/critical_curve.hpp>
#include <equilibria/continuation/event_function.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/locus/plane/locus_seeds.hpp>
#include <equilibria/locus/plane/pitchfork_curve.hpp>
#include <equilibria/locus/plane/region_counts.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/singularity/reduced_coefficients.hpp>

namespace equilibria {

struct LocusOptions {
    int lines = 12;            ///< lines in each direction that are solved beside the borders of the window, at least 2
    int checks = 20;           ///< points in each direction whose count is compared with their region's; 0: none
    std::uint64_t seed = 1;    ///< of every enumeration
    unsigned threads = 1;      ///< 0: all of the machine's; does not change the result
    /// Of the curves, in angles and in parts of the window; parameter_weight is set by it.
    PathOptions path{.first_step = 1e-3, .largest_step = 0.006, .largest_angle = 0.15};
    int most_points = 20000;   ///< of one curve

    EnumerateOptions enumeration() const { return {.seed = seed, .threads = threads}; }
    void validate() const {
        enumeration().validate();
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

    LocusTracer(const Parameters<M>& p, const PlaneWindow& window, const LocusOptions& options,
                RootRescue<CriticalSystem<M, X, Y>> rescue)
        : options_(options), seeds_(p, window, options.lines, options.enumeration(), rescue) {
        locus_.window = window;
        locus_.parameters = p;
    }

    Locus<M> run() {
        const auto begin = std::chrono::steady_clock::now();
        seeds_.solve(locus_.evidence);
        for (Seed& seed : seeds_.all())
            if (!seed.traced) trace_from(seed);
        seeds_.compare(locus_);
        for (const Seed& seed : seeds_.all()) locus_.evidence.untraced_seeds += !seed.traced;
        count_regions<M, X, Y>(locus_, options_.checks, options_.enumeration());
        locus_.evidence.seconds = seconds_since(begin);
        return std::move(locus_);
    }

private:
    using Seed = LocusSeed<M>;
    using Source = LocusSource;
    using Family = PlaneFamily<M, X, Y>;

    Parameters<M> parameters_at(double x, double y) const {
        Parameters<M> p = locus_.parameters;
        p[X] = x;
        p[Y] = y;
        return p;
    }

    using Folds = FoldCurve<Family>;
    using Pitchforks = PitchforkCurve<M, X, Y>;
    /// Of both kinds of curves: q, x and the border.
    using At = Configuration<Folds>;

    /// The unit null vector, with the sign of `before` where that is given.
    Eigen::VectorXd null_vector(const At& at, double y, const Eigen::VectorXd* before = nullptr) const {
        const BorderedTangent<PlaneProblem<M, X, Y>> b(Family{locus_.parameters}(y), at);
        Eigen::VectorXd v = b.regular ? b.null.x.normalized().eval() : Eigen::VectorXd::Zero(n).eval();
        if (before && v.dot(*before) < 0) v = -v;
        return v;
    }
    LocusPoint<M> point_of(const At& at, double y) const {
        using Problem = PlaneProblem<M, X, Y>;
        return {at.p, y, Problem::unknowns(at.q), Problem::unknowns(null_vector(at, y))};
    }

    void trace_from(const Seed& seed) {
        At at;
        at.q = PlaneProblem<M, X, Y>::vector(seed.at.q);
        at.p = seed.at.x;
        PlaneProblem<M, X, Y>::vector(seed.at.v).cwiseAbs().maxCoeff(&at.border.column);
        at.border.row = at.border.column;  // about: J is symmetric but for scales of its rows
        const Family family{locus_.parameters};
        at = with_best_border(family(seed.at.y), at);
        if (seed.kind == LocusKind::fold)
            trace(Folds(family, seed.at.y, locus_.window.width()), at, seed);
        else if constexpr (Formulation<M>::reflection_symmetric)
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
        // events are sought between points: not at the first one
        if (seed.source == Source::extremal) locus_.extremal.push_back({seed.kind, seed.fixed, seed.at});
        if constexpr (std::is_same_v<Curve, Folds>)
            if (seed.source == Source::cusp || seed.source == Source::degenerate_pitchfork) note_cusp(*start);
        note_extremal_points(stepper, whole, seed.kind);
        claim_seeds(stepper, whole, seed.kind);
        claim_near(stepper, whole, seed.kind);
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
        using Problem = PlaneProblem<M, X, Y>;
        return reduced_coefficients<M>(Problem::unknowns(at.q.q), Problem::unknowns(null_vector(at.q, at.p, &before)),
                                       parameters_at(at.q.p, at.p))
            .third;
    }

    /// Back at the first point, in the same direction; angles modulo 2 pi.
    template <class Curve>
    bool closes(const PathStepper<Curve>& stepper, const BranchPoint<Curve>& first, const BranchPoint<Curve>& now) const {
        Direction d = stepper.difference(first, now.q, now.p);
        for (int i = 0; i + 1 < d.q.size() && i < n_angles<M>; ++i)
            d.q(i + 1) = wrap(d.q(i + 1));
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
        if (on_symmetric_branch<M>(at.q)) {
            bool known = false;
            for (const auto& other : locus_.degenerate_pitchforks) known = known || seeds_.same(other, at);
            if (!known) locus_.degenerate_pitchforks.push_back(at);
            return true;
        }
        for (const Cusp<M>& other : locus_.cusps)
            if (seeds_.same(other.at, at)) return false;
        const Parameters<M> p = parameters_at(at.x, at.y);
        const auto coefficients = reduced_coefficients<M>(at.q, at.v, p);
        const Eigen::Matrix<double, n, 1> v = PlaneProblem<M, X, Y>::vector(at.v);
        const double residual = std::max({cusp.residual, (jacobian<M, double>(at.q, p) * v).cwiseAbs().maxCoeff(),
                                          std::abs(coefficients.third)});
        locus_.cusps.push_back({at, residual, coefficients.fourth});
        return false;
    }

    /// The points at which one of x, y turns back and the other does not.
    template <class Curve>
    void note_extremal_points(PathStepper<Curve>& stepper, const std::vector<BranchPoint<Curve>>& curve, LocusKind kind) {
        const EventFunction<Curve> slopes[] = {
            {"dx/ds", [](const BranchPoint<Curve>& at) { return at.tangent.q(0); }},
            {"dy/ds", [](const BranchPoint<Curve>& at) { return at.tangent.p; }}};
        const auto is_cusp = [&](const BranchPoint<Curve>& at) {
            for (const auto& cusp : locus_.cusps)
                if (at.q.p == cusp.at.x && at.p == cusp.at.y) return true;
            return false;
        };
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
            const auto &a = curve[i], &b = curve[i + 1];
            const bool turns[] = {a.tangent.q(0) * b.tangent.q(0) < 0, a.tangent.p * b.tangent.p < 0};
            if (turns[0] == turns[1] || is_cusp(a) || is_cusp(b)) continue;
            const int parameter = turns[0] ? X : Y;
            const auto point = zero_between(stepper, slopes[turns[0] ? 0 : 1], a, b);
            if (!point || !locus_.window.contains(point->q.p, point->p)) continue;
            const LocusPoint<M> at = point_of(point->q, point->p);
            bool known = false;
            for (const auto& other : locus_.extremal)
                known = known || (other.kind == kind && other.parameter == parameter && seeds_.same(other.at, at));
            if (!known) locus_.extremal.push_back({kind, parameter, at});
        }
    }

    /// Marks the points of a kind that a traced curve passes.
    template <class Curve>
    void claim_near(PathStepper<Curve>& stepper, const std::vector<BranchPoint<Curve>>& curve, LocusKind kind) {
        const auto position = [&](const BranchPoint<Curve>& at) {
            Eigen::VectorXd y(n + 2);
            y << at.q.p / locus_.window.width(), at.p / locus_.window.height(), at.q.q;
            return y;
        };
        for (Seed& seed : seeds_.all()) {
            if (seed.traced || seed.kind != kind) continue;
            for (const bool mirror : {false, true}) {
                if (seed.traced || (mirror && !Formulation<M>::reflection_symmetric)) break;
                const Unknowns<M> image = mirror ? mirrored<M>(seed.at.q) : seed.at.q;
                for (std::size_t i = 0; i + 1 < curve.size() && !seed.traced; ++i) {
                    const Eigen::VectorXd a = position(curve[i]), chord = position(curve[i + 1]) - a;
                    Eigen::VectorXd to(n + 2);
                    to(0) = seed.at.x / locus_.window.width() - a(0);
                    to(1) = seed.at.y / locus_.window.height() - a(1);
                    const auto d = displacement<M>(PlaneProblem<M, X, Y>::unknowns(a.tail(n)), image);
                    for (int k = 0; k < n; ++k) to(k + 2) = d[k];
                    const double length2 = chord.squaredNorm(), part = to.dot(chord) / length2;
                    if (!(part > -0.1 && part < 1.1) || (to - part * chord).squaredNorm() > 0.1 * length2 + 1e-10)
                        continue;
                    Direction step = stepper.difference(curve[i], curve[i + 1].q, curve[i + 1].p);
                    // the plane through the point, normal to the chord
                    const double along = stepper.length(step);
                    Direction target = step;
                    target.q(0) = to(0) * locus_.window.width();
                    target.p = to(1) * locus_.window.height();
                    if constexpr (std::is_same_v<Curve, Folds>) target.q.tail(n) = to.tail(n);
                    const double reach = stepper.dot(target, step) / (along * along);
                    const Direction normal = step;
                    PathStepper<Curve>::scale(step, reach);
                    const auto point = stepper.onto(curve[i].q, curve[i].p, step, normal, curve[i].tangent);
                    if (point) seed.traced = seeds_.same(seed.at, point_of(point->q, point->p));
                }
            }
        }
    }

    /// Marks the seeds that a traced curve passes, and counts its crossings of lines that are no seed.
    template <class Curve>
    void claim_seeds(PathStepper<Curve>& stepper, const std::vector<BranchPoint<Curve>>& curve, LocusKind kind) {
        const PlaneWindow& w = locus_.window;
        for (const int axis : {0, 1}) {
            const auto value = [&](std::size_t i) { return axis == 0 ? curve[i].q.p : curve[i].p; };
            for (const double line : seeds_.lines(axis)) {
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
                    for (Seed& seed : seeds_.all())
                        if (seed.source == Source::line && seed.kind == kind &&
                            seed.fixed == (axis == 0 ? X : Y) && seed.line == line && seeds_.same(seed.at, at))
                            known = seed.traced = true;
                    locus_.evidence.unseeded_crossings += !known;
                }
            }
        }
    }

    LocusOptions options_;
    LocusSeeds<M, X, Y> seeds_;
    Locus<M> locus_;
};

}  // namespace detail

}  // namespace equilibria
