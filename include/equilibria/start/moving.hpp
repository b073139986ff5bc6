/// \file
/// The start of a model's parameter homotopies: a line in the space of coefficients, from a solved instance to the
/// target; and a total-degree start of the same type, so that a program that needs both compiles one tracker, for some
/// loss of speed.
#pragma once

#include <complex>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/start/total_degree.hpp>

namespace equilibria {

/// H = F with the coefficients (1-t) gamma b + t a, b of the solved instance; or H = (1-t) G + t F.
template <Model M>
class Moving {
public:
    static constexpr bool moving = true;
    using Coefficients = Array<std::complex<double>, Formulation<M>::terms>;
    using Points = std::vector<Array<std::complex<double>, n_unknowns<M>>>;

    /// A total-degree start.
    Moving(const ModelSystem<M>& target, Generator& generator)
        : numbering_(PathNumbering::all(static_cast<std::uint64_t>(total_degree<M>()))) {
        degree_.emplace_back(target, generator);
    }
    /// From regular solutions `points` (complex angles in radians, then coordinates) of the system with the
    /// coefficients `from`, times gamma.
    Moving(const Array<double, Formulation<M>::terms>& from, std::complex<double> gamma, Points points)
        : points_(std::move(points)), numbering_(PathNumbering::all(points_.size())) {
        for (int k = 0; k < Formulation<M>::terms; ++k) from_[k] = gamma * from[k];
    }

    static constexpr bool has_term(int i, int code) { return TotalDegree<M>::has_term(i, code); }
    std::complex<double> coefficient(int i, int code) const {
        return degree_.empty() ? std::complex<double>() : degree_.front().coefficient(i, code);
    }
    /// The coefficient of the term at t = 0.
    std::complex<double> from(int term) const { return from_[term]; }

    std::string_view name() const { return degree_.empty() ? "a solved instance" : "total degree"; }
    const PathNumbering& numbering() const { return numbering_; }
    Point<M, double> point(std::uint64_t k) const {
        return degree_.empty() ? point_of<M>(points_[k]) : degree_.front().point(k);
    }

private:
    std::vector<TotalDegree<M>> degree_;  // one, or none
    Coefficients from_{};
    Points points_;
    PathNumbering numbering_;
};

}  // namespace equilibria
