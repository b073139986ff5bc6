/// \file
/// The start of a model's parameter homotopies: a line in the space of coefficients, from a solved instance to the
/// target.
#pragma once

#include <complex>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/start/path_numbering.hpp>

namespace equilibria {

/// H = F with the coefficients (1-t) gamma b + t a, b of the solved instance.
template <Model M>
class Moving {
public:
    static constexpr bool moving = true;  ///< the coefficients of the target move in a way of their own
    /// Complex angles in radians, then coordinates.
    using Points = std::vector<Array<std::complex<double>, n_unknowns<M>>>;

    /// From regular solutions `points` (complex angles in radians, then coordinates) of the system with the
    /// coefficients `from`, times gamma.
    Moving(const Array<double, Formulation<M>::terms>& from, std::complex<double> gamma, Points points)
        : points_(std::move(points)), numbering_(PathNumbering::all(points_.size())) {
        for (int k = 0; k < Formulation<M>::terms; ++k) from_[k] = gamma * from[k];
    }

    static constexpr std::string_view name() { return "a solved instance"; }  ///< what results call it
    /// The coefficient of the term at t = 0.
    std::complex<double> from(int term) const { return from_[term]; }
    const PathNumbering& numbering() const { return numbering_; }                      ///< all are tracked
    Point<M, double> point(std::uint64_t k) const { return point_of<M>(points_[k]); }  ///< where path k begins

private:
    Array<std::complex<double>, Formulation<M>::terms> from_;
    Points points_;
    PathNumbering numbering_;
};

}  // namespace equilibria
