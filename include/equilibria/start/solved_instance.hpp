/// \file
/// The start of a parameter homotopy between systems that are data: H = F with the coefficients (1-t) gamma b + t a,
/// from the solutions of the system with the coefficients b.
#pragma once

#include <algorithm>
#include <complex>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/evaluation/start_forms.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

template <int Angles, int Coordinates>
class SolvedInstance {
public:
    using Unknowns = UnknownsOf<Angles, Coordinates>;
    using System = SparseSystem<Angles, Coordinates>;
    using Term = typename System::Term;
    using Points = std::vector<Array<std::complex<double>, n_unknowns<Unknowns>>>;
    static constexpr bool moving = true;
    static constexpr int law_order = 1;
    static constexpr std::string_view name() { return "a solved instance"; }
    template <class H, class R>
    using Form = detail::NoForm<H, R>;

    /// points: regular solutions of `from`, complex angles in radians, then coordinates.
    SolvedInstance(const System& from, const System& to, std::complex<double> gamma, Points points)
        : points_(std::move(points)), terms_(to.terms()) {
        std::vector<Term> others;
        for (Term t : from.terms())
            if (const auto at = find(terms_, t); at == terms_.end()) t.coefficient = 0, others.push_back(t);
        terms_.insert(terms_.end(), others.begin(), others.end());
        std::sort(terms_.begin(), terms_.end(), System::before);
        from_.resize(terms_.size());
        for (const Term& t : from.terms())
            from_[static_cast<std::size_t>(find(terms_, t) - terms_.begin())] = gamma * t.coefficient;
    }

    /// The terms of both systems, with the coefficients of the target.
    const std::vector<Term>& terms(const System&) const { return terms_; }
    template <int Order, class R, class Time>
    auto law(int term, double target, const Time& t) const {
        const std::complex<double> difference = target - from_[static_cast<std::size_t>(term)];
        if constexpr (Order == 0)
            return Complex<R>(broadcast_complex<R>(std::complex<double>(target)) -
                              broadcast_complex<R>(difference) * (1.0 - t));
        else
            return difference;
    }

    PathNumbering numbering() const { return PathNumbering::all(points_.size()); }
    Point<Unknowns, double> point(std::uint64_t k) const { return point_of<Unknowns>(points_[k]); }

private:
    static auto find(const std::vector<Term>& terms, const Term& t) {
        const auto at = std::lower_bound(terms.begin(), terms.end(), t, System::before);
        return at != terms.end() && !System::before(t, *at) ? at : terms.end();
    }

    Points points_;
    std::vector<Term> terms_;
    std::vector<std::complex<double>> from_;  ///< gamma b, a term each
};

}  // namespace equilibria
