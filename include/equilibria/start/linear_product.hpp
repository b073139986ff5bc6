/// \file
/// Multihomogeneous homotopies: the unknowns in groups, and linear-product start systems with as many solutions as the
/// multihomogeneous number of Bezout, which can be far below the total degree.
///
/// Equation i of degree d_ig in group g starts as a product of d_ig linear forms of each group g. A start solution
/// chooses a form of each equation, as many of each group as it has unknowns, and makes the chosen ones vanish. The
/// forms of angles are linear in the cosines alone, so that the choice is a linear system, with two sines for each
/// cosine. The products are evaluated as they are: multiplied out, they would have ten times the terms of the target.
/// Source: Morgan, Sommese, A homotopy for solving general polynomial systems that respects m-homogeneous structures,
/// Appl. Math. Comput. 24 (1987); Verschelde, Cools, Symbolic homotopy construction, Appl. Algebra Engrg. Comm. Comput.
/// 4 (1993) (linear products).
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/core/random.hpp>
#include <equilibria/evaluation/factor_series.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

namespace detail {
template <class H, class R>
class LinearProductForm;
}

/// G_i = product of linear forms; H = (1-t) gamma G + t F.
template <int Angles, int Coordinates>
class LinearProduct {
public:
    using Unknowns = UnknownsOf<Angles, Coordinates>;
    using System = SparseSystem<Angles, Coordinates>;
    using Number = std::complex<double>;
    using Solution = Array<Number, n_unknowns<Unknowns>>;
    static constexpr int n = n_unknowns<Unknowns>;
    static constexpr bool moving = false;
    static constexpr int law_order = 0;
    static constexpr std::string_view name() { return "linear product"; }
    template <class H, class R>
    using Form = detail::LinearProductForm<H, R>;

    /// constant + sum over the unknowns of its group of factor times cos theta, or x.
    struct LinearForm {
        int group;
        Number constant;
        std::vector<Number> factors;
    };

    /// grouping: the group of each unknown, numbers from 0, none left out. Degrees are those of the terms that the
    /// target has: each equation is scaled to its largest coefficient.
    LinearProduct(const System& target, const Array<int, n>& grouping, Number gamma, Generator& generator) {
        for (int u = 0; u < n; ++u) {
            members_.resize(std::max(members_.size(), static_cast<std::size_t>(grouping[u]) + 1));
            members_[static_cast<std::size_t>(grouping[u])].push_back(u);
        }
        const std::size_t groups = members_.size();
        std::vector<std::vector<int>> degrees(static_cast<std::size_t>(n), std::vector<int>(groups));
        for (const auto& term : target.terms()) {
            std::vector<int> d(groups);
            for (int u = 0; u < n; ++u) d[static_cast<std::size_t>(grouping[u])] += term.monomial.degree(u);
            auto& most = degrees[static_cast<std::size_t>(term.equation)];
            for (std::size_t g = 0; g < groups; ++g) most[g] = std::max(most[g], d[g]);
        }
        for (int i = 0; i < n; ++i)
            for (std::size_t g = 0; g < groups; ++g)
                for (int k = 0; k < degrees[static_cast<std::size_t>(i)][g]; ++k)
                    forms_[i].push_back(draw(static_cast<int>(g), generator));
        for (int i = 0; i < n; ++i) weight_[i] = gamma * target.scale()[i] / largest_coefficient(i);
        std::vector<std::size_t> left;
        for (const auto& members : members_) left.push_back(members.size());
        choose(0, left);
    }

    const std::vector<typename System::Term>& terms(const System& target) const { return target.terms(); }
    const std::vector<LinearForm>& forms(int equation) const { return forms_[equation]; }
    const std::vector<int>& members(int group) const { return members_[static_cast<std::size_t>(group)]; }
    /// What G_i is multiplied by, gamma included.
    Number weight(int equation) const { return weight_[equation]; }
    const std::vector<Solution>& solutions() const { return solutions_; }

    PathNumbering numbering() const { return PathNumbering::all(solutions_.size()); }
    Point<Unknowns, double> point(std::uint64_t k) const { return point_of<Unknowns>(solutions_[k]); }

private:
    /// A random form of length 1.
    LinearForm draw(int group, Generator& generator) const {
        LinearForm form{group, 0, std::vector<Number>(members(group).size())};
        double norm2 = 0;
        const auto number = [&](Number& z) {
            const double size = uniform(generator, 0.5, 1);
            z = size * unit_complex(generator);
            norm2 += size * size;
        };
        number(form.constant);
        for (Number& z : form.factors) number(z);
        form.constant /= std::sqrt(norm2);
        for (Number& z : form.factors) z /= std::sqrt(norm2);
        return form;
    }
    /// Of G_i, multiplied out.
    double largest_coefficient(int i) const {
        using Polynomial = TrigonometricPolynomial<Angles, Coordinates, Number>;
        Polynomial product(Number(1));
        for (const LinearForm& form : forms_[i]) {
            Polynomial sum(form.constant);
            for (std::size_t m = 0; m < form.factors.size(); ++m)
                sum += Polynomial(Polynomial::Basis::single(members(form.group)[m], 1), form.factors[m]);
            product *= sum;
        }
        return product.scale();
    }

    void choose(int i, std::vector<std::size_t>& left) {
        if (i == n) return solve();
        for (const LinearForm& form : forms_[i]) {
            std::size_t& here = left[static_cast<std::size_t>(form.group)];
            if (here == 0) continue;
            --here;
            chosen_[i] = &form;
            choose(i + 1, left);
            ++here;
        }
    }
    /// The solutions of the chosen forms.
    void solve() {
        Solution q;
        for (std::size_t g = 0; g < members_.size(); ++g) {
            const auto size = static_cast<Eigen::Index>(members_[g].size());
            Eigen::MatrixXcd a(size, size);
            Eigen::VectorXcd right(size);
            Eigen::Index row = 0;
            for (const LinearForm* form : chosen_) {
                if (form->group != static_cast<int>(g)) continue;
                right(row) = -form->constant;
                for (Eigen::Index m = 0; m < size; ++m) a(row, m) = form->factors[static_cast<std::size_t>(m)];
                ++row;
            }
            const Eigen::VectorXcd root = a.partialPivLu().solve(right);
            for (Eigen::Index m = 0; m < size; ++m) {
                const int u = members_[g][static_cast<std::size_t>(m)];
                q[u] = u < Angles ? std::acos(root(m)) : root(m);
            }
        }
        for (unsigned signs = 0; signs < 1u << Angles; ++signs) {
            Solution signed_root = q;
            for (int u = 0; u < Angles; ++u)
                if (signs >> u & 1) signed_root[u] = -signed_root[u];
            solutions_.push_back(signed_root);
        }
    }

    std::vector<std::vector<int>> members_;  ///< unknowns of each group
    Array<std::vector<LinearForm>, n> forms_;
    Array<Number, n> weight_;
    std::vector<Solution> solutions_;
    Array<const LinearForm*, n> chosen_{};
};

namespace detail {

/// gamma G, its Taylor coefficients and its Jacobian: a form and its series first, then products of forms.
template <class H, class R>
class LinearProductForm {
public:
    using S = typename H::System;
    using Z = Complex<R>;
    static constexpr int n = n_unknowns<S>;

    explicit LinearProductForm(const H& h) : start_(&h.start()) {
        for (int i = 0; i < n; ++i) {
            first_[i] = static_cast<int>(forms_.size());
            for (const auto& form : start_->forms(i)) {
                Entry entry{form.constant, {}};
                for (std::size_t m = 0; m < form.factors.size(); ++m) {
                    const int u = start_->members(form.group)[m];
                    entry.parts.push_back({u, h.tables().factor(u, 1), form.factors[m]});
                }
                forms_.push_back(std::move(entry));
            }
        }
        first_[n] = static_cast<int>(forms_.size());
        series_.resize(forms_.size());
        product_.resize(forms_.size());
    }

    void series(int k, const FactorSeries<S, R>& factors, Z (&g)[n]) {
        for (std::size_t m = 0; m < forms_.size(); ++m) {
            Z sum = k == 0 ? broadcast_complex<R>(forms_[m].constant) : zero();
            for (const Part& part : forms_[m].parts) sum += broadcast_complex<R>(part.by) * factors(k, part.factor);
            series_[m][k] = sum;
        }
        // product_[m]: of the forms of the equation up to number m
        for (int i = 0; i < n; ++i) {
            for (int m = first_[i]; m < first_[i + 1]; ++m) {
                const auto& form = series_[static_cast<std::size_t>(m)];
                auto& product = product_[static_cast<std::size_t>(m)];
                if (m == first_[i]) {
                    product[k] = broadcast_complex<R>(start_->weight(i)) * form[k];
                    continue;
                }
                const auto& before = product_[static_cast<std::size_t>(m) - 1];
                product[k] = before[0] * form[k];
                for (int l = 1; l <= k; ++l) product[k] += before[l] * form[k - l];
            }
            g[i] = product_[static_cast<std::size_t>(first_[i + 1]) - 1][k];
        }
    }

    /// After `series(0, ..)`.
    void slopes(const FactorSeries<S, R>& factors, Z (&j)[n][n]) const {
        for (int i = 0; i < n; ++i) {
            Z behind = broadcast_complex<R>(1.0);  // of the forms behind number m
            for (int m = first_[i + 1] - 1; m >= first_[i]; --m) {
                const auto at = static_cast<std::size_t>(m);
                const Z others = m == first_[i] ? Z(broadcast_complex<R>(start_->weight(i)) * behind)
                                                : Z(product_[at - 1][0] * behind);
                for (const Part& part : forms_[at].parts)
                    j[i][part.unknown] += others * (broadcast_complex<R>(part.by) * factors.slope(part.factor));
                behind = behind * series_[at][0];
            }
        }
    }

private:
    struct Part {
        int unknown, factor;
        std::complex<double> by;
    };
    struct Entry {
        std::complex<double> constant;
        std::vector<Part> parts;
    };
    struct Series {
        Z value[FactorSeries<S, R>::order + 1];
        Z& operator[](int k) { return value[k]; }
        const Z& operator[](int k) const { return value[k]; }
    };
    static Z zero() { return {broadcast<R>(0.0), broadcast<R>(0.0)}; }

    const std::remove_reference_t<decltype(std::declval<const H&>().start())>* start_;
    std::vector<Entry> forms_;
    int first_[n + 1];
    std::vector<Series> series_, product_;
};

}  // namespace detail

}  // namespace equilibria
