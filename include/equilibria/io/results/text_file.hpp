/// \file
/// Text into a file, whole or not at all: what stood there before stays until all is written.
#pragma once

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace equilibria {

/// Writes `text` next to the file and then puts it in its place. Throws std::system_error where that fails; the file is
/// then what it was.
inline void write_text(const std::filesystem::path& path, std::string_view text) {
    std::filesystem::path part = path;
    part += ".part";
    errno = 0;
    std::ofstream file(part, std::ios::binary);
    file << text;
    file.close();
    std::error_code error;
    if (file) {
        std::filesystem::rename(part, path, error);
        if (!error) return;
    } else {
        error = {errno != 0 ? errno : EIO, std::generic_category()};
    }
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw std::system_error(error, path.string());
}

}  // namespace equilibria
