/// \file
/// From the roots of one member of a family of systems to those of another, along an arc of the parameters: the
/// homotopy between members of a model whose parameters enter nonlinearly.
///
/// It is complete if the first member has as many roots as a generic one on the complex line through the parameters of
/// both: with probability one over the seed no path meets another before its end, and each isolated root of the second
/// member is the end of one (Morgan, Sommese, Coefficient-parameter polynomial continuation, Appl. Math. Comput. 29
/// (1989)). Paths whose roots are lost there are at infinity or end at singular points, and are counted so.
#pragma once

#include <complex>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/homotopy/arc_homotopy.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/paths/detail/path_problem.hpp>
#include <equilibria/paths/path_set.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/start/path_numbering.hpp>
#include <equilibria/system/system_family.hpp>

namespace equilibria {

/// Where paths begin that follow known roots.
class KnownRoots {
public:
    /// Complex angles in radians, then coordinates.
    using Points = std::vector<UnknownArray<RuntimeUnknowns, std::complex<double>>>;

    /// Angles in complex radians, then coordinates. The points have to outlive it.
    KnownRoots(const RuntimeSizes& sizes, const Points& points) : sizes_(sizes), points_(&points) {}

    static constexpr std::string_view name() { return "a solved instance"; }         ///< what results call it
    PathNumbering numbering() const { return PathNumbering::all(points_->size()); }  ///< one path a root
    /// Where path k begins.
    RuntimePoint<double> point(std::uint64_t k) const { return point_of<RuntimeUnknowns>((*points_)[k], sizes_); }

private:
    RuntimeSizes sizes_;
    const Points* points_;
};

/// Tracks all paths of the homotopy, as `track` of a PolynomialHomotopy.
PathSet track(const ArcHomotopy& homotopy, const KnownRoots& start, const RunOptions& run = {},
              const TrackerOptions& options = {}, MoreDigits<ArcHomotopy> resort = nullptr);

namespace detail {
/// A problem with a checkpoint.
PathSet track_paths(const ArcHomotopy& homotopy, PathProblem problem, const RunOptions& run,
                    const TrackerOptions& options, MoreDigits<ArcHomotopy> resort);
}  // namespace detail

/// The solutions of the member at the parameters `to`, from regular solutions `roots` of that at `from`; parameters may
/// be complex. Where paths fail, all are tracked along another arc, up to three; what is returned is of the arc on
/// which fewest failed. With a `resort`, more_digits_along_arcs, as solve_multihomogeneous. Throws InvalidArgument
/// where no arc is found along which the coefficients are analytic, where the numbers of parameters or unknowns are
/// others than the family's, where the run names a checkpoint or options are out of range.
ComplexRoots<> solve_along(const std::vector<Root<RuntimeUnknowns>>& roots, const SystemFamily& family,
                           std::span<const std::complex<double>> from, std::span<const std::complex<double>> to,
                           const RunOptions& run = {}, const TrackerOptions& options = {},
                           MoreDigits<ArcHomotopy> resort = nullptr);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/solve_along_definitions.hpp>
#endif
