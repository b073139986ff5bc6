/// \file
/// The integers of circuit tables: 32 bits, 64 bits, and without limit, with the one operation that everything costs, a
/// combination of two rows that is divided exactly.
///
/// A quotient that is known to be an integer, and to fit, is known from its lowest bits: division by an odd number is
/// multiplication by its inverse modulo 2^32 or 2^64 (Jebelean, An algorithm for exact division, J. Symb. Comp. 15
/// (1993) 169-180), for which no product has to be wider than the entries. Powers of two are cancelled first, and what
/// is left of them is shifted out of wide products.
#pragma once

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace equilibria::detail {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;
using UnlimitedInteger = boost::multiprecision::cpp_int;

/// What belongs to tables of a kind of integers: their number, products of two entries, products of an entry and a
/// height, and of three.
template <class Integer>
struct TableInteger;
template <>
struct TableInteger<std::int32_t> {
    static constexpr int width = 0;
    using Unsigned = std::uint32_t;
    using Product = std::int64_t;
    using UnsignedProduct = std::uint64_t;
    using Height = std::int64_t;
    using HeightProduct = Int128;
    /// Heights, and their partial sums, whose magnitudes are below this are computed.
    static constexpr double largest_height = 0x1p61;
};
template <>
struct TableInteger<std::int64_t> {
    static constexpr int width = 1;
    using Unsigned = std::uint64_t;
    using Product = Int128;
    using UnsignedProduct = UInt128;
    using Height = Int128;
    using HeightProduct = UnlimitedInteger;
    static constexpr double largest_height = 0x1p124;
};
template <>
struct TableInteger<UnlimitedInteger> {
    static constexpr int width = 2;
    using Product = UnlimitedInteger;
    using Height = UnlimitedInteger;
    using HeightProduct = UnlimitedInteger;
};
template <class Integer>
inline constexpr bool is_unlimited = std::is_same_v<Integer, UnlimitedInteger>;

template <class Integer>
Integer absolute_value(const Integer& x) {
    return x < 0 ? Integer(-x) : x;
}

/// One integer of another kind that holds it.
template <class To, class From>
To converted(const From& x) {
    if constexpr (is_unlimited<From> && !is_unlimited<To>)
        return x.template convert_to<To>();
    else
        return static_cast<To>(x);
}

/// The inverse of an odd number modulo 2^bits; each step of Newton's method doubles the 3 bits that are right.
template <class Unsigned>
constexpr Unsigned inverse_of_odd(Unsigned odd) {
    Unsigned y = odd * 3 ^ 2;
    for (int bits = 5; bits < static_cast<int>(8 * sizeof(Unsigned)); bits *= 2) y *= 2 - odd * y;
    return y;
}

/// row = (p row + c other) / divisor, where all quotients are integers that fit; p and the divisor are positive.
template <class Integer>
void combine_rows(Integer* row, const Integer* other, std::size_t size, Integer p, Integer c, Integer divisor) {
    if constexpr (is_unlimited<Integer>) {
        for (std::size_t k = 0; k < size; ++k) row[k] = (p * row[k] + c * other[k]) / divisor;
    } else {
        using U = typename TableInteger<Integer>::Unsigned;
        using Product = typename TableInteger<Integer>::Product;
        using UnsignedProduct = typename TableInteger<Integer>::UnsignedProduct;
        const bool adds = p == divisor;  // c other is divisible then
        const U together = adds ? U(c) | U(divisor) : U(p) | U(c) | U(divisor);
        const int common = std::countr_zero(together);
        p = Integer(p >> common), c = Integer(c >> common), divisor = Integer(divisor >> common);
        const int shift = std::countr_zero(U(divisor));
        const U inverse = inverse_of_odd(U(divisor >> shift));
        if (shift == 0) {
            const U a = U(p) * inverse, b = U(c) * inverse;
            if (adds && (b == 1 || b == U(-1))) {
                if (b == 1)
                    for (std::size_t k = 0; k < size; ++k) row[k] = Integer(U(row[k]) + U(other[k]));
                else
                    for (std::size_t k = 0; k < size; ++k) row[k] = Integer(U(row[k]) - U(other[k]));
            } else if (adds) {
                for (std::size_t k = 0; k < size; ++k) row[k] = Integer(U(row[k]) + b * U(other[k]));
            } else {
                for (std::size_t k = 0; k < size; ++k) row[k] = Integer(a * U(row[k]) + b * U(other[k]));
            }
        } else if (adds) {
            for (std::size_t k = 0; k < size; ++k) {
                const Product x = Product(c) * other[k];
                row[k] = Integer(U(row[k]) + U(UnsignedProduct(x) >> shift) * inverse);
            }
        } else {
            for (std::size_t k = 0; k < size; ++k) {
                const Product x = Product(p) * row[k] + Product(c) * other[k];
                row[k] = Integer(U(UnsignedProduct(x) >> shift) * inverse);
            }
        }
    }
}

}  // namespace equilibria::detail
