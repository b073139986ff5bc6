/// \file
/// Degenerate equilibria of a model as the solutions of polynomial systems: what `enumerate` does for equilibria is
/// done for folds, cusps and the extremal points of a locus, all of them, every path accounted for.
///
/// Unknowns: the model's q, then w (n - 1 numbers), then the active parameters x. Equations:
///     F(q, p) = 0,    J(q, p) v = 0,    v = B (1, w),                        and with two active parameters
///     slice + sum_k extremal_k v . dF/dx_k + cusp V'''[v, v, v] = 0,         slice = s_0 + s_1 x_1 + s_2 x_2,
/// with a random basis B, so that no null vector is at infinity in w. The weights in the last equation choose what is
/// solved for: the folds of a line of the plane (slice); the points at which the locus has a tangent normal to x_1
/// (extremal_2 = 1: there v . dF/dx_2 = 0), folds of the fold curve over the axis of x_1; or its cusps. A parameter
/// that enters by even powers alone is replaced by its square, which halves degrees and solutions, and equations are
/// divided by powers of active parameters that all their terms have: solutions at 0 of such a parameter, where that
/// equation would vanish identically, are left out.
///
/// The systems are data, made at run time by symbolic differentiation of the model's own equations, over doubles to be
/// solved and over exact numbers to be proved. Pitchforks on symmetric branches are singular solutions; they are found
/// on those branches (symmetric_branches.hpp, symmetric_system.hpp). Source: Govaerts, Numerical Methods for
/// Bifurcations of Dynamical Equilibria, SIAM, 2000, chapter 4.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/system/model_polynomials.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// How the active parameters enter a model's equations.
struct ActiveEntry {
    /// x_k is the power[k]-th power (1 or 2) of the active parameter number k over its scale.
    std::array<int, 2> power{};
    /// The highest power of that parameter in F.
    std::array<int, 2> degree{};
    /// Equations i of F and of J v are divided by prod_k x_k^content[i][k].
    std::vector<std::array<int, 2>> content;

    /// Equation i divided so, x_k being the coordinate first + k.
    template <class C>
    RuntimePolynomial<C> divided(const RuntimePolynomial<C>& equation, int i, int first) const {
        const auto& by = content[static_cast<std::size_t>(i)];
        return with_exponents(equation, first,
                              [&by](int k, int code) { return code - by[static_cast<std::size_t>(k)]; });
    }
    /// F in x_k, where it was in the parameters over their scales.
    template <class C>
    RuntimePolynomials<C> in_powers(RuntimePolynomials<C> f, int first) const {
        for (auto& equation : f)
            equation = with_exponents(equation, first,
                                      [this](int k, int code) { return code / power[static_cast<std::size_t>(k)]; });
        return f;
    }

private:
    /// With other exponents change(k, exponent) of x_k.
    template <class C>
    static RuntimePolynomial<C> with_exponents(const RuntimePolynomial<C>& f, int first, const auto& change) {
        RuntimePolynomial<C> y;
        for (const auto& term : f.terms()) {
            auto monomial = term.monomial;
            for (int k = 0; k < 2; ++k) {
                const int u = most_angles + first + k;
                if (monomial.code(u) != 0) monomial.set_code(u, change(k, monomial.code(u)));
            }
            y += RuntimePolynomial<C>(monomial, term.coefficient);
        }
        return y;
    }
};

/// v = B (1, w), w being the coordinates from number `first` on.
template <class C>
RuntimePolynomials<C> null_vector_polynomials(const RuntimeMatrix<double>& basis, int first) {
    RuntimePolynomials<C> v;
    for (int i = 0; i < basis.size(); ++i) {
        RuntimePolynomial<C> sum = RuntimePolynomial<C>(C(basis[i][0]));
        for (int k = 1; k < basis.size(); ++k)
            sum += RuntimePolynomial<C>(RuntimePolynomial<C>::Basis::single(most_angles + first + k - 1, 1),
                                        C(basis[i][k]));
        v.push_back(sum);
    }
    return v;
}

/// The critical systems of a model with one or two active parameters.
class CriticalSystem {
public:
    /// The model's polynomials have to outlive it. active: the numbers of one or two parameters, different ones. Throws
    /// InvalidArgument for others, and as model_polynomials does.
    CriticalSystem(const ModelPolynomials& model, std::span<const int> active);

    /// What the equations depend on.
    struct Numbers {
        RuntimeArray<double> p;       ///< of the model; the active ones are not read
        std::vector<double> scale;    ///< of the active ones: x_k is of the size of 1
        RuntimeMatrix<double> basis;  ///< B, row by row
        // with two active parameters, of the last equation:
        std::array<double, 3> slice{};     ///< s_1, s_2, s_0
        std::array<double, 2> extremal{};  ///< weights of v . dF/dx_k
        double cusp = 0;                   ///< weight of V'''[v, v, v]
        RuntimeArray<double> sine;         ///< r
    };

    const ModelPolynomials& model() const { return *model_; }  ///< the one it was made from
    std::span<const int> active() const { return active_; }    ///< numbers of the active parameters, in the order of x
    int actives() const { return static_cast<int>(active_.size()); }  ///< how many parameters are active: 1 or 2
    const ActiveEntry& entry() const { return entry_; }               ///< how they enter the equations
    /// Of the system: angles, then the model's coordinates, w, x and, off symmetric branches, y.
    const RuntimeSizes& sizes() const { return sizes_; }
    int first_null() const { return model_->sizes().coordinates; }     ///< the coordinate w_1
    int first_active() const { return first_null() + unknowns_ - 1; }  ///< the coordinate x_1
    int reciprocal() const { return first_active() + actives(); }      ///< the coordinate y
    /// With two active parameters symmetric branches hold curves of solutions, the pitchforks. They are sent to
    /// infinity by one more unknown and equation, y sum_i r_i sin theta_i = 1.
    bool off_symmetric_branches() const { return actives() == 2 && model_->reflection_symmetric(); }
    /// {q}, {w}, {x_1}, {x_2}
    const std::vector<int>& grouping() const { return grouping_; }

    /// The numbers for those of the model: random B and r, weights 0. scales: of the active parameters, positive.
    Numbers numbers(const RuntimeArray<double>& p, std::vector<double> scales, Generator& generator) const;

    /// The active parameter number k from its unknown x_k, and back; `scale` is that of Numbers.
    /// \{
    double parameter(int k, double x, double scale) const {
        return scale * (entry_.power[static_cast<std::size_t>(k)] == 2 ? std::sqrt(x) : x);
    }
    double unknown(int k, double parameter, double scale) const {
        const double x = parameter / scale;
        return entry_.power[static_cast<std::size_t>(k)] == 2 ? x * x : x;
    }
    /// \}

    /// The equations over the numbers C, from the model's (see model_polynomials, of first_active) over them.
    template <class C>
    RuntimePolynomials<C> equations(const Numbers& numbers, RuntimePolynomials<C> model) const {
        const auto f = entry_.in_powers(std::move(model), first_active());
        const auto v = null_vector_polynomials<C>(numbers.basis, first_null());
        RuntimePolynomials<C> jv, y;
        for (const auto& equation : f) jv.push_back(along(equation, v));
        for (int i = 0; i < unknowns_; ++i) y.push_back(entry_.divided(f[at(i)], i, first_active()));
        for (int i = 0; i < unknowns_; ++i) y.push_back(entry_.divided(jv[at(i)], i, first_active()));
        if (actives() == 2) y.push_back(last_equation(numbers, f, jv, v));
        if (off_symmetric_branches()) {
            RuntimePolynomial<C> sum;
            for (int i = 0; i < sizes_.angles; ++i)
                sum += RuntimePolynomial<C>(RuntimePolynomial<C>::Basis::single(i, -1), C(numbers.sine[i]));
            y.push_back(sum * coordinate_polynomial<C>(reciprocal()) - RuntimePolynomial<C>(1));
        }
        return y;
    }
    /// The same over doubles, from the model's polynomials at the numbers' parameters.
    RuntimePolynomials<> equations(const Numbers& numbers) const;
    /// The system to be solved.
    SparseSystem system(const Numbers& numbers) const;

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    /// The unknown number i of the model in a polynomial.
    int unknown_code(int i) const { return i < sizes_.angles ? i : most_angles + i - sizes_.angles; }
    ActiveEntry find_entry() const;

    /// The derivative by q along v.
    template <class C>
    RuntimePolynomial<C> along(const RuntimePolynomial<C>& f, const RuntimePolynomials<C>& v) const {
        RuntimePolynomial<C> y;
        for (int k = 0; k < unknowns_; ++k) y += derivative(f, unknown_code(k)) * v[at(k)];
        return y;
    }
    template <class C>
    RuntimePolynomial<C> last_equation(const Numbers& numbers, const RuntimePolynomials<C>& f,
                                       const RuntimePolynomials<C>& jv, const RuntimePolynomials<C>& v) const {
        using Polynomial = RuntimePolynomial<C>;
        Polynomial y(C(numbers.slice[2]));
        for (int k = 0; k < 2; ++k)
            if (numbers.slice[at(k)] != 0)
                y += Polynomial(C(numbers.slice[at(k)])) * coordinate_polynomial<C>(first_active() + k);
        if (!model_->has_potential()) return y;  // left null vectors would be needed
        if (numbers.cusp != 0)
            for (int i = 0; i < unknowns_; ++i) y += Polynomial(C(numbers.cusp)) * (along(jv[at(i)], v) * v[at(i)]);
        for (int k = 0; k < 2; ++k)
            if (numbers.extremal[at(k)] != 0)
                for (int i = 0; i < unknowns_; ++i)
                    y += Polynomial(C(numbers.extremal[at(k)])) *
                         (derivative(f[at(i)], most_angles + first_active() + k) * v[at(i)]);
        return y;
    }

    const ModelPolynomials* model_;
    std::vector<int> active_;
    int unknowns_;  ///< of the model
    RuntimeSizes sizes_;
    std::vector<int> grouping_;
    ActiveEntry entry_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/system/detail/critical_system_definitions.hpp>
#endif
