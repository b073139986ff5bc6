/// \file
/// The evaluation of a homotopy whose terms are known at compile time: H(q, t), its Jacobian in q, and its Taylor
/// coefficients along a path, every term code of its own. By loops over tables: table_evaluation.hpp.
///
/// Everything is generic over the real type R (double, a pack of lanes, a multiprecision float) and over the type of
/// the time: real along a path, complex in the loops of an endgame.
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>

#include <equilibria/core/complex.hpp>
#include <equilibria/core/static_for.hpp>
#include <equilibria/evaluation/evaluation_plan.hpp>
#include <equilibria/evaluation/point.hpp>

namespace equilibria {

namespace detail {

/// Evaluates a homotopy at points of type R, with Taylor coefficients along a path up to order 3.
template <class H, class R, class Time>
class UnrolledEvaluation {
public:
    using M = typename H::System;
    using Plan = typename H::Plan;
    using Z = Complex<R>;
    static constexpr int n = n_unknowns<M>;
    static constexpr int order = 3;
    static constexpr bool symmetric = H::symmetric;
    static constexpr bool moving = H::moving;

    explicit UnrolledEvaluation(const H& h) : h_(&h) {}

    /// H(q, t).
    void value(const Point<M, R>& q, const Time& t, auto& f) {
        prepare(q, t);
        for (int i = 0; i < n; ++i) f[i] = zero();
        static_for<Plan::n_groups>([&](auto g) {
            constexpr auto group = Plan::groups[g];
            accumulate(f[group.equation], own<g>(0), blend_[0][g]);
        });
    }

    /// H(q, t) and its Jacobian; with a potential only the entries on and above the diagonal are set.
    void jacobian(const Point<M, R>& q, const Time& t, auto& f, auto& j) {
        value(q, t, f);
        for (int r = 0; r < n; ++r)
            for (int c = symmetric ? r : 0; c < n; ++c) j[r][c] = zero();
        static_for<Plan::n_groups>([&](auto g) {
            constexpr auto group = Plan::groups[g];
            constexpr int i = group.equation;
            constexpr int own_factor = Plan::factor(i, group.own_code);
            if constexpr (own_factor >= 0) j[i][i] += derivative<own_factor, i>() * blend_[0][g];
            if constexpr (group.last > group.first) {
                Z row[n];
                bool used[n] = {};
                static_for<group.last - group.first>([&](auto k) {
                    constexpr int term = group.first + k, operand = Plan::operand[term];
                    if constexpr (operand >= 0)
                        static_for<n>([&](auto c) {
                            if constexpr (depends(operand, c) && (!symmetric || c > i)) {
                                const Z d = weighted<term>(derivative<operand, c>());
                                row[c] = used[c] ? row[c] + d : d;
                                used[c] = true;
                            }
                        });
                });
                const Z factor = scaled_own<g>(t);
                static_for<n>([&](auto c) {
                    if constexpr (touches(g, c)) {
                        if constexpr (own_factor >= 0 || !moving)
                            j[i][c] += factor * row[c];
                        else
                            j[i][c] += row[c];
                    }
                });
            }
        });
    }

    /// The Taylor coefficient k of -H(q(t), t), given those of q(t) below k and taking its k-th as zero: the
    /// right-hand side of J q_k = ... Call with k = 1, 2, ... after `jacobian`, and `set_coefficient` in between.
    void taylor_right_side(int k, auto& f) {
        extend_factors(k);
        for (int i = 0; i < n; ++i) f[i] = zero();
        static_for<Plan::n_groups>([&](auto g) {
            constexpr auto group = Plan::groups[g];
            constexpr int own_factor = Plan::factor(group.equation, group.own_code);
            sum_terms<g>(k);
            blend_[k][g] = blended<g>(k);
            if constexpr (own_factor < 0)
                f[group.equation] -= blend_[k][g];
            else
                for (int l = 0; l <= k; ++l) f[group.equation] -= factor_[l][own_factor] * blend_[k - l][g];
        });
    }
    /// Tells the k-th Taylor coefficient of q(t), once solved for.
    void set_coefficient(int k, const auto& d) {
        for (int u = 0; u < n; ++u) path_[k][u] = d[u];
        complete_factors(k);
    }

private:
    static Z zero() { return {broadcast<R>(0.0), broadcast<R>(0.0)}; }

    static constexpr bool depends(int operand, int unknown) {
        if (operand < 0) return false;
        if (operand < Plan::factors) return Plan::unknown_of(operand) == unknown;
        const auto node = Plan::nodes[operand - Plan::factors];
        return depends(node.left, unknown) || depends(node.right, unknown);
    }
    static constexpr bool touches(int g, int unknown) {
        if (symmetric && unknown <= Plan::groups[g].equation) return false;
        for (int k = Plan::groups[g].first; k < Plan::groups[g].last; ++k)
            if (depends(Plan::operand[k], unknown)) return true;
        return false;
    }

    // --- coefficients -------------------------------------------------------------------------------------------
    static auto number(double a) { return broadcast<R>(a); }
    static auto number(const std::complex<double>& a) { return broadcast_complex<R>(a); }

    /// coefficient(t) * v: with a total-degree start without the factor t.
    template <int Term>
    Z weighted(const Z& v) const {
        if constexpr (moving)
            return current_[Term] * v;
        else
            return number(h_->target(Term)) * v;
    }

    /// The own factor of a group, times t with a total-degree start.
    template <int G>
    Z scaled_own(const Time& t) const {
        constexpr auto group = Plan::groups[G];
        constexpr int f = Plan::factor(group.equation, group.own_code);
        if constexpr (moving) {
            if constexpr (f >= 0)
                return factor_[0][f];
            else
                return zero();
        } else {
            if constexpr (f >= 0)
                return t * factor_[0][f];
            else
                return zero() + t;
        }
    }
    template <int G>
    auto own(int k) const {
        constexpr auto group = Plan::groups[G];
        constexpr int f = Plan::factor(group.equation, group.own_code);
        if constexpr (f < 0)
            return 1;
        else
            return factor_[k][f];
    }
    static void accumulate(Z& sum, int, const Z& v) { sum += v; }
    static void accumulate(Z& sum, const Z& factor, const Z& v) { sum += factor * v; }

    // --- values at order 0 --------------------------------------------------------------------------------------
    void prepare(const Point<M, R>& q, const Time& t) {
        time_ = t;
        static_for<n>([&](auto u) {
            constexpr int first = Plan::factor_offset[u], k_max = Plan::highest(u);
            if constexpr (u < n_angles<M>) {
                factor_[0][first] = q.c[u];
                factor_[0][first + 1] = q.s[u];
                for (int k = 1; k < k_max; ++k) {
                    const Z& c = factor_[0][first + 2 * (k - 1)];
                    const Z& s = factor_[0][first + 2 * (k - 1) + 1];
                    factor_[0][first + 2 * k] = c * q.c[u] - s * q.s[u];
                    factor_[0][first + 2 * k + 1] = s * q.c[u] + c * q.s[u];
                }
            } else {
                path_[0][u] = factor_[0][first] = q.x[u - n_angles<M>];
                for (int k = 1; k < k_max; ++k) factor_[0][first + k] = factor_[0][first + k - 1] * factor_[0][first];
            }
        });
        multiply_nodes(0);
        if constexpr (moving)
            for (int k = 0; k < Formulation<M>::terms; ++k)
                current_[k] = number(h_->target(k)) - number(h_->difference(k)) * (1.0 - t);
        static_for<Plan::n_groups>([&](auto g) {
            sum_terms<g>(0);
            blend_[0][g] = blended<g>(0);
        });
    }

    template <int Operand>
    const Z& value_of(int k) const {
        return factor_[k][Operand];
    }
    void multiply_nodes(int k) {
        const auto multiply = [&](int m, int left, int right) {
            Z sum = factor_[0][left] * factor_[k][right];
            for (int l = 1; l <= k; ++l) sum += factor_[l][left] * factor_[k - l][right];
            factor_[k][Plan::factors + m] = sum;
        };
        static_for<Plan::n_nodes>([&](auto m) {
            constexpr auto node = Plan::nodes[m];
            multiply(m, node.left, node.right);
        });
    }

    /// P of the group, at order k; with a parameter homotopy also its change in time.
    template <int G>
    void sum_terms(int k) {
        constexpr auto group = Plan::groups[G];
        Z p = zero(), d = zero();
        static_for<group.last - group.first>([&](auto m) {
            constexpr int term = group.first + m, operand = Plan::operand[term];
            if constexpr (operand >= 0) {
                p += weighted<term>(value_of<operand>(k));
                if constexpr (moving) d += number(h_->difference(term)) * value_of<operand>(k);
            } else if (k == 0) {
                if constexpr (moving) {
                    p += current_[term];
                    d += number(h_->difference(term));
                } else {
                    p = p + number(h_->target(term));
                }
            }
        });
        sum_[k][G] = p;
        if constexpr (moving) change_[k][G] = d;
    }
    /// The Taylor coefficient k of (1-t) g + t P, or of P with its moving coefficients.
    template <int G>
    Z blended(int k) const {
        constexpr auto group = Plan::groups[G];
        Z y;
        if constexpr (moving) {
            y = sum_[k][G];
            if (k > 0) y += change_[k - 1][G];
        } else {
            y = time_ * sum_[k][G];
            if (k > 0) y += sum_[k - 1][G];
        }
        if constexpr (group.in_start) {
            const Z g = broadcast_complex<R>(h_->start(G));
            if (k == 0) y += (1.0 - time_) * g;
            if (k == 1) y -= g;
        }
        return y;
    }

    /// The derivative of an operand by one of its unknowns.
    template <int Operand, int U>
    Z derivative() const {
        if constexpr (Operand < Plan::factors) {
            constexpr int code = Plan::code_of(Operand);
            if constexpr (U < n_angles<M>) {
                constexpr double multiple = -code;  // (cos k)' = -k sin k, (sin k)' = k cos k
                const Z& other = factor_[0][Plan::factor(U, -code)];
                if constexpr (multiple == 1)
                    return other;
                else if constexpr (multiple == -1)
                    return -other;
                else
                    return multiple * other;
            } else if constexpr (code == 1) {
                return zero() + broadcast<R>(1.0);
            } else {
                return static_cast<double>(code) * factor_[0][Plan::factor(U, code - 1)];
            }
        } else {
            constexpr auto node = Plan::nodes[Operand - Plan::factors];
            if constexpr (depends(node.right, U))
                return value_of<node.left>(0) * derivative<node.right, U>();
            else
                return derivative<node.left, U>() * value_of<node.right>(0);
        }
    }

    // --- Taylor coefficients ------------------------------------------------------------------------------------
    /// (cos k theta)' = -k theta' sin k theta and (sin k theta)' = k theta' cos k theta, coefficient by coefficient.
    void extend_factors(int k) {
        static_for<n>([&](auto u) {
            constexpr int first = Plan::factor_offset[u], k_max = Plan::highest(u);
            path_[k][u] = zero();
            if constexpr (u < n_angles<M>) {
                for (int m = 1; m <= k_max; ++m) {
                    const int c = first + 2 * (m - 1), s = c + 1;
                    Z cosine = zero(), sine = zero();
                    for (int l = 1; l < k; ++l) {
                        const double weight = static_cast<double>(m * l) / k;
                        cosine -= weight * (path_[l][u] * factor_[k - l][s]);
                        sine += weight * (path_[l][u] * factor_[k - l][c]);
                    }
                    factor_[k][c] = cosine;
                    factor_[k][s] = sine;
                }
            } else {
                raise_powers<u>(k);
            }
        });
        multiply_nodes(k);
    }
    void complete_factors(int k) {
        static_for<n>([&](auto u) {
            constexpr int first = Plan::factor_offset[u], k_max = Plan::highest(u);
            if constexpr (u < n_angles<M>) {
                for (int m = 1; m <= k_max; ++m) {
                    const int c = first + 2 * (m - 1), s = c + 1;
                    const Z step = static_cast<double>(m) * path_[k][u];
                    factor_[k][c] -= step * factor_[0][s];
                    factor_[k][s] += step * factor_[0][c];
                }
            } else {
                raise_powers<u>(k);
            }
        });
        multiply_nodes(k);
        static_for<Plan::n_groups>([&](auto g) {
            sum_terms<g>(k);
            blend_[k][g] = blended<g>(k);
        });
    }
    template <int U>
    void raise_powers(int k) {
        constexpr int first = Plan::factor_offset[U];
        factor_[k][first] = path_[k][U];
        for (int m = 1; m < Plan::highest(U); ++m) {
            Z sum = factor_[0][first + m - 1] * factor_[k][first];
            for (int l = 1; l <= k; ++l) sum += factor_[l][first + m - 1] * factor_[k - l][first];
            factor_[k][first + m] = sum;
        }
    }

    const H* h_;
    Time time_;
    Z factor_[order + 1][Plan::factors + Plan::n_nodes];  ///< operands: factors, then nodes
    Z sum_[order + 1][Plan::n_groups];
    Z change_[order + 1][moving ? Plan::n_groups : 1];
    Z blend_[order + 1][Plan::n_groups];
    Z path_[order + 1][n];
    Z current_[moving ? Formulation<M>::terms : 1];
};

}  // namespace detail
}  // namespace equilibria
