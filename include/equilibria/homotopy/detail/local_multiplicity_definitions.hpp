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
template <int Digits>
class DualSpace {
public:
    using S = Multiprecision<Digits>;
    using Z = Complex<S>;
    using Exponents = std::vector<int>;
    using Series = std::map<Exponents, Z>;

    static constexpr double smallest_pivot = 1e-26;
    static constexpr std::size_t most_columns = 230;

    DualSpace(const RuntimeSizes& sizes, const std::vector<LaurentColumn>& columns, std::vector<Z> at)
        : n_(static_cast<std::size_t>(sizes.unknowns)), columns_(&columns), at_(std::move(at)) {
        for (const Z& z : at_) unit_.push_back(z.re == S(0) && z.im == S(0) ? Z(1.0) : z);
    }
    /// The point, and the units of the unknowns, of another number of digits.
    template <int Other>
    explicit DualSpace(const DualSpace<Other>& a) : n_(a.n_), columns_(a.columns_) {
        for (const auto& z : a.at_) at_.emplace_back(S(z.re), S(z.im));
        for (const auto& z : a.unit_) unit_.emplace_back(S(z.re), S(z.im));
    }

    /// The nullity at order d; -1 where the matrix is too large.
    int nullity(int d, LocalMultiplicity& y) const {
        const Monomials monomials(n_, d);
        if (monomials.list.size() > most_columns) return -1;
        auto equations = series(d);
        for (Series& f : equations)
            if (const auto value = f.find(Exponents(n_)); value != f.end()) {
                y.largest_dropped = std::max(y.largest_dropped, size_of(value->second));
                f.erase(value);
            }
        auto rows = macaulay(equations, monomials, d);
        return static_cast<int>(monomials.list.size()) - rank(rows, y);
    }

    /// Moves the point to the mean of the m roots next to it, whose dual space has the order d; false where the series
    /// do not tell them from others. Of order d + 1, the functionals at the roots differ from those at the point by the
    /// square of the distance: so each step doubles the digits. The traces of the multiplication matrices, which the
    /// functionals are columns of, add up the roots' coordinates.
    bool move_to_mean(int m, int d) {
        const Monomials monomials(n_, d + 1);
        double before = 1;
        for (int step = 0; step < 12; ++step) {
            const auto functionals = dual_basis(macaulay(series(d + 1), monomials, d + 1), monomials, m);
            if (functionals.empty()) return false;
            double moved = 0;
            for (std::size_t u = 0; u < n_; ++u) {
                Z trace(0.0);
                for (const auto& [own, c] : functionals) {
                    Exponents next = monomials.list[own];
                    ++next[u];
                    const auto at = monomials.number.find(next);
                    if (at == monomials.number.end()) return false;
                    trace += c[at->second];
                }
                const Z by = trace / S(m);
                at_[u] += unit_[u] * by;
                moved = std::max(moved, size_of(by));
            }
            if (!(moved < before)) return moved < std::pow(10.0, -0.75 * Digits);
            before = moved;
        }
        return true;
    }

private:
    template <int>
    friend class DualSpace;

    /// The monomials up to a degree, and their numbers.
    struct Monomials {
        Monomials(std::size_t n, int degree) {
            Exponents e(n);
            add(0, degree, e);
            for (std::size_t k = 0; k < list.size(); ++k) number[list[k]] = k;
        }
        void add(std::size_t u, int left, Exponents& e) {
            if (u == e.size()) {
                list.push_back(e);
                return;
            }
            for (int k = 0; k <= left; ++k) {
                e[u] = k;
                add(u + 1, left - k, e);
            }
            e[u] = 0;
        }
        std::vector<Exponents> list;
        std::map<Exponents, std::size_t> number;
    };
    using Rows = std::vector<std::vector<Z>>;

    /// The rows of Macaulay's matrix: each series times each monomial of degree d - 1 at most.
    Rows macaulay(const std::vector<Series>& equations, const Monomials& monomials, int d) const {
        Rows rows;
        for (const Series& f : equations) {
            for (const Exponents& by : monomials.list) {
                if (degree(by) > d - 1) continue;
                std::vector<Z> row(monomials.list.size(), Z(0.0));
                for (const auto& [at, c] : f) {
                    Exponents sum = at;
                    for (std::size_t u = 0; u < n_; ++u) sum[u] += by[u];
                    if (const auto k = monomials.number.find(sum); k != monomials.number.end()) row[k->second] = c;
                }
                rows.push_back(std::move(row));
            }
        }
        return rows;
    }
    /// The m functionals that vanish on all rows but for what is dropped, each with the number of the monomial on which
    /// it alone is 1; none where a pivot is too small. The monomials of the highest degree are eliminated first.
    std::vector<std::pair<std::size_t, std::vector<Z>>> dual_basis(Rows a, const Monomials& monomials, int m) const {
        const std::size_t columns = monomials.list.size();
        const int highest = degree(*std::ranges::max_element(monomials.list, {}, degree));
        const auto wanted = columns - static_cast<std::size_t>(m);
        if (a.size() < wanted) return {};
        const std::size_t none = a.size();
        std::vector<std::size_t> pivot_of(columns, none);
        std::size_t high = 0;
        for (const Exponents& e : monomials.list) high += degree(e) == highest;
        std::vector<char> used(a.size());
        for (std::size_t r = 0; r < wanted; ++r) {
            const Pivot p = largest(a, used, [&](std::size_t j) {
                return pivot_of[j] == none && (r >= high || degree(monomials.list[j]) == highest);
            });
            if (!(p.size > smallest_pivot)) return {};
            used[p.row] = 1, pivot_of[p.column] = p.row;
            const Z by = inverse(a[p.row][p.column]);
            for (Z& z : a[p.row])
                if (!is_zero(z)) z *= by;
            eliminate(a, p, [&](std::size_t i) { return i != p.row; });
        }
        std::vector<std::pair<std::size_t, std::vector<Z>>> y;
        for (std::size_t own = 0; own < columns; ++own) {
            if (pivot_of[own] != none) continue;
            std::vector<Z> c(columns, Z(0.0));
            c[own] = Z(1.0);
            for (std::size_t j = 0; j < columns; ++j)
                if (pivot_of[j] != none) c[j] = -a[pivot_of[j]][own];
            y.emplace_back(own, std::move(c));
        }
        return y;
    }
    struct Pivot {
        double size;
        std::size_t row, column;
    };
    template <class F>
    static Pivot largest(const Rows& a, const std::vector<char>& used, const F& may) {
        Pivot y{-1, 0, 0};
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (used[i]) continue;
            for (std::size_t j = 0; j < a[i].size(); ++j)
                if (may(j))
                    if (const double size = size_of(a[i][j]); size > y.size) y = {size, i, j};
        }
        return y;
    }
    /// Subtracts the pivot's row, whose pivot is 1, from others.
    template <class F>
    static void eliminate(Rows& a, const Pivot& p, const F& from) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            const Z f = a[i][p.column];
            if (!from(i) || is_zero(f)) continue;
            for (std::size_t j = 0; j < a[i].size(); ++j)
                if (!is_zero(a[p.row][j])) a[i][j] -= f * a[p.row][j];
            a[i][p.column] = Z(0.0);
        }
    }
    static bool is_zero(const Z& z) { return z.re == S(0) && z.im == S(0); }
    static double size_of(const Z& z) {
        return std::abs(static_cast<double>(z.re)) + std::abs(static_cast<double>(z.im));
    }
    static int degree(const Exponents& e) {
        int y = 0;
        for (const int k : e) y += k;
        return y;
    }
    /// Each equation to the order d, the sizes of its terms adding up to 1: unknowns against their size, those that are
    /// 0 as they are.
    std::vector<Series> series(int d) const {
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
                if (is_zero(at_[u])) {
                    add(product, k, Z(1.0));
                } else {
                    Z by = pow(at_[u], k);
                    const Z ratio = unit_[u] / at_[u];
                    for (int m = 0; m <= d; ++m) {  // binomials of k, which may be negative
                        add(product, m, by);
                        by = ((static_cast<double>(k - m) * by) / S(m + 1)) * ratio;
                        if (k >= 0 && m >= k) break;
                    }
                }
                product = std::move(next);
            }
            for (const auto& [at, value] : product) {
                Z& sum = y[static_cast<std::size_t>(c.equation)].try_emplace(at, Z(0.0)).first->second;
                sum += value;
            }
            S term = hypot(S(c.to.real()), S(c.to.imag()));
            for (std::size_t u = 0; u < n_; ++u) term *= power_of_size(u, c.exponents[u]);
            size[static_cast<std::size_t>(c.equation)] += term;
        }
        for (std::size_t i = 0; i < n_; ++i) {
            if (!(size[i] > S(0))) continue;
            const S by = S(1) / size[i];
            for (auto& [_, value] : y[i]) value = by * value;
        }
        return y;
    }
    S power_of_size(std::size_t u, int k) const {
        const S size = sqrt(norm2(is_zero(at_[u]) || (k > 0 && norm2(at_[u]) < norm2(unit_[u])) ? unit_[u] : at_[u]));
        S y(1);
        for (int j = 0; j < std::abs(k); ++j) y *= size;
        return k < 0 ? S(1) / y : y;
    }
    /// By elimination with full pivots, whose sizes count against those of the equations' terms.
    static int rank(Rows& a, LocalMultiplicity& y) {
        if (a.empty()) return 0;
        const std::size_t columns = a.front().size();
        std::vector<char> used(a.size());
        for (std::size_t r = 0; r < std::min(a.size(), columns); ++r) {
            const Pivot p = largest(a, used, [](std::size_t) { return true; });
            if (!(p.size > smallest_pivot)) {
                y.largest_dropped = std::max(y.largest_dropped, p.size);
                return static_cast<int>(r);
            }
            y.smallest_kept = std::min(y.smallest_kept, p.size);
            used[p.row] = 1;
            const Z by = inverse(a[p.row][p.column]);
            for (Z& z : a[p.row])
                if (!is_zero(z)) z *= by;
            eliminate(a, p, [&](std::size_t i) { return !used[i]; });
        }
        return static_cast<int>(std::min(a.size(), columns));
    }

    std::size_t n_;
    const std::vector<LaurentColumn>* columns_;
    std::vector<Z> at_;
    std::vector<Z> unit_;  ///< of the series' unknowns
};

/// The dimension of the dual space, by the first order at which it does not grow.
template <int Digits>
LocalMultiplicity multiplicity_at(const DualSpace<Digits>& space, int most) {
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

/// Whether the multiplicity is the same at the mean of the roots, with more digits.
template <int Digits>
bool is_confirmed(const DualSpace<64>& space, const LocalMultiplicity& y, int most, double zero) {
    DualSpace<Digits> sharper(space);
    if (!sharper.move_to_mean(y.multiplicity, y.order)) return false;
    const LocalMultiplicity again = multiplicity_at(sharper, most);
    return again.multiplicity == y.multiplicity && again.smallest_kept > 1e-13 && again.largest_dropped < zero;
}

/// The exponent by 10 of the smallest term of the target at a point, against the largest of its equation; unknowns that
/// are 0 there count as 1. log_z: the decimal logarithms of the unknowns' sizes.
EQUILIBRIA_INLINE double smallest_term_exponent(const std::vector<LaurentColumn>& columns,
                                                const std::vector<double>& log_z) {
    std::map<int, std::pair<double, double>> ends;
    for (const LaurentColumn& c : columns) {
        if (c.to == 0.0) continue;
        double size = std::log10(std::abs(c.to));
        for (std::size_t u = 0; u < log_z.size(); ++u) size += c.exponents[u] * log_z[u];
        auto& [low, high] = ends.try_emplace(c.equation, size, size).first->second;
        low = std::min(low, size), high = std::max(high, size);
    }
    double y = 0;
    for (const auto& [_, own] : ends) y = std::min(y, own.first - own.second);
    return y;
}

}  // namespace detail

EQUILIBRIA_INLINE LocalMultiplicity local_multiplicity(const RuntimeSizes& sizes,
                                                       const std::vector<LaurentColumn>& columns,
                                                       const std::vector<const PathLimit*>& limits, std::size_t level,
                                                       int most) {
    using S = detail::DualSpace<64>::S;
    using Z = detail::DualSpace<64>::Z;
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
    std::vector<double> log_z;
    for (const Z& z : mean) {
        const double size = std::hypot(static_cast<double>(z.re), static_cast<double>(z.im));
        log_z.push_back(size > 0 ? std::log10(size) : 0);
    }
    const detail::DualSpace<64> space(sizes, columns, std::move(mean));
    LocalMultiplicity y = detail::multiplicity_at(space, most);
    // a gap between what counted as 0 and what did not
    if (y.grows || !(y.smallest_kept > 1e-13) || !(y.largest_dropped < 1e-27)) return y;
    // roots that a term of size e keeps apart differ by values of e^m at their mean
    const double apart = y.multiplicity * detail::smallest_term_exponent(columns, log_z);
    if (apart > -80)
        y.confirmed = detail::is_confirmed<LocalMultiplicity::digits>(space, y, most, LocalMultiplicity::zero);
    else if (apart > -280)
        y.confirmed = detail::is_confirmed<400>(space, y, most, 1e-300);
    return y;
}

}  // namespace equilibria
