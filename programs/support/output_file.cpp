#include "output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <equilibria/io/results/text_file.hpp>
#include <fstream>
#include <iostream>
#include <system_error>
#include <utility>

namespace support {

OutputFile::OutputFile(std::string option, const std::string& name) : option_(std::move(option)), name_(name) {
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

void OutputFile::write(const std::string& text) const {
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

std::filesystem::path OutputFile::temporary() const {
    auto name = path_;
    name += ".part" + std::to_string(getpid());
    return name;
}
void OutputFile::refuse() const {
    fail(option_, name_,
         std::string("cannot be written (") + std::strerror(errno) + "); must be a file that can, or -");
}

void add_output(CommandLine& app, const std::string& option, std::optional<OutputFile>& file, const std::string& text) {
    app.add_option_function(option, [&file, option](const std::string& name) { file.emplace(option, name); }, text);
}

}  // namespace support
