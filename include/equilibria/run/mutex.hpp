/// \file
/// What threads of this process share is guarded by these; the one place that knows EQUILIBRIA_NO_THREADS, beside the
/// executor.
///
/// With that macro, for all units of a program, there are no threads: guards do nothing, threads(n) is serial whatever
/// n, and no header of the library asks for std::mutex or std::thread. It is for systems whose C++ library has none,
/// as WebAssembly's. It changes no result.
#pragma once

#ifndef EQUILIBRIA_NO_THREADS
#include <mutex>
#endif

namespace equilibria::detail {

#ifdef EQUILIBRIA_NO_THREADS

/// Guards nothing.
struct Mutex {};
/// Holds nothing.
class Lock {
public:
    explicit Lock(Mutex&) {}
    Lock(const Lock&) = delete;
    void lock() {}
    void unlock() {}
};
/// Whether it has been called.
struct OnceFlag {
    bool called = false;
};
/// Calls f the first time, again where that threw.
template <class F>
void call_once(OnceFlag& flag, F&& f) {
    if (flag.called) return;
    f();
    flag.called = true;
}

#else

using Mutex = std::mutex;
using Lock = std::unique_lock<std::mutex>;
using OnceFlag = std::once_flag;
using std::call_once;

#endif

}  // namespace equilibria::detail
