/// \file
/// See enumerate/enumerate.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/families.hpp>
#include <equilibria/homotopy/arc_homotopy.hpp>
#include <equilibria/paths/choose_start.hpp>
#include <equilibria/paths/generic_instance.hpp>
#include <equilibria/paths/merge.hpp>
#include <equilibria/paths/solve_along.hpp>
#include <equilibria/start/coefficient_path.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE RootSet<RuntimeUnknowns> root_set_of(PathSet paths, const RuntimeArray<double>& p,
                                                       const ModelProperties<RuntimeUnknowns>& model,
                                                       const PolynomialHomotopy& homotopy,
                                                       const RealEquations& equations, const RunOptions& run) {
    auto [counts, failures] = account_for(paths);
    const double tracking_seconds = paths.effort.tracking_seconds;
    std::vector<Root<RuntimeUnknowns>> roots;
    {
        PathSet done = std::move(paths);  // many paths have large records
        roots = merge(done);
    }
    auto [isolated, families, regular_paths] = split_families(std::move(roots), homotopy, run.executor);
    auto real = classify(isolated, equations, model.reflection_symmetric, run.executor);
    RootSet<RuntimeUnknowns> set{.parameters = p,
                                 .seed = run.seed,
                                 .paths = counts.with_singular(regular_paths),
                                 .roots = std::move(isolated),
                                 .equilibria = std::move(real.equilibria),
                                 .families = std::move(families),
                                 .failures = std::move(failures),
                                 .alarms = {},
                                 .largest_real_imaginary = real.largest_real_imaginary,
                                 .smallest_nonreal_imaginary = real.smallest_nonreal_imaginary,
                                 .tracking_seconds = tracking_seconds,
                                 .seconds = 0,
                                 .start = {},
                                 .model = model};
    set.alarms = check_alarms(set, run.executor, run.ranks);
    return set;
}

EQUILIBRIA_INLINE std::optional<SparseSystem> system_of_terms(const RuntimeSizes& sizes,
                                                              const std::vector<SparseTerm>& terms) {
    std::vector<SparseTerm> present;
    std::vector<bool> vanishes(static_cast<std::size_t>(sizes.unknowns), true);
    for (const auto& t : terms)
        if (t.coefficient != 0) present.push_back(t), vanishes[static_cast<std::size_t>(t.equation)] = false;
    if (std::ranges::count(vanishes, true) > 0) return {};
    return SparseSystem(sizes, std::move(present));
}

EQUILIBRIA_INLINE bool polyhedral_pays(const std::optional<SparseSystem>& system, const PathCount& tracked,
                                       bool reflected, StartReport& report, const RunOptions& run) {
    // a walk over cells takes a part of the time of as many paths, and is lost where it does not pay: it ends early.
    // Where the start is reflected the paths are half as many, and each costs less
    const std::int64_t few = reflected ? 2000 : 100, share = reflected ? 8 : 2;
    if (!system || (!tracked.saturated && tracked.value <= few)) {
        report.why = "few paths";
        return false;
    }
    const std::int64_t most = (tracked.saturated ? std::numeric_limits<std::int64_t>::max() : tracked.value) / share;
    auto choice = choose_start(polyhedral_bounds(*system, tracked, static_cast<std::uint64_t>(most), run));
    report.mixed_volume = choice.bounds.mixed_volume;
    report.why = std::move(choice.why);
    return choice.kind == StartKind::polyhedral;
}

EQUILIBRIA_INLINE RootSet<RuntimeUnknowns> enumerate_polyhedral(
    const SparseSystem& system, const RuntimeArray<double>& p, const ModelProperties<RuntimeUnknowns>& model,
    std::shared_ptr<const OwnEquations> own, const RealEquations& equations, CheckpointFields fields,
    const RunOptions& run, const TrackerOptions& options, MoreDigits<> resort) {
    const GenericInstance instance(
        system, {.seed = run.seed, .executor = run.executor, .ranks = run.ranks, .cancel = run.cancel}, options);
    const GenericInstance::Start start(instance);
    const PolynomialHomotopy homotopy = instance.homotopy(system, std::move(own));
    auto paths = track_paths(homotopy, {.start = StartPoints(start), .model = std::move(fields)}, run, options, resort);
    auto set = root_set_of(std::move(paths), p, model, homotopy, equations, run);
    instance.add_unsolved_to(set.paths);
    set.tracking_seconds += instance.effort().tracking_seconds;
    set.start = {std::string(GenericInstance::Start::name()), "asked for", instance.mixed_volume()};
    return set;
}

EQUILIBRIA_INLINE void require_start_instance(const PathCounts& solved) {
    require(solved.failed == 0 && solved.singular == 0, "solved.paths",
            std::to_string(solved.failed) + " failed, " + std::to_string(solved.singular) + " singular",
            "a start instance must have regular roots only");
}

EQUILIBRIA_INLINE bool line_serves(std::uint64_t roots, std::span<const int> degrees, const SystemFamily& family,
                                   const RuntimeArray<double>& from, const RuntimeArray<double>& to) {
    PathCount bound{1, false};
    for (std::size_t i = 0; i < degrees.size(); ++i)
        bound = bound * PathCount{(static_cast<int>(i) < family.sizes().angles ? 2 : 1) * degrees[i], false};
    return (!bound.saturated && roots == static_cast<std::uint64_t>(bound.value)) ||
           family.is_affine_between(complex_parameters(from), complex_parameters(to));
}

EQUILIBRIA_INLINE PathSet track_along_arc(const SystemFamily& family, const KnownRoots::Points& points,
                                          const RuntimeArray<double>& from, const RuntimeArray<double>& to,
                                          std::shared_ptr<const OwnEquations> own, const CheckpointFields& model,
                                          const RunOptions& run, const TrackerOptions& options,
                                          MoreDigits<ArcHomotopy> resort) {
    const KnownRoots start(family.sizes(), points);
    Generator generator(run.seed);
    std::optional<PathSet> best;
    std::uint64_t fewest = 0;
    for (int attempt = 0; attempt < 3; ++attempt) {
        RunOptions of = run;
        if (attempt > 0) of.checkpoint.clear(), of.progress = nullptr;
        const auto path = CoefficientPath::between(family, complex_parameters(from), complex_parameters(to), generator);
        PathProblem problem{.start = StartPoints(start)};
        if (of.is_told_apart()) problem.model = model;
        PathSet paths = track_paths(ArcHomotopy(path, own), std::move(problem), of, options, resort);
        const std::uint64_t failed = account_for(paths).counts.failed;
        if (!best || failed < fewest) best.emplace(std::move(paths)), fewest = failed;
        if (fewest == 0 || run.cancelled_anywhere()) break;
    }
    return *std::move(best);
}

}  // namespace equilibria::detail
