// Files that are written whole or not at all, and the options that name them.
#pragma once

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <equilibria/io/results/text_file.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
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
        if (exists(status) && access(path_.c_str(), W_OK) != 0) refuse();
        if (exists(status) && !is_regular_file(status)) return;  // a device or a pipe: nothing to be replaced
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
        try {
            equilibria::write_text(path_, text);
        } catch (const std::system_error& error) {
            errno = error.code().value();
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
};

/// An option that names such a file. Options that are to be checked before it is looked at stand before this one.
inline void add_output(CLI::App& app, const std::string& option, std::optional<OutputFile>& file,
                       const std::string& text) {
    app.add_option_function<std::string>(
        option, [&file, option](const std::string& name) { file.emplace(option, name); }, text);
}

/// Whether text for programs goes to stdout, so that none for people may.
inline bool to_stdout(const std::optional<OutputFile>& file) { return file && file->to_stdout(); }

}  // namespace support
