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

#include <algorithm>
#include <array>
#include <complex>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <equilibria/certify/enclosure.hpp>
#include <equilibria/certify/krawczyk_systems.hpp>
#include <equilibria/certify/newton.hpp>
#include <equilibria/certify/proved_bound.hpp>
#include <equilibria/certify/proved_index.hpp>
#include <equilibria/certify/real_search.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/regions/regions.hpp>
#include <equilibria/paths/coincidence.hpp>
#include <equilibria/run/elapsed.hpp>

namespace equilibria {

struct ProveRegionOptions {
    double min_cell = 1e-3;  ///< a cell is not cut along an edge that is at most that long; in units of the parameters

    void validate() const {
        require(std::isfinite(min_cell) && min_cell > 0, "min_cell", min_cell, "must be positive and finite");
    }
};

/// Why a cell has no equilibrium beside those found.
enum class CountArgument {
    root_bound,   ///< as many complex roots are proved as there can be
    real_search,  ///< the torus of real angles holds no other
};
constexpr const char* to_string(CountArgument argument) {
    return argument == CountArgument::root_bound ? "root bound" : "real search";
}

/// A rectangle of the plane, proved: the same equilibria for each of its points.
struct ProvedCell {
    Window window;
    CountArgument argument = CountArgument::root_bound;
    std::int64_t count = 0;              ///< real equilibria
    std::vector<std::int64_t> by_index;  ///< of index 0, 1, .. n
};

struct RegionProof {
    Window window;
    std::vector<ProvedCell> cells;
    std::vector<Window> undecided;
    double proved_area_share = 0;    ///< area of the cells over the area of the window
    std::uint64_t tested = 0;        ///< cells tested, those that were cut included
    std::uint64_t enumerations = 0;  ///< runs of the tracker for candidates
    double seconds = 0;
};

namespace detail {

template <Model M, int X, int Y>
class RegionProver {
public:
    static_assert(PotentialModel<M>, "equilibria: prove_region counts by the index of a Hessian: it needs a potential");
    static constexpr int n = n_unknowns<M>;
    using Pack = Lanes<native_lanes>;
    using Candidates = std::vector<ComplexUnknowns<M, double>>;

    RegionProver(const Parameters<M>& p, const Window& window, const RunOptions& run, const ProveRegionOptions& options)
        : parameters_(p), window_(window), run_(run), options_(options) {}

    RegionProof run() {
        const detail::Stopwatch begin;
        RegionProof proof;
        proof.window = window_;
        const double area = window_.width() * window_.height();
        std::vector<Cell> generation{{window_, nullptr}};
        double decided = 0;
        while (!generation.empty()) {
            std::vector<Outcome> outcomes(generation.size());
            run_.executor.for_blocks(generation.size(), 16, [&](std::size_t first, std::size_t last) {
                for (std::size_t k = first; k < last; ++k) outcomes[k] = test(generation[k]);
            });
            std::vector<Cell> next;
            for (std::size_t k = 0; k < generation.size(); ++k) {
                const Window& w = generation[k].window;
                ++proof.tested;
                proof.enumerations += outcomes[k].enumerated;
                if (outcomes[k].proved) {
                    auto& counts = outcomes[k].by_index;
                    std::int64_t count = 0;
                    for (const std::int64_t c : counts) count += c;
                    proof.cells.push_back({w, outcomes[k].argument, count, std::move(counts)});
                    decided += w.width() * w.height();
                } else if (std::max(w.width(), w.height()) <= options_.min_cell) {
                    proof.undecided.push_back(w);
                    decided += w.width() * w.height();
                } else {
                    for (const Window& half : halves(w)) next.push_back({half, outcomes[k].candidates});
                }
            }
            generation = std::move(next);
            if (run_.progress)  // in millionths of the area
                run_.progress(static_cast<std::uint64_t>(1e6 * std::min(1.0, decided / area)), 1000000);
        }
        for (const auto& cell : proof.cells)
            proof.proved_area_share += cell.window.width() * cell.window.height() / area;
        proof.seconds = begin.seconds();
        return proof;
    }

private:
    struct Cell {
        Window window;
        std::shared_ptr<const Candidates>
            candidates;  ///< the roots at the middle of the cell that this one is a half of
    };
    struct Outcome {
        bool proved = false, enumerated = false;
        CountArgument argument = CountArgument::root_bound;
        std::vector<std::int64_t> by_index;
        std::shared_ptr<const Candidates> candidates;  ///< the roots at this cell's middle
    };

    static std::array<Window, 2> halves(Window w) {
        Window a = w, b = w;
        if (w.width() > w.height())
            a.x.high = b.x.low = w.x.low + w.width() / 2;
        else
            a.y.high = b.y.low = w.y.low + w.height() / 2;
        return {a, b};
    }

    Outcome test(const Cell& cell) const {
        Outcome out;
        const Window& w = cell.window;
        const ExactSystems<M, 2> exact(parameters_, {{X, Y}}, {{w.x.low, w.y.low}}, {{w.x.high, w.y.high}});
        const auto bound = total_degree_bound<M>(exact.all);
        const BallSystems<M, double, 2> systems(exact);
        Candidates roots;
        if (cell.candidates) roots = moved(*cell.candidates, systems.center);
        if (!bound || roots.size() != bound->value || !all_different(roots)) {
            out.enumerated = true;
            Parameters<M> p = parameters_;
            p[X] = w.x.low + w.width() / 2;
            p[Y] = w.y.low + w.height() / 2;
            roots.clear();
            for (const auto& root : enumerate<M>(p, {.seed = run_.seed}).roots) {
                ComplexUnknowns<M, double> q;
                for (int u = 0; u < n; ++u) q[u] = Complex<double>(root.q[u].real(), root.q[u].imag());
                roots.push_back(q);
            }
        }
        prove(systems, roots, bound && roots.size() == bound->value, out);
        out.candidates = std::make_shared<const Candidates>(std::move(roots));
        return out;
    }

    /// The roots of a neighbouring point brought to this cell's middle by Newton's method; without those that did not
    /// come to a root.
    static Candidates moved(const Candidates& from, const BallSystem<double>& system) {
        Candidates y;
        for (auto q : from)
            if (newton(system, q, 8) < 1e-8) y.push_back(q);
        return y;
    }
    static bool all_different(const Candidates& roots) {
        std::vector<RuntimePoint<double>> points;
        for (const auto& q : roots) points.push_back(runtime_point(point_of<M, double>(q)));
        return coincident(points, 1e-9).empty();
    }

    /// What is proved of some roots, for all parameters of a cell.
    struct ProvedRoots {
        std::vector<Enclosure<double>> enclosures;
        std::vector<AngleBox<n_angles<M>>> boxes;  ///< of real roots
        std::vector<std::int64_t> by_index = std::vector<std::int64_t>(static_cast<std::size_t>(n) + 1);

        bool distinct() const {
            const auto groups = groups_of_enclosures(enclosures);
            for (std::size_t k = 0; k < groups.size(); ++k)
                if (groups[k] != k) return false;
            return true;
        }
    };

    void prove(const BallSystems<M, double, 2>& systems, const Candidates& roots, bool bound_reached,
               Outcome& out) const {
        ProvedRoots proved;
        if (!prove_roots(systems, roots, true, proved) || !proved.distinct()) return;
        const auto boxes = proved.boxes;
        out.proved = bound_reached && prove_roots(systems, roots, false, proved) && proved.distinct();
        if constexpr (n_coordinates<M> == 0)
            if (!out.proved) {
                out.argument = CountArgument::real_search;
                out.proved = search_real_roots<M>(systems, boxes, most_boxes).complete;
            }
        out.by_index = std::move(proved.by_index);
    }

    /// The roots of one kind: that each exists, is real or not, and the index of real ones. False where one fails.
    static bool prove_roots(const BallSystems<M, double, 2>& systems, const Candidates& roots, bool real,
                            ProvedRoots& out) {
        std::vector<std::size_t> members;
        for (std::size_t k = 0; k < roots.size(); ++k) {
            double imaginary = 0;
            for (const auto& z : roots[k]) imaginary = std::max(imaginary, std::abs(z.im));
            if ((imaginary < 1e-8) == real) members.push_back(k);
        }
        for (std::size_t at = 0; at < members.size(); at += native_lanes) {
            Point<M, Pack> q;
            for (int l = 0; l < native_lanes; ++l) {
                auto root = roots[members[std::min(at + static_cast<std::size_t>(l), members.size() - 1)]];
                if (real)
                    for (auto& z : root) z.im = 0;
                copy_lane(point_of<M, double>(root), 0, q, l);
            }
            const auto proof = krawczyk<M, Pack>(systems, q, real);
            for (int l = 0; l < native_lanes && at + static_cast<std::size_t>(l) < members.size(); ++l) {
                if (!mask_lane(proof.proved, l)) return false;
                out.enclosures.push_back(Enclosure<double>::of(proof, l));
                if (real) {
                    const auto index = proved_index(proof, l);
                    if (!index) return false;
                    ++out.by_index[static_cast<std::size_t>(*index)];
                    if constexpr (n_coordinates<M> == 0) out.boxes.push_back(AngleBox<n>::of(proof, q, l));
                } else if (!out.enclosures.back().excludes_real_points()) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Of one search, before the cell is cut: several times what the searches that succeed need.
    static constexpr std::size_t most_boxes = std::size_t{50} << (3 * std::min(n, 16));

    Parameters<M> parameters_;
    Window window_;
    RunOptions run_;
    ProveRegionOptions options_;
};

}  // namespace detail

/// Proves the equilibria of the model in the plane of its parameters number X and Y, the others being those of p.
///
/// Throws InvalidArgument for a window that is empty, reversed or not finite, for parameters that are not finite and
/// for options out of range, and for a run with a checkpoint or a cancel.
template <Model M, int X, int Y>
RegionProof prove_region(const Parameters<M>& p, const Window& window, const RunOptions& run = {},
                         const ProveRegionOptions& options = {}) {
    static_assert(X != Y, "equilibria: a plane needs two different parameters");
    require_finite(p, "parameters");
    window.validate();
    options.validate();
    run.require_whole("a proof");
    return detail::RegionProver<M, X, Y>(p, window, run, options).run();
}

}  // namespace equilibria
