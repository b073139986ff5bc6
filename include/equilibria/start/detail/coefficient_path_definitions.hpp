/// \file
/// See start/coefficient_path.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include <equilibria/core/error.hpp>
#include <equilibria/start/coefficient_path.hpp>
#include <equilibria/system/laurent_terms.hpp>

namespace equilibria {

namespace detail {

/// A Laurent term: the shares of the family's terms in it.
struct LaurentShares {
    SparseTerm term;
    std::vector<std::pair<std::size_t, std::complex<double>>> shares;
};

/// The products of powers of exp(i theta) and of the coordinates that the terms of a support are sums of.
EQUILIBRIA_INLINE std::vector<LaurentShares> laurent_shares(const std::vector<SparseTerm>& support,
                                                            const RuntimeSizes& sizes) {
    using Number = std::complex<double>;
    std::map<std::pair<int, std::vector<int>>, std::vector<std::pair<std::size_t, Number>>> sums;
    for (std::size_t k = 0; k < support.size(); ++k)
        for (const auto& product : laurent_products(support[k].monomial, sizes))
            sums[{support[k].equation, product.exponents}].emplace_back(k, product.coefficient);
    std::vector<LaurentShares> y;
    for (const auto& [key, shares] : sums) y.push_back({{key.first, SparseMonomial(key.second), 0}, shares});
    std::sort(y.begin(), y.end(), [](const auto& a, const auto& b) { return before(a.term, b.term); });
    return y;
}

/// The values of a family's coefficients along an arc at Chebyshev's points, each computed once.
class ArcSamples {
public:
    using Number = std::complex<double>;

    ArcSamples(const SystemFamily& family, const ParameterArc& arc)
        : family_(&family), arc_(&arc), last_(CoefficientPath::most_points - 1) {
        at_[0] = family.coefficients(arc.to);
        at_[last_] = family.coefficients(arc.from);
        for (const int end : {0, last_})
            for (const Number& a : at_[end])
                require(std::isfinite(a.real()) && std::isfinite(a.imag()), end == 0 ? "to" : "from", a,
                        "must be parameters at which all coefficients are finite");
    }
    /// Number j of n + 1, from t = 1 to t = 0; nothing where a coefficient is not finite.
    const std::vector<Number>* operator()(int j, int n) {
        const int key = j * (last_ / n);
        if (const auto known = at_.find(key); known != at_.end()) return &known->second;
        std::vector<Number> a;
        try {
            a = family_->coefficients(arc_->at(0.5 + 0.5 * std::cos(std::numbers::pi * j / n)));
        } catch (const InvalidArgument&) {  // a model says so of a coefficient that is not finite
            return nullptr;
        }
        for (const Number& value : a)
            if (!std::isfinite(value.real()) || !std::isfinite(value.imag())) return nullptr;
        return &(at_[key] = std::move(a));
    }
    const std::vector<Number>& to() const { return at_.at(0); }
    const std::vector<Number>& from() const { return at_.at(last_); }

private:
    const SystemFamily* family_;
    const ParameterArc* arc_;
    int last_;
    std::map<int, std::vector<Number>> at_;
};

/// The Chebyshev coefficients of the polynomial of degree n with these values at cos(pi j / n), j = 0 .. n.
EQUILIBRIA_INLINE std::vector<std::complex<double>> chebyshev_series(const std::vector<std::complex<double>>& values) {
    const int n = static_cast<int>(values.size()) - 1;
    std::vector<double> cosine(static_cast<std::size_t>(2 * n));
    for (int j = 0; j < 2 * n; ++j) cosine[static_cast<std::size_t>(j)] = std::cos(std::numbers::pi * j / n);
    std::vector<std::complex<double>> y(values.size());
    for (int k = 0; k <= n; ++k) {
        std::complex<double>& c = y[static_cast<std::size_t>(k)];
        for (int j = 0; j <= n; ++j)
            c += (j == 0 || j == n ? 0.5 : 1.0) * cosine[static_cast<std::size_t>((j * k) % (2 * n))] *
                 values[static_cast<std::size_t>(j)];
        c *= (k == 0 || k == n ? 1.0 : 2.0) / n;
    }
    return y;
}

/// The derivative in x of a Chebyshev series, times a factor; of a constant there is none left.
EQUILIBRIA_INLINE std::vector<std::complex<double>> slope_of_series(const std::vector<std::complex<double>>& c,
                                                                    double factor) {
    std::vector<std::complex<double>> y(c.size() - 1);
    for (std::size_t k = y.size(); k-- > 0;)
        y[k] = 2.0 * static_cast<double>(k + 1) * c[k + 1] + (k + 2 < y.size() ? y[k + 2] : 0.0);
    if (!y.empty()) y[0] *= 0.5;
    for (auto& value : y) value *= factor;
    return y;
}

}  // namespace detail

EQUILIBRIA_INLINE std::vector<std::complex<double>> ParameterArc::at(double t) const {
    const std::complex<double> s(t, bend * t * (1 - t));
    std::vector<std::complex<double>> p(from.size());
    for (std::size_t k = 0; k < p.size(); ++k)  // from the nearer end: the ends, and what does not move, are exact
        p[k] = t < 0.5 ? from[k] + s * (to[k] - from[k]) : to[k] + (s - 1.0) * (to[k] - from[k]);
    return p;
}

EQUILIBRIA_INLINE double random_bend(Generator& generator) {
    const double bend = uniform(generator, -1, 1);
    return bend < 0 ? bend - 0.6 : bend + 0.6;
}

EQUILIBRIA_INLINE std::optional<CoefficientPath> CoefficientPath::along(const SystemFamily& family,
                                                                        const ParameterArc& arc) {
    require(static_cast<int>(arc.to.size()) == family.parameters(), "to", arc.to.size(),
            "must have as many parameters as the family");
    require(static_cast<int>(arc.from.size()) == family.parameters(), "from", arc.from.size(),
            "must have as many parameters as the family");
    detail::ArcSamples samples(family, arc);
    const auto laurent = detail::laurent_shares(family.support(), family.sizes());
    const auto unknowns = static_cast<std::size_t>(family.sizes().unknowns);
    for (int n = 4; n < most_points; n *= 2) {
        std::vector<const std::vector<Number>*> values;
        for (int j = 0; j <= n; ++j) {
            values.push_back(samples(j, n));
            if (!values.back()) return {};
        }
        std::vector<double> largest(unknowns);  // of each equation
        for (const auto* at : values)
            for (std::size_t k = 0; k < at->size(); ++k) {
                double& of = largest[static_cast<std::size_t>(family.support()[k].equation)];
                of = std::max(of, std::abs((*at)[k]));
            }
        CoefficientPath y;
        bool ends = true;
        for (const auto& [term, shares] : laurent) {
            std::vector<Number> sums;
            double size = 0, terms = 0;  // of the sums, and of what they are made of
            for (const auto* at : values) {
                Number sum = 0;
                double of_terms = 0;
                for (const auto& [k, share] : shares) {
                    sum += share * (*at)[k];
                    of_terms += std::abs(share * (*at)[k]);
                }
                sums.push_back(sum);
                size = std::max(size, std::abs(sum));
                terms = std::max(terms, of_terms);
            }
            if (size <= 4e-15 * terms) continue;  // what cancels, as in cos(theta_1 - theta_2), or is 0
            const double negligible = 1e-14 * size + 1e-15 * largest[static_cast<std::size_t>(term.equation)];
            auto series = detail::chebyshev_series(sums);
            const auto length = series.size();
            ends = std::abs(series[length - 1]) + std::abs(series[length - 2]) <= negligible;
            if (!ends) break;
            while (series.size() > 1 && std::abs(series.back()) <= negligible) series.pop_back();
            y.add(term, std::move(series), sums.back(), sums.front());
        }
        if (!ends) continue;
        y.sizes_ = family.sizes();
        y.arc_ = arc;
        y.scale_.resize(unknowns);
        for (std::size_t k = 0; k < samples.to().size(); ++k) {
            double& of = y.scale_[static_cast<std::size_t>(family.support()[k].equation)];
            of = std::max(of, std::abs(samples.to()[k]));
        }
        for (double& of : y.scale_)
            if (!(of > 0)) of = 1;
        return y;
    }
    return {};
}

EQUILIBRIA_INLINE void CoefficientPath::add(SparseTerm term, std::vector<Number> series, const Number& from,
                                            const Number& to) {
    // to a rounding of the sum what it is at t = 1, where the paths end
    Number end = 0;
    for (std::size_t k = series.size(); k-- > 0;) end += series[k];
    series[0] += to - end;
    terms_.push_back(std::move(term));
    from_.push_back(from);
    to_.push_back(to);
    const int degree = static_cast<int>(series.size()) - 1;
    degree_ = std::max(degree_, degree);
    places_.push_back({static_cast<int>(series_.size()), degree});
    for (int order = 0; order <= std::min(degree, law_order); ++order) {
        if (order > 0) series = detail::slope_of_series(series, 2.0 / order);
        series_.insert(series_.end(), series.begin(), series.end());
    }
}

EQUILIBRIA_INLINE CoefficientPath CoefficientPath::between(const SystemFamily& family, std::span<const Number> from,
                                                           std::span<const Number> to, Generator& generator) {
    ParameterArc arc{{from.begin(), from.end()}, {to.begin(), to.end()}, 0};
    for (int attempt = 0; attempt < 12; ++attempt) {
        arc.bend = random_bend(generator);
        if (auto y = along(family, arc)) return *std::move(y);
    }
    throw InvalidArgument("to", "parameters",
                          "must be reached from `from` along an arc on which all coefficients are analytic: of 12 arcs "
                          "each passes a pole or a cut of one too closely");
}

}  // namespace equilibria
