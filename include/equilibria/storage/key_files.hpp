/// \file
/// Keys of endpoints by ranges, in files that nobody sees: what is sorted need not fit into memory.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/storage/checkpoint_error.hpp>

namespace equilibria::detail {

/// How much memory a search among keys may take, and where they go beyond that: to files beside this one. Without a
/// name they stay in memory.
struct KeyLimits {
    std::uint64_t memory = std::uint64_t{1} << 30;
    std::string beside = {};
};

/// The key of a point, its size, its number.
struct KeyEntry {
    double key, size;
    std::size_t k;
};

class KeyFiles {
public:
    /// Files that a process may well have open.
    static constexpr std::size_t most = 500;

    /// Ranges end at these keys, in ascending order, the last one nowhere. Throws CheckpointError where files cannot be
    /// made, written or read, as all functions here.
    KeyFiles(const std::string& beside, std::vector<double> ends) : name_(beside + ".keys"), ends_(std::move(ends)) {
        ends_.push_back(std::numeric_limits<double>::infinity());
        for (std::size_t k = 0; k < ends_.size(); ++k) {
            files_.emplace_back(std::fopen(name_.c_str(), "w+b"));
            if (!files_.back()) refuse("cannot be created");
            ::unlink(name_.c_str());  // it lives until it is closed, whatever becomes of the process
        }
        sizes_.resize(ends_.size());
    }

    std::size_t ranges() const { return ends_.size(); }
    double end_of(std::size_t range) const { return ends_[range]; }

    void put(const KeyEntry& entry) {
        const auto at =
            static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end() - 1, entry.key) - ends_.begin());
        if (std::fwrite(&entry, sizeof entry, 1, files_[at].get()) != 1) refuse("cannot be written");
        ++sizes_[at];
    }
    /// Appends a range's entries.
    void get(std::size_t range, std::vector<KeyEntry>& to) {
        std::FILE* const file = files_[range].get();
        if (std::fflush(file) != 0) refuse("cannot be written");
        std::rewind(file);
        const std::size_t before = to.size();
        to.resize(before + sizes_[range]);
        if (std::fread(to.data() + before, sizeof(KeyEntry), sizes_[range], file) != sizes_[range])
            refuse("cannot be read");
        files_[range].reset();
    }

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    [[noreturn]] void refuse(const char* wrong) const {
        throw CheckpointError(name_, std::string(wrong) + " (" + std::strerror(errno) + ")");
    }

    std::string name_;
    std::vector<double> ends_;
    std::vector<std::unique_ptr<std::FILE, Close>> files_;
    std::vector<std::size_t> sizes_;
};

}  // namespace equilibria::detail
