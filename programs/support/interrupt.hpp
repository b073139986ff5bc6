// Ctrl-C, and SIGTERM of a batch system, end a long run with what is finished.
#pragma once

#include <signal.h>

#include <atomic>

namespace support {

/// Becomes true with the first of them; a second one ends the program.
inline const std::atomic<bool>& cancelled_by_signal() {
    static std::atomic<bool> cancelled = false;
    static_assert(std::atomic<bool>::is_always_lock_free);
    struct sigaction action{};
    action.sa_handler = [](int) { cancelled = true; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    return cancelled;
}

}  // namespace support
