/// \file
/// Families of equilibria: curves and surfaces of solutions, which an enumeration must not count as isolated roots.
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/model/sizes.hpp>
#include <equilibria/paths/root.hpp>

namespace equilibria {

/// An endpoint of paths that lies on a family, and what shows it.
template <class M>
struct FamilyPoint {
    using Vector = UnknownArray<M, std::complex<double>>;  ///< of complex unknowns

    Vector q;                     ///< complex angles, radians, then the plain coordinates
    int nullity = 0;              ///< of the Jacobian there; more than the dimension where families cross, say
    std::vector<Vector> tangent;  ///< an orthonormal basis of the Jacobian's null space, unit vectors in the unknowns
    Vector neighbour;             ///< another solution of the family, at `distance` of q
    double distance = 0;          ///< largest change of an unknown, radians (of coordinates: against 1 + |x|)
    double residual = 0;          ///< of the neighbour: max_i |F_i| / (largest term of F_i)
    double condition = 0;         ///< of the Jacobian at the endpoint, as of a Root
    std::uint64_t path = 0;       ///< the first path that ended here
    std::int32_t paths = 1;       ///< how many did; 0: found on a generic plane
};

/// A family of solutions. Points are of one family where a walk on it leads from one to the other: what no walk
/// connected may be one family all the same, so that the number of families is an upper bound.
template <class M>
struct Family {
    int dimension = 0;  ///< complex dimension: 1 a curve, 2 a surface
    int degree = 0;     ///< in how many points generic hyperplanes meet it, `dimension` of them; 0: not counted
    std::optional<UnknownArray<M, double>>
        real_point;                      ///< a real point with real neighbours in as many directions, if one was found
    std::vector<FamilyPoint<M>> points;  ///< the endpoints on it, by path

    /// Real equilibria form a family of the same (real) dimension.
    bool real() const { return real_point.has_value(); }
    /// How many paths ended on it.
    std::uint64_t paths() const {
        std::uint64_t sum = 0;
        for (const auto& point : points) sum += static_cast<std::uint64_t>(point.paths);
        return sum;
    }
};

/// In the unknowns of a model, which are as many.
template <class M>
[[gnu::cold]] Family<M> typed(const Family<RuntimeUnknowns>& family) {
    Family<M> y{family.dimension, family.degree, std::nullopt, std::vector<FamilyPoint<M>>(family.points.size())};
    if (family.real_point) y.real_point = unknowns_from<M>(*family.real_point);
    for (std::size_t k = 0; k < y.points.size(); ++k) {
        const auto& from = family.points[k];
        auto& to = y.points[k];
        to.q = unknowns_from<M>(from.q);
        to.nullity = from.nullity;
        to.tangent.resize(from.tangent.size());
        for (std::size_t i = 0; i < to.tangent.size(); ++i) to.tangent[i] = unknowns_from<M>(from.tangent[i]);
        to.neighbour = unknowns_from<M>(from.neighbour);
        to.distance = from.distance;
        to.residual = from.residual;
        to.condition = from.condition;
        to.path = from.path;
        to.paths = from.paths;
    }
    return y;
}

/// "curve", "surface", "3-dimensional family".
std::string family_kind(int dimension);

namespace detail {
struct FamilySummary {
    int dimension;
    bool real;
    std::uint64_t paths;
};
std::string summary(const std::vector<FamilySummary>& families);
}  // namespace detail

/// "a real curve of solutions (18 paths)"; many families of a kind are counted.
template <class M>
std::string summary(const std::vector<Family<M>>& families) {
    std::vector<detail::FamilySummary> all;
    for (const auto& family : families) all.push_back({family.dimension, family.real(), family.paths()});
    return detail::summary(all);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/family_definitions.hpp>
#endif
