/// \file
/// A root to up to 1,000 digits, with a proved error: Newton's method and Krawczyk's test in that many digits.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>
#include <string>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// A root in decimal digits.
template <class M>
struct RefinedRoot {
    int digits = 0;                          ///< after the decimal point
    UnknownArray<M, std::string> real;       ///< angles in radians, then coordinates
    UnknownArray<M, std::string> imaginary;  ///< as `real`, of the imaginary parts
    bool proved = false;       ///< exactly one root lies within 10^-digits of these numbers, in every unknown
    bool proved_real = false;  ///< and it is real; the imaginary parts are 0 then
    std::string error;         ///< a bound of the distance of any unknown, in digits of its own; empty if not proved
};

namespace detail {

/// See `refine`, of equations as data.
RefinedRoot<RuntimeUnknowns> refine_root(const ExactTerms& exact, std::span<const std::complex<double>> q, int digits);

}  // namespace detail

/// The root next to q (angles in radians, then coordinates) of the model at the parameters p, to `digits` digits after
/// the decimal point, 1 to 1000. Where the root is singular nothing is proved of it, and its digits are those that
/// Newton's method came to. Throws InvalidArgument for digits out of range and numbers that are not finite.
template <Model M>
RefinedRoot<M> refine(const Array<std::complex<double>, n_unknowns<M>>& q, const Parameters<M>& p, int digits) {
    require(digits >= 1 && digits <= 1000, "digits", digits, "must be 1 to 1000");
    require_finite(p, "parameters");
    for (const auto& z : q) require(std::isfinite(z.real()) && std::isfinite(z.imag()), "q", z, "must be finite");
    auto found = detail::refine_root(ExactSystem<M>::at(p), {q.begin(), q.end()}, digits);
    RefinedRoot<M> out;
    out.digits = digits;
    std::move(found.real.begin(), found.real.end(), out.real.begin());
    std::move(found.imaginary.begin(), found.imaginary.end(), out.imaginary.begin());
    out.proved = found.proved;
    out.proved_real = found.proved_real;
    out.error = std::move(found.error);
    return out;
}

/// The same of a model at run time.
template <RuntimeModel T>
RefinedRoot<RuntimeUnknowns> refine(const T& model, const RuntimeArray<std::complex<double>>& q,
                                    const RuntimeArray<double>& p, int digits) {
    require(digits >= 1 && digits <= 1000, "digits", digits, "must be 1 to 1000");
    const ExactTerms exact = exact_terms(model, p);
    require(q.size() == exact.sizes.unknowns, "q", q.size(), "must be a number for each unknown");
    for (const auto& z : q) require(std::isfinite(z.real()) && std::isfinite(z.imag()), "q", z, "must be finite");
    return detail::refine_root(exact, {q.begin(), q.end()}, digits);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/certify/detail/refine_root_definitions.hpp>
#endif
