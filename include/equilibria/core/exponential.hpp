/// \file
/// The exponential function of all lanes of a pack at once.
///
/// x = k ln 2 + r with |r| <= ln(2) / 2: exp(r) by its Taylor polynomial, whose error there is below the rounding of
/// the lanes' numbers, and 2^k by its bits. What lies below the smallest normal number is that number, or 0 times it
/// where the caller multiplies: denormal numbers cost processors a hundred cycles each.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include <equilibria/core/lanes.hpp>

namespace equilibria {

namespace detail {

/// Of a bare vector of lanes. Shifter: 1.5 * 2^(bits of the fraction); what is added to it is rounded to an integer,
/// which stands in the lowest bits.
template <int Degree, int FractionBits, int Bias, class Integers, class Values>
Values exponential_of_values(Values x, auto shifter, auto ln2_high, auto ln2_low, auto least, auto most) {
    using Scalar = decltype(shifter);
    const Values low = least - Values{}, high = most - Values{};
    x = x < low ? low : x;
    x = x > high ? high : x;
    const Values shifted = x * static_cast<Scalar>(1.4426950408889634) + shifter;
    const Values k = shifted - shifter;
    const Values r = (x - k * ln2_high) - k * ln2_low;
    Values y = Values{} + Scalar(1);
    for (int d = Degree; d > 0; --d) y = Scalar(1) + (r * (Scalar(1) / static_cast<Scalar>(d))) * y;
    const Integers power = (std::bit_cast<Integers>(shifted) + Bias) << FractionBits;
    return y * std::bit_cast<Values>(power);
}

}  // namespace detail

/// e^x; |x| is taken to be at most 708 (87 in single precision).
template <class R>
R exponential(const R& x) {
    if constexpr (!is_pack<R>) {
        using std::exp;
        return exp(x);
    } else if constexpr (is_single<R>) {
        return {detail::exponential_of_values<7, 23, 127, typename R::Mask>(x.values, 12582912.0f, 0.693359375f,
                                                                            -2.12194440e-4f, -87.0f, 87.0f)};
    } else {
        using Mask = typename LaneTraits<R>::Mask;
        return detail::exponential_of_values<13, 52, 1023, Mask>(x, 6755399441055744.0, 0.693147180369123816490,
                                                                 1.90821492927058770002e-10, -708.0, 708.0);
    }
}

}  // namespace equilibria
