/// \file
/// The homotopy from a start to a system that is data.
#pragma once

#include <complex>
#include <cstdint>
#include <memory>
#include <vector>

#include <equilibria/evaluation/start_forms.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/evaluation/term_tables.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// H(q, t), with H(q, 1) = F(q). Start: see start.hpp; beside that it says how it is evaluated: `Form<H, R>`, and where
/// it is `moving`, how the coefficients of F move: `law_order`, and law<l>(equation, monomial, coefficient of F, t)
/// with the Taylor coefficients in t at the time t.
template <int Angles, int Coordinates, class StartSystem>
class SparseHomotopy {
public:
    using System = UnknownsOf<Angles, Coordinates>;
    using Target = SparseSystem<Angles, Coordinates>;
    static constexpr int n = Angles + Coordinates;
    static constexpr bool symmetric = false;
    static constexpr bool moving = StartSystem::moving;
    static constexpr int law_order = StartSystem::law_order;
    template <class R, class Time>
    using Evaluation = detail::TableEvaluation<SparseHomotopy, R, Time>;
    template <class R>
    using Form = typename StartSystem::template Form<SparseHomotopy, R>;

    /// The start has to outlive the homotopy.
    SparseHomotopy(const Target& target, const StartSystem& start)
        : SparseHomotopy(target, start, start.terms(target)) {}

    const detail::TermTables<System>& tables() const { return *tables_; }
    /// The coefficient of a term at t = 1.
    double target(int term) const { return terms_[static_cast<std::size_t>(term)].coefficient; }
    template <int Order, class R, class Time>
    auto law(int term, const Time& t) const {
        return start_->template law<Order, R>(term, target(term), t);
    }
    const StartSystem& start() const { return *start_; }

    const Array<double, n>& scale() const { return scale_; }
    /// The polynomials are all that there is of the system.
    template <class R>
    void residual(const Point<System, R>&, Complex<R> (&)[n]) const {}

private:
    using Terms = std::vector<typename Target::Term>;

    SparseHomotopy(const Target& target, const StartSystem& start, Terms terms)
        : start_(&start), terms_(std::move(terms)), scale_(target.scale()),
          tables_(std::make_shared<detail::TermTables<System>>(terms_, Array<int, n>{})) {}

    const StartSystem* start_;
    Terms terms_;  ///< of the target, and with coefficient 0 those that the start has beside them
    Array<double, n> scale_;
    std::shared_ptr<const detail::TermTables<System>> tables_;
};

}  // namespace equilibria
