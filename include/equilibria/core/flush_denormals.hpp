/// \file
/// Arithmetic without denormal numbers. Where paths start from powers of a time that is next to 0, single precision is
/// full of them, and each costs many processors 100 cycles and more; what is that small is 0 there to rounding.
#pragma once

#if defined(__SSE2__) || defined(_M_X64)
#define EQUILIBRIA_FLUSHES_DENORMALS 1
#include <xmmintrin.h>
#endif

namespace equilibria {

/// As long as it lives, this thread takes denormal numbers for 0 and makes none, in floats and doubles. Elsewhere than
/// on x86 nothing happens.
class FlushDenormals {
public:
#ifdef EQUILIBRIA_FLUSHES_DENORMALS
    FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_to_zero | denormals_are_zeros); }
    ~FlushDenormals() { _mm_setcsr((_mm_getcsr() & ~modes) | (before_ & modes)); }
#else
    FlushDenormals() = default;
    ~FlushDenormals() {}
#endif
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
#ifdef EQUILIBRIA_FLUSHES_DENORMALS
    static constexpr unsigned flush_to_zero = 0x8000, denormals_are_zeros = 0x0040,
                              modes = flush_to_zero | denormals_are_zeros;
    unsigned before_;
#endif
};

}  // namespace equilibria
