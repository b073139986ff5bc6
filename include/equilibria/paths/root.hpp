/// \file
/// Where paths ended: a root, or a point on a path that failed.
#pragma once

#include <complex>
#include <cstdint>

#include <equilibria/core/array.hpp>
#include <equilibria/homotopy/path_status.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// A solution of a system of equations, real or not. M: the model or the unknowns of the system.
template <class M>
struct Root {
    /// Angles in radians, real parts in (-pi, pi], imaginary parts any; then the plain coordinates.
    Array<std::complex<double>, n_unknowns<M>> q;
    double residual = 0;     ///< max_i |F_i(q)| / (largest coefficient of F_i), F being the model's own function
    double condition = 0;    ///< of the Jacobian: equations against their terms, coordinates against 1 + |x|
    std::uint64_t path = 0;  ///< the first path that ended here
    std::int32_t paths = 1;  ///< how many did: the multiplicity of an isolated root
    std::int32_t winding_number = 1;
    PathStatus status = PathStatus::finite;  ///< finite (regular) or singular
};

/// A path that failed, why, and where it was last.
template <class M>
struct FailedPath {
    std::uint64_t path = 0;
    FailureReason reason = FailureReason::none;
    Array<std::complex<double>, n_unknowns<M>>
        q;  ///< as of a Root; far out on paths that were on their way to infinity
};

}  // namespace equilibria
