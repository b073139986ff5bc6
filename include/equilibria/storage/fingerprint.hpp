/// \file
/// A number that stands for many.
#pragma once

#include <bit>
#include <complex>
#include <cstdint>
#include <string>

#include <equilibria/core/splitmix.hpp>

namespace equilibria::detail {

/// A hash of numbers, word by word (the mixing of splitmix64).
class Fingerprint {
public:
    void operator()(std::uint64_t word) {
        std::uint64_t state = value_ ^ word;
        value_ = splitmix64(state);
    }
    void operator()(double number) { (*this)(std::bit_cast<std::uint64_t>(number)); }
    void operator()(const std::complex<double>& z) { (*this)(z.real()), (*this)(z.imag()); }
    std::string text() const {
        std::string hex;
        for (int shift = 60; shift >= 0; shift -= 4) hex += "0123456789abcdef"[(value_ >> shift) & 15];
        return hex;
    }

private:
    std::uint64_t value_ = 0;
};

}  // namespace equilibria::detail
