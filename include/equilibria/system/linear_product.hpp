/// \file
/// Multihomogeneous homotopies: the unknowns in groups, and linear-product start systems with as many solutions as the
/// multihomogeneous number of Bezout, which can be far below the total degree.
///
/// Equation i of degree d_ig in group g starts as a product of d_ig linear forms of each group g. A start solution
/// chooses a form of each equation, as many of each group as it has unknowns, and makes the chosen ones vanish. The
/// forms of angles are linear in the cosines alone, so that the choice is a linear system, with two sines for each
/// cosine.
/// Source: Morgan, Sommese, A homotopy for solving general polynomial systems that respects m-homogeneous structures,
/// 1987; Verschelde, Cools, Symbolic homotopy construction, 1993 (linear products).
#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/core/linear_solve.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/core/static_for.hpp>
#include <equilibria/model/derivatives.hpp>

namespace equilibria {

/// A model with the terms of its start system added to its support. M names the groups: `static constexpr Grouping<M>
/// grouping`. Parameters: those of M, then the weight w of M's equations, then the forms; the polynomials are
/// w F + (1 - w) G, `equations` those of M.
template <Model M>
struct LinearProduct {
    static constexpr int n_angles = equilibria::n_angles<M>;
    static constexpr int n_coordinates = equilibria::n_coordinates<M>;
    static constexpr int n = n_unknowns<M>;
    static constexpr int groups = detail::n_groups(M::grouping);
    static constexpr int weight = equilibria::n_parameters<M>;
    static constexpr int first_form = weight + 1;

    using Degrees = Array<Array<int, groups>, n>;  ///< of each equation in each group
    /// The degrees of the terms for which keep(k), k the number in M's support, is true.
    static constexpr Degrees degrees_of(const auto& keep) {
        Degrees y{};
        for (int k = 0; k < Formulation<M>::terms; ++k) {
            if (!keep(k)) continue;
            const auto& term = Formulation<M>::support[k];
            Array<int, groups> d{};
            for (int u = 0; u < n; ++u) d[M::grouping[u]] += term.monomial.degree(u);
            for (int g = 0; g < groups; ++g) y[term.equation][g] = std::max(y[term.equation][g], d[g]);
        }
        return y;
    }
    static constexpr Degrees degrees = degrees_of([](int) { return true; });
    static constexpr Array<int, groups> sizes = [] {
        Array<int, groups> y{};
        for (int g : M::grouping) ++y[g];
        return y;
    }();
    static constexpr int form_entries = [] {
        int entries = 0;
        for (int i = 0; i < n; ++i)
            for (int g = 0; g < groups; ++g) entries += degrees[i][g] * (sizes[g] + 1);
        return entries;
    }();
    static constexpr int n_parameters = first_form + form_entries;

    /// Calls take(i, g, k, at): the form number k of equation i in group g has its constant at the parameter `at`, and
    /// the factors of the group's unknowns, in order, behind it.
    static constexpr void for_each_form(const auto& take) {
        int at = first_form;
        for (int i = 0; i < n; ++i)
            for (int g = 0; g < groups; ++g)
                for (int k = 0; k < degrees[i][g]; ++k, at += sizes[g] + 1) take(i, g, k, at);
    }

    static constexpr auto own(const auto& p) {
        using P = std::remove_cvref_t<decltype(p[0])>;
        Parameters<M, P> q;
        for (int k = 0; k < q.size(); ++k) q[k] = p[k];
        return q;
    }
    constexpr auto equations(const auto& theta, const auto& p) const requires(n_coordinates == 0) {
        using S = scalar_of<decltype(theta)>;
        if constexpr (PotentialModel<M>)
            return detail::equations_at<M, S>(theta, detail::CoordinatesOf<M, S>(), own(p));
        else
            return M{}.equations(theta, own(p));
    }
    constexpr auto equations(const auto& theta, const auto& x, const auto& p) const requires(n_coordinates != 0) {
        if constexpr (PotentialModel<M>)
            return detail::equations_at<M, std::remove_cvref_t<decltype(x[0])>>(theta, x, own(p));
        else
            return M{}.equations(theta, x, own(p));
    }

    template <class C>
    static constexpr auto polynomials(const Array<C, n_parameters>& p) {
        using Polynomial = TrigonometricPolynomial<n_angles, n_coordinates, C>;
        std::vector<Polynomial> start(static_cast<std::size_t>(n), Polynomial(C(1) - p[weight]));
        for_each_form([&](int i, int g, int, int at) {
            Polynomial form(p[at]);
            for (int u = 0; u < n; ++u)
                if (M::grouping[u] == g) form += Polynomial(Polynomial::Basis::single(u, 1), p[++at]);
            start[static_cast<std::size_t>(i)] *= form;
        });
        auto f = detail::symbolic_equations<M, C>(own(p));
        for (std::size_t i = 0; i < f.size(); ++i) f[i] = f[i] * Polynomial(p[weight]) + start[i];
        return f;
    }
};

/// A linear-product start of M at given parameters: the coefficients of the start system on the support of
/// LinearProduct<M>, and its solutions.
template <Model M>
struct LinearProductStart {
    using System = LinearProduct<M>;
    using Number = std::complex<double>;
    Parameters<System> target;
    Array<Number, Formulation<System>::terms> coefficients;
    std::vector<Array<Number, n_unknowns<M>>> solutions;  ///< angles (complex), then coordinates

    /// Degrees are those of the terms that M has at p: terms whose coefficient is 0 cost no paths.
    LinearProductStart(const Parameters<M>& p, Generator& generator) {
        for (int k = 0; k < p.size(); ++k) target[k] = p[k];
        for (int k = 0; k < start_.size(); ++k) start_[k] = k < p.size() ? Number(p[k]) : Number(0);
        target[System::weight] = 1;
        const auto own = equilibria::coefficients<M, double>(p);
        const auto degrees = System::degrees_of([&](int k) { return own[k] != 0; });
        System::for_each_form([&](int i, int g, int k, int at) {
            if (k < degrees[i][g]) {
                forms_[static_cast<std::size_t>(i)].push_back({g, at});
                double norm2 = 0;
                for (int m = 0; m <= System::sizes[g]; ++m) {
                    const double size = uniform(generator, 0.5, 1);
                    start_[at + m] = size * unit_complex(generator);
                    norm2 += size * size;
                }
                for (int m = 0; m <= System::sizes[g]; ++m) start_[at + m] /= std::sqrt(norm2);
            } else {
                start_[at] = 1;
            }
            target[at] = 0;
        });
        coefficients = equilibria::coefficients<System, Number>(start_);
        weigh(own);
        Array<int, System::groups> left = System::sizes;
        choose(0, left);
    }

private:
    struct Form {
        int group, at;
    };

    /// Scales each equation of the start system to the largest coefficient of M's own.
    void weigh(const auto& own) {
        using F = Formulation<System>;
        for (int i = 0; i < System::n; ++i) {
            double here = 0, there = 0;
            for (int k = F::first[i]; k < F::first[i + 1]; ++k) here = std::max(here, std::abs(coefficients[k]));
            for (int k = Formulation<M>::first[i]; k < Formulation<M>::first[i + 1]; ++k)
                there = std::max(there, std::abs(own[k]));
            for (int k = F::first[i]; k < F::first[i + 1]; ++k) coefficients[k] *= there / here;
        }
    }

    void choose(int i, Array<int, System::groups>& left) {
        if (i == System::n) return solve();
        for (const Form& form : forms_[static_cast<std::size_t>(i)]) {
            if (left[form.group] == 0) continue;
            --left[form.group];
            chosen_[i] = form;
            choose(i + 1, left);
            ++left[form.group];
        }
    }

    /// The solutions of the chosen forms.
    void solve() {
        Array<Number, System::n> q;
        static_for<System::groups>([&](auto g) {
            constexpr int size = System::sizes[g];
            Complex<double> a[size][size], y[size];
            int row = 0;
            const auto number = [&](int at) { return Complex<double>(start_[at].real(), start_[at].imag()); };
            for (const Form& form : chosen_) {
                if (form.group != g) continue;
                y[row] = -number(form.at);
                for (int m = 0; m < size; ++m) a[row][m] = number(form.at + 1 + m);
                ++row;
            }
            PivotedFactorization<double, size> lu;
            lu.factor(a);
            lu.solve(y);
            for (int u = 0, m = 0; u < System::n; ++u) {
                if (M::grouping[u] != g) continue;
                const Number root(y[m].re, y[m].im);
                q[u] = u < n_angles<M> ? std::acos(root) : root;
                ++m;
            }
        });
        for (unsigned signs = 0; signs < 1u << n_angles<M>; ++signs) {
            auto root = q;
            for (int u = 0; u < n_angles<M>; ++u)
                if (signs >> u & 1) root[u] = -root[u];
            solutions.push_back(root);
        }
    }

    Parameters<System, Number> start_;
    Array<std::vector<Form>, System::n> forms_;
    Array<Form, System::n> chosen_;
};

}  // namespace equilibria
