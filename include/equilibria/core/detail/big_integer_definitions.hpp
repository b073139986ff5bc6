/// \file
/// See core/big_integer.hpp.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <memory>
#include <new>
#include <utility>

#include <equilibria/core/big_integer.hpp>

namespace equilibria {

namespace detail {
using BoostInteger = boost::multiprecision::cpp_int;
}

EQUILIBRIA_INLINE BigInteger::BigInteger() { ::new (storage_) detail::BoostInteger; }
EQUILIBRIA_INLINE BigInteger::BigInteger(std::int64_t value) { ::new (storage_) detail::BoostInteger(value); }
EQUILIBRIA_INLINE BigInteger::BigInteger(std::uint64_t value) { ::new (storage_) detail::BoostInteger(value); }
EQUILIBRIA_INLINE BigInteger::BigInteger(const BigInteger& other) {
    static_assert(sizeof(detail::BoostInteger) <= sizeof storage_ &&
                  alignof(detail::BoostInteger) <= alignof(BigInteger));
    ::new (storage_) detail::BoostInteger(other.as<detail::BoostInteger>());
}
EQUILIBRIA_INLINE BigInteger::BigInteger(BigInteger&& other) noexcept {
    ::new (storage_) detail::BoostInteger(std::move(other.as<detail::BoostInteger>()));
}
EQUILIBRIA_INLINE BigInteger& BigInteger::operator=(const BigInteger& other) {
    as<detail::BoostInteger>() = other.as<detail::BoostInteger>();
    return *this;
}
EQUILIBRIA_INLINE BigInteger& BigInteger::operator=(BigInteger&& other) noexcept {
    as<detail::BoostInteger>() = std::move(other.as<detail::BoostInteger>());
    return *this;
}
EQUILIBRIA_INLINE BigInteger::~BigInteger() { std::destroy_at(&as<detail::BoostInteger>()); }

EQUILIBRIA_INLINE bool BigInteger::is_zero() const { return as<detail::BoostInteger>().is_zero(); }
EQUILIBRIA_INLINE int BigInteger::trailing_zeros() const {
    return static_cast<int>(lsb(detail::BoostInteger(abs(as<detail::BoostInteger>()))));
}
EQUILIBRIA_INLINE int BigInteger::top_bit() const {
    return static_cast<int>(msb(detail::BoostInteger(abs(as<detail::BoostInteger>()))));
}
template <>
EQUILIBRIA_INLINE double BigInteger::to<double>() const {
    return static_cast<double>(as<detail::BoostInteger>());
}

EQUILIBRIA_INLINE BigInteger BigInteger::operator-() const {
    BigInteger y = *this;
    y.as<detail::BoostInteger>().backend().negate();
    return y;
}
EQUILIBRIA_INLINE BigInteger operator+(const BigInteger& a, const BigInteger& b) {
    BigInteger y = a;
    y.as<detail::BoostInteger>() += b.as<detail::BoostInteger>();
    return y;
}
EQUILIBRIA_INLINE BigInteger operator*(const BigInteger& a, const BigInteger& b) {
    BigInteger y = a;
    y.as<detail::BoostInteger>() *= b.as<detail::BoostInteger>();
    return y;
}
EQUILIBRIA_INLINE BigInteger BigInteger::operator<<(int bits) const {
    BigInteger y = *this;
    y.as<detail::BoostInteger>() <<= bits;
    return y;
}
EQUILIBRIA_INLINE BigInteger BigInteger::operator>>(int bits) const {
    BigInteger y = *this;
    y.as<detail::BoostInteger>() >>= bits;
    return y;
}

}  // namespace equilibria
