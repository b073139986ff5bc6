/// \file
/// The supports of a square system of Laurent polynomials: what its mixed volume and its mixed cells depend on, and all
/// that they depend on. The coefficients do not enter.
///
/// Source: D. N. Bernstein, The number of roots of a system of equations, Funct. Anal. Appl. 9 (1975) 183-185.
#pragma once

#include <vector>

#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// The exponents of each equation of a square Laurent system: points of Z^n, which may be negative. The points of all
/// equations one after another are the columns that liftings and heights are given for.
class Supports {
public:
    using Point = std::vector<int>;  ///< exponents of a term

    /// So many unknowns (1 to 1024), and the points of as many equations, each of that many coordinates from -2^30 to
    /// 2^30. Throws InvalidArgument where an equation has no point, or a point twice. The order of the points is kept.
    explicit Supports(int unknowns, std::vector<std::vector<Point>> equations);

    int unknowns() const { return unknowns_; }  ///< number of unknowns and of equations
    /// Points of each, in the order that was given.
    const std::vector<std::vector<Point>>& equations() const { return equations_; }
    /// The number of points of all equations together.
    int columns() const { return first_column_.back(); }
    /// Where the columns of an equation begin; of unknowns(): columns().
    int first_column(int equation) const { return first_column_[static_cast<std::size_t>(equation)]; }

private:
    int unknowns_;
    std::vector<std::vector<Point>> equations_;
    std::vector<int> first_column_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/polyhedral/detail/supports_definitions.hpp>
#endif
