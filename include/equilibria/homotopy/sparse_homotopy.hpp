/// \file
/// The homotopy from a start with a law of time of its own to a system that is data.
#pragma once

#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>

namespace equilibria {

/// The same with a start that has a law of its own, of any order in t: `law_order`, and law<l, R>(term, coefficient of
/// F, t) with the Taylor coefficients at the time t; from() is not read, and need not be empty.
template <class StartSystem>
class SparseHomotopy : public PolynomialHomotopy {
public:
    static constexpr int law_order = StartSystem::law_order;  ///< the highest order in t of a term's coefficient
    /// What a tracker evaluates, in numbers R at times Time.
    template <class R, class Time>
    using Evaluation = detail::TableEvaluation<SparseHomotopy, R, Time>;

    /// The start has to outlive the homotopy.
    SparseHomotopy(const SparseSystem& target, const StartSystem& start)
        : PolynomialHomotopy(target, start), start_(&start) {}

    static constexpr bool moving() { return true; }  ///< coefficients change with t
    /// The Taylor coefficient of order `Order` in t, at the time t, of a term's coefficient.
    template <int Order, class R, class Time>
    auto law(int term, const Time& t) const {
        return start_->template law<Order, R>(term, target(term), t);
    }

private:
    const StartSystem* start_;
};

}  // namespace equilibria
