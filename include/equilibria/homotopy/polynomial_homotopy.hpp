/// \file
/// The homotopy from a start to a system that is data. It is one type, whatever the system: what tracks its paths, ends
/// and polishes them is compiled once.
#pragma once

#include <complex>
#include <concepts>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/lanes.hpp>
#include <equilibria/evaluation/start_forms.hpp>
#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

namespace detail {
class TermTables;
template <class H, class R, class Time>
class TableEvaluation;
}  // namespace detail

/// The equations of which a system's polynomials are another form, at points in lanes and alone: what is polished is a
/// solution of these.
class OwnEquations {
public:
    virtual ~OwnEquations() = default;
    /// At `width` points side by side: c[2 width i], and width numbers from there on, are the real parts of their c_i,
    /// width more their imaginary parts; f as many of each equation. Numbers, not packs: who evaluates may have wider
    /// or narrower registers than who asks.
    virtual void at(int width, const double* c, const double* s, const double* x, double* f) const = 0;
};

/// H(q, t), with H(q, 1) = F(q):
///     t F(q) + (1 - t) G(q),  or, where coefficients move,  sum_k ((1-t) b_k + t a_k) m_k(q) + (1 - t) G(q).
class PolynomialHomotopy {
public:
    using System = RuntimeUnknowns;      ///< sizes are known at run time
    static constexpr int law_order = 1;  ///< the highest order in t of a term's coefficient
    /// What a tracker evaluates, in numbers R at times Time.
    template <class R, class Time>
    using Evaluation = detail::TableEvaluation<PolynomialHomotopy, R, Time>;

    /// What a homotopy is made of.
    struct Parts {
        RuntimeSizes sizes;                      ///< numbers of angles and of coordinates
        std::vector<SparseTerm> terms;           ///< of F, in order, and with coefficient 0 what only b has
        std::vector<std::complex<double>> from;  ///< b, a number for each term, or none: the coefficients do not move
        StartForms forms;                        ///< G
        std::vector<double> scale;               ///< the largest coefficient of each equation of F
        bool symmetric = false;                  ///< the Jacobian is: F is a gradient
        std::shared_ptr<const OwnEquations> own = nullptr;  ///< what is polished; null: F
        std::vector<int> degrees = {};                      ///< of each unknown in G, where it is more than 1
        /// The coefficients of F, where it is given as a Laurent system: codes of angles are powers of exp(i theta),
        /// the coefficients move, and those of the terms are not read. Far off the real axis exponentials keep their
        /// digits, which products of cosines and sines lose.
        std::vector<std::complex<double>> laurent = {};
    };
    /// The parts must fit each other.
    explicit PolynomialHomotopy(Parts parts);
    /// start: what SolvedInstance and LinearProduct have.
    template <class StartSystem>
    PolynomialHomotopy(const SparseSystem& target, const StartSystem& start)
        : PolynomialHomotopy(Parts{.sizes = target.sizes(),
                                   .terms = start.terms(target),
                                   .from = start.from(),
                                   .forms = start.forms(),
                                   .scale = target.scale()}) {}

    const RuntimeSizes& sizes() const { return sizes_; }           ///< numbers of angles and of coordinates
    const detail::TermTables& tables() const { return *tables_; }  ///< the terms that are evaluated
    const StartForms& forms() const { return forms_; }             ///< G
    bool moving() const { return !from_.empty(); }                 ///< whether coefficients change with t
    bool symmetric() const { return symmetric_; }                  ///< whether the Jacobian is symmetric
    /// The square of the size beyond which a path is left to the endgame. Exponentials have their digits there still,
    /// and on a line of generic coefficients paths come back from farther out.
    double far_away2() const { return laurent_.empty() ? equilibria::far_away2 : 1e60; }

    /// The coefficient of a term at t = 1.
    double target(int term) const { return target_[static_cast<std::size_t>(term)]; }
    /// The same of a Laurent system, where it is complex.
    std::complex<double> complex_target(int term) const {
        return laurent_.empty() ? target(term) : laurent_[static_cast<std::size_t>(term)];
    }
    /// The Taylor coefficient in t, at the time t, of a term's coefficient where it moves.
    template <int Order, class R, class Time>
    auto law(int term, const Time& t) const {
        const std::complex<double> difference = complex_target(term) - from_[static_cast<std::size_t>(term)];
        if constexpr (Order == 0)
            return Complex<R>(broadcast_complex<R>(complex_target(term)) -
                              broadcast_complex<R>(difference) * (1.0 - t));
        else
            return difference;
    }

    const std::vector<double>& scale() const { return scale_; }  ///< the largest coefficient of each equation of F
    /// The same paths in numbers of a size that single precision can work with: each equation divided by a power of
    /// two near its largest coefficient, all by the same one where the Jacobian is symmetric.
    PolynomialHomotopy scaled() const;
    /// Whether the system has equations of its own beside its polynomials.
    bool has_own_equations() const { return own_ != nullptr; }
    /// The system's own equations at q. `polynomials` has their values as polynomials, and is left as it is where the
    /// system has no other form.
    template <class R>
    void residual(const RuntimePoint<R>& q, auto& polynomials) const {
        constexpr int width = LaneTraits<R>::width;
        static_assert(sizeof(Complex<R>) == 2 * width * sizeof(double));
        if (!own_) return;
        const auto numbers = [](const auto& array) { return reinterpret_cast<const double*>(array.begin()); };
        own_->at(width, numbers(q.c), numbers(q.s), numbers(q.x), reinterpret_cast<double*>(&polynomials[0]));
    }
    /// Calls take(number) for each number that a path depends on beside its start point.
    void for_each_number(const auto& take) const {
        for (const double a : target_) take(a);
        for (const auto& a : laurent_) take(a);
        for (const auto& b : from_) take(b);
        for (const auto& term : forms_.terms) take(term.coefficient);
        for (const auto& product : forms_.products) {
            take(product.weight);
            for (const auto& form : product.forms) {
                take(form.constant);
                for (const auto& part : form.parts) take(part.factor);
            }
        }
    }

private:
    RuntimeSizes sizes_;
    std::vector<double> target_;
    std::vector<std::complex<double>> laurent_, from_;
    StartForms forms_;
    std::vector<double> scale_;
    bool symmetric_;
    std::shared_ptr<const OwnEquations> own_;
    std::shared_ptr<const detail::TermTables> tables_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/homotopy/detail/polynomial_homotopy_definitions.hpp>
#endif
