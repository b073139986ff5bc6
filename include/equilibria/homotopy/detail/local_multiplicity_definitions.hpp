/// \file
/// See homotopy/local_multiplicity.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <equilibria/core/complex.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/homotopy/local_multiplicity.hpp>

namespace equilibria {

namespace detail {

/// Taylor series of the target's equations at a point, and ranks of their Macaulay matrices.
class DualSpace {
public:
    using S = Multiprecision<64>;
    using Z = Complex<S>;
    using Exponents = std::vector<int>;
    using Series = std::map<Exponents, Z>;

    static constexpr double smallest_pivot = 1e-26;
    static constexpr std::size_t most_columns = 230;

    DualSpace(const RuntimeSizes& sizes, const std::vector<LaurentColumn>& columns, std::vector<Z> at)
        : n_(static_cast<std::size_t>(sizes.unknowns)), columns_(&columns), at_(std::move(at)) {
        for (const Z& z : at_) zero_.push_back(z.re == S(0) && z.im == S(0));
    }

    /// The nullity at order d; -1 where the matrix is too large.
    int nullity(int d, LocalMultiplicity& y) const {
        std::vector<Exponents> monomials;
        Exponents e(n_);
        list(0, d, e, monomials);
        if (monomials.size() > most_columns) return -1;
        std::map<Exponents, std::size_t> number;
        for (std::size_t k = 0; k < monomials.size(); ++k) number[monomials[k]] = k;
        std::vector<std::vector<Z>> rows;
        for (const Series& f : series(d, y)) {
            for (const Exponents& by : monomials) {
                if (degree(by) > d - 1) continue;
                std::vector<Z> row(monomials.size(), Z(0.0));
                for (const auto& [at, c] : f) {
                    Exponents sum = at;
                    for (std::size_t u = 0; u < n_; ++u) sum[u] += by[u];
                    if (const auto k = number.find(sum); k != number.end()) row[k->second] = c;
                }
                rows.push_back(std::move(row));
            }
        }
        return static_cast<int>(monomials.size()) - rank(rows, y);
    }

private:
    static int degree(const Exponents& e) {
        int y = 0;
        for (const int k : e) y += k;
        return y;
    }
    void list(std::size_t u, int left, Exponents& e, std::vector<Exponents>& to) const {
        if (u == n_) {
            to.push_back(e);
            return;
        }
        for (int k = 0; k <= left; ++k) {
            e[u] = k;
            list(u + 1, left - k, e, to);
        }
        e[u] = 0;
    }
    /// Each equation to the order d, the sizes of its terms adding up to 1, without its value, which counts as dropped:
    /// unknowns against their size, those that are 0 as they are.
    std::vector<Series> series(int d, LocalMultiplicity& evidence) const {
        std::vector<Series> y(n_);
        std::vector<S> size(n_, S(0));
        for (const LaurentColumn& c : *columns_) {
            if (c.to == 0.0) continue;
            Series product{{Exponents(n_), Z(S(c.to.real()), S(c.to.imag()))}};
            for (std::size_t u = 0; u < n_; ++u) {
                const int k = c.exponents[u];
                if (k == 0) continue;
                Series next;
                const auto add = [&](const Series& of, int power, const Z& by) {
                    for (const auto& [at, value] : of) {
                        Exponents to = at;
                        to[u] += power;
                        if (degree(to) <= d) {
                            Z& sum = next.try_emplace(to, Z(0.0)).first->second;
                            sum += by * value;
                        }
                    }
                };
                if (zero_[u]) {
                    add(product, k, Z(1.0));
                } else {
                    Z by = pow(at_[u], k);
                    for (int m = 0; m <= d; ++m) {  // binomials of k, which may be negative
                        add(product, m, by);
                        by = (static_cast<double>(k - m) * by) / S(m + 1);
                        if (k >= 0 && m >= k) break;
                    }
                }
                product = std::move(next);
            }
            S largest(0);
            for (const auto& [at, value] : product) {
                largest = std::max(largest, norm2(value));
                Z& sum = y[static_cast<std::size_t>(c.equation)].try_emplace(at, Z(0.0)).first->second;
                sum += value;
            }
            size[static_cast<std::size_t>(c.equation)] += sqrt(largest);
        }
        for (std::size_t i = 0; i < n_; ++i) {
            if (!(size[i] > S(0))) continue;
            const S by = S(1) / size[i];
            if (const auto value = y[i].find(Exponents(n_)); value != y[i].end()) {
                const auto re = static_cast<double>(value->second.re * by),
                           im = static_cast<double>(value->second.im * by);
                evidence.largest_dropped = std::max(evidence.largest_dropped, std::abs(re) + std::abs(im));
                y[i].erase(value);
            }
            for (auto& [_, value] : y[i]) value = by * value;
        }
        return y;
    }
    /// By elimination with full pivots, whose sizes count against those of the equations' terms.
    static int rank(std::vector<std::vector<Z>>& a, LocalMultiplicity& y) {
        if (a.empty()) return 0;
        const std::size_t columns = a.front().size();
        std::vector<char> used(a.size());
        for (std::size_t r = 0; r < std::min(a.size(), columns); ++r) {
            std::size_t row = 0, column = 0;
            double pivot = -1;
            for (std::size_t i = 0; i < a.size(); ++i) {
                if (used[i]) continue;
                for (std::size_t j = 0; j < columns; ++j) {
                    const auto re = static_cast<double>(a[i][j].re), im = static_cast<double>(a[i][j].im);
                    const double size = std::abs(re) + std::abs(im);
                    if (size > pivot) pivot = size, row = i, column = j;
                }
            }
            if (!(pivot > smallest_pivot)) {
                y.largest_dropped = std::max(y.largest_dropped, pivot);
                return static_cast<int>(r);
            }
            y.smallest_kept = std::min(y.smallest_kept, pivot);
            used[row] = 1;
            const Z by = inverse(a[row][column]);
            for (std::size_t i = 0; i < a.size(); ++i) {
                if (used[i]) continue;
                const Z f = a[i][column] * by;
                if (f.re == S(0) && f.im == S(0)) continue;
                for (std::size_t j = 0; j < columns; ++j)
                    if (!(a[row][j].re == S(0) && a[row][j].im == S(0))) a[i][j] -= f * a[row][j];
                a[i][column] = Z(0.0);
            }
        }
        return static_cast<int>(std::min(a.size(), columns));
    }

    std::size_t n_;
    const std::vector<LaurentColumn>* columns_;
    std::vector<Z> at_;
    std::vector<char> zero_;
};

}  // namespace detail

EQUILIBRIA_INLINE LocalMultiplicity local_multiplicity(const RuntimeSizes& sizes,
                                                       const std::vector<LaurentColumn>& columns,
                                                       const std::vector<const PathLimit*>& limits, std::size_t level,
                                                       int most) {
    using S = detail::DualSpace::S;
    using Z = detail::DualSpace::Z;
    const auto n = static_cast<std::size_t>(sizes.unknowns);
    std::vector<Z> mean(n, Z(0.0));
    for (std::size_t u = 0; u < n; ++u) {
        bool vanishes = true;
        for (const PathLimit* limit : limits) {
            vanishes = vanishes && limit->z[u] == 0.0;
            S part[2] = {S(0), S(0)};
            for (std::size_t k = 0; k < 2; ++k)
                for (const double x : limit->points[level].z[u][k]) part[k] += S(x);
            mean[u] += Z(part[0], part[1]);
        }
        mean[u] = vanishes ? Z(0.0) : mean[u] / S(static_cast<double>(limits.size()));
    }
    const detail::DualSpace space(sizes, columns, std::move(mean));
    LocalMultiplicity y;
    int before = 1;
    for (int d = 1;; ++d) {
        const int now = space.nullity(d, y);
        if (now < 0 || now > most) {
            y.grows = true;
            return y;
        }
        if (now == before) {
            y.multiplicity = now;
            y.order = d - 1;
            return y;
        }
        before = now;
    }
}

}  // namespace equilibria
