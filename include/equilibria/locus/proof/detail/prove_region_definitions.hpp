/// \file
/// See locus/proof/prove_region.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include <equilibria/certify/enclosure.hpp>
#include <equilibria/certify/krawczyk_systems.hpp>
#include <equilibria/certify/newton.hpp>
#include <equilibria/certify/proved_index.hpp>
#include <equilibria/certify/real_search.hpp>
#include <equilibria/core/lanes.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/locus/proof/prove_region.hpp>
#include <equilibria/paths/coincidence.hpp>
#include <equilibria/run/elapsed.hpp>

namespace equilibria::detail {

class RegionProver {
public:
    using Pack = Lanes<native_lanes>;

    RegionProver(const ProvedModel& model, const Window& window, const RunOptions& run,
                 const ProveRegionOptions& options)
        : model_(model), n_(model.sizes.unknowns), window_(window), run_(run), options_(options) {}

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
        const auto [exact, bound] = model_.systems(w);
        const BallSystems<double> systems(exact);
        Candidates roots;
        if (cell.candidates) roots = moved(*cell.candidates, systems.center);
        if (!bound || roots.size() != *bound || !all_different(roots)) {
            out.enumerated = true;
            roots = model_.roots(w.x.low + w.width() / 2, w.y.low + w.height() / 2, run_.seed);
        }
        prove(systems, roots, bound && roots.size() == *bound, out);
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
    bool all_different(const Candidates& roots) const {
        std::vector<RuntimePoint<double>> points;
        for (const auto& q : roots) points.push_back(point_of<RuntimeUnknowns, double>(q, model_.sizes));
        return coincident(points, 1e-9).empty();
    }

    /// What is proved of some roots, for all parameters of a cell.
    struct ProvedRoots {
        std::vector<Enclosure<double>> enclosures;
        std::vector<AngleBox> boxes;  ///< of real roots
        std::vector<std::int64_t> by_index;

        explicit ProvedRoots(int n) : by_index(static_cast<std::size_t>(n) + 1) {}

        bool distinct() const {
            const auto groups = groups_of_enclosures(enclosures);
            for (std::size_t k = 0; k < groups.size(); ++k)
                if (groups[k] != k) return false;
            return true;
        }
    };

    void prove(const BallSystems<double>& systems, const Candidates& roots, bool bound_reached, Outcome& out) const {
        ProvedRoots proved(n_);
        KrawczykSystemsTest<Pack> test(systems);
        if (!prove_roots(test, roots, true, proved) || !proved.distinct()) return;
        const auto boxes = proved.boxes;
        out.proved = bound_reached && prove_roots(test, roots, false, proved) && proved.distinct();
        if (!out.proved && model_.sizes.coordinates == 0) {
            out.argument = CountArgument::real_search;
            out.proved = search_real_roots(systems, boxes, most_boxes()).complete;
        }
        out.by_index = std::move(proved.by_index);
    }

    /// The roots of one kind: that each exists, is real or not, and the index of real ones. False where one fails.
    bool prove_roots(KrawczykSystemsTest<Pack>& test, const Candidates& roots, bool real, ProvedRoots& out) const {
        std::vector<std::size_t> members;
        for (std::size_t k = 0; k < roots.size(); ++k) {
            double imaginary = 0;
            for (const auto& z : roots[k]) imaginary = std::max(imaginary, std::abs(z.im));
            if ((imaginary < 1e-8) == real) members.push_back(k);
        }
        for (std::size_t at = 0; at < members.size(); at += native_lanes) {
            auto q = point_of_zeros<RuntimeUnknowns, Pack>(model_.sizes);
            for (int l = 0; l < native_lanes; ++l) {
                auto root = roots[members[std::min(at + static_cast<std::size_t>(l), members.size() - 1)]];
                if (real)
                    for (auto& z : root) z.im = 0;
                copy_lane(point_of<RuntimeUnknowns, double>(root, model_.sizes), 0, q, l);
            }
            const auto& proof = test(q, real);
            for (int l = 0; l < native_lanes && at + static_cast<std::size_t>(l) < members.size(); ++l) {
                if (!mask_lane(proof.proved, l)) return false;
                out.enclosures.push_back(Enclosure<double>::of(proof, l));
                if (real) {
                    const auto index = proved_index(proof, l);
                    if (!index) return false;
                    ++out.by_index[static_cast<std::size_t>(*index)];
                    if (model_.sizes.coordinates == 0) out.boxes.push_back(AngleBox::of(proof, q, l));
                } else if (!out.enclosures.back().excludes_real_points()) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Of one search, before the cell is cut: several times what the searches that succeed need.
    std::size_t most_boxes() const { return std::size_t{50} << (3 * std::min(n_, 16)); }

    const ProvedModel& model_;
    int n_;
    Window window_;
    RunOptions run_;
    ProveRegionOptions options_;
};

EQUILIBRIA_INLINE RegionProof prove_region(const ProvedModel& model, const Window& window, const RunOptions& run,
                                           const ProveRegionOptions& options) {
    window.validate();
    options.validate();
    run.require_alone("a proof");
    return RegionProver(model, window, run, options).run();
}

}  // namespace equilibria::detail
