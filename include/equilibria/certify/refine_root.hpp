/// \file
/// A root to up to 1,000 digits, with a proved error: Newton's method and Krawczyk's test in that many digits.
#pragma once

#include <algorithm>
#include <complex>
#include <string>

#include <equilibria/certify/newton.hpp>
#include <equilibria/core/multiprecision.hpp>

namespace equilibria {

/// A root in decimal digits.
template <Model M>
struct RefinedRoot {
    int digits = 0;                          ///< after the decimal point
    Array<std::string, n_unknowns<M>> real;  ///< angles in radians, then coordinates
    Array<std::string, n_unknowns<M>> imaginary;
    bool proved = false;       ///< exactly one root lies within 10^-digits of these numbers, in every unknown
    bool proved_real = false;  ///< and it is real; the imaginary parts are 0 then
    std::string error;         ///< a bound of the distance of any unknown, in digits of its own; empty if not proved
};

namespace detail {

template <int Digits, Model M>
RefinedRoot<M> refine(const ExactSystem<M>& exact, const Array<std::complex<double>, n_unknowns<M>>& q, int digits) {
    using S = Multiprecision<Digits>;
    RefinedRoot<M> out;
    out.digits = digits;
    const BallSystem<M, S> system(exact);
    ComplexUnknowns<M, S> z = unknowns_of<M, S>(q);
    newton(system, z, 200);
    S size(0), largest(0);
    for (const auto& a : z) {
        size = std::max(size, a.im < 0 ? S(-a.im) : a.im);
        largest = std::max(largest, a.re < 0 ? S(-a.re) : a.re);
    }
    const bool nearly_real = size <= sqrt(rounding_unit<S>);
    S error(0);
    const auto test = [&](bool real) {
        const auto proof = krawczyk<M, S>(system, point_of<M, S>(z), real);
        if (!proof.proved) return;
        out.proved = true;
        out.proved_real = real;
        for (const S& r : proof.radius) error = std::max(error, r);
    };
    if (nearly_real) test(true);
    if (!out.proved) test(false);
    if (out.proved_real)
        for (auto& a : z) a.im = S(0);
    // a cosine and sine of many digits are right to a few of their last ones, and the text to its last
    const S unit = S(1e6) * rounding_unit<S> * (S(1) + largest + size);
    S tenth(1);
    for (int k = 0; k < digits; ++k) tenth = tenth / S(10);
    error = error + unit + tenth / S(2);
    out.proved = out.proved && error <= tenth;
    if (!out.proved) out.proved_real = false;
    for (int u = 0; u < z.size(); ++u) {
        out.real[u] = z[u].re.text(digits, std::ios_base::fixed);
        out.imaginary[u] = z[u].im.text(digits, std::ios_base::fixed);
    }
    if (out.proved) out.error = error.text(3, std::ios_base::scientific);
    return out;
}

}  // namespace detail

/// The root next to q (angles in radians, then coordinates) of the model at the parameters p, to `digits` digits after
/// the decimal point, 1 to 1000. Where the root is singular nothing is proved of it, and its digits are those that
/// Newton's method came to. Throws InvalidArgument for digits out of range and numbers that are not finite.
template <Model M>
RefinedRoot<M> refine(const Array<std::complex<double>, n_unknowns<M>>& q, const Parameters<M>& p, int digits) {
    require(digits >= 1 && digits <= 1000, "digits", digits, "must be 1 to 1000");
    require_finite(p, "parameters");
    for (const auto& z : q) require(std::isfinite(z.real()) && std::isfinite(z.imag()), "q", z, "must be finite");
    const auto exact = ExactSystem<M>::at(p);
    if (digits <= 90) return detail::refine<110, M>(exact, q, digits);
    return detail::refine<1020, M>(exact, q, digits);
}

}  // namespace equilibria
