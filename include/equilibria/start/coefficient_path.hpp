/// \file
/// The coefficients of a family of systems along an arc of its parameters: the law of time of a homotopy that stays in
/// the family.
///
/// Where parameters enter nonlinearly, a line in the space of coefficients leaves the family. Systems on it may have
/// more roots than the family's members, and of the paths that begin at a member's roots some go to the others'. So the
/// coefficients are those at p(t) = from + s(t) (to - from), s(t) = t + i b t (1 - t), with a real bend b drawn at
/// random: all systems on the way are members, and no b but finitely many leads through one that is degenerate. The arc
/// lies in the complex line through its ends: parameters that are the same at both do not move, and `from` need have as
/// many roots as a generic member on that line, no more.
///
/// Why interpolation: the coefficients may be any analytic functions of the parameters, and are there as a function to
/// be called. At Chebyshev's points they are interpolated to rounding, with as many points as that takes (2 d + 1 where
/// they are polynomials of degree d in p), and a value and three Taylor coefficients at a time are four sums by
/// Clenshaw's recurrence, which is stable (Trefethen, Approximation Theory and Approximation Practice, SIAM, 2013,
/// ch. 3, 8, 19). Differentiating the model's function along with it would need jets of it at every step. A pole or a
/// cut of a coefficient on the arc, or next to it, is seen: the series does not end; another arc is drawn. Between two
/// points beyond a ratio of about a hundred of a parameter that is divided by no arc may be found; that is an error.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/model/sizes.hpp>
#include <equilibria/system/sparse_term.hpp>
#include <equilibria/system/system_family.hpp>

namespace equilibria {

/// A way between parameters, t from 0 to 1.
struct ParameterArc {
    std::vector<std::complex<double>> from;  ///< parameters at t = 0
    std::vector<std::complex<double>> to;    ///< parameters at t = 1
    double bend = 0;                         ///< b: 0 is the line between them

    std::vector<std::complex<double>> at(double t) const;  ///< the parameters p(t)
};

/// A bend of size 0.6 to 1.6, of either sign.
double random_bend(Generator& generator);

/// The coefficients of a family along an arc, as Chebyshev series in t.
class CoefficientPath {
public:
    using Number = std::complex<double>;     ///< type of parameters and coefficients
    static constexpr int law_order = 3;      ///< highest Taylor coefficient that law() gives
    static constexpr int most_points = 257;  ///< of an interpolation

    /// None where the coefficients are not analytic on the arc, as far as the interpolation tells. Throws
    /// InvalidArgument where the coefficients are not finite at its ends, or other numbers of parameters are given.
    static std::optional<CoefficientPath> along(const SystemFamily& family, const ParameterArc& arc);
    /// Along arcs with bends that are drawn until one serves. Throws InvalidArgument also where none of 12 does.
    static CoefficientPath between(const SystemFamily& family, std::span<const Number> from, std::span<const Number> to,
                                   Generator& generator);

    const RuntimeSizes& sizes() const { return sizes_; }  ///< numbers of angles and coordinates
    /// Of the Laurent system in exp(i theta) and the coordinates: codes of angles are powers; coefficients 0.
    const std::vector<SparseTerm>& terms() const { return terms_; }
    /// The coefficients at t = 0 and at t = 1, one a term.
    /// \{
    const std::vector<Number>& from() const { return from_; }
    const std::vector<Number>& to() const { return to_; }
    /// \}
    /// The largest coefficient of each equation at t = 1, of cosines and sines; 1 of one that vanishes.
    const std::vector<double>& scale() const { return scale_; }
    const ParameterArc& arc() const { return arc_; }  ///< the way of the parameters, bend included
    /// The highest degree in t of a term's coefficient.
    int degree() const { return degree_; }
    /// The numbers that the law is made of.
    std::span<const Number> numbers() const { return series_; }

    /// The Taylor coefficient `Order`, to 3, of a term's coefficient at the time t.
    template <int Order, class R, class Time>
    Complex<R> law(int term, const Time& t) const {
        static_assert(Order >= 0 && Order <= law_order);
        const Series& of = places_[static_cast<std::size_t>(term)];
        const int last = of.degree - Order;
        if (last < 0) return {broadcast<R>(0.0), broadcast<R>(0.0)};
        // its series in the polynomials T_0, .., T_last of 2 t - 1; those of lower orders lie before it
        const Number* const c = series_.data() + of.first + Order * (of.degree + 1) - Order * (Order - 1) / 2;
        Complex<R> y = broadcast_complex<R>(c[last]), next{broadcast<R>(0.0), broadcast<R>(0.0)};
        if (last == 0) return y;
        const auto x = 2.0 * t - 1.0;
        const auto twice = 2.0 * x;
        for (int k = last - 1; k > 0; --k) {
            const Complex<R> sum = broadcast_complex<R>(c[k]) + twice * y - next;
            next = y;
            y = sum;
        }
        return broadcast_complex<R>(c[0]) + x * y - next;
    }

private:
    CoefficientPath() = default;
    struct Series {
        int first, degree;
    };
    void add(SparseTerm term, std::vector<Number> series, const Number& from, const Number& to);

    RuntimeSizes sizes_;
    ParameterArc arc_;
    std::vector<SparseTerm> terms_;
    std::vector<Number> from_, to_;
    std::vector<double> scale_;
    std::vector<Series> places_;
    std::vector<Number> series_;
    int degree_ = 0;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/start/detail/coefficient_path_definitions.hpp>
#endif
