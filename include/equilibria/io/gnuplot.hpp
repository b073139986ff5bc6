/// \file
/// Pictures are drawn by gnuplot, which must be on the PATH: a script goes in, an image comes out. What a script file
/// draws, data and settings, stands before it (GnuplotData), so that the file itself never changes.
/// Where the C++ library knows no files there are data alone.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>
#include <version>

namespace equilibria {

#ifdef __cpp_lib_filesystem
/// The image that gnuplot makes of a script; `terminal` is the argument of `set terminal`, for instance "svg size
/// 900,700" or "pngcairo size 900,700". Throws std::runtime_error where gnuplot is missing or refuses the script.
inline std::string gnuplot(const std::string& terminal, const std::string& script) {
    namespace fs = std::filesystem;
    std::random_device device;
    const fs::path folder =
        fs::temp_directory_path() / ("equilibria-" + std::to_string(device()) + std::to_string(device()));
    fs::create_directory(folder);
    const fs::path input = folder / "script.gp", output = folder / "image";
    std::ofstream(input) << "set terminal " << terminal << "\nset output '" << output.string() << "'\n"
                         << script << "\nunset output\n";
    const int status = std::system(("gnuplot '" + input.string() + "' 1>&2").c_str());
    std::ifstream file(output, std::ios::binary);
    const std::string image{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    fs::remove_all(folder);
    if (status != 0 || image.empty())
        throw std::runtime_error("gnuplot is not on the PATH, or refused the script (status " + std::to_string(status) +
                                 ")");
    return image;
}
#endif

/// A gnuplot data block: `$name << EOD`, the rows, `EOD`.
inline std::string gnuplot_block(const std::string& name, const std::string& rows) {
    return "$" + name + " << EOD\n" + rows + "EOD\n";
}

/// Data blocks and variables for a script file, in the order in which they are given. Numbers have every digit. No
/// array may be called x or y, which gnuplot plots over.
class GnuplotData {
public:
    /// $name: rows of numbers with spaces between. No rows become one that draws nothing, since gnuplot refuses a plot
    /// without data. columns: how many the script reads.
    GnuplotData& block(const std::string& name, const std::string& rows, int columns = 2) {
        std::string nothing;
        for (int k = 0; k < columns; ++k) nothing += "nan ";
        text_ += gnuplot_block(name, rows.empty() ? nothing + "\n" : rows);
        return *this;
    }
    /// A variable; x with every digit.
    GnuplotData& value(const std::string& name, double x) { return assign(name, number(x)); }
    /// An integer variable.
    GnuplotData& integer(const std::string& name, long long n) { return assign(name, std::to_string(n)); }
    /// In single quotes: markup is markup, a backslash is one.
    GnuplotData& string(const std::string& name, std::string_view value) { return assign(name, quoted(value)); }
    /// Arrays count from 1. gnuplot has no empty ones: of nothing there is one entry, 0 or ''.
    GnuplotData& values(const std::string& name, const std::vector<double>& list) {
        return array(name, list, [](double x) { return number(x); }, "0");
    }
    /// An array of texts, in single quotes.
    GnuplotData& strings(const std::string& name, const std::vector<std::string>& list) {
        return array(name, list, [](const std::string& text) { return quoted(text); }, "''");
    }
    const std::string& text() const { return text_; }  ///< everything so far, as lines of a script

private:
    static std::string number(double x) {
        std::ostringstream out;
        out.imbue(std::locale::classic());
        out.precision(17);
        out << x;
        // 3 is an integer to gnuplot, whose 1 / 3 is 0
        return out.str() + (out.str().find_first_of(".en") == std::string::npos ? ".0" : "");
    }
    static std::string quoted(std::string_view value) {
        std::string out = "'";
        for (const char c : value) {
            if (c == '\'') out += '\'';
            out += c == '\n' ? ' ' : c;
        }
        return out + "'";
    }
    GnuplotData& assign(const std::string& name, const std::string& value) {
        text_ += name + " = " + value + "\n";
        return *this;
    }
    template <class List, class Text>
    GnuplotData& array(const std::string& name, const List& list, const Text& text, const char* nothing) {
        // no sum of a literal and a string that ends: g++ 12 takes it for overlapping copies at -O3
        std::string entries = "[";
        for (const auto& entry : list) {
            if (entries.size() > 1) entries += ',';
            entries += text(entry);
        }
        if (list.empty()) entries += nothing;
        entries += ']';
        const std::size_t size = list.empty() ? 1 : list.size();
        return assign("array " + name + "[" + std::to_string(size) + "]", entries);
    }

    std::string text_;
};

}  // namespace equilibria
