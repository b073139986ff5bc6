/// \file
/// The homotopy between two members of a family of systems, along an arc of its parameters: all systems on the way are
/// members (start/coefficient_path.hpp).
#pragma once

#include <memory>
#include <utility>

#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/start/coefficient_path.hpp>

namespace equilibria {

/// H(q, t) = sum_k a_k(p(t)) m_k(q), as a Laurent system. Its Jacobians count as unsymmetric, those of a potential too:
/// symmetric ones are factorised without pivoting, and in models with a multiplier, whose diagonal has zeros, a fifth
/// of the paths failed at first for want of it.
class ArcHomotopy : public PolynomialHomotopy {
public:
    static constexpr int law_order = CoefficientPath::law_order;  ///< the highest order in t of a term's coefficient
    /// What a tracker evaluates, in numbers R at times Time.
    template <class R, class Time>
    using Evaluation = detail::TableEvaluation<ArcHomotopy, R, Time>;

    /// own: what is polished, where the target has equations of its own beside its polynomials. The path has to outlive
    /// the homotopy.
    explicit ArcHomotopy(const CoefficientPath& path, std::shared_ptr<const OwnEquations> own = nullptr)
        : PolynomialHomotopy(Parts{.sizes = path.sizes(),
                                   .terms = path.terms(),
                                   .from = path.from(),
                                   .forms = {},
                                   .scale = path.scale(),
                                   .own = std::move(own),
                                   .laurent = path.to()}),
          path_(&path) {}

    static constexpr bool moving() { return true; }  ///< coefficients change with t
    /// The Taylor coefficient of order `Order` in t, at the time t, of a term's coefficient.
    template <int Order, class R, class Time>
    Complex<R> law(int term, const Time& t) const {
        return path_->law<Order, R>(term, t);
    }
    /// Calls take(number) for each number that a path depends on beside its start point.
    void for_each_number(const auto& take) const {
        PolynomialHomotopy::for_each_number(take);
        for (const auto& number : path_->numbers()) take(number);
    }

private:
    const CoefficientPath* path_;
};

}  // namespace equilibria
