/// \file
/// See paths/path_set.hpp.
#pragma once

#include <algorithm>
#include <numbers>
#include <utility>

#include <equilibria/evaluation/angles.hpp>
#include <equilibria/paths/path_set.hpp>
#include <equilibria/storage/endpoint_store.hpp>

namespace equilibria {

EQUILIBRIA_INLINE PathSet::PathSet(PathNumbering numbering, detail::EndpointStore ends, std::vector<Endpoint> resting)
    : ends_(std::make_unique<detail::EndpointStore>(std::move(ends))), resting_(std::move(resting)),
      numbering_(std::move(numbering)) {}
EQUILIBRIA_INLINE PathSet::PathSet(PathSet&&) noexcept = default;
EQUILIBRIA_INLINE PathSet& PathSet::operator=(PathSet&&) noexcept = default;
EQUILIBRIA_INLINE PathSet::~PathSet() = default;

EQUILIBRIA_INLINE const RuntimeSizes& PathSet::sizes() const { return ends_->sizes(); }
EQUILIBRIA_INLINE std::size_t PathSet::tracked() const { return static_cast<std::size_t>(ends_->size()); }
EQUILIBRIA_INLINE const Endpoint& PathSet::operator[](std::size_t k) {
    return k < tracked() ? (*ends_)[k] : resting_[k - tracked()];
}
EQUILIBRIA_INLINE EndpointRecord PathSet::record(std::size_t k) {
    return k < tracked() ? ends_->record(k) : EndpointRecord(resting_[k - tracked()]);
}
EQUILIBRIA_INLINE PointView PathSet::point(std::size_t k) {
    return k < tracked() ? ends_->point(k) : PointView(resting_[k - tracked()].q);
}
EQUILIBRIA_INLINE bool PathSet::finished(std::size_t k) const { return k >= tracked() || ends_->finished(k); }

namespace detail {
EQUILIBRIA_INLINE Root<RuntimeUnknowns> root_without_angles(const PointView& at, const EndpointRecord& end,
                                                            std::uint64_t path) {
    Root<RuntimeUnknowns> root;
    const auto angles = static_cast<int>(at.c.size());
    root.q.resize(angles + static_cast<int>(at.x.size()));
    std::transform(at.x.begin(), at.x.end(), root.q.begin() + angles,
                   [](const Complex<double>& x) { return std::complex<double>(x.re, x.im); });
    root.residual = end.evidence.residual;
    root.condition = end.evidence.condition;
    root.path = path;
    root.winding_number = end.winding_number;
    root.status = end.status;
    return root;
}
}  // namespace detail

EQUILIBRIA_INLINE Root<RuntimeUnknowns> root_of(const PointView& at, const EndpointRecord& end, std::uint64_t path) {
    auto root = detail::root_without_angles(at, end, path);
    for (std::size_t i = 0; i < at.c.size(); ++i) {
        const Complex<double> angle = angle_of(at.c[i], at.s[i]);
        root.q[static_cast<int>(i)] = {angle.re, angle.im};
    }
    return root;
}

namespace detail {

EQUILIBRIA_INLINE Root<RuntimeUnknowns> reflected(Root<RuntimeUnknowns> root, std::uint64_t path) {
    for (auto& q : root.q) {
        const double angle = -q.real();
        q = {angle <= -std::numbers::pi ? std::numbers::pi : angle, -q.imag()};
    }
    root.path = path;
    return root;
}

}  // namespace detail

EQUILIBRIA_INLINE PathAccount account_for(PathSet& paths) {
    PathAccount y;
    PathCounts& counts = y.counts;
    counts.retracked = paths.effort.retracked;
    counts.crossed = paths.effort.crossed;
    counts.more_digits = paths.effort.more_digits;
    counts.tracked = paths.ends().finished();
    for (std::size_t k = 0; k < paths.size(); ++k) {
        const std::uint64_t weight = paths.weight(k);
        counts.total += weight;
        if (!paths.finished(k)) {
            counts.cancelled += weight;
            continue;
        }
        const EndpointRecord end = paths.record(k);
        counts.in_double += end.precision == Precision::in_double;
        counts.steps += static_cast<std::uint64_t>(end.steps);
        switch (end.status) {
            case PathStatus::finite: counts.finite += weight; break;
            case PathStatus::at_infinity: counts.at_infinity += weight; break;
            case PathStatus::singular: counts.singular += weight; break;
            case PathStatus::failed: {
                counts.failed += weight;
                const auto at = root_of(paths.point(k), end, paths.path(k));
                y.failures.push_back({at.path, end.reason, at.q});
                if (weight == 2) {
                    const auto image = detail::reflected(at, paths.mirror(at.path));
                    y.failures.push_back({image.path, end.reason, image.q});
                }
            }
        }
    }
    std::sort(y.failures.begin(), y.failures.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return y;
}

}  // namespace equilibria
