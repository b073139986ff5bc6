/// \file
/// What a start adds in a form of its own, for an evaluation by loops (table_evaluation.hpp).
#pragma once

#include <complex>
#include <vector>

#include <equilibria/core/complex.hpp>
#include <equilibria/evaluation/factor_series.hpp>

namespace equilibria::detail {

/// G of a total-degree start, a polynomial of unknown i for each equation i.
template <class H, class R>
class SeparableForm {
public:
    using S = typename H::System;
    using Z = Complex<R>;
    static constexpr int n = n_unknowns<S>;

    explicit SeparableForm(const H& h) {
        for (int g = 0; g < H::Plan::n_groups; ++g)
            if (H::Plan::groups[g].in_start && h.start(g) != std::complex<double>())
                terms_.push_back({H::Plan::groups[g].equation,
                                  h.tables().factor(H::Plan::groups[g].equation, H::Plan::groups[g].own_code),
                                  h.start(g)});
    }
    void series(int k, const FactorSeries<S, R>& factors, Z (&g)[n]) const {
        for (Z& entry : g) entry = {broadcast<R>(0.0), broadcast<R>(0.0)};
        for (const Term& t : terms_)
            if (t.factor >= 0)
                g[t.equation] += broadcast_complex<R>(t.coefficient) * factors(k, t.factor);
            else if (k == 0)
                g[t.equation] += broadcast_complex<R>(t.coefficient);
    }
    void slopes(const FactorSeries<S, R>& factors, Z (&j)[n][n]) const {
        for (const Term& t : terms_)
            if (t.factor >= 0)
                j[t.equation][t.equation] += broadcast_complex<R>(t.coefficient) * factors.slope(t.factor);
    }

private:
    struct Term {
        int equation, factor;
        std::complex<double> coefficient;
    };
    std::vector<Term> terms_;
};

/// No G.
template <class H, class R>
class NoForm {
public:
    using S = typename H::System;
    using Z = Complex<R>;
    static constexpr int n = n_unknowns<S>;

    explicit NoForm(const H&) {}
    void series(int, const FactorSeries<S, R>&, Z (&g)[n]) const {
        for (Z& entry : g) entry = {broadcast<R>(0.0), broadcast<R>(0.0)};
    }
    void slopes(const FactorSeries<S, R>&, Z (&)[n][n]) const {}
};

}  // namespace equilibria::detail
