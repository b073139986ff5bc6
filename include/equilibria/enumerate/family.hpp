/// \file
/// Families of equilibria: curves and surfaces of solutions, which an enumeration must not count as isolated roots.
#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <equilibria/core/array.hpp>
#include <equilibria/model/derivatives.hpp>

namespace equilibria {

/// An endpoint of paths that lies on a family, and what shows it.
template <Model M>
struct FamilyPoint {
    using Vector = Array<std::complex<double>, n_unknowns<M>>;

    Vector q;                     ///< complex angles, radians, then the plain coordinates
    int nullity = 0;              ///< of the Jacobian there; more than the dimension where families cross, say
    std::vector<Vector> tangent;  ///< an orthonormal basis of the Jacobian's null space, unit vectors in the unknowns
    Vector neighbour;             ///< another solution of the family, at `distance` of q
    double distance = 0;          ///< largest change of an unknown, radians (of coordinates: against 1 + |x|)
    double residual = 0;          ///< of the neighbour: max_i |F_i| / (largest term of F_i)
    double condition = 0;         ///< of the Jacobian at the endpoint, as of a Root
    std::uint64_t path = 0;       ///< the first path that ended here
    std::int32_t paths = 1;       ///< how many did
};

/// A family of solutions. Points are of one family where a walk on it leads from one to the other: what no walk
/// connected may be one family all the same, so that the number of families is an upper bound.
template <Model M>
struct Family {
    int dimension = 0;  ///< complex dimension: 1 a curve, 2 a surface
    std::optional<Unknowns<M>>
        real_point;                      ///< a real point with real neighbours in as many directions, if one was found
    std::vector<FamilyPoint<M>> points;  ///< the endpoints on it, by path

    /// Real equilibria form a family of the same (real) dimension.
    bool real() const { return real_point.has_value(); }
    std::uint64_t paths() const {
        std::uint64_t sum = 0;
        for (const auto& point : points) sum += static_cast<std::uint64_t>(point.paths);
        return sum;
    }
};

/// "curve", "surface", "3-dimensional family".
inline std::string family_kind(int dimension) {
    if (dimension == 1) return "curve";
    if (dimension == 2) return "surface";
    return std::to_string(dimension) + "-dimensional family";
}

/// "a real curve of solutions (18 paths)"; many families of a kind are counted.
template <Model M>
std::string summary(const std::vector<Family<M>>& families) {
    std::string all;
    std::vector<bool> told(families.size());
    for (std::size_t k = 0; k < families.size(); ++k) {
        if (told[k]) continue;
        std::uint64_t alike = 0, paths = 0;
        for (std::size_t m = k; m < families.size(); ++m)
            if (families[m].dimension == families[k].dimension && families[m].real() == families[k].real()) {
                told[m] = true;
                ++alike;
                paths += families[m].paths();
            }
        const std::string kind = (families[k].real() ? "real " : "") + family_kind(families[k].dimension);
        all += (all.empty() ? "" : ", ") +
               (alike == 1 ? "a " + kind : "at most " + std::to_string(alike) + " times a " + kind) +
               " of solutions (" + std::to_string(paths) + " paths)";
    }
    return all;
}

}  // namespace equilibria
