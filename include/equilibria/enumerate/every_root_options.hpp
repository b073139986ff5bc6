/// \file
/// How every_root searches, and paths that it explained by a root at infinity: see enumerate/every_root.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include <equilibria/certify/proved_bound.hpp>
#include <equilibria/homotopy/tracker_options.hpp>

namespace equilibria {

/// Paths that leave in one direction, each to a root of that face system.
struct DivergingPaths {
    std::vector<double> direction;  ///< growth of log |x_u|, or of the imaginary part of -theta_u, against -log(1 - t)
    std::uint64_t paths = 0;        ///< how many
    double residual = 0;            ///< the largest of the face systems at their roots, against the size of their terms
};

/// How every_root searches.
struct EveryRootOptions {
    TrackerOptions tracker{};              ///< of all paths in double
    std::uint64_t most_explained = 20000;  ///< paths above which none is explained one by one
    int seeds = 3;                         ///< starts that are tried before something is left open
    /// Bounds that hold as theorems, of the system that this one is the rounding of; none: those of this system.
    std::vector<ProvedBound> bounds{};
};

}  // namespace equilibria
