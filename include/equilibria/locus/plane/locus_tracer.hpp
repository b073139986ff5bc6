/// \file
/// Traces the curves of a locus from its points on lines, its cusps and its extremal points, until each is on a curve.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include <equilibria/continuation/curves/critical_curve.hpp>
#include <equilibria/continuation/event_function.hpp>
#include <equilibria/core/eigen_copies.hpp>
#include <equilibria/locus/line/coordinate_sizes.hpp>
#include <equilibria/locus/plane/curve_copies.hpp>
#include <equilibria/locus/plane/curve_steps.hpp>
#include <equilibria/locus/plane/infinity_curves.hpp>
#include <equilibria/locus/plane/locus_options.hpp>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/locus/plane/locus_seeds.hpp>
#include <equilibria/locus/plane/pitchfork_curve.hpp>
#include <equilibria/locus/plane/region_counts.hpp>
#include <equilibria/locus/plane/scaled_folds.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/reduced_coefficients.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria {

namespace detail {

class LocusTracer {
public:
    /// The model has to outlive it. active: the numbers of x and y.
    LocusTracer(const SearchedModel& model, std::span<const int> active, const RuntimeArray<double>& p,
                const Window& window, const RunOptions& run, const LocusOptions& options)
        : model_(model), functions_(*model.functions), n_(model.unknowns()), system_(*model.polynomials, active),
          run_(run), options_(options), seeds_(model, system_, p, window, options.lines, run),
          steps_(window, model.sizes().angles), sizes_(Eigen::VectorXd::Ones(n_)) {
        locus_.window = window;
        locus_.parameters = p;
    }
    LocusTracer(const LocusTracer&) = delete;
    LocusTracer& operator=(const LocusTracer&) = delete;

    Locus<RuntimeUnknowns> run() {
        const detail::Stopwatch begin;
        seeds_.solve(locus_.evidence);
        trace_from_infinity();
        for (Seed& seed : seeds_.all())
            if (!seed.traced) trace_from(seed);
        drop_copies();
        seeds_.compare(locus_);
        for (const Seed& seed : seeds_.all())
            if (!seed.traced) locus_.evidence.add(LocusFaultKind::untraced_seed, {seed.at.x(), seed.at.y()});
        for (auto& at : locus_.points) tidy(at);
        count_regions(locus_, model_, system_.active(), options_.checks, run_);
        locus_.evidence.seconds = begin.seconds();
        return std::move(locus_);
    }

private:
    using Seed = LocusSeed;
    using Folds = FoldCurve<PlaneProblems>;
    /// Of both kinds of curves: q, x and the border.
    using At = Configuration<Folds>;

    /// A point of a curve with its unit null vector, that of the divided equations; 0 where they are not defined.
    RuntimeSingularity<> point_of(const At& at, double y, SingularityKind kind) const {
        const Eigen::MatrixXd tangent = problems()(y).tangent(at.q, at.p);
        RuntimeArray<double> p = locus_.parameters;
        p[x_number()] = at.p;
        p[y_number()] = y;
        return singularity_at<double>(
            kind, system_.active(), runtime_array(at.q), p,
            tangent.allFinite() ? null_vector(runtime_matrix(tangent)) : RuntimeArray<double>(n_));
    }
    PlaneProblems problems() const { return {&functions_, &system_, locus_.parameters, sizes_}; }
    int x_number() const { return system_.active()[0]; }
    int y_number() const { return system_.active()[1]; }

    void trace_from(const Seed& seed) {
        At at;
        at.q = eigen_vector(seed.at.q);
        at.p = seed.at.x();
        eigen_vector(seed.at.v).cwiseAbs().maxCoeff(&at.border.column);
        at.border.row = at.border.column;  // about: J is symmetric but for scales of its rows
        at = with_best_border(problems()(seed.at.y()), at);
        if (seed.curve() == SingularityKind::fold)
            trace(Folds(problems(), seed.at.y(), locus_.window.width()), at, seed);
        else if (model_.reflection_symmetric())
            trace(PitchforkCurve(problems(), locus_.window.width()), at, seed);
    }

    template <class Curve>
    void trace(const Curve& system, const At& at, const Seed& seed) {
        BranchOptions branch = options_.branch;
        branch.parameter_weight = 1 / locus_.window.height();
        BranchStepper<Curve> stepper(system, branch);
        auto start = stepper.start(at, seed.at.y(), 1);
        if (!start || !is_next_to(*start, seed)) {
            // where y turns back Newton's method at a fixed y fails, and the seed is exact
            start = stepper.assess(at, seed.at.y(), std::nullopt);
            if (!start || !is_next_to(*start, seed)) return;
            start->proposed_step = branch.first_step;
        }
        LocusCurve<RuntimeUnknowns> curve{seed.curve(), {}, {CurveEnd::step, CurveEnd::step}};
        std::vector<BranchPoint<Curve>> whole;
        for (int side = 0; side < 2; ++side) {
            BranchStepper<Curve>::flip(start->tangent);
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
        for (const auto& point : whole) curve.points.push_back(point_of(point.q, point.p, curve.kind));
        const double extent = extent_of(curve);
        if (extent < 1e-9) {  // a continuum of equilibria at one point of the plane, or a point of the border
            for (Seed& other : seeds_.all())
                other.traced = other.traced || (std::abs(other.at.x() - seed.at.x()) < 1e-9 * locus_.window.width() &&
                                                std::abs(other.at.y() - seed.at.y()) < 1e-9 * locus_.window.height());
            return;
        }
        if (extent < 1e-4 && curve.ends[0] != CurveEnd::closed && steps_.on_border(*start)) {
            claim_near(stepper, whole, curve.kind);  // it touches the window with a cusp
            return;
        }
        if (is_copy(model_.sizes(), locus_.window, model_.reflection_symmetric(), curve, locus_.curves)) {
            // its seed was not recognised on the curve that it is on
            claim_seeds(stepper, whole, curve.kind);
            claim_near(stepper, whole, curve.kind);
            return;
        }
        // events are sought between points: not at the first one
        if (seed.at.extremal >= 0) locus_.points.push_back(seed.at);
        if constexpr (std::is_same_v<Curve, Folds>)
            if (seed.at.kind == SingularityKind::cusp || seed.at.kind == SingularityKind::tricritical_pitchfork)
                note_cusp(*start);
        note_extremal_points(stepper, whole);
        claim_seeds(stepper, whole, curve.kind);
        claim_near(stepper, whole, curve.kind);
        locus_.curves.push_back(std::move(curve));
    }

    /// Follows a curve from its only point, appending to it, to the border of the window or where it ends within.
    template <class Curve>
    CurveEnd follow(BranchStepper<Curve>& stepper, std::vector<BranchPoint<Curve>>& points) {
        constexpr bool folds = std::is_same_v<Curve, Folds>;
        const BranchPoint<Curve> first = points.front();
        BranchPoint<Curve> last = first;
        ScaledFolds scaled(problems(), model_.sizes().angles, locus_.window, stepper.options());
        BranchStepper<Curve>* used = &stepper;
        double standing = 0;  // how far the unknowns alone have moved
        int points_there = 0;
        while (static_cast<int>(points.size()) < options_.most_points) {
            bool near = true;
            if constexpr (folds) {
                used = &scaled.stepper_at(last, stepper, *used);
                near = used == &stepper;
                if (scaled.may_be_infinite(last))
                    if (const auto end = scaled.limit(last, locus_.from_infinity)) {
                        last.q.p = end->x;
                        last.p = end->y;
                        points.push_back(last);
                        return CurveEnd::infinity;
                    }
                if (scaled.is_lost(last)) return CurveEnd::step;
            }
            auto next = used->advance(last);
            if (!next) return CurveEnd::step;
            const bool leaves = !locus_.window.contains(next->q.p, next->p);
            if (steps_.stands(last, *next)) {
                standing += next->step;
                ++points_there;
            } else {
                standing = points_there = 0;
            }
            if (standing > 0.1) {  // a continuum of equilibria
                points.erase(points.end() + 1 - points_there, points.end());
                drop_points_at(points.back());
                return CurveEnd::continuum;
            }
            if constexpr (folds)
                if (near && standing == 0) {
                    const RuntimeArray<double> v = point_of(last.q, last.p, SingularityKind::fold).v;
                    const EventFunction<Curve> third{"third derivative",
                                                     [&](const BranchPoint<Curve>& at) { return third_at(at, v); }};
                    std::optional<BranchPoint<Curve>> cusp;
                    if (std::signbit(third.value(last)) != std::signbit(third.value(*next)))
                        cusp = zero_between(stepper, third, last, *next);
                    if (cusp && steps_.put_into_window(*cusp) && !(leaves && is_family(*cusp))) {
                        points.push_back(*cusp);
                        if (note_cusp(*cusp)) return CurveEnd::symmetric;
                        if (leaves && steps_.on_border(*cusp)) return CurveEnd::border;
                    }
                }
            if (leaves) {
                points.push_back(steps_.at_border(*used, points.back(), *next));
                return CurveEnd::border;
            }
            if (points.size() > 2 && steps_.closes(*used, first, last, *next)) {
                points.push_back(first);
                return CurveEnd::closed;
            }
            points.push_back(*next);
            last = std::move(*next);
        }
        return CurveEnd::length;
    }

    /// Drops the special points at the end of a curve: where equilibria are not isolated, signs of derivatives are
    /// those of rounding.
    template <class Point>
    void drop_points_at(const Point& end) {
        std::erase_if(locus_.points, [&](const RuntimeSingularity<>& at) {
            return std::abs(at.x() - end.q.p) < 1e-9 * locus_.window.width() &&
                   std::abs(at.y() - end.p) < 1e-9 * locus_.window.height();
        });
    }
    /// Whether the first point of a curve is the seed, and not one that Newton's method went to from there.
    template <class Point>
    bool is_next_to(const Point& start, const Seed& seed) const {
        const Window& w = locus_.window;
        return std::abs(start.q.p - seed.at.x()) < 1e-3 * w.width() &&
               std::abs(start.p - seed.at.y()) < 1e-3 * w.height() &&
               same_unknowns(model_.sizes(), runtime_array(start.q.q), seed.at.q, 1e-2);
    }
    template <class Point>
    bool is_family(const Point& at) const {
        return seeds_.is_family(at.q.p, at.p);
    }
    /// How far a curve goes from its first point, in parts of the window.
    double extent_of(const LocusCurve<RuntimeUnknowns>& curve) const {
        double y = 0;
        for (const auto& at : curve.points)
            y = std::max({y, std::abs(at.x() - curve.points.front().x()) / locus_.window.width(),
                          std::abs(at.y() - curve.points.front().y()) / locus_.window.height()});
        return y;
    }
    /// Curves that are part of another one, as one that broke off and was traced again from elsewhere.
    void drop_copies() {
        auto& curves = locus_.curves;
        for (std::size_t k = 0; k < curves.size();) {
            const LocusCurve<RuntimeUnknowns> curve = curves[k];
            auto others = curves;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
            if (is_copy(model_.sizes(), locus_.window, model_.reflection_symmetric(), curve, others))
                curves = std::move(others);
            else
                ++k;
        }
        for (const auto& curve : curves)
            for (const int side : {0, 1}) {
                const CurveEnd end = curve.ends[static_cast<std::size_t>(side)];
                const auto& at = side == 0 ? curve.points.front() : curve.points.back();
                if (end == CurveEnd::step || end == CurveEnd::length)
                    locus_.evidence.add(LocusFaultKind::broken_curve, {at.x(), at.y()});
            }
    }
    /// Angles in (-pi, pi], and 0 for what is rounding of 0.
    void tidy(RuntimeSingularity<>& at) const {
        const auto clear = [](double& value, double size) {
            if (std::abs(value) < 1e-13 * size) value = 0;
        };
        at.q = wrapped(model_.sizes(), at.q);
        for (int i = 0; i < at.q.size(); ++i) {
            clear(at.q[i], 1);
            if (i < model_.sizes().angles && at.q[i] < -std::numbers::pi + 1e-13) at.q[i] = std::numbers::pi;
        }
        clear(at.x(), locus_.window.width());
        clear(at.y(), locus_.window.height());
    }

    /// Curves on which equilibria come from infinity, or go there, through what lines of both directions are solved
    /// for.
    void trace_from_infinity() {
        if (model_.sizes().coordinates == 0) return;
        const Window& w = locus_.window;
        const auto inside = [&](double part) {
            RuntimeArray<double> p = locus_.parameters;
            p[x_number()] = w.x.low + part * w.width();
            p[y_number()] = w.y.low + part * w.height();
            return p;
        };
        const auto sizes = coordinate_sizes(model_, std::array{inside(0.21), inside(0.79)}, run_);
        std::ranges::copy(sizes, sizes_.data() + model_.sizes().angles);
        InfinityCurveTracer tracer(model_, {x_number(), y_number()}, locus_.parameters, w, sizes, run_);
        for (const int axis : {0, 1}) {
            const auto& lines = seeds_.lines(axis);
            const std::size_t step = std::max<std::size_t>(1, lines.size() / 6);
            for (std::size_t k = 0; k < lines.size(); ++k)
                if (k % step == 0 || k + 1 == lines.size()) tracer.add_line(axis, lines[k]);
        }
        locus_.from_infinity = tracer.trace();
        locus_.evidence.failed_paths += tracer.failed_paths();
        locus_.evidence.seeds_from_infinity = tracer.seeds();
        locus_.evidence.lines_from_infinity = tracer.lines();
        for (const PlanePoint& point : tracer.untraced()) locus_.evidence.add(LocusFaultKind::from_infinity, point);
        for (const InfinityCurve& curve : locus_.from_infinity)
            for (const int side : {0, 1}) {
                const CurveEnd end = curve.ends[static_cast<std::size_t>(side)];
                if (end == CurveEnd::step || end == CurveEnd::length)
                    locus_.evidence.add(LocusFaultKind::from_infinity,
                                        side == 0 ? curve.points.front() : curve.points.back());
            }
    }

    /// The reduced third derivative along the null vector on the side of `before`.
    double third_at(const BranchPoint<Folds>& at, const RuntimeArray<double>& before) const {
        const auto point = point_of(at.q, at.p, SingularityKind::fold);
        const double third = reduced_coefficients(functions_, point.q, point.v, point.p).third;
        return dot(point.v, before) < 0 ? -third : third;
    }

    /// A zero of the third derivative; true if it is a symmetric point, where the curve turns into its mirror image.
    bool note_cusp(const BranchPoint<Folds>& cusp) {
        auto at = point_of(cusp.q, cusp.p, SingularityKind::cusp);
        const bool symmetric = on_symmetric_branch(*model_.polynomials, at.q);
        if (symmetric) {
            at.kind = SingularityKind::tricritical_pitchfork;
        } else {
            const auto reduced = reduced_coefficients(functions_, at.q, at.v, at.p);
            const Eigen::VectorXd jv = eigen_matrix(jacobian(functions_, at.q, at.p)) * eigen_vector(at.v);
            at.nullity = 1;
            at.derivatives[0] = reduced.third;
            at.derivatives[1] = reduced.fourth;
            at.residual = std::max({cusp.residual, jv.cwiseAbs().maxCoeff(), std::abs(reduced.third)});
            // a jump of the third derivative, on a step to another curve, is no cusp
            const Eigen::MatrixXd j = eigen_matrix(jacobian(functions_, at.q, at.p));
            if (!(at.residual < 1e-6 * std::max(1.0, j.cwiseAbs().maxCoeff()))) return false;
        }
        note(at);
        return symmetric;
    }

    /// Keeps a special point unless it is known.
    void note(const RuntimeSingularity<>& at) {
        for (const auto& other : locus_.points)
            if (other.kind == at.kind && other.extremal == at.extremal && seeds_.same(other, at)) return;
        locus_.points.push_back(at);
    }

    /// The points at which one of x, y turns back and the other does not.
    template <class Curve>
    void note_extremal_points(BranchStepper<Curve>& stepper, const std::vector<BranchPoint<Curve>>& curve) {
        constexpr auto kind =
            std::is_same_v<Curve, Folds> ? SingularityKind::extremal_fold : SingularityKind::extremal_pitchfork;
        const EventFunction<Curve> slopes[] = {{"dx/ds", [](const BranchPoint<Curve>& at) { return at.tangent.q(0); }},
                                               {"dy/ds", [](const BranchPoint<Curve>& at) { return at.tangent.p; }}};
        const auto is_cusp = [&](const BranchPoint<Curve>& at) {
            for (const auto& cusp : locus_.points)
                if (cusp.kind == SingularityKind::cusp && at.q.p == cusp.x() && at.p == cusp.y()) return true;
            return false;
        };
        // their tangents are of other lengths
        const auto is_far = [&]([[maybe_unused]] const BranchPoint<Curve>& at) {
            if constexpr (std::is_same_v<Curve, Folds>)
                return ScaledFolds::is_far(at, sizes_, model_.sizes().angles);
            else
                return false;
        };
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
            const auto &a = curve[i], &b = curve[i + 1];
            // along a line parallel to an axis the other parameter has rounding for a slope
            const auto turn = [](double from, double to, double size) {
                return from * to < 0 && std::max(std::abs(from), std::abs(to)) > 1e-9 * size;
            };
            const bool turns[] = {turn(a.tangent.q(0), b.tangent.q(0), locus_.window.width()),
                                  turn(a.tangent.p, b.tangent.p, locus_.window.height())};
            if (turns[0] == turns[1] || is_cusp(a) || is_cusp(b) || is_far(a) || is_far(b)) continue;
            const auto point = zero_between(stepper, slopes[turns[0] ? 0 : 1], a, b);
            if (!point || !locus_.window.contains(point->q.p, point->p)) continue;
            auto at = point_of(point->q, point->p, kind);
            at.extremal = turns[0] ? x_number() : y_number();
            note(at);
        }
    }

    /// Marks the points of a kind that a traced curve passes.
    template <class Curve>
    void claim_near(BranchStepper<Curve>& stepper, const std::vector<BranchPoint<Curve>>& curve, SingularityKind kind) {
        const auto position = [&](const BranchPoint<Curve>& at) {
            Eigen::VectorXd y(n_ + 2);
            y << at.q.p / locus_.window.width(), at.p / locus_.window.height(), at.q.q;
            return y;
        };
        for (Seed& seed : seeds_.all()) {
            if (seed.traced || seed.curve() != kind) continue;
            for (const bool mirror : {false, true}) {
                if (seed.traced || (mirror && !model_.reflection_symmetric())) break;
                const auto image = mirror ? mirrored(model_.sizes(), seed.at.q) : seed.at.q;
                for (std::size_t i = 0; i + 1 < curve.size() && !seed.traced; ++i) {
                    const Eigen::VectorXd a = position(curve[i]), chord = position(curve[i + 1]) - a;
                    Eigen::VectorXd to(n_ + 2);
                    to(0) = seed.at.x() / locus_.window.width() - a(0);
                    to(1) = seed.at.y() / locus_.window.height() - a(1);
                    const auto d = displacement(model_.sizes(), runtime_array(Eigen::VectorXd(a.tail(n_))), image);
                    for (int k = 0; k < n_; ++k) to(k + 2) = d[k];
                    const double length2 = chord.squaredNorm(), part = to.dot(chord) / length2;
                    if (!(part > -0.1 && part < 1.1) || (to - part * chord).squaredNorm() > 0.1 * length2 + 1e-10)
                        continue;
                    Direction step = stepper.difference(curve[i], curve[i + 1].q, curve[i + 1].p);
                    // the plane through the point, normal to the chord
                    const double along = stepper.length(step);
                    Direction target = step;
                    target.q(0) = to(0) * locus_.window.width();
                    target.p = to(1) * locus_.window.height();
                    if constexpr (std::is_same_v<Curve, Folds>) target.q.tail(n_) = to.tail(n_);
                    const double reach = stepper.dot(target, step) / (along * along);
                    const Direction normal = step;
                    BranchStepper<Curve>::scale(step, reach);
                    const auto point = stepper.onto(curve[i].q, curve[i].p, step, normal, curve[i].tangent);
                    if (point) seed.traced = seeds_.same(seed.at, point_of(point->q, point->p, kind));
                }
            }
        }
    }

    /// Marks the seeds that a traced curve passes, and counts its crossings of lines that are no seed.
    template <class Curve>
    void claim_seeds(BranchStepper<Curve>& stepper, const std::vector<BranchPoint<Curve>>& curve,
                     SingularityKind kind) {
        const Window& w = locus_.window;
        for (const int axis : {0, 1}) {
            const auto value = [&](std::size_t i) { return axis == 0 ? curve[i].q.p : curve[i].p; };
            for (const double line : seeds_.lines(axis)) {
                for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
                    const double before = value(i) - line, after = value(i + 1) - line;
                    if (!(before * after < 0) && before != 0) continue;
                    Direction chord = stepper.difference(curve[i], curve[i + 1].q, curve[i + 1].p);
                    BranchStepper<Curve>::scale(chord, before == 0 ? 0 : before / (before - after));
                    CurveSteps::entry(chord, axis) = -before;
                    const auto point = steps_.where(stepper, curve[i], chord, axis);
                    if (!point || !w.contains(point->q.p, point->p)) continue;
                    const auto at = point_of(point->q, point->p, kind);
                    bool known = false;
                    for (Seed& seed : seeds_.all())
                        if (seed.curve() == kind && seed.fixed == (axis == 0 ? x_number() : y_number()) &&
                            seed.line == line && seeds_.same(seed.at, at))
                            known = seed.traced = true;
                    if (!known) locus_.evidence.add(LocusFaultKind::unseeded_crossing, {at.x(), at.y()});
                }
            }
        }
    }

    const SearchedModel& model_;
    const ModelFunctions<>& functions_;
    int n_;  ///< unknowns
    CriticalSystem system_;
    RunOptions run_;
    LocusOptions options_;
    LocusSeeds seeds_;
    CurveSteps steps_;
    Eigen::VectorXd sizes_;  ///< of the unknowns: 1 for angles
    Locus<RuntimeUnknowns> locus_;
};

}  // namespace detail

}  // namespace equilibria
