/// \file
/// See paths/predicted_work.hpp.
#pragma once

#include <algorithm>
#include <limits>
#include <string_view>

#include <equilibria/core/random.hpp>
#include <equilibria/paths/detail/choose_start_definitions.hpp>
#include <equilibria/paths/predicted_work.hpp>
#include <equilibria/paths/track.hpp>
#include <equilibria/polyhedral/affine_supports.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/start/total_degree_start.hpp>
#include <equilibria/system/path_bounds.hpp>
#include <equilibria/system/unit_scaling.hpp>

namespace equilibria {

namespace detail {

/// Some paths of a start, spread over all of them.
class SampleOfStart {
public:
    SampleOfStart(const TotalDegreeStart& of, std::uint64_t paths)
        : of_(of), paths_(std::min(paths, of.numbering().total())), stride_(of.numbering().total() / paths_) {}
    static constexpr std::string_view name() { return "sample"; }
    PathNumbering numbering() const { return PathNumbering::all(paths_); }
    RuntimePoint<double> point(std::uint64_t k) const { return of_.point(k * stride_); }

private:
    const TotalDegreeStart& of_;
    std::uint64_t paths_, stride_;
};

/// Seconds that one thread takes for a path of the total degree, and for a step.
struct SampledSeconds {
    double path = 0, step = 0;
};
EQUILIBRIA_INLINE SampledSeconds sampled_seconds(const SparseSystem& in_own_units, const RunOptions& run) {
    const SparseSystem system = scaled(in_own_units, unit_scaling(in_own_units));
    Generator generator(run.seed);
    const TotalDegreeStart start(TotalDegreeKind::general, system.sizes(), system.degrees(), system.scale(), generator);
    const PolynomialHomotopy homotopy = total_degree_homotopy(system, start, system.degrees());
    const SampleOfStart sample(start, 128);
    const Stopwatch clock;
    PathSet paths = track(homotopy, sample, {.seed = run.seed, .cancel = run.cancel});
    const double seconds = clock.seconds();
    return {seconds / static_cast<double>(paths.size()),
            seconds / static_cast<double>(std::max<std::uint64_t>(account_for(paths).counts.steps, 1))};
}

}  // namespace detail

EQUILIBRIA_INLINE PredictedWork predicted_work(const SparseSystem& system, const StartChoice& start,
                                               const RunOptions& run, std::int64_t fewest_sampled) {
    PredictedWork y;
    const StartBounds& bounds = start.bounds;
    y.paths = bounds.total_degree;
    bool polyhedral = false;
    const auto n = static_cast<double>(system.sizes().unknowns);
    double bytes_of_path = 100 + 70 * n;
    if (start.kind == StartKind::multihomogeneous) y.paths = bounds.multihomogeneous;
    if (start.kind == StartKind::polyhedral || start.kind == StartKind::monodromy) {
        y.paths = {0, true};
        constexpr std::uint64_t largest = std::uint64_t{1} << 62;
        if (bounds.mixed_volume && *bounds.mixed_volume < largest)
            y.paths = {static_cast<std::int64_t>(*bounds.mixed_volume), false};
        polyhedral = true;
        bytes_of_path += 70 * n + 4.0 * affine_supports(system).columns();
    }
    y.bytes = y.paths.saturated ? std::numeric_limits<double>::infinity()
                                : bytes_of_path * static_cast<double>(y.paths.value);
    const bool sampled = !y.paths.saturated && y.paths.value >= fewest_sampled && !bounds.total_degree.saturated &&
                         std::ranges::all_of(system.degrees(), [](int d) { return d > 0; });
    if (sampled) {
        constexpr double steps = 60;  // of a path to a finite root, in two stages; paths of the sample may diverge
        const auto seconds = detail::sampled_seconds(system, run);
        y.seconds = static_cast<double>(y.paths.value) * (polyhedral ? steps * seconds.step : seconds.path) /
                    static_cast<double>(run.executor.workers()) / run.ranks.size();
    }
    return y;
}

}  // namespace equilibria
