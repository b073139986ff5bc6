/// \file
/// The polyhedral homotopy: from the binomial systems of a polyhedral start to its generic system.
///
/// It ends at regular roots alone, with probability one, so that its paths need no endgame.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <equilibria/evaluation/laurent_tables.hpp>
#include <equilibria/evaluation/polyhedral_evaluation.hpp>
#include <equilibria/model/sizes.hpp>
#include <equilibria/start/polyhedral_start.hpp>

namespace equilibria {

/// H_i = sum_a c_ia exp(i a.theta + w_ia s(t)), w of the path's cell.
class PolyhedralHomotopy {
public:
    using System = RuntimeUnknowns;  ///< sizes are known at run time
    /// What a tracker evaluates, in numbers R at times Time.
    template <class R, class Time>
    using Evaluation = detail::PolyhedralEvaluation<PolyhedralHomotopy, R, Time>;

    /// The start has to outlive the homotopy.
    explicit PolyhedralHomotopy(const PolyhedralStart& start)
        : start_(&start), tables_(start.supports().unknowns()),
          scale_(static_cast<std::size_t>(start.supports().unknowns()), 1.0) {
        const auto& supports = start.supports();
        for (int i = 0; i < supports.unknowns(); ++i) {
            const auto& support = supports.equations()[static_cast<std::size_t>(i)];
            tables_.add(support, {start.coefficients().data() + supports.first_column(i), support.size()});
        }
    }

    RuntimeSizes sizes() const { return {tables_.unknowns(), 0}; }  ///< angles alone
    static constexpr bool symmetric() { return false; }             ///< its Jacobian is no Hessian
    /// No path ends at infinity, however far out it begins.
    static constexpr double far_away2() { return 1e280; }
    const LaurentTables& tables() const { return tables_; }  ///< the terms of each equation
    /// The weights w of the path's cell.
    std::span<const float> weights(std::uint64_t path) const { return start_->weights(path); }
    double rate(std::uint64_t path) const { return start_->rate(path); }  ///< of s(t), see PolyhedralStart::rate

    /// What polishing asks for: the largest coefficient of each equation; there is no other form of them.
    const std::vector<double>& scale() const { return scale_; }
    static constexpr bool has_own_equations() { return false; }  ///< F is what is polished
    void residual(const auto&, auto&) const {}                   ///< nothing, as there is no other form

private:
    const PolyhedralStart* start_;
    LaurentTables tables_;
    std::vector<double> scale_;
};

}  // namespace equilibria
