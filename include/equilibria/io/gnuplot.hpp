/// \file
/// Pictures are drawn by gnuplot, which must be on the PATH: a script goes in, an image comes out.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>

namespace equilibria {

/// The image that gnuplot makes of a script; `terminal` is the argument of `set terminal`, for instance "svg size 900,700"
/// or "pngcairo size 900,700". Throws std::runtime_error where gnuplot is missing or refuses the script.
inline std::string gnuplot(const std::string& terminal, const std::string& script) {
    namespace fs = std::filesystem;
    std::random_device device;
    const fs::path folder = fs::temp_directory_path() / ("equilibria-" + std::to_string(device()) + std::to_string(device()));
    fs::create_directory(folder);
    const fs::path input = folder / "script.gp", output = folder / "image";
    std::ofstream(input) << "set terminal " << terminal << "\nset output '" << output.string() << "'\n"
                         << script << "\nunset output\n";
    const int status = std::system(("gnuplot '" + input.string() + "' 1>&2").c_str());
    std::ifstream file(output, std::ios::binary);
    const std::string image{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    fs::remove_all(folder);
    if (status != 0 || image.empty())
        throw std::runtime_error("gnuplot is not on the PATH, or refused the script (status " + std::to_string(status) + ")");
    return image;
}

/// A gnuplot data block: `$name << EOD`, the rows, `EOD`.
inline std::string gnuplot_block(const std::string& name, const std::string& rows) {
    return "$" + name + " << EOD\n" + rows + "EOD\n";
}

}  // namespace equilibria
