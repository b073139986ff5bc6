/// \file
/// See paths/generic_instance.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>

#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/homotopy/lane_tracker.hpp>
#include <equilibria/homotopy/polish.hpp>
#include <equilibria/homotopy/polyhedral_homotopy.hpp>
#include <equilibria/paths/detail/coincidence_finder.hpp>
#include <equilibria/paths/generic_instance.hpp>
#include <equilibria/paths/over_ranks.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/start/polyhedral_start.hpp>
#include <equilibria/system/laurent_terms.hpp>

namespace equilibria {

namespace detail {

/// The paths of a polyhedral homotopy. Each ends at a regular root, and no two at the same: what does not was not
/// tracked well, and is tracked again.
class PolyhedralPaths {
public:
    PolyhedralPaths(const PolyhedralStart& start, const RunOptions& run, const TrackerOptions& options)
        : start_(start), homotopy_(start), polisher_(homotopy_), run_(run), options_(options),
          ends_(start.numbering().total()) {}

    /// Whether it came to an end: a cancelled run does not.
    bool track() {
        std::vector<std::uint64_t> open(ends_.size());
        std::iota(open.begin(), open.end(), std::uint64_t{0});
        TrackerOptions options = options_;
        for (int round = 0; round < 5 && !open.empty(); ++round) {
            track(open, options);
            if (run_.cancelled_anywhere()) return false;
            options = round == 0 ? options : options.tightened();
            options.single_precision = false;
            open = unfinished();
            retracked += open.size();
        }
        return true;
    }

    std::vector<Endpoint>& ends() { return ends_; }
    std::uint64_t retracked = 0, crossed = 0;

private:
    using Pack = Lanes<native_lanes>;

    void track(const std::vector<std::uint64_t>& paths, const TrackerOptions& options) {
        const std::size_t workers = run_.executor.workers();
        const std::size_t block =
            run_.ranks.several()
                ? shared_block(paths.size())
                : std::clamp<std::size_t>(paths.size() / (8 * workers), 8 * native_lanes, workers == 1 ? 4096 : 512);
        std::vector<Endpoint> tracked(paths.size());
        compute_endpoints(run_, homotopy_.sizes(), tracked, block, [&](std::size_t first, std::size_t last) {
            if (!run_.ranks.several() && run_.cancelled()) return;
            const std::span numbers(paths.data() + first, last - first);
            const auto ends = std::span(tracked).subspan(first, last - first);
            const auto from = [this](std::uint64_t path) { return start_.point(path); };
            if (options.single_precision && paths.size() >= 3 * native_lanes)
                track_single_first(homotopy_, homotopy_, options, numbers, from, ends);
            else
                track_lanes<Pack, false>(homotopy_, options, numbers, from, ends);
            polish(ends);
        });
        for (std::size_t k = 0; k < paths.size(); ++k) {
            tracked[k].steps += ends_[paths[k]].steps;
            ends_[paths[k]] = std::move(tracked[k]);
        }
    }
    void polish(std::span<Endpoint> ends) const {
        typename Polisher<PolyhedralHomotopy>::template Workspace<Pack> with(homotopy_);
        auto q = point_of_zeros<RuntimeUnknowns, Pack>(homotopy_.sizes());
        for (std::size_t first = 0; first < ends.size(); first += native_lanes) {
            const std::size_t filled = std::min<std::size_t>(ends.size() - first, native_lanes);
            for (std::size_t k = 0; k < native_lanes; ++k)
                copy_lane(ends[first + (k < filled ? k : 0)].q, 0, q, static_cast<int>(k));
            std::array<PolishedEvidence, native_lanes> evidence;
            polisher_.run(q, evidence.data(), with);
            for (std::size_t k = 0; k < filled; ++k) {
                Endpoint& end = ends[first + k];
                end.evidence = evidence[k];
                if (end.arrival != Arrival::end || !(end.evidence.correction < 1e-8) ||
                    !(end.evidence.condition < 1e12))
                    continue;
                copy_lane(q, static_cast<int>(k), end.q, 0);
                end.status = PathStatus::finite;
            }
        }
    }
    /// The paths that have not arrived, and those that have arrived at another's root.
    std::vector<std::uint64_t> unfinished() {
        const auto groups =
            CoincidenceFinder(false, homotopy_.sizes())
                .groups(
                    ends_.size(),
                    [this](std::size_t k) {
                        return ends_[k].status == PathStatus::finite ? PointView(ends_[k].q) : PointView();
                    },
                    1e-9);
        for (const auto& group : groups)
            for (const std::size_t k : group) ends_[k].status = PathStatus::failed, ++crossed;
        std::vector<std::uint64_t> y;
        for (std::size_t k = 0; k < ends_.size(); ++k)
            if (ends_[k].status != PathStatus::finite) y.push_back(k);
        return y;
    }

    const PolyhedralStart& start_;
    PolyhedralHomotopy homotopy_;
    Polisher<PolyhedralHomotopy> polisher_;
    const RunOptions& run_;
    TrackerOptions options_;
    std::vector<Endpoint> ends_;
};

/// Generic coefficients near those of a system, a column of the supports each.
EQUILIBRIA_INLINE std::vector<std::complex<double>> generic_coefficients(const SparseSystem& typical,
                                                                         const Supports& supports,
                                                                         Generator& generator) {
    std::vector<std::complex<double>> y;
    const auto equations = laurent_terms(typical);
    for (std::size_t i = 0; i < equations.size(); ++i) {
        double largest = 0;
        for (const auto& term : equations[i]) largest = std::max(largest, std::abs(term.coefficient));
        for (const auto& point : supports.equations()[i]) {
            std::complex<double> c = largest;
            for (const auto& term : equations[i])
                if (term.exponents == point) c = term.coefficient;
            const double size = std::clamp(std::abs(c) / largest, 0.05, 1.0);
            y.push_back(std::polar(size * uniform(generator, 0.8, 1.25), std::arg(c) + uniform(generator, -2, 2)));
        }
    }
    return y;
}

}  // namespace detail

EQUILIBRIA_INLINE GenericInstance::GenericInstance(const SparseSystem& typical, const RunOptions& run,
                                                   const TrackerOptions& options)
    : sizes_(typical.sizes()), supports_(affine_supports(typical)) {
    options.validate();
    run.require_no_checkpoint();
    const detail::Stopwatch clock;
    Generator generator(run.seed);
    coefficients_ = detail::generic_coefficients(typical, supports_, generator);
    const PolyhedralStart start(supports_, coefficients_, generator, 4,
                                {.executor = run.executor, .cancel = run.ranks.several() ? nullptr : run.cancel});
    mixed_volume_ = start.numbering().total();
    for (int i = 0; i < sizes_.unknowns; ++i)
        for (int k = supports_.first_column(i); k < supports_.first_column(i + 1); ++k)
            coefficients_[static_cast<std::size_t>(k)] *= typical.scale()[static_cast<std::size_t>(i)];
    effort_.cells = start.cells();
    effort_.weight_ratio = start.weight_ratio();
    effort_.cells_seconds = clock.seconds();
    detail::PolyhedralPaths paths(start, run, options);
    cancelled_ = start.cancelled() || !paths.track();
    for (const Endpoint& end : paths.ends()) {
        effort_.steps += static_cast<std::uint64_t>(end.steps);
        effort_.in_double += end.precision == Precision::in_double;
        if (end.status != PathStatus::finite) continue;
        roots_.push_back(root_of(end.q, end, 0).q);
        for (int u = sizes_.angles; u < sizes_.unknowns; ++u) {
            auto& x = roots_.back()[u];
            x = std::exp(std::complex<double>(0, 1) * x);
        }
    }
    effort_.retracked = paths.retracked;
    effort_.crossed = paths.crossed;
    effort_.tracking_seconds = clock.seconds() - effort_.cells_seconds;
}

EQUILIBRIA_INLINE std::vector<LaurentColumn> GenericInstance::columns(const SparseSystem& target) const {
    require(target.sizes().angles == sizes_.angles && target.sizes().coordinates == sizes_.coordinates, "target",
            target.sizes().unknowns, "must have the unknowns of the typical system");
    std::vector<LaurentColumn> columns;
    const auto equations = laurent_terms(target);
    for (int i = 0; i < sizes_.unknowns; ++i) {
        const auto at = static_cast<std::size_t>(i);
        std::size_t found = 0;
        const auto& support = supports_.equations()[at];
        for (std::size_t k = 0; k < support.size(); ++k) {
            LaurentColumn column{i, support[k], coefficients_[static_cast<std::size_t>(supports_.first_column(i)) + k],
                                 0};
            for (const auto& term : equations[at])
                if (term.exponents == support[k]) column.to = term.coefficient, ++found;
            columns.push_back(std::move(column));
        }
        require(found == equations[at].size(), "target", "equation " + std::to_string(i + 1),
                "must have no other exponents than the typical system");
    }
    return columns;
}

EQUILIBRIA_INLINE PolynomialHomotopy GenericInstance::homotopy(const SparseSystem& target,
                                                               std::shared_ptr<const OwnEquations> own) const {
    struct Column {
        SparseTerm term;
        std::complex<double> from, to;
    };
    std::vector<Column> ordered;
    for (LaurentColumn& column : columns(target))
        ordered.push_back({{column.equation, SparseMonomial(std::move(column.exponents)), 0}, column.from, column.to});
    std::sort(ordered.begin(), ordered.end(), [](const Column& a, const Column& b) { return before(a.term, b.term); });
    PolynomialHomotopy::Parts parts{
        .sizes = sizes_, .terms = {}, .from = {}, .forms = {}, .scale = target.scale(), .own = std::move(own)};
    for (Column& column : ordered) {
        parts.terms.push_back(std::move(column.term));
        parts.from.push_back(column.from);
        parts.laurent.push_back(column.to);
    }
    return PolynomialHomotopy(std::move(parts));
}

EQUILIBRIA_INLINE ComplexRoots<> GenericInstance::solve(const SparseSystem& target, const RunOptions& run,
                                                        const TrackerOptions& options, MoreDigits<> resort) const {
    options.validate();
    ComplexRoots<> y = complex_roots(homotopy(target), Start(*this), run, options, resort);
    add_unsolved_to(y.paths);
    return y;
}

EQUILIBRIA_INLINE ComplexRoots<> solve_polyhedral(const SparseSystem& system, const RunOptions& run,
                                                  const TrackerOptions& options, MoreDigits<> resort) {
    return GenericInstance(system, run, options).solve(system, run, options, resort);
}

}  // namespace equilibria
