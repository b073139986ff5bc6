// Files that are written whole or not at all.
#pragma once

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <system_error>

#include "fail.hpp"

namespace support {

/// Where an option sends text: a file, or stdout for "-". Whether that can be written is found out at once, before the
/// long computation; the file itself appears, or changes, only when `write` has everything on the disk.
class OutputFile {
public:
    OutputFile(std::string option, const std::string& name) : option_(std::move(option)), name_(name) {
        if (name.empty()) fail(option_, "''", "must be the name of a file, or - for stdout");
        if (to_stdout()) return;
        std::error_code error;
        path_ = std::filesystem::weakly_canonical(name, error);  // a link stays a link
        if (error) path_ = name;
        const auto status = std::filesystem::status(path_, error);
        if (is_directory(status)) fail(option_, name, "is a folder; must be a file that can be written");
        special_ = exists(status) && !is_regular_file(status);  // a device or a pipe: nothing to be replaced
        if (exists(status) && access(path_.c_str(), W_OK) != 0) refuse();
        if (special_) return;
        if (!std::ofstream(temporary())) refuse();
        std::filesystem::remove(temporary(), error);
    }

    bool to_stdout() const { return name_ == "-"; }

    /// Writes the file, or ends the program; text for stdout is written and flushed.
    void write(const std::string& text) const {
        if (to_stdout()) {
            if (!(std::cout << text << std::flush)) refuse();
            return;
        }
        const auto target = special_ ? path_ : temporary();
        std::ofstream file(target, std::ios::binary);
        file << text;
        file.close();
        std::error_code error;
        if (file && !special_) std::filesystem::rename(target, path_, error);
        if (!file || error) {
            const int reason = errno;
            if (!special_) std::filesystem::remove(target, error);
            errno = reason;
            refuse();
        }
    }

private:
    std::filesystem::path temporary() const {
        auto name = path_;
        name += ".part" + std::to_string(getpid());
        return name;
    }
    [[noreturn]] void refuse() const {
        fail(option_, name_,
             std::string("cannot be written (") + std::strerror(errno) + "); must be a file that can, or -");
    }

    std::string option_, name_;
    std::filesystem::path path_;
    bool special_ = false;
};

}  // namespace support
