/// \file
/// Total-degree starts of a model.
#pragma once

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/start/total_degree_start.hpp>
#include <equilibria/system/model_system.hpp>

namespace equilibria {

/// From products of random lines.
template <Model M>
class TotalDegree : public TotalDegreeStart {
    static_assert(total_degree<M>() > 0);  // so many paths can be numbered

public:
    /// A start for the target's sizes of equations.
    TotalDegree(const ModelSystem<M>& target, Generator& generator)
        : TotalDegreeStart(TotalDegreeKind::general, Sizes<M>(), Formulation<M>::degrees, target.scale, generator) {}
};

/// From a start system that is odd under theta -> -theta, as the target has to be.
template <Model M>
class Reflected : public TotalDegreeStart {
    static_assert(total_degree<M>() > 0);  // so many paths can be numbered
    static_assert(Formulation<M>::reflection_symmetric,
                  "equilibria: the reflected start needs equations that are odd under theta -> -theta");

public:
    /// A start for the target's sizes of equations.
    Reflected(const ModelSystem<M>& target, Generator& generator)
        : TotalDegreeStart(TotalDegreeKind::reflected, Sizes<M>(), Formulation<M>::degrees, target.scale, generator) {}
};

namespace detail {

/// The start system that suits the model: reflected where it has the symmetry theta -> -theta (a model may decline
/// with `static constexpr bool use_reflection = false`, or insist with `true`, which is checked).
template <Model M>
constexpr bool starts_reflected() {
    if constexpr (requires { M::use_reflection; }) {
        static_assert(!M::use_reflection || Formulation<M>::reflection_symmetric,
                      "equilibria: the model declares use_reflection, but its equations are not odd under "
                      "theta -> -theta (or it has plain coordinates, with which the library does not use it)");
        return M::use_reflection;
    } else {
        return Formulation<M>::reflection_symmetric;
    }
}
template <Model M, bool Mirrored>
struct NaturalStartOf {
    using type = TotalDegree<M>;
};
template <Model M>
struct NaturalStartOf<M, true> {
    using type = Reflected<M>;
};

}  // namespace detail

/// The start that suits a model: reflected where its equations are odd under theta -> -theta, unless it declines.
template <Model M>
using NaturalStart = typename detail::NaturalStartOf<M, detail::starts_reflected<M>()>::type;

}  // namespace equilibria
