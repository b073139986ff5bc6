/// \file
/// All paths of one homotopy to their ends: tracked in lanes, what the lanes leave undecided by the endgame, endpoints
/// polished, and paths that ran into each other found and tracked again.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <equilibria/enumerate/coincidence.hpp>
#include <equilibria/enumerate/parallel.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/homotopy/endgame.hpp>

namespace equilibria {

struct EnumerateOptions {
    std::uint64_t seed = 1;   ///< of the start system; the same seed gives the same result
    unsigned threads = 1;     ///< 0: all of the machine's; does not change the result
    TrackerOptions tracker{};
    /// Called now and then with the numbers of paths done and of all, from any thread, one call at a time.
    std::function<void(std::uint64_t done, std::uint64_t all)> progress{};

    void validate() const {
        require(threads <= 1024, "threads", threads, "must be 0 (all) to 1024");
        tracker.validate();
    }
};

namespace detail {

inline double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The largest coefficient of each equation.
template <Model M, class C>
Array<double, n_unknowns<M>> equation_scales(const Array<C, Formulation<M>::terms>& coefficients) {
    Array<double, n_unknowns<M>> scale;
    for (int i = 0; i < n_unknowns<M>; ++i) {
        for (int k = Formulation<M>::first[i]; k < Formulation<M>::first[i + 1]; ++k)
            scale[i] = std::max(scale[i], std::abs(coefficients[k]));
        if (!(scale[i] > 0)) scale[i] = 1;  // an equation that vanishes identically: every endpoint will be singular
    }
    return scale;
}

/// Tracks a path that failed in double with more digits (see multiprecision.hpp). A pointer, so that only those who
/// want it compile it.
template <Model M, StartKind Kind, class C>
using Rescue = void (*)(const Homotopy<M, Kind, C>&, const Polisher<M, Kind, C>&, const TrackerOptions&,
                        const Point<M, double>& start, Endpoint<M>& end);

template <Model M, StartKind Kind, class C>
class PathSolver {
public:
    using Pack = Lanes<native_lanes>;

    PathSolver(const Homotopy<M, Kind, C>& homotopy, const Parameters<M, C>& parameters,
               const Array<double, n_unknowns<M>>& scale, const EnumerateOptions& options,
               Rescue<M, Kind, C> rescue = nullptr)
        : homotopy_(homotopy), polisher_(homotopy_, parameters, scale), options_(options), rescue_(rescue) {}
    PathSolver(const PathSolver&) = delete;

    /// Tracks `paths` from start(path). resting: solutions that rest at every t (none of the paths may end there);
    /// reflected: mirror images count as the same endpoint.
    template <class Start>
    std::vector<Endpoint<M>> run(std::span<const std::uint64_t> paths, Start&& start,
                                 std::span<const Endpoint<M>> resting, bool reflected, PathCounts& counts) {
        const auto begin = std::chrono::steady_clock::now();
        std::vector<Endpoint<M>> ends(paths.size());
        constexpr bool pivoted = !Formulation<M>::has_potential;
        report(0, paths.size());
        parallel_blocks(paths.size(), block(paths.size()), options_.threads, [&](std::size_t first, std::size_t last) {
            track_lanes<Pack, pivoted>(homotopy_, options_.tracker, paths.subspan(first, last - first), start,
                                       std::span(ends).subspan(first, last - first));
            report(last - first, paths.size());
        });
        tracking_seconds_ = seconds_since(begin);
        std::atomic<std::uint64_t> retracked = 0;
        parallel_blocks(paths.size(), 64 * native_lanes, options_.threads, [&](std::size_t first, std::size_t last) {
            polish(std::span(ends).subspan(first, last - first));
            for (std::size_t k = first; k < last; ++k)
                if (ends[k].status == PathStatus::failed) retracked += finish(ends[k], start(paths[k]));
        });
        counts.retracked += retracked;
        rescue_failed(paths, start, ends, counts);
        uncross(paths, start, ends, resting, reflected, counts);
        rescue_failed(paths, start, ends, counts);
        for (const auto& end : ends) counts.steps += static_cast<std::uint64_t>(end.steps);
        counts.tracked += paths.size();
        return ends;
    }

    double tracking_seconds() const { return tracking_seconds_; }
    const Polisher<M, Kind, C>& polisher() const { return polisher_; }

private:
    std::size_t block(std::size_t size) const {
        // lanes idle at the end of a block: few blocks, but enough to keep all threads busy
        if (options_.threads == 1) return 4096;
        return std::clamp<std::size_t>(size / (8 * std::max(2u, options_.threads)), 8 * native_lanes, 4096);
    }
    void report(std::uint64_t more, std::uint64_t all) {
        if (!options_.progress) return;
        const std::lock_guard lock(progress_guard_);
        options_.progress(done_ += more, all);
    }

    void polish(std::span<Endpoint<M>> ends) const {
        std::array<std::size_t, native_lanes> member{};
        int filled = 0;
        Point<M, Pack> q{};
        const auto flush = [&] {
            if (filled == 0) return;
            for (int k = filled; k < native_lanes; ++k) copy_lane(q, 0, q, k);
            std::array<PolishedEvidence, native_lanes> evidence;
            polisher_.run(q, evidence.data());
            for (int k = 0; k < filled; ++k) {
                Endpoint<M>& end = ends[member[static_cast<std::size_t>(k)]];
                end.evidence = evidence[static_cast<std::size_t>(k)];
                // an ill-conditioned endpoint is not believed: the endgame decides
                if (end.evidence.condition < regular_condition && end.evidence.correction < 1e-8) {
                    copy_lane(q, k, end.q, 0);
                    end.status = PathStatus::finite;
                }
            }
            filled = 0;
        };
        for (std::size_t k = 0; k < ends.size(); ++k) {
            if (ends[k].arrival != Arrival::end) continue;
            member[static_cast<std::size_t>(filled)] = k;
            copy_lane(ends[k].q, 0, q, filled);
            if (++filled == native_lanes) flush();
        }
        flush();
    }

    /// Decides a path that the lanes left open; returns whether it was tracked again from its start.
    bool finish(Endpoint<M>& end, const Point<M, double>& start) const {
        if (end.arrival == Arrival::endgame) {
            Endgame<M, Kind, C> endgame(homotopy_, polisher_, options_.tracker);
            endgame.finish(end, 1 - end.t);
            if (end.status != PathStatus::failed) return false;
        }
        TrackerOptions careful = options_.tracker;
        for (int round = 0; round < 2 && end.status == PathStatus::failed; ++round) {
            careful = careful.tightened();
            track_again(end, start, careful);
        }
        return true;
    }
    void track_again(Endpoint<M>& end, const Point<M, double>& start, const TrackerOptions& options) const {
        const std::int32_t steps = end.steps;
        end = Endgame<M, Kind, C>(homotopy_, polisher_, options).from_start(start);
        end.steps += steps;
    }

    /// Tracks the failed paths with more digits, each once.
    template <class Start>
    void rescue_failed(std::span<const std::uint64_t> paths, Start&& start, std::vector<Endpoint<M>>& ends,
                       PathCounts& counts) const {
        if (!rescue_) return;
        std::vector<std::size_t> failed;
        for (std::size_t k = 0; k < ends.size(); ++k)
            if (ends[k].status == PathStatus::failed && !ends[k].more_digits) failed.push_back(k);
        TrackerOptions careful = options_.tracker.tightened();
        careful.most_steps = std::max(careful.most_steps, 20000);
        parallel_blocks(failed.size(), 1, options_.threads, [&](std::size_t at, std::size_t) {
            rescue_(homotopy_, polisher_, careful, start(paths[failed[at]]), ends[failed[at]]);
            ends[failed[at]].more_digits = true;
        });
        counts.more_digits += failed.size();
    }

    /// Two paths cannot end at one regular solution: where they seem to, one of them jumped.
    template <class Start>
    void uncross(std::span<const std::uint64_t> paths, Start&& start, std::vector<Endpoint<M>>& ends,
                 std::span<const Endpoint<M>> resting, bool reflected, PathCounts& counts) const {
        const CoincidenceFinder<M> finder(reflected);
        const auto point = [&](std::size_t k) -> const Point<M, double>* {
            const Endpoint<M>& end = k < ends.size() ? ends[k] : resting[k - ends.size()];
            return end.status == PathStatus::finite ? &end.q : nullptr;
        };
        TrackerOptions careful = options_.tracker;
        for (int round = 0; round < 3; ++round) {
            const auto groups = finder.groups(ends.size() + resting.size(), point, 1e-9);
            if (groups.empty()) return;
            careful = careful.tightened();
            for (const auto& group : groups)
                for (const std::size_t k : group) {
                    if (k >= ends.size()) continue;
                    const Point<M, double> before = ends[k].q;
                    track_again(ends[k], start(paths[k]), careful);
                    ++counts.retracked;
                    counts.crossed += ends[k].status != PathStatus::finite || !finder.same(before, ends[k].q, 1e-9);
                }
        }
    }

    Homotopy<M, Kind, C> homotopy_;
    Polisher<M, Kind, C> polisher_;
    EnumerateOptions options_;
    Rescue<M, Kind, C> rescue_;
    std::mutex progress_guard_;
    std::uint64_t done_ = 0;
    double tracking_seconds_ = 0;
};

}  // namespace detail
}  // namespace equilibria
