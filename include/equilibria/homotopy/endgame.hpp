/// \file
/// Paths near t = 1: finite, at infinity or singular, told apart by two-sided tests; and single paths tracked
/// carefully.
///
/// Valuation: nu_u = |(1-t) q_u'(t)| of an angle, |(1-t) x'/x| of a coordinate. On a path to a finite point it tends to
/// 0 like (1-t)^(1/m); on one to infinity it settles at a positive rational (theta ~ -+ i nu log(1-t)).
/// Cauchy: on the circle |1-t| = r the path closes after m turns, m the winding number; the mean of its points is the
/// endpoint, to the accuracy of the tracking even where Newton's method would crawl. It is accepted when two radii
/// agree; on a path to infinity they agree on a pole instead, at radii where it is not far out yet. Sources: Morgan,
/// Sommese, Wampler, Computing singular solutions to nonlinear analytic systems, Numer. Math. 58 (1991) (Cauchy), and
/// those of divergence.hpp.
///
/// Many paths are ended together: at each scale of 1-t all of those that are still open are expanded, looped and
/// brought to their next scale, a path a lane.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include <equilibria/homotopy/detail/circle.hpp>
#include <equilibria/homotopy/detail/closed_loop.hpp>
#include <equilibria/homotopy/detail/divergence.hpp>
#include <equilibria/homotopy/detail/segments.hpp>
#include <equilibria/homotopy/newton_in_digits.hpp>
#include <equilibria/homotopy/polish.hpp>

namespace equilibria::detail {

/// R: double, or a multiprecision float, which tracks, closes loops and tells regular endpoints from singular ones with
/// more digits; what is polished is in double all the same.
template <class H, class R = double>
class Endgame {
public:
    using M = typename H::System;
    using At = RuntimePoint<R>;
    using Loop = ClosedLoop<R>;

    /// resort: more digits end what this leaves undecided. It leaves them what seems a regular endpoint that rounding
    /// hides, loops only where all valuations are small, and believes that a path diverges where all far unknowns do.
    Endgame(const H& h, const Polisher<H>& polisher, const TrackerOptions& options, bool resort = false)
        : homotopy_(&h), sizes_(h.sizes()), options_(options), resort_(resort), tracker_(h, options, shortest_step),
          closing_(h, closing(options), shortest_step), polisher_(&polisher), polishing_(h) {}

    /// Ends paths that have come to ends[k]->q at t = ends[k]->t.
    void finish(std::span<Endpoint* const> ends) {
        std::vector<Path> paths;
        for (Endpoint* end : ends) paths.push_back(path_at(*end, 1 - end->t));
        for (std::size_t k = 0; k < ends.size(); ++k) copy_lane(ends[k]->q, 0, paths[k].q, 0);
        finish(paths);
    }
    /// Ends a path that is at end.q at t = end.t if that leads straight to a regular solution; whether it does.
    bool end_straight(Endpoint& end) {
        Path path = path_at(end, 1 - end.t);
        copy_lane(end.q, 0, path.q, 0);
        return is_regular_at_the_end(path);
    }
    /// Tracks the path from its start, slowly, and ends it with the endgame wherever it leads.
    Endpoint from_start(const RuntimePoint<double>& start) {
        Endpoint end;
        from_starts(std::span(&start, 1), std::span(&end, 1));
        return end;
    }
    /// The same for many paths; ends[k] belongs to starts[k], and comes as made by default.
    void from_starts(std::span<const RuntimePoint<double>> starts, std::span<Endpoint> ends) {
        std::vector<Segment<R>> segments(starts.size());
        for (std::size_t k = 0; k < starts.size(); ++k) {
            copy_lane(starts[k], 0, segments[k].q, 0);
            segments[k].from = time(1);
            segments[k].to = time(1e-3);
            segments[k].may_leave = true;
        }
        tracker_.follow(std::span(segments));
        std::vector<Path> paths;
        for (std::size_t k = 0; k < starts.size(); ++k) {
            const Segment<R>& segment = segments[k];
            Endpoint& end = ends[k];
            end.steps = segment.steps;
            copy_lane(segment.q, 0, end.q, 0);
            const double r = 1 - segment.reached * (1 - 1e-3);
            const bool out_of_steps = end.steps >= options_.most_steps;
            // close to t = 1 rounding may be what stops it, and the endgame measures that
            if (segment.progress == Progress::stuck && (out_of_steps || r > 0.02)) {
                end.reason = out_of_steps ? FailureReason::too_many_steps : FailureReason::step_too_small;
                continue;
            }
            paths.push_back(path_at(end, r));
            paths.back().q = segment.q;
        }
        finish(paths);
    }

private:
    static constexpr bool exact = !std::is_same_v<R, double>;
    /// What a difference, a radius and a step may be with the digits of R: rounding of 1e-16 in double.
    static constexpr double closed = exact ? 1e-22 : 1e-11;
    /// How well two means of loops must agree.
    static constexpr double settled = 1e-7;
    static constexpr double smallest_radius = exact ? 1e-24 : 1e-13;
    /// Where a path that seems to diverge is believed, once it is 1e5 out and before: a finite solution that is merely
    /// far away looks the same down to r = size^(-1 / nu), nu the valuation on the way there.
    static constexpr double diverging_radius = exact ? 1e-14 : 2e-9, slowly_diverging_radius = exact ? 1e-18 : 1e-12;
    /// Where a pole that closed loops show is believed of a path that rounding stops.
    static constexpr double pole_radius = 1e-9;
    static constexpr double shortest_step = exact ? 1e-18 : 1e-9;

    /// A path on its way to t = 1.
    struct Path {
        Endpoint* end;
        At q;  ///< at t = 1 - r
        double r;
        double noise = 1e-7;    ///< Newton corrections up to this size may be rounding there
        Valuations nu, before;  ///< valuations there and at the last scale, -1 without one
        bool diverging = false;
        double excluded = 1;  ///< no finite solution has its branch point between this radius and r
        Loop now, last;
        int loops = 0;  ///< that were tried
        bool decided = false, left = false;
    };
    using Paths = std::vector<Path*>;

    Path path_at(Endpoint& end, double r) const {
        Path path{.end = &end, .q = {}, .r = r, .nu = Valuations(sizes_.unknowns), .before = {}, .now = {}, .last = {}};
        for (double& nu : path.nu) nu = -1;
        return path;
    }
    /// The point 1 - r of the time.
    static Complex<R> time(double r) { return {1.0 - R(r), R(0.0)}; }
    /// Near a family the position along it is known only to 1e-16 / r: contractions below 1e-5 can't be told there.
    static TrackerOptions closing(TrackerOptions o) {
        o.contraction = std::max(o.contraction, 1e-5);
        o.largest_contraction = std::max(o.largest_contraction, 1e-3);
        return o;
    }
    static double size2(const At& q) { return static_cast<double>(farthest2(q)); }
    static Paths select(const Paths& paths, const auto& which) {
        Paths y;
        std::copy_if(paths.begin(), paths.end(), std::back_inserter(y), [&](Path* path) { return which(*path); });
        return y;
    }

    void finish(std::vector<Path>& paths) {
        Paths open;
        for (Path& path : paths) {
            // most that doubles cannot end are regular: to them R leads straight, and loops are dear
            path.decided = exact && is_regular_at_the_end(path);
            if (!path.decided) open.push_back(&path);
        }
        while (true) {
            std::erase_if(open, [](Path* path) { return path->r <= smallest_radius; });
            if (open.empty()) break;
            find_valuations(open);
            std::erase_if(open, [this](Path* path) { return is_believed_to_diverge(*path) || is_left(*path); });
            for (Path* path : open) path->last = std::exchange(path->now, Loop{});
            find_loops(select(open, [this](const Path& path) {
                return !recedes(path) && !(size2(path.q) > far_away2) && (!resort_ || are_below(path.nu, 0.25));
            }));
            std::erase_if(open, [this](Path* path) { return closes(*path); });
            go_on(open);
        }
        Paths left;
        for (Path& path : paths)
            if (!path.decided) left.push_back(&path);
        conclude(left);
        for (const Path& path : paths)
            if (path.end->status == PathStatus::at_infinity || path.end->status == PathStatus::failed) {
                copy_lane(path.q, 0, path.end->q, 0);
                path.end->t = 1 - path.r;
            }
    }

    /// Whether the path is believed to diverge: less easily where somebody can tell better.
    bool is_believed_to_diverge(Path& path) const {
        path.diverging = detail::diverges(path.q, path.nu, path.before, resort_);
        const double size = size2(path.q);
        return path.diverging &&
               (size > far_away2 || path.r < (size > 1e10 ? diverging_radius : slowly_diverging_radius));
    }
    /// Whether the path is left to more digits: no unknown shows a branch point, loops have told nothing, and rounding
    /// can be seen.
    bool is_left(Path& path) const {
        return path.left = resort_ && path.loops > 5 && path.noise > 1e-7 && are_below(path.nu, 0.05);
    }
    /// Whether two loops settle what becomes of the path.
    bool closes(Path& path) {
        const Loop &now = path.now, &last = path.last;
        if (now.winding == 0 || last.winding == 0) return false;
        path.excluded = std::min(path.excluded, excluded_radius(now, path.r, last));
        if (path.excluded < slowly_diverging_radius) return true;
        path.decided = (exact && now.winding == 1 && is_regular_at_the_end(path)) ||
                       (now.has_mean && last.has_mean && distance(now.mean, last.mean) < settled &&
                        settle(*path.end, now.mean, now.winding));
        return path.decided;
    }
    /// To the next scale: where the fastest unknown has grown e^3 times, a tenth at the most. Those that are stuck stay
    /// behind, and are no longer open.
    void go_on(Paths& open) {
        std::vector<double> next;
        std::vector<Segment<R>> segments;
        for (const Path* path : open) {
            double fastest = 0;
            for (const double v : path->nu) fastest = std::max(fastest, v);
            next.push_back(path->r * std::max(0.1, std::exp(-3 / (fastest + 1e-3))));
            segments.push_back(segment(*path, next.back()));
            segments.back().may_leave = true;
        }
        closing_.follow(std::span(segments));
        for (std::size_t k = 0; k < open.size(); ++k) {
            Path& path = *open[k];
            path.end->steps = segments[k].steps;
            if (segments[k].progress == Progress::stuck) {
                open[k] = nullptr;
                continue;
            }
            path.q = segments[k].q;
            path.r -= segments[k].reached * (path.r - next[k]);
        }
        std::erase(open, nullptr);
    }
    /// What the paths that no loop settled are.
    void conclude(const Paths& left) {
        const auto infinite = [](const Path& path) {
            return path.diverging || path.excluded < slowly_diverging_radius ||
                   (path.r > smallest_radius && path.excluded < pole_radius);
        };
        Paths receding =
            select(left, [&](const Path& path) { return !infinite(path) && path.r > smallest_radius && !path.left; });
        find_receding(receding);
        Paths regular;
        for (Path* path : left) {
            if (infinite(*path) || std::find(receding.begin(), receding.end(), path) != receding.end()) {
                path->end->status = PathStatus::at_infinity;
                continue;
            }
            path->end->status = PathStatus::failed;
            path->end->reason = FailureReason::endgame_undecided;
            if (path->r <= 10 * smallest_radius && !path->left) regular.push_back(path);
        }
        go_to_the_end(regular);
    }
    /// No singularity on any scale: the paths are regular at t = 1, only badly conditioned.
    void go_to_the_end(const Paths& paths) {
        std::vector<Segment<R>> segments;
        for (const Path* path : paths) segments.push_back(segment(*path, 0));
        closing_.follow(std::span(segments));
        for (std::size_t k = 0; k < paths.size(); ++k) {
            Endpoint& end = *paths[k]->end;
            end.steps = segments[k].steps;
            if (segments[k].progress != Progress::arrived) continue;
            // rounding may have led it along a family
            const bool strayed = distance(paths[k]->q, segments[k].q) > 1;
            paths[k]->q = segments[k].q;
            if (strayed || is_regular_in_digits(segments[k].q, end)) continue;
            RuntimePoint<double> reached;
            copy_lane(segments[k].q, 0, reached, 0);
            RuntimePoint<double> q = reached;
            polisher_->run(q, &end.evidence, polishing_);
            if (!is_regular(end.evidence) || distance(q, reached) > 1e-6) continue;
            end.q = q;
            end.status = PathStatus::finite;
            end.reason = FailureReason::none;
        }
    }

    /// From where the path is to t = 1 - r.
    static Segment<R> segment(const Path& path, double r) {
        Segment<R> y;
        y.q = path.q;
        y.from = time(path.r);
        y.to = time(r);
        y.steps = path.end->steps;
        y.noise = path.noise;
        return y;
    }

    /// Valuations, and how large rounding is there.
    void find_valuations(const Paths& paths) {
        std::vector<Expansion<R>> points;
        for (const Path* path : paths)
            points.push_back({.q = path->q, .r = path->r, .noise = 0, .nu = Valuations(sizes_.unknowns)});
        closing_.expand(std::span(points));
        for (std::size_t k = 0; k < paths.size(); ++k) {
            Path& path = *paths[k];
            path.q = points[k].q;
            path.noise = std::clamp(16 * points[k].noise / closing(options_).contraction, 1e-7, 1e-5);
            path.before = path.nu;
            path.nu = points[k].nu;
            for (int u = sizes_.angles; u < sizes_.unknowns; ++u)
                path.nu[u] /= 1e-30 + std::sqrt(static_cast<double>(norm2(path.q.x[u - sizes_.angles])));
        }
    }
    void find_loops(const Paths& paths) {
        std::vector<Circle<R>> circles;
        for (const Path* path : paths) circles.emplace_back(path->q, path->r, path->end->steps, path->noise, closed);
        closing_.follow(std::span(circles));
        for (std::size_t k = 0; k < paths.size(); ++k) {
            paths[k]->now = circles[k].loop();
            ++paths[k]->loops;
            paths[k]->end->steps = circles[k].steps;
        }
    }
    /// The unknown that is farthest out is far, and on its way.
    static bool recedes(const Path& path) { return is_far(path.q) && path.nu[farthest(path.q)] > 0.1; }
    /// Of paths that rounding stops, those on their way to infinity as far as r and 10 r tell: loops there show a pole,
    /// or they are so far out that their valuations are enough.
    void find_receding(Paths& paths) {
        std::erase_if(paths, [](Path* path) { return !is_far(path->q) || 10 * path->r > 0.05; });
        find_valuations(paths);
        find_loops(paths);
        std::vector<Path> wider;  // the same paths at 10 r
        std::vector<Segment<R>> segments;
        for (const Path* path : paths) segments.push_back(segment(*path, 10 * path->r));
        closing_.follow(std::span(segments));
        for (std::size_t k = 0; k < paths.size(); ++k) {
            Path& path = *paths[k];
            path.end->steps = segments[k].steps;
            wider.push_back(path_at(*path.end, 10 * path.r));
            wider.back().q = segments[k].q;
        }
        Paths back;
        for (std::size_t k = 0; k < paths.size(); ++k)
            if (segments[k].progress == Progress::arrived) back.push_back(&wider[k]);
        find_valuations(back);
        find_loops(back);
        for (std::size_t k = 0; k < paths.size(); ++k) {
            const Path &path = *paths[k], &at_wider = wider[k];
            const bool recedes = segments[k].progress == Progress::arrived &&
                                 (grows(path.q, path.nu, at_wider.q, at_wider.nu, resort_) ||
                                  (!resort_ && excluded_radius(path.now, path.r, at_wider.now) < pole_radius));
            if (!recedes) paths[k] = nullptr;
        }
        std::erase(paths, nullptr);
    }
    static bool is_regular(const PolishedEvidence& evidence) {
        return evidence.condition < regular_condition && evidence.correction < 1e-8;
    }
    /// Whether the endpoint is next to q and regular, which no condition tells where R has digits to spare.
    bool is_regular_in_digits(At q, Endpoint& end) {
        if constexpr (exact) {
            if (!converges_in_digits(*homotopy_, q)) return false;
            copy_lane(q, 0, end.q, 0);
            polisher_->assess(end.q, &end.evidence, polishing_);
            end.status = PathStatus::finite;
            end.reason = FailureReason::none;
            return true;
        }
        return false;
    }
    /// The same of the end of a path, straight on. A regular one is not many steps away.
    bool is_regular_at_the_end(const Path& path) {
        constexpr std::int32_t many_steps = 100;
        Segment<R> rest = segment(path, 0);
        const std::int32_t before = rest.steps;
        const auto counted_from = rest.steps = std::max(before, options_.most_steps - many_steps);
        closing_.follow(std::span(&rest, 1));
        path.end->steps = before + (rest.steps - counted_from);
        return rest.progress == Progress::arrived && is_regular_in_digits(rest.q, *path.end);
    }
    /// Decides at a settled estimate of the endpoint; false if the radius is still too large to tell.
    bool settle(Endpoint& end, const At& mean, int winding) {
        RuntimePoint<double> estimate;
        copy_lane(mean, 0, estimate, 0);
        RuntimePoint<double> q = estimate;
        polisher_->run(q, &end.evidence, polishing_);
        if (is_regular(end.evidence)) {
            if (winding > 1 || distance(q, estimate) > 1e-6) return false;  // a branch point near t = 1, not at it
            end.q = q;
            end.status = PathStatus::finite;
            return true;
        }
        if (winding == 1 && is_regular_in_digits(mean, end)) return true;
        // loops around what looks like an endpoint at these radii, but is none, close as well: it fulfils no equations
        q = estimate;
        if (!(polisher_->correct_determined(q, polishing_) < 1e-10)) return false;
        polisher_->assess(q, &end.evidence, polishing_);
        if (end.evidence.condition < regular_condition) return false;  // a regular solution, near the estimate
        end.q = q;
        end.status = PathStatus::singular;
        end.winding_number = static_cast<std::int16_t>(winding);
        return true;
    }

    const H* homotopy_;
    Sizes<M> sizes_;
    TrackerOptions options_;
    bool resort_;
    SegmentLanes<H, R> tracker_, closing_;  // from the start, and near t = 1
    const Polisher<H>* polisher_;
    typename Polisher<H>::template Workspace<double> polishing_;
};

}  // namespace equilibria::detail
