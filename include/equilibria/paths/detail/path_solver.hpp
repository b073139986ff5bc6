/// \file
/// All paths of a homotopy: in blocks, tracked, polished, ended, tracked again where it is hard, and uncrossed.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/homotopy/endgame.hpp>
#include <equilibria/homotopy/lane_tracker.hpp>
#include <equilibria/paths/detail/coincidence_finder.hpp>
#include <equilibria/paths/detail/path_problem.hpp>
#include <equilibria/paths/over_ranks.hpp>
#include <equilibria/paths/path_set.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/run/mutex.hpp>
#include <equilibria/run/ranks.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/storage/checkpoint.hpp>
#include <equilibria/storage/endpoint_bytes.hpp>
#include <equilibria/storage/endpoint_store.hpp>
#include <equilibria/storage/fingerprint.hpp>

namespace equilibria::detail {

/// H: a homotopy of a system that is data.
template <class H>
class PathSolver {
public:
    using Pack = Lanes<native_lanes>;
    /// What brings its own law of time, predictor or step control is tracked in double.
    static constexpr bool may_be_single = std::is_same_v<H, PolynomialHomotopy>;
    /// Three packs of doubles: fewer paths fill the lanes of floats too badly.
    static constexpr std::uint64_t least_in_single = 3 * LaneTraits<Pack>::width;

    PathSolver(const H& homotopy, PathProblem problem, const RunOptions& run, const TrackerOptions& options,
               MoreDigits<H> resort)
        : homotopy_(&homotopy), problem_(std::move(problem)), numbering_(problem_.start.numbering), polisher_(homotopy),
          run_(&run), options_(options), more_digits_(resort) {
        if constexpr (may_be_single)
            if (options_.single_precision && numbering_.tracked() >= least_in_single) single_ = homotopy.scaled();
    }
    PathSolver(const PathSolver&) = delete;

    /// Where it was cancelled, not all paths are finished.
    PathSet track() {
        PathSet paths(numbering_, store(), resting());
        if (problem_.streamed) paths.key_limits = {run_->key_memory, run_->checkpoint};
        track_unfinished(paths);
        if (paths.ends().complete() && !elsewhere()) {
            track_with_more_digits(paths);
            const bool apart = uncross(paths);
            paths.apart = track_with_more_digits(paths) == 0 && apart;
        }
        return paths;
    }

private:
    RuntimePoint<double> start_point(std::uint64_t k) const { return problem_.start.point(k); }

    void track_block(std::span<const std::uint64_t> paths, std::span<Endpoint> ends) const {
        if constexpr (may_be_single)
            if (single_) return track_single_first(*single_, *homotopy_, options_, paths, problem_.start.point, ends);
        track_lanes<Pack, false>(*homotopy_, options_, paths, problem_.start.point, ends);
    }

    /// Solutions that rest at every t, and at which no other path may end.
    std::vector<Endpoint> resting() const {
        std::vector<Endpoint> y(numbering_.resting());
        if (y.empty()) return y;
        typename Polisher<H>::template Workspace<double> with(*homotopy_);
        for (std::size_t k = 0; k < y.size(); ++k) {
            y[k].q = problem_.start.resting_point(k);
            y[k].arrival = Arrival::end;
            polisher_.assess(y[k].q, &y[k].evidence, with);
            y[k].status = y[k].evidence.condition < regular_condition ? PathStatus::finite : PathStatus::singular;
        }
        return y;
    }

    /// Where the endpoints go: to memory, or to the checkpoint that the options name, and, unless streamed, to both.
    EndpointStore store() const {
        const std::uint64_t size = numbering_.tracked();
        if (!run_->is_told_apart()) return {size, block(size), homotopy_->sizes()};
        require(run_->checkpoint.empty() || !problem_.model.empty(), "checkpoint", run_->checkpoint,
                "must be empty: it keeps the enumeration of a model");
        Fingerprint numbers;
        homotopy_->for_each_number([&](const auto& number) { numbers(number); });
        // roots of a start system follow from its numbers: some of them are a check of how they are numbered
        const std::uint64_t step = problem_.start.of_system ? std::max<std::uint64_t>(size / 16, 1) : 1;
        for (std::uint64_t k = 0; k < size; k += step) {
            const RuntimePoint<double> q = start_point(k);
            for (const auto* part : {&q.c, &q.s, &q.x})
                for (const auto& z : *part) numbers(z.re), numbers(z.im);
        }
        const auto header = checkpoint_header(
            problem_.model, {run_->seed, problem_.start.name, numbers, size, block(size), more_digits_ != nullptr},
            options_);
        require_same_run(run_->ranks, header);
        std::optional<EndpointStore> kept;
        if (!run_->checkpoint.empty())
            run_->ranks.at_first([&] {
                kept.emplace(size, block(size), run_->checkpoint, header, !problem_.streamed, homotopy_->sizes());
            });
        if (kept) return std::move(*kept);
        if (elsewhere()) return EndpointStore::elsewhere(size, block(size), homotopy_->sizes());
        return {size, block(size), homotopy_->sizes()};
    }
    /// Whether the endpoints are at rank 0 alone, which goes on alone: this is another rank.
    bool elsewhere() const { return problem_.streamed && !run_->ranks.first(); }

    void track_unfinished(PathSet& paths) {
        const detail::Stopwatch begin;
        EndpointStore& ends = paths.ends();
        std::atomic<std::int64_t> tracking = 0, working = 0;
        const auto now = [] { return std::chrono::steady_clock::now().time_since_epoch().count(); };
        const auto track_all = [&](std::size_t first, std::size_t last) {
            const auto started = now();
            std::vector<std::uint64_t> numbers(last - first);
            std::iota(numbers.begin(), numbers.end(), first);
            std::vector<Endpoint> tracked(numbers.size());
            track_block(numbers, tracked);
            tracking += now() - started;
            working += now() - started;
            return tracked;
        };
        const auto end_block = [&](std::span<Endpoint> block, std::size_t first) {
            const auto started = now();
            polish(block);
            const std::uint64_t retracked = finish(block, first);
            working += now() - started;
            return retracked;
        };
        const auto track_from = [&](std::size_t first, std::size_t last, std::vector<Endpoint>& block) {
            block = track_all(first, last);
            return end_block(block, first);
        };
        report(ends.finished(), ends.size());
        if (run_->ranks.several()) {
            share_blocks(ends, track_from);
        } else {
            const std::size_t length = ends.block();
            run_->executor.for_blocks(ends.size(), together(ends), [&](std::size_t first, std::size_t last) {
                if (ends.has_block(first / length) || run_->cancelled()) return;
                std::vector<Endpoint> tracked = track_all(first, last);
                for (std::size_t at = first; at < last && !run_->cancelled(); at += length) {
                    const auto block = std::span(tracked).subspan(at - first, std::min(length, last - at));
                    ends.put(at / length, block, end_block(block, at));
                    report(block.size(), ends.size());
                }
            });
        }
        // the trackers' share, polishing and endgames left out
        paths.effort.tracking_seconds = begin.seconds();
        if (working > 0) paths.effort.tracking_seconds *= static_cast<double>(tracking) / static_cast<double>(working);
        paths.effort.retracked += ends.retracked();
    }

    /// The blocks that are not there yet, over the ranks. Rank 0 keeps all of them, each other rank its own; in the
    /// end they get what they lack, where rank 0 does not go on alone.
    void share_blocks(EndpointStore& ends, const auto& track_from) {
        const BlockCodec codec(homotopy_->sizes());
        const Ranks& ranks = run_->ranks;
        const std::size_t size = ends.size(), length = ends.block(), blocks = (size + length - 1) / length;
        const auto paths = [&](std::size_t which) { return std::min(length, size - which * length); };
        std::vector<char> from_others(blocks, 0);  // at rank 0
        ranks.for_blocks({.size = blocks,
                          .done = [&](std::size_t which) { return ends.has_block(which); },
                          .work =
                              [&](std::size_t which) {
                                  std::vector<Endpoint> block;
                                  const std::size_t first = which * length;
                                  const auto retracked = track_from(first, first + paths(which), block);
                                  if (!problem_.streamed || ranks.first()) ends.put(which, block, retracked);
                                  return ranks.first() ? Bytes() : codec.encode(block, retracked);
                              },
                          .take =
                              [&](std::size_t which, Ranks::BytesView bytes) {
                                  if (!bytes.empty()) {
                                      ends.put(which, bytes, paths(which));
                                      from_others[which] = 1;
                                  }
                                  report(paths(which), size);
                              },
                          .cancelled = [this] { return run_->cancelled(); }},
                         run_->executor);
        if (problem_.streamed) return;
        const auto lacking = [&](std::size_t which) {
            return ends.has_block(which) && (ranks.size() > 2 || from_others[which] == 0);
        };
        ranks.share(
            blocks, lacking, [&](std::size_t which, Ranks::Bytes& to) { ends.append_to(to, which, paths(which)); },
            [&](std::size_t which, Ranks::BytesView bytes) {
                if (!ends.has_block(which)) ends.put(which, bytes, paths(which));
            });
        ends.set_retracked(ranks.of_first(ends.retracked()));
    }

    std::size_t block(std::size_t size) const {
        // lanes idle at the end of a block: few blocks, but enough to keep all workers busy, and to lose little of the
        // work where the run is cancelled or killed
        if (run_->cancel || run_->is_told_apart()) return shared_block(size);
        if (run_->executor.workers() == 1) return 4096;
        return std::clamp<std::size_t>(size / (8 * run_->executor.workers()), 8 * native_lanes, 4096);
    }
    /// How many paths are tracked at once, a multiple of the block: all of a block; or, where a run may be cancelled
    /// and blocks are small, so many blocks that lanes stay filled and their tracking takes about a tenth of a second.
    /// What factorisations cost grows with the cube of the unknowns.
    std::size_t together(const EndpointStore& ends) const {
        const std::size_t block = ends.block();
        if (!run_->cancel || run_->is_told_apart()) return block;
        constexpr double paths_of_one_unknown = 2e6, most = 1024;
        const double paths = std::min(paths_of_one_unknown / std::pow(homotopy_->sizes().unknowns, 3), most);
        const std::size_t workers = run_->executor.workers();
        const auto fair = workers == 1 ? paths : std::min(paths, static_cast<double>(ends.size() / (8 * workers)));
        return block * std::max<std::size_t>(static_cast<std::size_t>(fair) / block, 1);
    }
    void report(std::uint64_t more, std::uint64_t all) {
        if (!run_->progress || !run_->ranks.first()) return;
        const Lock lock(progress_guard_);
        run_->progress(done_ += more, all);
    }

    void polish(std::span<Endpoint> ends) const {
        std::array<std::size_t, native_lanes> member{};
        int filled = 0;
        auto q = point_of_zeros<RuntimeUnknowns, Pack>(homotopy_->sizes());
        typename Polisher<H>::template Workspace<Pack> with(*homotopy_);
        const auto flush = [&] {
            if (filled == 0) return;
            for (int k = filled; k < native_lanes; ++k) copy_lane(q, 0, q, k);
            std::array<PolishedEvidence, native_lanes> evidence;
            polisher_.run(q, evidence.data(), with);
            for (int k = 0; k < filled; ++k) {
                Endpoint& end = ends[member[static_cast<std::size_t>(k)]];
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

    /// Decides the paths of a block that the lanes left open; returns how many were tracked again from their start.
    std::uint64_t finish(std::span<Endpoint> block, std::size_t first) const {
        std::vector<Endpoint*> arrived;
        for (Endpoint& end : block)
            if (end.status == PathStatus::failed && end.arrival == Arrival::endgame) arrived.push_back(&end);
        if (!arrived.empty()) Endgame<H>(*homotopy_, polisher_, options_, more_digits_ != nullptr).finish(arrived);
        std::uint64_t retracked = 0;
        TrackerOptions careful = options_;
        for (int round = 0; round < 2; ++round) {
            std::vector<std::uint64_t> failed;
            for (std::size_t k = 0; k < block.size(); ++k)
                if (block[k].status == PathStatus::failed && !end_straight(block[k])) failed.push_back(k);
            if (round == 0) retracked = failed.size();
            if (failed.empty()) break;
            careful = careful.tightened();
            std::vector<Endpoint> ends = track_again(failed, first, careful);
            for (std::size_t m = 0; m < failed.size(); ++m) {
                ends[m].steps += block[failed[m]].steps;
                ends[m].precision = block[failed[m]].precision;
                block[failed[m]] = ends[m];
            }
        }
        return retracked;
    }
    /// Ends a path that rounding alone has stopped near its end, with more digits where there are; whether it did.
    bool end_straight(Endpoint& end) const {
        if (!more_digits_ || end.reason != FailureReason::endgame_undecided || !(end.t > 0.98)) return false;
        more_digits_(*homotopy_, polisher_, options_, nullptr, end);
        if (end.status == PathStatus::failed) return false;
        end.precision = Precision::more_digits;
        return true;
    }
    /// The paths of these numbers, `first` added, from their start.
    std::vector<Endpoint> track_again(std::span<const std::uint64_t> paths, std::uint64_t first,
                                      const TrackerOptions& options) const {
        std::vector<RuntimePoint<double>> starts;
        for (const std::uint64_t k : paths) starts.push_back(start_point(first + k));
        std::vector<Endpoint> ends(paths.size());
        Endgame<H>(*homotopy_, polisher_, options).from_starts(starts, ends);
        return ends;
    }

    /// The failed paths, and singular ones that may be badly conditioned, each once; returns how many.
    std::size_t track_with_more_digits(PathSet& paths) const {
        if (!more_digits_) return 0;
        EndpointStore& ends = paths.ends();
        std::vector<std::uint64_t> failed;
        std::vector<Endpoint> again;
        paths.effort.more_digits = 0;
        for (std::uint64_t k = 0; k < ends.size(); ++k) {
            const EndpointRecord end = ends.record(k);
            paths.effort.more_digits += end.precision == Precision::more_digits;
            const bool doubtful = end.status == PathStatus::failed || end.status == PathStatus::singular;
            if (doubtful && end.precision != Precision::more_digits) failed.push_back(k), again.push_back(ends[k]);
        }
        TrackerOptions careful = options_.tightened();
        careful.most_steps = std::max(careful.most_steps, 20000);
        RunOptions run = *run_;
        if (problem_.streamed) run.ranks = {};
        compute_endpoints(run, homotopy_->sizes(), again, 1, [&](std::size_t at, std::size_t) {
            Endpoint& end = again[at];
            const PathStatus before = end.status;
            const RuntimePoint<double> start = start_point(failed[at]);
            more_digits_(*homotopy_, polisher_, careful, &start, end);
            if (before == PathStatus::failed || end.status != before) end.precision = Precision::more_digits;
        });
        std::size_t changed = 0;
        for (std::size_t at = 0; at < failed.size(); ++at) {
            if (again[at].precision != Precision::more_digits) continue;
            ends.replace(failed[at], again[at]);
            ++changed;
        }
        paths.effort.more_digits += changed;
        return changed;
    }

    /// Two paths cannot end at one regular solution: where they seem to, one of them jumped, and they are tracked
    /// again. Returns whether no two do any more.
    bool uncross(PathSet& paths) const {
        EndpointStore& ends = paths.ends();
        const CoincidenceFinder finder(paths.symmetric(), paths.sizes(), paths.key_limits);
        const auto point = [&](std::size_t k) {
            return paths.status(k) == PathStatus::finite ? paths.point(k) : PointView();
        };
        TrackerOptions careful = options_;
        for (int round = 0; round < 3; ++round) {
            const auto groups = finder.groups(paths.size(), point, 1e-9);
            if (groups.empty()) return true;
            careful = careful.tightened();
            const bool cancelled = problem_.streamed ? run_->cancelled() : run_->cancelled_anywhere();
            std::vector<std::uint64_t> crossed;
            for (const auto& group : groups)
                for (const std::size_t k : group)
                    if (paths.rests(k))
                        continue;
                    else if (cancelled)
                        ends.unsettle(k);
                    else
                        crossed.push_back(k);
            const std::vector<Endpoint> again = track_again(crossed, 0, careful);
            for (std::size_t m = 0; m < crossed.size(); ++m) {
                const Endpoint before = ends[crossed[m]];
                Endpoint end = again[m];
                end.steps += before.steps;
                if (before.precision != Precision::more_digits) end.precision = before.precision;  // not with these
                ++paths.effort.retracked;
                paths.effort.crossed += end.status != PathStatus::finite || !finder.same(before.q, end.q, 1e-9);
                ends.replace(crossed[m], end);
            }
            if (!ends.complete()) return false;
        }
        return false;
    }

    const H* homotopy_;
    std::optional<PolynomialHomotopy> single_;  // where paths are tracked in single precision first
    PathProblem problem_;
    PathNumbering numbering_;
    Polisher<H> polisher_;
    const RunOptions* run_;
    TrackerOptions options_;
    MoreDigits<H> more_digits_;
    Mutex progress_guard_;
    std::uint64_t done_ = 0;
};

}  // namespace equilibria::detail
