// Ctrl-C, SIGTERM of a batch system and a limit of time end a long run with what is finished.
#pragma once

#include <signal.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>

namespace support {

namespace detail {
inline std::atomic<bool> stopped = false, limit_over = false;
static_assert(std::atomic<bool>::is_always_lock_free);
}  // namespace detail

/// Becomes true with the first of the signals, or when a TimeLimit is over; a second signal ends the program.
inline const std::atomic<bool>& cancelled_by_signal() {
    struct sigaction action{};
    action.sa_handler = [](int) { detail::stopped = true; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    return detail::stopped;
}

/// A limit of the time that is left to a run, which ends it as a signal does.
class TimeLimit {
public:
    /// seconds: from now; 0: no limit.
    explicit TimeLimit(double seconds) {
        if (seconds > 0)
            clock_ = std::thread([this, seconds] {
                std::unique_lock lock(guard_);
                if (ended_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return done_; })) return;
                detail::limit_over = detail::stopped = true;
            });
    }
    ~TimeLimit() {
        {
            const std::lock_guard lock(guard_);
            done_ = true;
        }
        ended_.notify_one();
        if (clock_.joinable()) clock_.join();
    }
    TimeLimit(const TimeLimit&) = delete;

private:
    std::mutex guard_;
    std::condition_variable ended_;
    bool done_ = false;
    std::thread clock_;
};

/// Thrown by what can only be stopped where it reports its progress.
struct Stopped {};

/// The status of a program that was stopped: 124 by its limit, as of timeout(1), 130 by a signal, 0 where it was not.
inline int stopped_status() { return detail::limit_over ? 124 : detail::stopped ? 130 : 0; }

/// Says on stderr that a run was stopped, and by what; the status to end with.
inline int say_stopped(const std::string& program, const std::string& what) {
    std::fprintf(stderr, "%s: %s; %s\n", program.c_str(),
                 detail::limit_over ? "stopped, since the time that --limit allows is over" : "interrupted",
                 what.c_str());
    return stopped_status();
}

}  // namespace support
