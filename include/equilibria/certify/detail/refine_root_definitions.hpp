/// \file
/// See certify/refine_root.hpp.
#pragma once

#include <algorithm>
#include <complex>
#include <ios>
#include <span>

#include <equilibria/certify/newton.hpp>
#include <equilibria/certify/refine_root.hpp>
#include <equilibria/core/multiprecision.hpp>

namespace equilibria::detail {

template <int Digits>
RefinedRoot<RuntimeUnknowns> refine_with(const ExactTerms& exact, std::span<const std::complex<double>> q, int digits) {
    using S = Multiprecision<Digits>;
    RefinedRoot<RuntimeUnknowns> out;
    out.digits = digits;
    const BallSystem<S> system(exact);
    auto z = complex_unknowns<S>(q);
    newton(system, z, 200);
    S size(0), largest(0);
    for (const auto& a : z) {
        size = std::max(size, a.im < 0 ? S(-a.im) : a.im);
        largest = std::max(largest, a.re < 0 ? S(-a.re) : a.re);
    }
    const bool nearly_real = size <= sqrt(rounding_unit<S>);
    S error(0);
    const auto test = [&](bool real) {
        const auto proof = krawczyk(system, point_of<RuntimeUnknowns, S>(z, exact.sizes), real);
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
    out.real.resize(z.size());
    out.imaginary.resize(z.size());
    for (int u = 0; u < z.size(); ++u) {
        out.real[u] = z[u].re.text(digits, std::ios_base::fixed);
        out.imaginary[u] = z[u].im.text(digits, std::ios_base::fixed);
    }
    if (out.proved) out.error = error.text(3, std::ios_base::scientific);
    return out;
}

EQUILIBRIA_INLINE RefinedRoot<RuntimeUnknowns> refine_root(const ExactTerms& exact,
                                                           std::span<const std::complex<double>> q, int digits) {
    if (digits <= 90) return refine_with<110>(exact, q, digits);
    return refine_with<1020>(exact, q, digits);
}

}  // namespace equilibria::detail
