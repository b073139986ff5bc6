/// \file
/// The paths of a total-degree start: H = (1-t) G + t F, with gamma in G.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/start/path_numbering.hpp>
#include <equilibria/start/total_degree_system.hpp>

namespace equilibria {

/// Of the general kind, each path is tracked; of the reflected one, one path of a mirror pair is, and the 2^n that are
/// their own mirror images rest: the target has to be odd under theta -> -theta.
class TotalDegreeStart {
public:
    static constexpr bool moving = false;  ///< the target's coefficients are t times its own

    /// See TotalDegreeSystem.
    TotalDegreeStart(TotalDegreeKind kind, const RuntimeSizes& sizes, std::span<const int> degrees,
                     std::span<const double> scale, Generator& generator);

    /// "reflected" or "total degree".
    std::string_view name() const {
        return system_.kind() == TotalDegreeKind::reflected ? "reflected" : "total degree";
    }
    const PathNumbering& numbering() const { return numbering_; }  ///< all paths, or one of each mirror pair
    /// Where the k-th tracked path begins.
    RuntimePoint<double> point(std::uint64_t k) const { return point_of(numbering_.tracked_path(k)); }
    /// The k-th solution that rests at every t.
    RuntimePoint<double> resting_point(std::uint64_t k) const { return point_of(numbering_.resting_path(k)); }
    /// The start of path number `path`, which is a number in mixed radix: digit i chooses the root of G_i.
    RuntimePoint<double> point_of(std::uint64_t path) const;
    const TotalDegreeSystem& system() const { return system_; }  ///< G and its roots

private:
    RuntimeSizes sizes_;
    TotalDegreeSystem system_;
    PathNumbering numbering_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/start/detail/total_degree_start_definitions.hpp>
#endif
