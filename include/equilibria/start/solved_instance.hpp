/// \file
/// The start of a parameter homotopy between systems that are data: H = F with the coefficients (1-t) gamma b + t a,
/// from the solutions of the system with the coefficients b.
#pragma once

#include <complex>
#include <cstdint>
#include <string_view>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/evaluation/start_forms.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// Solutions of one system, and the terms that it has together with another.
class SolvedInstance {
public:
    /// Complex angles in radians, then coordinates.
    using Points = std::vector<UnknownArray<RuntimeUnknowns, std::complex<double>>>;
    static constexpr std::string_view name() { return "a solved instance"; }  ///< what results call it

    /// points: regular solutions of `from`, complex angles in radians, then coordinates. Throws InvalidArgument where
    /// the systems have other unknowns than each other.
    SolvedInstance(const SparseSystem& from, const SparseSystem& to, std::complex<double> gamma, Points points);

    /// The terms of both systems, with the coefficients of the target.
    const std::vector<SparseTerm>& terms(const SparseSystem&) const { return terms_; }
    /// Their coefficients at t = 0.
    const std::vector<std::complex<double>>& from() const { return from_; }
    StartForms forms() const { return {}; }  ///< none: only coefficients move

    PathNumbering numbering() const { return PathNumbering::all(points_.size()); }  ///< all are tracked
    /// Where path k begins.
    RuntimePoint<double> point(std::uint64_t k) const { return point_of<RuntimeUnknowns>(points_[k], sizes_); }

private:
    RuntimeSizes sizes_;
    Points points_;
    std::vector<SparseTerm> terms_;
    std::vector<std::complex<double>> from_;  ///< gamma b, a term each
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/start/detail/solved_instance_definitions.hpp>
#endif
