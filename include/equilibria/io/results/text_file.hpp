/// \file
/// Text into a file, whole or not at all: what stood there before stays until all is written. Where the C++ library
/// knows no files nothing can be written.
#pragma once

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <system_error>
#include <version>

namespace equilibria {

#ifdef __cpp_lib_filesystem

namespace detail {

/// What was wrong with the last output; nothing if it went well.
inline std::error_code write_through(const std::filesystem::path& path, std::string_view text) {
    errno = 0;
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (file) return {};
    return {errno != 0 ? errno : EIO, std::generic_category()};
}

}  // namespace detail

/// Writes `text` next to the file and then puts it in its place; what is no file, a device or a pipe, is written to.
/// A link stays a link. Throws std::system_error where that fails; a file is then what it was.
inline void write_text(const std::filesystem::path& path, std::string_view text) {
    std::error_code error;
    std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
    if (error) target = path;
    const auto status = std::filesystem::status(target, error);
    const bool special = exists(status) && !is_regular_file(status);
    std::filesystem::path part = target;
    if (!special) part += ".part" + std::to_string(std::random_device()());  // of this run alone
    error = detail::write_through(part, text);
    if (!error && !special) std::filesystem::rename(part, target, error);
    if (!error) return;
    std::error_code ignored;
    if (!special) std::filesystem::remove(part, ignored);
    throw std::system_error(error, path.string());
}

#else

/// There are no files. Throws std::system_error.
inline void write_text(const std::filesystem::path& path, std::string_view) {
    throw std::system_error(std::make_error_code(std::errc::not_supported), path.string());
}

#endif

}  // namespace equilibria
