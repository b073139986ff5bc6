/// \file
/// What certificates say of a locus: Krawczyk's test on the critical systems at the points of its curves, its cusps and
/// its extremal points, and proofs of the enumerations of its regions.
///
/// A point that passes is a degenerate equilibrium of the model at exactly these doubles: one, and only one, is within
/// the radius given, on the line through the point across its curve; of special points it is one of their kind, and
/// regular, so that a cusp has an unfolding and a fourth derivative that do not vanish. That no curve is missing is not
/// what is proved here (see Locus::argument).
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <span>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/exact_ball.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/system/critical_system.hpp>

namespace equilibria {

/// How many of some points are proved.
struct ProvedShare {
    std::uint64_t proved = 0;  ///< points that are proved
    std::uint64_t of = 0;      ///< points that were tried
    /// As in "5 of 7".
    friend std::ostream& operator<<(std::ostream& out, const ProvedShare& s) {
        return out << s.proved << " of " << s.of;
    }
};

/// How many points and regions of a locus are proved.
struct LocusProof {
    ProvedShare folds;                  ///< points of fold curves, special ones apart
    ProvedShare pitchforks;             ///< the same of pitchfork curves
    ProvedShare cusps;                  ///< cusps of the plane
    ProvedShare extremal;               ///< folds and pitchforks at which a parameter is extremal
    ProvedShare degenerate_pitchforks;  ///< pitchforks that turn from super- to subcritical
    ProvedShare regions;                ///< whose table is proved at their point
    double largest_radius = 0;          ///< of the parameters of a proved point, in parts of the window
    double seconds = 0;                 ///< of the whole proof

    /// The shares, in words.
    friend std::ostream& operator<<(std::ostream& out, const LocusProof& p) {
        return out << p.folds << " points of fold curves, " << p.pitchforks << " of pitchfork curves, " << p.cusps
                   << " cusps, " << p.extremal << " extremal points, " << p.degenerate_pitchforks
                   << " degenerate pitchforks and the equilibria of " << p.regions << " regions, by index";
    }
};

namespace detail {

/// The model's polynomials over exact numbers, its active parameters having these scales (see model_polynomials).
using ExactPolynomials = std::function<RuntimePolynomials<ExactBall>(std::span<const double> scales, int first)>;
/// Whether the equilibria at a region's point are proved, and are those of its table.
using ProveTable = std::function<bool(const LocusRegion&)>;

/// The proof for a model whose numbers of unknowns and parameters are known at run time.
LocusProof prove_locus(const Locus<RuntimeUnknowns>& locus, const CriticalSystem& folds, const ExactPolynomials& exact,
                       const ProveTable& prove_table, const RunOptions& run);

}  // namespace detail

/// Proves what can be proved of a locus of the plane of the parameters number X and Y. What is not proved is missing in
/// the shares, no more. Throws InvalidArgument for a run with a checkpoint or a cancel. Source: krawczyk.hpp.
template <PotentialModel M, int X, int Y>
LocusProof prove_locus(const Locus<M>& locus, const RunOptions& run = {}) {
    detail::check_active<M, X, Y>();
    constexpr int active[] = {X, Y};
    const auto p = runtime_array(locus.parameters);
    return detail::prove_locus(
        runtime_locus(locus), CriticalSystem(polynomials_of<M>(), active),
        [&](std::span<const double> scales, int first) {
            return model_polynomials<M, ExactBall>(p, active, scales, first);
        },
        [&](const LocusRegion& region) {
            const auto proof =
                prove(enumerate<M>(with_active<X, Y>(locus.parameters, region.point.x, region.point.y), run));
            return proof.complete && proof.by_index == region.by_index;
        },
        run);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/locus/proof/detail/prove_locus_definitions.hpp>
#endif
