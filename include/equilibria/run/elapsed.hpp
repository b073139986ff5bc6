/// \file
/// The time that goes by.
#pragma once

#include <equilibria/core/compiled.hpp>

namespace equilibria::detail {

/// A clock that begins when it is made.
class Stopwatch {
public:
    Stopwatch() : begin_(now()) {}
    double seconds() const { return now() - begin_; }

private:
    static double now();
    double begin_;
};

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/run/detail/elapsed_definitions.hpp>
#endif
