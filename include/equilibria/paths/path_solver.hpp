/// \file
/// All paths of one homotopy to their ends: tracked in lanes, what the lanes leave undecided by the endgame, endpoints
/// polished, and paths that ran into each other found and tracked again.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include <equilibria/homotopy/endgame.hpp>
#include <equilibria/homotopy/lane_tracker.hpp>
#include <equilibria/paths/coincidence.hpp>
#include <equilibria/paths/path_counts.hpp>
#include <equilibria/run/parallel.hpp>
#include <equilibria/storage/endpoint_store.hpp>

namespace equilibria {

struct EnumerateOptions {
    std::uint64_t seed = 1;   ///< of the start system; the same seed gives the same result
    unsigned threads = 1;     ///< 0: all of the machine's; does not change the result
    TrackerOptions tracker{};
    /// Called now and then with the numbers of paths done and of all, from any thread, one call at a time.
    std::function<void(std::uint64_t done, std::uint64_t all)> progress{};
    /// A file that keeps what is finished; if it exists already, the run goes on from there. Empty: none. An existing
    /// file of another run is refused (CheckpointError). It does not change the result.
    std::string checkpoint{};
    /// The run ends soon after this has become true, with what is finished until then; see RootSet::cancelled. It may be
    /// set from a signal handler.
    const std::atomic<bool>* cancel = nullptr;

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
        : homotopy_(homotopy), parameters_(parameters), polisher_(homotopy_, parameters, scale), options_(options),
          rescue_(rescue) {}
    PathSolver(const PathSolver&) = delete;

    /// Where the endpoints of paths 0 .. size-1 from start(path) go: to memory, or to the checkpoint that the options
    /// name, and, unless `streamed`, to both. Throws CheckpointError.
    template <class Start>
    EndpointStore<M> store(std::uint64_t size, Start&& start, std::string_view kind, bool streamed) const {
        if (options_.checkpoint.empty()) return {size, block(size)};
        Fingerprint numbers;
        const auto& [target, difference, constants] = homotopy_;
        for (const auto& a : target) numbers(a);
        for (const auto& a : difference) numbers(a);
        for (const auto& a : constants) numbers(a);
        for (std::uint64_t k = 0; k < size; ++k) {
            const Point<M, double> q = start(k);
            for (const auto& z : q.c) numbers(z.re), numbers(z.im);
            for (const auto& z : q.s) numbers(z.re), numbers(z.im);
            for (const auto& z : q.x) numbers(z.re), numbers(z.im);
        }
        return {size, block(size), options_.checkpoint,
                checkpoint_header<M, C>(parameters_, options_.seed, kind, numbers, options_.tracker, size, block(size)),
                !streamed};
    }

    /// The same in memory, whatever the options.
    EndpointStore<M> memory(std::uint64_t size) const { return {size, block(size)}; }

    /// Tracks the paths from start(path) that `ends` lacks. resting: solutions that rest at every t (none of the paths may
    /// end there); reflected: mirror images count as the same endpoint. Where it was cancelled, `ends` is not complete.
    template <class Start>
    void run(EndpointStore<M>& ends, Start&& start, std::span<const Endpoint<M>> resting, bool reflected,
             PathCounts& counts) {
        const auto begin = std::chrono::steady_clock::now();
        constexpr bool pivoted = !Formulation<M>::has_potential;
        std::atomic<std::int64_t> tracking = 0, working = 0;
        const auto now = [] { return std::chrono::steady_clock::now().time_since_epoch().count(); };
        report(ends.finished(), ends.size());
        parallel_blocks(ends.size(), ends.block(), options_.threads, [&](std::size_t first, std::size_t last) {
            const std::uint64_t which = first / ends.block();
            if (ends.has_block(which) || cancelled()) return;
            const auto started = now();
            std::vector<std::uint64_t> paths(last - first);
            std::iota(paths.begin(), paths.end(), first);
            std::vector<Endpoint<M>> block(paths.size());
            track_lanes<Pack, pivoted>(homotopy_, options_.tracker, std::span<const std::uint64_t>(paths), start,
                                       std::span(block));
            tracking += now() - started;
            polish(block);
            std::uint64_t retracked = 0;
            for (std::size_t k = 0; k < block.size(); ++k)
                if (block[k].status == PathStatus::failed) retracked += finish(block[k], start(paths[k]));
            working += now() - started;
            ends.put(which, block, retracked);
            report(last - first, ends.size());
        });
        // the threads' share of tracking proper, polishing and endgames left out
        tracking_seconds_ = seconds_since(begin);
        if (working > 0) tracking_seconds_ *= static_cast<double>(tracking) / static_cast<double>(working);
        counts.retracked += ends.retracked();
        if (ends.complete()) {
            rescue_failed(start, ends, counts);
            uncross(start, ends, resting, reflected, counts);
            rescue_failed(start, ends, counts);
        }
        for (std::uint64_t k = 0; k < ends.size(); ++k)
            if (ends.finished(k)) counts.steps += static_cast<std::uint64_t>(ends[k].steps);
        counts.tracked += ends.finished();
    }

    double tracking_seconds() const { return tracking_seconds_; }
    const Polisher<M, Kind, C>& polisher() const { return polisher_; }

private:
    bool cancelled() const { return options_.cancel && options_.cancel->load(std::memory_order_relaxed); }

    std::size_t block(std::size_t size) const {
        // lanes idle at the end of a block: few blocks, but enough to keep all threads busy, and to lose little of the work
        // where the run is cancelled or killed
        if (options_.cancel || !options_.checkpoint.empty())
            return std::clamp<std::size_t>(size / 64, 8 * native_lanes, 512);
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
    void rescue_failed(Start&& start, EndpointStore<M>& ends, PathCounts& counts) const {
        if (!rescue_) return;
        std::vector<std::pair<std::uint64_t, Endpoint<M>>> failed;
        for (std::uint64_t k = 0; k < ends.size(); ++k)
            if (const Endpoint<M>& end = ends[k]; end.status == PathStatus::failed && !end.more_digits)
                failed.emplace_back(k, end);
        TrackerOptions careful = options_.tracker.tightened();
        careful.most_steps = std::max(careful.most_steps, 20000);
        parallel_blocks(failed.size(), 1, options_.threads, [&](std::size_t at, std::size_t) {
            auto& [k, end] = failed[at];
            rescue_(homotopy_, polisher_, careful, start(k), end);
            end.more_digits = true;
        });
        for (const auto& [k, end] : failed) ends.replace(k, end);
        counts.more_digits += failed.size();
    }

    /// Two paths cannot end at one regular solution: where they seem to, one of them jumped.
    template <class Start>
    void uncross(Start&& start, EndpointStore<M>& ends, std::span<const Endpoint<M>> resting, bool reflected,
                 PathCounts& counts) const {
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
                    if (cancelled()) {
                        ends.unsettle(k);
                        continue;
                    }
                    Endpoint<M> end = ends[k];
                    const Point<M, double> before = end.q;
                    track_again(end, start(k), careful);
                    ++counts.retracked;
                    counts.crossed += end.status != PathStatus::finite || !finder.same(before, end.q, 1e-9);
                    ends.replace(k, end);
                }
            if (!ends.complete()) return;
        }
    }

    Homotopy<M, Kind, C> homotopy_;
    Parameters<M, C> parameters_;
    Polisher<M, Kind, C> polisher_;
    EnumerateOptions options_;
    Rescue<M, Kind, C> rescue_;
    std::mutex progress_guard_;
    std::uint64_t done_ = 0;
    double tracking_seconds_ = 0;
};

}  // namespace detail
}  // namespace equilibria
