// Files that are written whole or not at all, and the options that name them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "options.hpp"

namespace support {

/// Where an option sends text: a file, or stdout for "-". Whether that can be written is found out at once, before the
/// long computation; the file itself appears, or changes, only when `write` has everything on the disk.
class OutputFile {
public:
    OutputFile(std::string option, const std::string& name);

    const std::string& name() const { return name_; }
    bool to_stdout() const { return name_ == "-"; }

    /// Writes the file, or ends the program; text for stdout is written and flushed.
    void write(const std::string& text) const;

private:
    std::filesystem::path temporary() const;
    [[noreturn]] void refuse() const;

    std::string option_, name_;
    std::filesystem::path path_;
};

/// An option that names such a file. Options that are to be checked before it is looked at stand before this one.
void add_output(CommandLine& app, const std::string& option, std::optional<OutputFile>& file, const std::string& text);

/// Whether text for programs goes to stdout, so that none for people may.
inline bool to_stdout(const std::optional<OutputFile>& file) { return file && file->to_stdout(); }

}  // namespace support
