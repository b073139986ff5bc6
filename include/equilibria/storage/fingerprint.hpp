/// \file
/// A number that stands for many.
#pragma once

#include <bit>
#include <complex>
#include <cstdint>
#include <string>

namespace equilibria::detail {

/// A hash of numbers, word by word (the mixing of splitmix64).
class Fingerprint {
public:
    void operator()(std::uint64_t word) {
        std::uint64_t z = (value_ ^ word) + 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        value_ = z ^ (z >> 31);
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
