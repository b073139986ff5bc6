/// \file
/// See run/elapsed.hpp.
#pragma once

#include <chrono>

#include <equilibria/run/elapsed.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE double Stopwatch::now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace equilibria::detail
