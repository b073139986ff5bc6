/// \file
/// Where paths ended: a root, or a point on a path that failed.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <equilibria/core/huge_pages.hpp>
#include <equilibria/homotopy/path_status.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// A solution of a system of equations, real or not. M: the model, or the unknowns of the system.
template <class M>
struct Root {
    /// Angles in radians, real parts in (-pi, pi], imaginary parts any; then the plain coordinates.
    UnknownArray<M, std::complex<double>> q;
    /// max_i |F_i| / (largest coefficient of F_i), F being the model's own function, before the last correction
    double residual = 0;
    double condition = 0;             ///< of the Jacobian: equations against their terms, coordinates against 1 + |x|
    std::uint64_t path = 0;           ///< the first path that ended here
    std::int32_t paths = 1;           ///< how many did: the multiplicity of an isolated root
    std::int32_t winding_number = 1;  ///< turns around t = 1 after which the path closes; 1 of a regular root
    PathStatus status = PathStatus::finite;  ///< finite (regular) or singular
};

/// Of a singular root that one path ended at, without winding around it: it may be a regular one whose condition is
/// large.
template <class M>
bool may_be_regular(const Root<M>& root) {
    return root.status == PathStatus::finite || (root.paths == 1 && root.winding_number == 1);
}

/// A path that failed, why, and where it was last.
template <class M>
struct FailedPath {
    std::uint64_t path = 0;                      ///< its number
    FailureReason reason = FailureReason::none;  ///< why it failed
    UnknownArray<M, std::complex<double>> q;     ///< as of a Root; far out on paths that were on their way to infinity
};

namespace detail {

/// A root where it is, whatever the type of its unknowns.
struct RootView {
    std::span<const std::complex<double>> q;
    double condition;
    bool singular;
};
template <class M>
RootView view(const Root<M>& root) {
    return {{root.q.begin(), root.q.end()}, root.condition, root.status == PathStatus::singular};
}

}  // namespace detail

/// In the unknowns of a model, which are as many.
/// \{
template <class M>
Root<M> typed(const Root<RuntimeUnknowns>& root) {
    const auto& [q, residual, condition, path, paths, winding_number, status] = root;
    return {unknowns_from<M>(q), residual, condition, path, paths, winding_number, status};
}
template <class M>
FailedPath<M> typed(const FailedPath<RuntimeUnknowns>& failed) {
    return {failed.path, failed.reason, unknowns_from<M>(failed.q)};
}
/// \}
/// All of these, each let go when it has been taken over.
template <class M, template <class> class Thing>
std::vector<Thing<M>> typed(std::vector<Thing<RuntimeUnknowns>>&& things) {
    std::vector<Thing<M>> y;
    y.reserve(things.size());
    prefer_huge_pages(y.data(), y.capacity() * sizeof(y[0]));
    for (auto& given : things) {
        const Thing<RuntimeUnknowns> thing = std::move(given);
        y.push_back(typed<M>(thing));
    }
    return y;
}

}  // namespace equilibria
