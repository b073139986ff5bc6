/// \file
/// Total-degree starts of a model: H = (1-t) G + t F, with gamma in G.
#pragma once

#include <complex>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/start/path_numbering.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/start/total_degree_system.hpp>
#include <equilibria/system/model_system.hpp>

namespace equilibria {

namespace detail {

/// What both total-degree starts have in common.
template <Model M, TotalDegreeKind Kind>
class TotalDegreeStart {
public:
    static constexpr bool moving = false;

    /// A start for the target's sizes of equations.
    TotalDegreeStart(const ModelSystem<M>& target, Generator& generator)
        : system_(Kind, Sizes<M>(), Formulation<M>::degrees, target.scale, generator) {}

    /// The start of path number `path`, which is a number in mixed radix: digit i chooses the root of G_i.
    Point<M, double> point_of(std::uint64_t path) const {
        Point<M, double> q;
        for (int i = 0; i < n_unknowns<M>; ++i) {
            const auto size = static_cast<std::uint64_t>(radix(i));
            const StartCoordinate& at = system_.points(i)[path % size];
            path /= size;
            if (i < n_angles<M>) {
                set_lane(q.c[i], 0, at.c);
                set_lane(q.s[i], 0, at.s);
            } else {
                set_lane(q.x[i - n_angles<M>], 0, at.c);
            }
        }
        return q;
    }
    const TotalDegreeSystem& system() const { return system_; }

protected:
    std::size_t radix(int i) const { return system_.points(i).size(); }

private:
    TotalDegreeSystem system_;
};

}  // namespace detail

/// From products of random lines.
template <Model M>
class TotalDegree : public detail::TotalDegreeStart<M, TotalDegreeKind::general> {
public:
    static constexpr std::string_view name() { return "total degree"; }
    using detail::TotalDegreeStart<M, TotalDegreeKind::general>::TotalDegreeStart;

    PathNumbering numbering() const { return PathNumbering::all(static_cast<std::uint64_t>(total_degree<M>())); }
    Point<M, double> point(std::uint64_t k) const { return this->point_of(k); }
};

/// From a start system that is odd under theta -> -theta, as the target has to be: one path of a mirror pair is
/// tracked, and the 2^n that are their own mirror images rest.
template <Model M>
class Reflected : public detail::TotalDegreeStart<M, TotalDegreeKind::reflected> {
    static_assert(Formulation<M>::reflection_symmetric,
                  "equilibria: the reflected start needs equations that are odd under theta -> -theta");

public:
    static constexpr std::string_view name() { return "reflected"; }
    Reflected(const ModelSystem<M>& target, Generator& generator)
        : detail::TotalDegreeStart<M, TotalDegreeKind::reflected>(target, generator) {
        std::vector<std::uint64_t> radices;
        for (int i = 0; i < n_unknowns<M>; ++i) radices.push_back(this->radix(i));
        numbering_ = PathNumbering::mirrored(std::move(radices));
    }

    const PathNumbering& numbering() const { return numbering_; }
    Point<M, double> point(std::uint64_t k) const { return this->point_of(numbering_.tracked_path(k)); }
    /// The k-th solution that rests at every t.
    Point<M, double> resting_point(std::uint64_t k) const { return this->point_of(numbering_.resting_path(k)); }

private:
    PathNumbering numbering_;
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

template <Model M>
using NaturalStart = typename detail::NaturalStartOf<M, detail::starts_reflected<M>()>::type;

}  // namespace equilibria
