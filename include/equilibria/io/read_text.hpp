/// \file
/// Text from a file, of a limited size. Where the C++ library knows no files every name is refused.
#pragma once

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <version>

#include <equilibria/core/error.hpp>

namespace equilibria {

/// What is in a file. Throws InvalidArgument where it cannot be read, or has more than so many bytes.
inline std::string read_text(const std::string& path, std::size_t most_bytes) {
    const auto refuse = [&](const std::string& allowed) { throw InvalidArgument("path", '"' + path + '"', allowed); };
#ifndef __cpp_lib_filesystem
    refuse("must be a file of at most " + std::to_string(most_bytes) + " bytes, and there are no files here");
    return {};
#else
    const std::string limit = "must be a file of at most " + std::to_string(most_bytes) + " bytes";
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) refuse("must be a file, not a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse(std::string("must be a file that can be read: ") + std::strerror(errno));
    if (std::filesystem::is_regular_file(path, error)) {
        const auto size = std::filesystem::file_size(path, error);
        if (!error && size > most_bytes) refuse(limit + ", not " + std::to_string(size));
    }
    std::string text;
    std::array<char, 1 << 16> part;
    while (file.read(part.data(), part.size()), file.gcount() > 0) {
        text.append(part.data(), static_cast<std::size_t>(file.gcount()));
        if (text.size() > most_bytes) refuse(limit);
    }
    if (file.bad()) refuse("must be a file that can be read to its end");
    return text;
#endif
}

}  // namespace equilibria
