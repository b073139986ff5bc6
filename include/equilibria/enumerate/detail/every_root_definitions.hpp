/// \file
/// See enumerate/every_root.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <utility>

#include <equilibria/enumerate/detail/explained_paths.hpp>
#include <equilibria/enumerate/detail/root_attempt.hpp>
#include <equilibria/enumerate/every_root.hpp>
#include <equilibria/enumerate/families.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/enumerate/named_families.hpp>
#include <equilibria/enumerate/prove_complex_roots.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/local_multiplicity.hpp>
#include <equilibria/homotopy/path_limit.hpp>
#include <equilibria/homotopy/polish.hpp>
#include <equilibria/paths/generic_instance.hpp>
#include <equilibria/paths/track.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/system/path_bounds.hpp>
#include <equilibria/system/unit_scaling.hpp>

namespace equilibria {

namespace detail {

/// The bounds of a choice, as theorems.
EQUILIBRIA_INLINE std::vector<ProvedBound> bounds_of(const StartBounds& bounds, const SparseSystem& system) {
    std::vector<ProvedBound> y;
    if (!bounds.total_degree.saturated)
        y.push_back({static_cast<std::uint64_t>(bounds.total_degree.value), "total degree", "Bezout's", true});
    if (!bounds.multihomogeneous.saturated && bounds.multihomogeneous < bounds.total_degree)
        y.push_back(
            {static_cast<std::uint64_t>(bounds.multihomogeneous.value), "multihomogeneous Bezout number", "Bezout's"});
    if (bounds.mixed_volume)
        y.push_back(
            {*bounds.mixed_volume, system.sizes().angles > 0 ? "Laurent mixed volume" : "mixed volume", "Bernstein's"});
    return y;
}
EQUILIBRIA_INLINE std::optional<ProvedBound> smallest(const std::vector<ProvedBound>& bounds) {
    const auto at = std::ranges::min_element(bounds, {}, &ProvedBound::value);
    return at == bounds.end() ? std::nullopt : std::optional(*at);
}

/// What the start of a choice finds, its paths not explained.
EQUILIBRIA_INLINE RootAttempt plain_attempt(const SparseSystem& system, const StartChoice& choice,
                                            const std::vector<ProvedBound>& bounds, const RunOptions& run,
                                            const EveryRootOptions& options, MoreDigits<> resort) {
    RootAttempt y;
    const Stopwatch clock;
    y.found = solve_from_start(system, choice, run, options.tracker, resort);
    y.tracking_seconds = clock.seconds();
    y.proof = prove_and_refine(system, y.found, bounds, run);
    y.confirmed.assign(y.found.roots.size(), 0);
    const PathCounts& c = y.found.paths;
    y.unexplained = c.total - std::min(c.total, y.proof.distinct);
    const auto leave = [&y](std::uint64_t number, const char* how) {
        if (number > 0) y.left += (y.left.empty() ? "" : ", ") + std::to_string(number) + " paths " + how;
    };
    leave(c.at_infinity, "diverge");
    leave(c.singular, "end at singular points");
    leave(c.failed, "failed");
    leave(c.cancelled, "were not followed to their ends, since the run was stopped");
    return y;
}

EQUILIBRIA_INLINE RootsVerdict verdict_of(const RootAttempt& y, const std::vector<ProvedBound>& bounds,
                                          bool polyhedral) {
    const auto count = [](std::uint64_t k) { return std::to_string(k); };
    const auto bound = smallest(bounds);
    const std::uint64_t counted = y.counted(), multiple = counted - y.proof.distinct;
    RootsVerdict v;
    static_assert(LocalMultiplicity::zero == 1e-100, "the sentence says so");
    const std::string roots =
        count(y.proof.distinct) + " regular roots are proved" +
        (multiple > 0 ? ", " + count(multiple) + " more are counted in multiple roots (to " +
                            count(LocalMultiplicity::digits) + " digits; values below 1e-100 count as 0)"
                      : "");
    if (bound && counted == bound->value) {
        v.completeness = Completeness::complete;
        v.missing_at_most = 0;
        v.sentence =
            roots + ": as many as the " + bound->name + " " + count(bound->value) + " allows, " + bound->no_other();
        return v;
    }
    if (polyhedral && y.unexplained == 0) {
        v.completeness = Completeness::explained;
        v.missing_at_most = 0;
        v.sentence = roots;
        std::uint64_t away = 0, on_curves = 0;
        for (const auto& d : y.at_infinity) away += d.paths;
        for (const auto& f : y.families) on_curves += f.paths();
        if (away > 0) v.sentence += "; face systems explain " + count(away) + " paths to infinity";
        if (on_curves > 0) v.sentence += "; " + count(on_curves) + " paths end on curves or surfaces of solutions";
        v.sentence += "; with them all " + count(y.found.paths.total) + " paths are accounted for";
        return v;
    }
    if (bound) v.missing_at_most = bound->value - std::min(bound->value, counted);
    v.sentence = roots + (bound ? ", and the " + bound->name + " " + count(bound->value) + " allows more" : "") +
                 (y.left.empty() ? "" : "; not explained: " + y.left);
    return v;
}

EQUILIBRIA_INLINE void undo(const UnitScaling& units, EveryRoot& y) {
    if (units.trivial()) return;
    // roots that no double can hold in the system's own units
    std::uint64_t too_large = 0;
    for (std::size_t k = y.found.roots.size(); k-- > 0;) {
        auto q = y.found.roots[k].q;
        units.undo({q.begin(), q.end()});
        if (std::ranges::all_of(q, [](const auto& z) { return std::isfinite(z.real()) && std::isfinite(z.imag()); }))
            continue;
        ++too_large;
        const auto at = static_cast<std::ptrdiff_t>(k);
        y.found.roots.erase(y.found.roots.begin() + at);
        y.confirmed.erase(y.confirmed.begin() + at);
        y.seems_real.erase(y.seems_real.begin() + at);
        y.proof.forget(k);
    }
    if (too_large > 0) {
        y.verdict = {Completeness::open, too_large,
                     std::to_string(too_large) + " roots are too large for double precision, and not shown"};
    }
    const auto back = [&](auto& q) { units.undo({q.begin(), q.end()}); };
    for (auto& root : y.found.roots) back(root.q);
    for (auto& failed : y.found.failures) back(failed.q);
    for (auto& family : y.families) {
        if (family.real_point)
            for (int u = 0; u < family.real_point->size(); ++u)
                (*family.real_point)[u] =
                    std::ldexp((*family.real_point)[u], units.unknown[static_cast<std::size_t>(u)]);
        for (auto& point : family.points) {
            back(point.q);
            back(point.neighbour);
            for (auto& t : point.tangent) back(t);
        }
    }
    const double largest = std::ldexp(1.0, *std::ranges::max_element(units.unknown));
    for (auto& c : y.proof.certificates) c.radius *= largest;
}

/// Names the curves on which singular ends lie, and leaves no root among those that lies on one.
EQUILIBRIA_INLINE void find_all_families(const SparseSystem& system, const RunOptions& run,
                                         const EveryRootOptions& options, RootAttempt& y) {
    std::vector<Root<RuntimeUnknowns>> suspects;
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < y.found.roots.size(); ++k)
        if (y.found.roots[k].status == PathStatus::singular && !y.confirmed[k]) {
            suspects.push_back(y.found.roots[k]);
            numbers.push_back(k);
        }
    const std::size_t roots = suspects.size();
    for (const auto& family : y.families)
        for (const auto& point : family.points) {
            Root<RuntimeUnknowns> root;
            root.q = point.q;
            root.paths = point.paths;
            root.path = point.path;
            root.condition = point.condition;
            root.status = PathStatus::singular;
            suspects.push_back(std::move(root));
        }
    auto found = name_families(system, suspects, run, options.tracker, options.most_explained);
    y.families = std::move(found.families);
    for (std::size_t m = roots; m-- > 0;)
        if (found.on_one[m]) y.leave_out(numbers[m]);
}

/// Leaves out the roots that are not proved, where a theorem says that there is no further isolated one.
EQUILIBRIA_INLINE void leave_out_unproved(RootAttempt& y, RootsVerdict& verdict) {
    std::uint64_t paths = 0;
    for (std::size_t k = y.found.roots.size(); k-- > 0;) {
        if (y.confirmed[k] || k >= y.proof.certificates.size() || y.proof.certificates[k].exists) continue;
        paths += static_cast<std::uint64_t>(y.found.roots[k].paths);
        y.leave_out(k);
    }
    if (paths > 0) verdict.sentence += no_further_roots(paths);
}

}  // namespace detail

EQUILIBRIA_INLINE std::uint64_t EveryRoot::distinct() const {
    std::uint64_t y = proof.distinct;
    for (const char c : confirmed) y += c != 0;
    return y;
}

EQUILIBRIA_INLINE std::vector<char> seem_real(std::span<const Root<RuntimeUnknowns>> roots, int angles) {
    std::vector<char> y;
    for (std::size_t k = 0; k < roots.size(); ++k)
        y.push_back(is_real(roots[k]) && !conjugate_is_another(roots, k, angles));
    return y;
}

EQUILIBRIA_INLINE EveryRoot every_root(const SparseSystem& system, const StartChoice& choice, const RunOptions& run,
                                       const EveryRootOptions& options) {
    options.tracker.validate();
    run.require_no_checkpoint();
    const detail::Stopwatch clock;
    const UnitScaling units = unit_scaling(system);
    const SparseSystem in_units = scaled(system, units);
    const auto bounds = options.bounds.empty() ? detail::bounds_of(choice.bounds, system) : options.bounds;
    const bool may_explain = choice.kind != StartKind::monodromy && choice.bounds.mixed_volume.has_value() &&
                             *choice.bounds.mixed_volume <= 4 * options.most_explained;
    EveryRoot y;
    if (run.cancelled_anywhere()) {
        y.start = choice;
        const auto bound = detail::smallest(bounds);
        y.found.paths.total = y.found.paths.cancelled = bound ? bound->value : 1;
        y.verdict.missing_at_most = bound ? std::optional(bound->value) : std::nullopt;
        y.proof.reason = y.verdict.sentence = "the run was stopped before a path was followed";
        return y;
    }
    std::optional<detail::RootAttempt> best;
    RootsVerdict verdict;
    double tracking = 0;
    const auto take = [&](detail::RootAttempt attempt, bool polyhedral) {
        tracking += attempt.tracking_seconds;
        RootsVerdict of = detail::verdict_of(attempt, bounds, polyhedral);
        const bool better =
            !best || of.completeness < verdict.completeness ||
            (of.completeness == verdict.completeness && attempt.counted() > best->counted()) ||
            (polyhedral && of.completeness == verdict.completeness && attempt.counted() == best->counted());
        if (better) best.emplace(std::move(attempt)), verdict = std::move(of);
    };
    const bool has_no_paths = choice.bounds.mixed_volume && *choice.bounds.mixed_volume == 0;
    if (choice.kind != StartKind::polyhedral || !may_explain || has_no_paths) {
        const auto resort = may_explain ? &detail::track_with_more_digits_but_ends : more_digits;
        take(detail::plain_attempt(in_units, choice, bounds, run, options, resort), false);
        best->start = choice;
    }
    std::string left_before;
    const bool stopped_first = best && run.cancelled_anywhere();
    for (int k = 0; k < options.seeds && may_explain && !stopped_first && verdict.completeness == Completeness::open;
         ++k) {
        if (has_no_paths || (best && best->hidden > 0 && best->hidden == best->unexplained)) break;
        const RunOptions again = run.with_seed(run.seed + 0x9e3779b97f4a7c15 * static_cast<std::uint64_t>(k));
        auto attempt = detail::ExplainedPaths(in_units, bounds, again, options).run();
        // what another seed leaves open for the same reasons, the next one does as well
        const bool as_before = k > 0 && attempt.unexplained > 0 && attempt.left == left_before;
        left_before = attempt.left;
        attempt.start = {
            StartKind::polyhedral,
            choice.kind == StartKind::polyhedral && k == 0 ? choice.why : "other starts left something open",
            choice.bounds};
        take(std::move(attempt), true);
        y.starts += best && (k > 0 || choice.kind != StartKind::polyhedral);
        if (as_before || run.cancelled_anywhere()) break;
    }
    if (verdict.completeness == Completeness::complete) {
        // what did not end at a root goes to infinity, since all roots are proved
        PathCounts& c = best->found.paths;
        const std::uint64_t known = c.finite + c.singular;
        if (best->families.empty() && c.failed > 0 && c.total >= known) {
            c.at_infinity += c.failed, c.failed = 0;
            best->found.failures.clear();
        }
    }
    if (verdict.completeness != Completeness::complete || has_no_paths)
        if (choice.kind != StartKind::monodromy && !run.cancelled_anywhere())
            detail::find_all_families(in_units, run, options, *best);
    if (verdict.completeness == Completeness::complete) detail::leave_out_unproved(*best, verdict);
    if (run.cancelled_anywhere() && verdict.completeness == Completeness::open) {
        for (auto& family : best->families) family.degree = 0;  // not all slices were followed
        if (best->found.paths.cancelled == 0) verdict.sentence += "; the run was stopped before more was tried";
    }
    y.start = std::move(best->start);
    y.found = std::move(best->found);
    y.confirmed = std::move(best->confirmed);
    y.proof = std::move(best->proof);
    y.families = std::move(best->families);
    y.at_infinity = std::move(best->at_infinity);
    y.verdict = std::move(verdict);
    y.seems_real = seem_real(y.found.roots, system.sizes().angles);
    detail::undo(units, y);
    y.proof.complete = y.verdict.completeness == Completeness::complete;
    y.proof.reason = y.verdict.sentence;
    y.tracking_seconds = tracking;
    y.seconds = clock.seconds();
    return y;
}

}  // namespace equilibria
