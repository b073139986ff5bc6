/// \file
/// Polyhedral starts: as many paths as the mixed volume of the equations' Newton polytopes, which is the number of
/// roots with every z_u = exp(i theta_u) other than 0 of a system with these supports and generic coefficients.
///
/// A lifting gives each term a height; each of its mixed cells, an edge of each equation's support, is a binomial
/// system with |det| solutions, and there starts a path of each to a root of the generic system
/// (polyhedral_homotopy.hpp). A term's weight on the way is its height above the cell's plane. Of several liftings the
/// one with the smallest ratio of largest to smallest weight is taken, of 90 % of the paths: it decides how many steps
/// they need. Source: Huber, Sturmfels, A polyhedral method for solving sparse polynomial systems, Math. Comp. 64
/// (1995).
///
/// Where it fails: nowhere with probability one; numbers of cells and of their weights are kept in memory.
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/evaluation/laurent_tables.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/polyhedral/mixed_cells.hpp>
#include <equilibria/polyhedral/supports.hpp>
#include <equilibria/start/binomial_system.hpp>
#include <equilibria/start/path_numbering.hpp>

namespace equilibria {

/// The mixed cells of the best of some liftings, and the start points in them.
class PolyhedralStart {
public:
    using Number = std::complex<double>;  ///< type of the coefficients

    /// coefficients: generic ones, a column of the supports each, about 1 in modulus. liftings: how many are drawn at
    /// most. Throws InvalidArgument where there are not as many coefficients as columns, and for what mixed_cells
    /// refuses.
    PolyhedralStart(const Supports& supports, std::vector<Number> coefficients, Generator& generator, int liftings = 4,
                    const MixedCellOptions& options = {});

    static constexpr std::string_view name() { return "polyhedral"; }       ///< what results call it
    bool cancelled() const { return cancelled_; }                           ///< there are no cells, by options.cancel
    PathNumbering numbering() const { return PathNumbering::all(paths_); }  ///< all are tracked
    /// Where the path begins: a root of its cell's binomial system.
    RuntimePoint<double> point(std::uint64_t path) const;

    const Supports& supports() const { return supports_; }  ///< those of the generic system
    /// Those of the generic system, one a column of the supports.
    const std::vector<Number>& coefficients() const { return coefficients_; }
    /// Of the path's cell: the height of each column over the largest one.
    std::span<const float> weights(std::uint64_t path) const;
    /// Of the path's cell: log(1 - s), s being the time at which all terms that are not the cell's are 2^-24 of its
    /// own, or less, at its start points.
    double rate(std::uint64_t path) const { return cells_[cell_of(path)].rate; }
    std::size_t cells() const { return cells_.size(); }  ///< number of mixed cells
    /// The ratio of weights that 90 % of the paths stay below.
    double weight_ratio() const { return weight_ratio_; }

private:
    struct Cell {
        BinomialSystem binomials;
        double rate;
        std::uint64_t first;  ///< path
    };
    struct Draw;

    std::size_t cell_of(std::uint64_t path) const;
    Draw draw(Generator& generator, bool convex, int bits, const MixedCellOptions& options) const;
    double rate_of(const BinomialSystem& binomials, std::span<const std::array<int, 2>> edges,
                   std::span<const float> weights) const;
    void take(const Draw& drawn);

    Supports supports_;
    std::vector<Number> coefficients_;
    std::vector<Cell> cells_;
    std::vector<float> weights_;  // of the columns, cell by cell
    std::uint64_t paths_ = 0;
    bool cancelled_ = false;
    double weight_ratio_ = 0;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/start/detail/polyhedral_start_definitions.hpp>
#endif
