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

#include <boost/math/tools/toms748_solve.hpp>

#include <equilibria/continuation/arc_length.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/fold_curve.hpp>
#include <equilibria/locus/line_events.hpp>
#include <equilibria/locus/locus_result.hpp>
#include <equilibria/locus/region_counts.hpp>

namespace equilibria {

struct LocusOptions {
    int lines = 12;            ///< lines in each direction that are solved for seeds, at least 2
    int checks = 20;           ///< points in each direction whose count is compared with their region's; 0: none
    std::uint64_t seed = 1;    ///< of every enumeration
    ArcLengthOptions arc_length{.first_step = 1e-3, .largest_step = 0.01};
    int most_points = 20000;   ///< of one curve

    void validate() const {
        require(lines >= 2 && lines <= 10000, "lines", lines, "must be 2 to 10000");
        require(checks >= 0 && checks <= 10000, "checks", checks, "must be 0 to 10000");
        require(most_points > 1, "most_points", most_points, "must be more than 1");
        arc_length.validate();
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

    template <class System>
    LocusPoint<M> point_of(const System& system, const typename System::Vector& y) const {
        const int x_at = System::unknowns - 2;
        LocusPoint<M> p{y(x_at), y(x_at + 1), {}, system.v(y)};
        if constexpr (requires { system.branch; })
            p.q = system.branch;
        else
            p.q = system.q(y);
        return p;
    }

    void trace_from(Seed& seed) {
        if (seed.kind == LocusKind::fold) {
            const FoldCurve<M, X, Y> system{locus_.parameters};
            typename FoldCurve<M, X, Y>::Vector y;
            for (int i = 0; i < n; ++i) y(i) = seed.at.q[i], y(n + i) = seed.at.v[i];
            y(2 * n) = seed.at.x;
            y(2 * n + 1) = seed.at.y;
            trace(system, y, seed);
        } else {
            const PitchforkCurve<M, X, Y> system{locus_.parameters, seed.at.q};
            typename PitchforkCurve<M, X, Y>::Vector y;
            for (int i = 0; i < n; ++i) y(i) = seed.at.v[i];
            y(n) = seed.at.x;
            y(n + 1) = seed.at.y;
            trace(system, y, seed);
        }
    }

    template <class System>
    void trace(const System& system, const typename System::Vector& y0, const Seed& seed) {
        using Stepper = ArcLengthStepper<System>;
        using Vector = typename System::Vector;
        constexpr int x_at = System::unknowns - 2;
        Vector scale = Vector::Ones();
        scale(x_at) = locus_.window.width();
        scale(x_at + 1) = locus_.window.height();
        const Stepper stepper(system, scale, options_.arc_length);
        LocusCurve<M> curve{seed.kind, {}, {CurveEnd::step, CurveEnd::step}};
        std::vector<Vector> whole;
        for (int side = 0; side < 2; ++side) {
            auto state = stepper.start(y0, side == 0 ? -1 : 1);
            std::vector<Vector> half;
            if (state) {
                half.push_back(state->y);
                curve.ends[static_cast<std::size_t>(side)] = follow(system, stepper, *state, half);
            }
            if (side == 0) {
                whole.assign(half.rbegin(), half.rend());
                if (curve.ends[0] == CurveEnd::closed) {
                    curve.ends[1] = CurveEnd::closed;
                    break;
                }
            } else if (!half.empty()) {
                whole.insert(whole.end(), half.begin() + 1, half.end());
            }
        }
        for (const CurveEnd end : curve.ends)
            locus_.evidence.broken_curves += end == CurveEnd::step || end == CurveEnd::length;
        for (const Vector& y : whole) curve.points.push_back(point_of(system, y));
        if (curve.points.size() < 2) return;
        claim_seeds(system, stepper, whole, seed.kind);
        locus_.curves.push_back(std::move(curve));
    }

    /// Follows a curve from a state, appending its points, to the border of the window or where it ends within.
    template <class System, class Stepper>
    CurveEnd follow(const System& system, const Stepper& stepper, typename Stepper::State state,
                    std::vector<typename System::Vector>& points) {
        constexpr int x_at = System::unknowns - 2;
        const auto first = state;
        double third = third_at(system, state.y);
        while (static_cast<int>(points.size()) < options_.most_points) {
            const auto next = stepper.advance(state);
            if (!next) return CurveEnd::step;
            const double x = next->y(x_at), y = next->y(x_at + 1);
            if (!locus_.window.contains(x, y)) {
                points.push_back(at_border(stepper, state.y, next->y));
                return CurveEnd::window;
            }
            if constexpr (!requires { system.branch; }) {
                const double now = third_at(system, next->y);
                if (std::signbit(now) != std::signbit(third) && note_cusp(system, stepper, state, *next, points))
                    return CurveEnd::symmetric;
                third = now;
            }
            if (points.size() > 10 && closes(first, *next)) {
                points.push_back(first.y);
                return CurveEnd::closed;
            }
            points.push_back(next->y);
            state = *next;
        }
        return CurveEnd::length;
    }

    template <class System>
    double third_at(const System& system, const typename System::Vector& y) const {
        if constexpr (requires { system.branch; })
            return 1;
        else
            return reduced_coefficients<M>(system.q(y), system.v(y), system.p(y)).third;
    }

    /// Back at the first point, in the same direction; angles modulo 2 pi.
    template <class State>
    bool closes(const State& first, const State& now) const {
        constexpr int size = decltype(first.y)::RowsAtCompileTime;
        auto d = (now.y - first.y).eval();
        if constexpr (size == 2 * n + 2)
            for (int i = 0; i < n_angles<M>; ++i) d(i) = std::remainder(d(i), 2 * std::numbers::pi);
        d(size - 2) /= locus_.window.width();
        d(size - 1) /= locus_.window.height();
        return d.norm() < 1.5 * options_.arc_length.largest_step && first.tangent.dot(now.tangent) > 0.95;
    }

    /// Where the segment from a (inside) to b (outside) leaves the window: on the curve if Newton's method finds it
    /// there, else on the chord.
    template <class Stepper, class Vector>
    Vector at_border(const Stepper& stepper, const Vector& a, const Vector& b) const {
        constexpr int x_at = Vector::RowsAtCompileTime - 2;
        const PlaneWindow& w = locus_.window;
        double part = 1;
        int unknown = x_at;
        double value = b(x_at);
        const auto clip = [&](int k, double bound) {
            if ((a(k) - bound) * (b(k) - bound) < 0 || b(k) == bound) {
                const double s = (bound - a(k)) / (b(k) - a(k));
                if (s < part) part = s, unknown = k, value = bound;
            }
        };
        clip(x_at, w.x_low);
        clip(x_at, w.x_high);
        clip(x_at + 1, w.y_low);
        clip(x_at + 1, w.y_high);
        Vector chord = a + part * (b - a);
        chord(unknown) = value;
        const double size = unknown == x_at ? w.width() : w.height();
        const auto near = [&](const std::optional<Vector>& y) { return y && ((*y) - chord).norm() < 0.1 * (1 + size); };
        if (const auto y = stepper.where(chord, unknown, value); near(y)) return *y;
        // the border itself may be degenerate (a massless link): extrapolate from two points close to it
        const double inward = (a(unknown) > value ? 1 : -1) * 1e-6 * size;
        const auto first = stepper.where(chord, unknown, value + inward);
        const auto second = stepper.where(chord, unknown, value + 2 * inward);
        if (near(first) && near(second)) chord = 2 * *first - *second;
        chord(unknown) = value;
        return chord;
    }

    /// Locates the zero of the third derivative between two states; true if it is a symmetric point, where the curve
    /// turns into its mirror image.
    template <class System, class Stepper>
    bool note_cusp(const System& system, const Stepper& stepper, const typename Stepper::State& a,
                   const typename Stepper::State& b, std::vector<typename System::Vector>& points) {
        using Vector = typename System::Vector;
        Vector scale = Vector::Ones();
        scale(System::unknowns - 2) = locus_.window.width();
        scale(System::unknowns - 1) = locus_.window.height();
        const double length = a.tangent.dot((b.y - a.y).cwiseQuotient(scale));
        const auto third = [&](double h) {
            const auto y = stepper.at(a, h);
            return y ? third_at(system, *y) : std::numeric_limits<double>::quiet_NaN();
        };
        const double at_a = third(0), at_b = third(length);
        if (!(at_a * at_b <= 0)) return false;
        std::uintmax_t iterations = 100;
        const auto bracket = boost::math::tools::toms748_solve(
            third, 0.0, length, at_a, at_b, [](double l, double r) { return std::abs(r - l) <= 1e-15; }, iterations);
        const auto y = stepper.at(a, 0.5 * (bracket.first + bracket.second));
        if (!y) return false;
        const LocusPoint<M> at = point_of(system, *y);
        points.push_back(*y);
        if (is_symmetric(at.q)) {
            locus_.degenerate_pitchforks.push_back(at);
            return true;
        }
        const auto coefficients_there = reduced_coefficients<M>(at.q, at.v, system.p(*y));
        for (const Cusp<M>& other : locus_.cusps)
            if (same(other.at, at)) return false;
        const double residual =
            std::max(system.residual(*y).template lpNorm<Eigen::Infinity>(), std::abs(coefficients_there.third));
        locus_.cusps.push_back({at, residual, coefficients_there.fourth});
        return false;
    }

    /// Marks the seeds that a traced curve passes, and counts its crossings of lines that are no seed.
    template <class System, class Stepper>
    void claim_seeds(const System& system, const Stepper& stepper, const std::vector<typename System::Vector>& curve,
                     LocusKind kind) {
        constexpr int x_at = System::unknowns - 2;
        const PlaneWindow& w = locus_.window;
        for (const int fixed : {X, Y}) {
            const int k = fixed == X ? x_at : x_at + 1;
            const double low = fixed == X ? w.x_low : w.y_low, size = fixed == X ? w.width() : w.height();
            for (int l = 0; l < options_.lines; ++l) {
                const double line = low + size * (l + 0.4713) / options_.lines;
                for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
                    const double before = curve[i](k) - line, after = curve[i + 1](k) - line;
                    if (!(before * after < 0) && before != 0) continue;
                    const double part = before == 0 ? 0 : before / (before - after);
                    const auto y = stepper.where(curve[i] + part * (curve[i + 1] - curve[i]), k, line);
                    if (!y || !w.contains((*y)(x_at), (*y)(x_at + 1))) continue;
                    const LocusPoint<M> at = point_of(system, *y);
                    bool known = false;
                    for (Seed& seed : seeds_)
                        if (seed.kind == kind && seed.fixed == fixed && seed.line == line && same(seed.at, at))
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
