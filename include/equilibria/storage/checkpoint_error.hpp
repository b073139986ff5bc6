/// \file
/// What is thrown of a checkpoint.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace equilibria {

/// A checkpoint that cannot be used: no wrong argument, but a file that is not what it should be, or a disk that fails.
/// `what()` reads "checkpoint = <path>: <what is wrong>".
class CheckpointError : public std::runtime_error {
public:
    /// Of the checkpoint at this path, and what is wrong with it in words.
    CheckpointError(std::string_view path, std::string_view wrong)
        : std::runtime_error("checkpoint = " + std::string(path.empty() ? "''" : path) + ": " + std::string(wrong)),
          wrong_(wrong) {}
    /// What is wrong, without the path.
    const std::string& wrong() const { return wrong_; }

private:
    std::string wrong_;
};

}  // namespace equilibria
