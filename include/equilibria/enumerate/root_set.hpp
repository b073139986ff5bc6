/// \file
/// What an enumeration returns: every path accounted for, every root and equilibrium with its evidence.
#pragma once

#include <algorithm>
#include <complex>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/enumerate/alarm.hpp>
#include <equilibria/enumerate/count_verdict.hpp>
#include <equilibria/enumerate/family.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/paths/path_counts.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/stability/inertia.hpp>

namespace equilibria {

/// A real root, classified.
template <Model M>
struct Equilibrium {
    Unknowns<M> q;      ///< angles in (-pi, pi], radians; then the plain coordinates
    double energy = 0;  ///< the potential there; NaN for models without one
    /// Negative eigenvalues of the Hessian. Of a model without a potential, eigenvalues of dF/dq with a negative real
    /// part: those with which dq/dt = -F(q) departs. Where F are polynomials in any order and sign, that is no number
    /// of theirs.
    int index = 0;
    int nullity = 0;       ///< eigenvalues that count as zero: above 0 the equilibrium is degenerate
    double margin = 0;     ///< the smallest |eigenvalue| over the largest
    double residual = 0;   ///< as of the root
    double condition = 0;  ///< as of the root
    std::uint64_t path = 0;
    std::int32_t multiplicity = 1;

    bool degenerate() const { return nullity > 0; }
    /// A strict minimum of the potential (Lagrange-Dirichlet); without one, a point that dq/dt = -F(q) comes back to.
    bool stable() const { return index == 0 && nullity == 0; }
};

template <Model M>
struct RootSet {
    Parameters<M> parameters;
    std::uint64_t seed = 0;
    PathCounts paths;
    std::vector<Root<M>> roots;              ///< distinct and isolated, by path number
    std::vector<Equilibrium<M>> equilibria;  ///< the real ones, by index, then nullity, then path
    std::vector<Family<M>> families;         ///< curves and surfaces of solutions: none of `roots` lies on one
    std::vector<FailedPath<M>> failures;
    Alarms alarms;  ///< tests that betray lost or doubled roots where no bound is sharp
    /// The imaginary parts that separated real from not: the largest among the real roots, the smallest among the
    /// others (infinity where there are none).
    double largest_real_imaginary = 0, smallest_nonreal_imaginary = 0;
    double tracking_seconds = 0, seconds = 0;

    std::uint64_t distinct() const { return roots.size(); }
    std::uint64_t real() const { return equilibria.size(); }
    std::uint64_t degenerate() const {
        return static_cast<std::uint64_t>(
            std::count_if(equilibria.begin(), equilibria.end(), [](const auto& e) { return e.degenerate(); }));
    }
    /// Whether the run was cancelled before all paths were finished. What is here is what was found until then; paths
    /// that ran into each other are not told apart.
    bool cancelled() const { return paths.cancelled > 0; }
    CountVerdict verdict() const {
        return {&paths, &alarms, distinct(), degenerate(), by_index(), n_coordinates<M> == 0 && PotentialModel<M>};
    }
    /// Whether nothing speaks against the count of equilibria, see CountVerdict.
    bool clean() const { return verdict().clean(); }

    /// Nondegenerate equilibria of each index 0 .. n (see Equilibrium).
    std::vector<std::int64_t> by_index() const {
        std::vector<std::int64_t> counts(static_cast<std::size_t>(n_unknowns<M>) + 1);
        for (const auto& e : equilibria)
            if (!e.degenerate()) ++counts[static_cast<std::size_t>(e.index)];
        return counts;
    }
    /// Whether the Morse relations of the n-torus apply, and whether they do and hold.
    bool morse_applies() const { return verdict().morse_applies(); }
    bool morse() const { return verdict().morse(); }

    friend std::ostream& operator<<(std::ostream& out, const RootSet& r) {
        out << r.paths.total << " paths: " << r.paths.finite << " finite, " << r.paths.at_infinity << " at infinity, "
            << r.paths.singular << " singular, " << r.paths.failed << " failed; " << r.distinct() << " distinct roots, "
            << r.real() << " real";
        // polynomials in plain coordinates come in any order and sign: their Jacobian's eigenvalues mean nothing
        if constexpr (PotentialModel<M> || n_angles<M> > 0) {
            out << (PotentialModel<M> ? ": index " : ": unstable eigenvalues of dq/dt = -F(q) ");
            const auto counts = r.by_index();
            for (std::size_t k = 0; k < counts.size(); ++k) out << (k == 0 ? "" : ", ") << k << ": " << counts[k];
        }
        if (r.degenerate() > 0) out << ", degenerate: " << r.degenerate();
        if (r.morse_applies())
            out << (r.morse() ? "; Morse relations hold" : "; MORSE RELATIONS VIOLATED: roots are missing");
        std::uint64_t on_families = 0;
        for (const auto& family : r.families) on_families += family.paths();
        if (!r.families.empty()) out << "; NOT ISOLATED: " << summary(r.families);
        if (r.paths.singular > on_families) out << "; SINGULAR: equilibria coincide";
        if (r.cancelled()) out << "; CANCELLED: " << r.paths.cancelled << " paths are not finished";
        if (r.paths.finite > 0 && r.paths.singular == 0 && r.paths.finite != r.distinct() && !r.cancelled())
            out << "; " << r.paths.finite - r.distinct() << " paths ended on another's root: roots may be missing";
        if (r.alarms.raised()) out << "; ALARM: " << r.alarms.sentences();
        return out;
    }
};

}  // namespace equilibria
