/// \file
/// Multihomogeneous homotopies: the unknowns in groups, and linear-product start systems with as many solutions as the
/// multihomogeneous number of Bezout, which can be far below the total degree.
///
/// Equation i of degree d_ig in group g starts as a product of d_ig linear forms of each group g. A start solution
/// chooses a form of each equation, as many of each group as it has unknowns, and makes the chosen ones vanish. The
/// forms of angles are linear in the cosines alone, so that the choice is a linear system, with two sines for each
/// cosine. The products are evaluated as they are: multiplied out, they would have ten times the terms of the target.
/// Source: Morgan, Sommese, A homotopy for solving general polynomial systems that respects m-homogeneous structures,
/// Appl. Math. Comput. 24 (1987); Verschelde, Cools, Symbolic homotopy construction, Appl. Algebra Engrg. Comm. Comput.
/// 4 (1993) (linear products).
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/evaluation/start_forms.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// G_i = product of linear forms; H = (1-t) gamma G + t F.
class LinearProduct {
public:
    using Number = std::complex<double>;                     ///< type of unknowns and of the forms' factors
    using Solution = UnknownArray<RuntimeUnknowns, Number>;  ///< complex angles in radians, then coordinates
    using LinearForm = StartForms::LinearForm;               ///< a factor of G_i
    static constexpr std::string_view name() { return "linear product"; }  ///< what results call it

    /// grouping: the group of each unknown, numbers from 0, none left out. Degrees are those of the terms that the
    /// target has: each equation is scaled to its largest coefficient. Throws InvalidArgument where the grouping names
    /// no group for each unknown.
    LinearProduct(const SparseSystem& target, std::span<const int> grouping, Number gamma, Generator& generator);

    /// Those of the target itself.
    const std::vector<SparseTerm>& terms(const SparseSystem& target) const { return target.terms(); }
    /// The coefficients do not move beside t F.
    std::vector<Number> from() const { return {}; }
    /// gamma G.
    const StartForms& forms() const { return forms_; }
    const std::vector<Solution>& solutions() const { return solutions_; }  ///< of G = 0, one a path

    PathNumbering numbering() const { return PathNumbering::all(solutions_.size()); }  ///< all are tracked
    /// Where path k begins.
    RuntimePoint<double> point(std::uint64_t k) const { return point_of<RuntimeUnknowns>(solutions_[k], sizes_); }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    /// A random form of length 1.
    static LinearForm draw(const std::vector<int>& members, Generator& generator);
    /// Of the product, multiplied out: cos k theta cos theta = (cos (k+1) theta + cos (k-1) theta) / 2.
    double largest_coefficient(const StartForms::Product& product) const;
    /// A form of each equation from number i on, `left` of each group.
    void choose(int i, std::vector<std::size_t>& left);
    /// The solutions of the chosen forms.
    void solve();

    RuntimeSizes sizes_;
    std::vector<std::vector<int>> members_;         // unknowns of each group
    StartForms forms_;                              // a product for each equation
    std::vector<std::vector<std::size_t>> groups_;  // of the forms of each product
    std::vector<Solution> solutions_;
    struct Choice {
        const LinearForm* form;
        std::size_t group;
    };
    std::vector<Choice> chosen_;  // a form of each equation
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/start/detail/linear_product_definitions.hpp>
#endif
