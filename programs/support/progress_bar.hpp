// A progress bar on stderr, where stderr is a terminal; nothing otherwise, so that logs stay clean.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>

namespace support {

class ProgressBar {
public:
    explicit ProgressBar(std::string label) : label_(std::move(label)), terminal_(isatty(STDERR_FILENO) != 0) {}
    ~ProgressBar() {
        if (drawn_) std::fputs("\r\x1b[K", stderr);
    }
    ProgressBar(const ProgressBar&) = delete;

    /// Draws at most ten times a second; one call at a time.
    void update(std::uint64_t done, std::uint64_t all) {
        const auto now = Clock::now();
        if (!terminal_ || now - last_ < std::chrono::milliseconds(100)) return;
        last_ = now;
        const double part = all == 0 ? 1 : static_cast<double>(std::min(done, all)) / static_cast<double>(all);
        constexpr int width = 40;
        const int filled = static_cast<int>(part * width);
        std::fprintf(stderr, "\r%s [%s%s] %3d %%", label_.c_str(), std::string(filled, '#').c_str(),
                     std::string(width - filled, ' ').c_str(), static_cast<int>(100 * part));
        const double seconds = std::chrono::duration<double>(now - begin_).count();
        if (part > 0) std::fprintf(stderr, ", %.0f s left", seconds / part - seconds);
        std::fputs("\x1b[K", stderr);
        drawn_ = true;
    }

private:
    using Clock = std::chrono::steady_clock;

    std::string label_;
    bool terminal_, drawn_ = false;
    Clock::time_point begin_ = Clock::now(), last_ = begin_;
};

}  // namespace support
