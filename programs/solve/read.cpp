// Reads a file of solve's, and finds out which of the formats it has.
#include <complex>
#include <cstddef>
#include <string>
#include <utility>

#include <equilibria/io/polynomial_limits.hpp>
#include <equilibria/io/read_bertini.hpp>
#include <equilibria/io/read_phcpack.hpp>
#include <equilibria/io/read_text.hpp>
#include <equilibria/system/sparse_system.hpp>

#include "solve/solution.hpp"

namespace solve {

namespace {

/// PHCpack's files begin with a number.
bool is_phcpack(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string::npos && '0' <= text[first] && text[first] <= '9';
}

Input input_of(std::string format, const equilibria::PolynomialSystem<std::complex<double>>& system,
               std::vector<int> grouping) {
    return {std::move(format), system.variables, equilibria::sparse_system(system), std::move(grouping)};
}

}  // namespace

Input read(const std::string& path, const std::string& format) {
    const equilibria::PolynomialLimits limits;
    const std::string text = equilibria::read_text(path, limits.bytes);
    if (format == "phcpack" || (format == "auto" && is_phcpack(text)))
        return input_of("PHCpack", equilibria::parse_phcpack(text, {}, limits), {});
    auto [system, grouping] = equilibria::parse_bertini(text, limits);
    bool groups = false;
    for (const int g : grouping) groups = groups || g > 0;
    if (!groups) grouping.clear();
    return input_of("Bertini", system, std::move(grouping));
}

}  // namespace solve
