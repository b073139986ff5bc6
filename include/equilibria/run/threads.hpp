/// \file
/// The executor over threads of this process.
#pragma once

#include <equilibria/core/compiled.hpp>
#include <equilibria/run/executor.hpp>

namespace equilibria {

/// An executor over so many threads, the caller's among them; 0: all of the machine's. With EQUILIBRIA_NO_THREADS
/// (run/mutex.hpp) the serial one, whatever the number. Throws InvalidArgument above 1024.
Executor threads(unsigned count);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/run/detail/threads_definitions.hpp>
#endif
