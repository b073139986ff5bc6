/// \file
/// The number and kind of the equilibria for every point of a part of the plane of two parameters, proved cell by cell.
///
/// In a cell, Krawczyk's test is made for all parameters of the cell at once: each real root found is one throughout
/// the cell and keeps its index. That there is no other real root has two proofs. Either as many distinct roots are
/// proved, complex ones included, as the total degree allows, each real throughout or non-real throughout. Or, for
/// models in angles alone, the torus of real angles is searched. The first costs less; the second does not need the
/// complex roots, of which some may be nearly singular or far out. So no fold, pitchfork or other change of the count
/// lies in a proved cell. A cell that cannot be proved is cut in two, until it is too small. Cells that a curve of the
/// locus crosses cannot be proved: what remains is a band around the locus. This is a computer-assisted version of a
/// bifurcation figure.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/certify/proved_bound.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/model/active_parameters.hpp>

namespace equilibria {

/// How finely a window is cut.
struct ProveRegionOptions {
    double min_cell = 1e-3;  ///< a cell is not cut along an edge that is at most that long; in units of the parameters

    /// Throws InvalidArgument for an option out of range.
    void validate() const {
        require(std::isfinite(min_cell) && min_cell > 0, "min_cell", min_cell, "must be positive and finite");
    }
};

/// Why a cell has no equilibrium beside those found.
enum class CountArgument {
    root_bound,   ///< as many complex roots are proved as there can be
    real_search,  ///< the torus of real angles holds no other
};
/// "root bound" or "real search".
constexpr const char* to_string(CountArgument argument) {
    return argument == CountArgument::root_bound ? "root bound" : "real search";
}

/// A rectangle of the plane, proved: the same equilibria for each of its points.
struct ProvedCell {
    Window window;                                       ///< the cell
    CountArgument argument = CountArgument::root_bound;  ///< why it holds no other equilibrium
    std::int64_t count = 0;                              ///< real equilibria
    std::vector<std::int64_t> by_index;                  ///< of index 0, 1, .. n
};

/// What is proved of a window: cells, and what remains.
struct RegionProof {
    Window window;                   ///< as it was asked for
    std::vector<ProvedCell> cells;   ///< proved, without overlap
    std::vector<Window> undecided;   ///< cells that were too small to be cut once more
    double proved_area_share = 0;    ///< area of the cells over the area of the window
    std::uint64_t tested = 0;        ///< cells tested, those that were cut included
    std::uint64_t enumerations = 0;  ///< runs of the tracker for candidates
    double seconds = 0;              ///< of the whole proof
};

namespace detail {

/// Roots near which proofs are tried.
using Candidates = std::vector<RuntimeArray<Complex<double>>>;

/// What the proof needs of a model with a potential.
struct ProvedModel {
    RuntimeSizes sizes;
    /// The equations for all parameters of a cell, and the bound of their roots, where there is one.
    std::function<std::pair<ExactTermFamily, std::optional<std::uint64_t>>(const Window&)> systems;
    /// The roots at a point of the plane, by an enumeration with this seed.
    std::function<Candidates(double x, double y, std::uint64_t seed)> roots;
};

RegionProof prove_region(const ProvedModel& model, const Window& window, const RunOptions& run,
                         const ProveRegionOptions& options);

}  // namespace detail

/// Proves the equilibria of the model in the plane of its parameters number X and Y, the others being those of p.
///
/// Throws InvalidArgument for a window that is empty, reversed or not finite, for parameters that are not finite and
/// for options out of range, and for a run with a checkpoint or a cancel.
template <Model M, int X, int Y>
RegionProof prove_region(const Parameters<M>& p, const Window& window, const RunOptions& run = {},
                         const ProveRegionOptions& options = {}) {
    static_assert(PotentialModel<M>, "equilibria: prove_region counts by the index of a Hessian: it needs a potential");
    static_assert(X != Y, "equilibria: a plane needs two different parameters");
    require_finite(p, "parameters");
    const detail::ProvedModel model{
        Sizes<M>(),
        [&](const Window& w) {
            const ExactSystems<M, 2> exact(p, {{X, Y}}, {{w.x.low, w.y.low}}, {{w.x.high, w.y.high}});
            std::optional<std::uint64_t> bound;
            if (const auto total = total_degree_bound<M>(exact.all)) bound = total->value;
            return std::pair(ExactTermFamily(exact), bound);
        },
        [&](double x, double y, std::uint64_t seed) {
            detail::Candidates roots;
            for (const auto& root : enumerate<M>(with_active<X, Y>(p, x, y), {.seed = seed}).roots) {
                roots.emplace_back(n_unknowns<M>);
                for (int u = 0; u < n_unknowns<M>; ++u)
                    roots.back()[u] = Complex<double>(root.q[u].real(), root.q[u].imag());
            }
            return roots;
        }};
    return detail::prove_region(model, window, run, options);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/locus/proof/detail/prove_region_definitions.hpp>
#endif
