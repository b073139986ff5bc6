// A name for a file in the folder for temporary files; whatever has that name is removed before and after.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace tests {

class ScratchFile {
public:
    explicit ScratchFile(const std::string& label)
        : name_(std::filesystem::temp_directory_path() / ("equilibria_" + std::to_string(getpid()) + "_" + label)) {
        std::filesystem::remove_all(name_);
    }
    ScratchFile(const ScratchFile&) = delete;
    ~ScratchFile() { std::filesystem::remove_all(name_); }

    std::string name() const { return name_; }
    std::vector<std::uint8_t> bytes() const {
        std::ifstream file(name_, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    void write(const std::vector<std::uint8_t>& bytes) const {
        std::ofstream file(name_, std::ios::binary);
        file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }

private:
    std::filesystem::path name_;
};

}  // namespace tests
