/// \file
/// Integers of any size: Boost's, out of sight, since Boost's headers take longer to read than most programs to
/// compile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>

#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// An integer without limit.
class BigInteger {
public:
    /// 0.
    BigInteger();
    /// Exactly this value.
    /// \{
    explicit BigInteger(std::int64_t value);
    explicit BigInteger(std::uint64_t value);
    /// \}
    /// That of a floating-point number that is one; of a Multiprecision where core/multiprecision.hpp is included.
    template <class A>
    explicit BigInteger(const A& value);
    /// Copies and moves; one that was moved from may only be assigned to or destroyed.
    /// \{
    BigInteger(const BigInteger& other);
    BigInteger(BigInteger&& other) noexcept;
    BigInteger& operator=(const BigInteger& other);
    BigInteger& operator=(BigInteger&& other) noexcept;
    /// \}
    ~BigInteger();

    bool is_zero() const;  ///< whether the value is 0
    /// Positions from 0 of the lowest and of the highest bit of the magnitude that are 1, of a number that is not 0.
    /// \{
    int trailing_zeros() const;
    int top_bit() const;
    /// \}
    /// In the floating-point type S, rounded; in a Multiprecision where core/multiprecision.hpp is included.
    template <class S>
    S to() const;

    /// Exact, of any size.
    /// \{
    BigInteger operator-() const;
    friend BigInteger operator+(const BigInteger& a, const BigInteger& b);
    friend BigInteger operator*(const BigInteger& a, const BigInteger& b);
    /// \}
    /// Times and over a power of two, bits >= 0; exact where the bits dropped are 0.
    /// \{
    BigInteger operator<<(int bits) const;
    BigInteger operator>>(int bits) const;
    /// \}

private:
    /// Boost's integer, where its type is known.
    template <class Integer>
    Integer& as() {
        return *std::launder(reinterpret_cast<Integer*>(storage_));
    }
    template <class Integer>
    const Integer& as() const {
        return *std::launder(reinterpret_cast<const Integer*>(storage_));
    }

    alignas(std::max_align_t) std::byte storage_[32];
};

/// Defined in the compiled library, so that its users need no Boost for it.
template <>
double BigInteger::to<double>() const;

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/core/detail/big_integer_definitions.hpp>
#endif
