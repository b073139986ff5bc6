/// \file
/// What an enumeration returns: every path accounted for, every root and equilibrium with its evidence.
#pragma once

#include <algorithm>
#include <complex>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/alarm.hpp>
#include <equilibria/enumerate/count_verdict.hpp>
#include <equilibria/enumerate/family.hpp>
#include <equilibria/enumerate/model_properties.hpp>
#include <equilibria/enumerate/roots_verdict.hpp>
#include <equilibria/enumerate/start_report.hpp>
#include <equilibria/paths/path_counts.hpp>
#include <equilibria/paths/root.hpp>

namespace equilibria {

/// A real root, classified. M: the model, or RuntimeUnknowns.
template <class M>
struct Equilibrium {
    UnknownArray<M, double> q;  ///< angles in (-pi, pi], radians; then the plain coordinates
    double energy = 0;          ///< the potential there; NaN for models without one
    /// Negative eigenvalues of the Hessian. Of a model without a potential, eigenvalues of dF/dq with a negative real
    /// part: those with which dq/dt = -F(q) departs. Where F are polynomials in any order and sign, that is no number
    /// of theirs.
    int index = 0;
    int nullity = 0;                ///< eigenvalues that count as zero: above 0 the equilibrium is degenerate
    double margin = 0;              ///< the smallest |eigenvalue| over the largest, in units of the Hessian's own
    double residual = 0;            ///< as of the root
    double condition = 0;           ///< as of the root
    std::uint64_t path = 0;         ///< number of the path that ends there
    std::int32_t multiplicity = 1;  ///< as of the root

    bool degenerate() const { return nullity > 0; }  ///< the Hessian is singular
    /// A strict minimum of the potential (Lagrange-Dirichlet); without one, a point that dq/dt = -F(q) comes back to.
    bool stable() const { return index == 0 && nullity == 0; }
};

/// In the unknowns of a model, which are as many.
template <class M>
Equilibrium<M> typed(const Equilibrium<RuntimeUnknowns>& e) {
    return {unknowns_from<M>(e.q), e.energy, e.index,       e.nullity, e.margin, e.residual,
            e.condition,           e.path,   e.multiplicity};
}

namespace detail {
/// What a RootSet prints of itself.
struct RootSetSummary {
    CountVerdict verdict;
    std::uint64_t real;
    std::string counted;   ///< what by_index counts, empty: nothing
    std::string families;  ///< empty: there are none
    std::uint64_t on_families;
};
std::ostream& write(std::ostream& out, const RootSetSummary& set);
}  // namespace detail

/// All isolated roots of a model at one point of its parameters. M: the model, or RuntimeUnknowns.
template <class M>
struct RootSet {
    ParameterArray<M, double> parameters;    ///< at which the roots were sought
    std::uint64_t seed = 0;                  ///< of the start's random numbers
    PathCounts paths;                        ///< how all paths ended
    std::vector<Root<M>> roots;              ///< distinct and isolated, by path number
    std::vector<Equilibrium<M>> equilibria;  ///< the real ones, by index, then nullity, then path
    std::vector<Family<M>> families;         ///< curves and surfaces of solutions: none of `roots` lies on one
    std::vector<FailedPath<M>> failures;     ///< paths that were not finished, and why
    Alarms alarms;                           ///< tests that betray lost or doubled roots where no bound is sharp
    double largest_real_imaginary = 0;       ///< the largest imaginary part among the real roots
    /// The smallest among the others; infinity: there are none.
    double smallest_nonreal_imaginary = std::numeric_limits<double>::infinity();
    double tracking_seconds = 0;                       ///< for the paths alone
    double seconds = 0;                                ///< for everything
    StartReport start{};                               ///< which start it was, and why
    RootsVerdict completeness{};                       ///< what is known of roots that are not in the set
    [[no_unique_address]] ModelProperties<M> model{};  ///< sizes and symmetries

    std::uint64_t distinct() const { return roots.size(); }   ///< complex and real roots
    std::uint64_t real() const { return equilibria.size(); }  ///< equilibria
    /// Equilibria with a singular Hessian.
    std::uint64_t degenerate() const {
        return static_cast<std::uint64_t>(
            std::count_if(equilibria.begin(), equilibria.end(), [](const auto& e) { return e.degenerate(); }));
    }
    /// Whether the run was cancelled before all paths were finished. What is here is what was found until then; paths
    /// that ran into each other are not told apart.
    bool cancelled() const { return paths.cancelled > 0; }
    /// What is to be said of the count of equilibria.
    CountVerdict verdict() const {
        return {&paths,           &alarms,    distinct(),
                degenerate(),     by_index(), model.sizes.coordinates == 0 && model.has_potential,
                !families.empty()};
    }
    /// Whether nothing speaks against the count of equilibria, see CountVerdict.
    bool clean() const { return verdict().clean(); }

    /// Nondegenerate equilibria of each index 0 .. n (see Equilibrium).
    std::vector<std::int64_t> by_index() const {
        std::vector<std::int64_t> counts(static_cast<std::size_t>(model.sizes.unknowns) + 1);
        for (const auto& e : equilibria)
            if (!e.degenerate()) ++counts[static_cast<std::size_t>(e.index)];
        return counts;
    }
    /// Whether the Morse relations of the n-torus apply, and whether they do and hold.
    /// \{
    bool morse_applies() const { return verdict().morse_applies(); }
    bool morse() const { return verdict().morse(); }
    /// \}

    /// Paths, roots and equilibria by their numbers, and all that speaks against these, in one sentence.
    [[gnu::cold]] friend std::ostream& operator<<(std::ostream& out, const RootSet& set) {
        std::uint64_t on_families = 0;
        for (const auto& family : set.families) on_families += family.paths();
        // polynomials in plain coordinates come in any order and sign: their Jacobian's eigenvalues mean nothing
        const std::string counted = set.model.has_potential       ? "index"
                                    : set.model.sizes.angles == 0 ? ""
                                                                  : "unstable eigenvalues of dq/dt = -F(q)";
        return detail::write(out, {set.verdict(), set.real(), counted, summary(set.families), on_families});
    }
};

/// In the unknowns of a model, whose properties those of the set are.
template <class M>
[[gnu::cold]] RootSet<M> typed(RootSet<RuntimeUnknowns>&& set) {
    RootSet<M> y;
    y.parameters = parameters_from<M>(set.parameters);
    y.seed = set.seed;
    y.paths = set.paths;
    y.roots = typed<M>(std::move(set.roots));
    y.equilibria = typed<M>(std::move(set.equilibria));
    y.families = typed<M>(std::move(set.families));
    y.failures = typed<M>(std::move(set.failures));
    y.alarms = std::move(set.alarms);
    y.largest_real_imaginary = set.largest_real_imaginary;
    y.smallest_nonreal_imaginary = set.smallest_nonreal_imaginary;
    y.tracking_seconds = set.tracking_seconds;
    y.seconds = set.seconds;
    y.start = std::move(set.start);
    y.completeness = std::move(set.completeness);
    return y;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/root_set_definitions.hpp>
#endif
