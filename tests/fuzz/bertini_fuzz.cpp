// Any bytes for a system in the input format of Bertini: one that comes back as it is when it is written, or an
// InvalidArgument with its place.
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <equilibria/io/polynomial_formats.hpp>
#include <equilibria/io/read_bertini.hpp>

using namespace equilibria;
using Z = std::complex<double>;

namespace {

void require_that(bool holds) {
    if (!holds) std::abort();
}

const PolynomialLimits limits{.equations = 8, .variables = 8, .exponent = 200, .nesting = 20, .products = 20'000};

std::vector<std::map<std::vector<int>, Z>> terms(const PolynomialSystem<Z>& system) {
    std::vector<std::map<std::vector<int>, Z>> y;
    for (const auto& equation : system.equations) {
        y.emplace_back();
        for (const auto& t : equation) {
            require_that(std::isfinite(t.coefficient.real()) && std::isfinite(t.coefficient.imag()));
            require_that(t.exponents.size() == system.variables.size());
            require_that(y.back().emplace(t.exponents, t.coefficient).second);
        }
    }
    return y;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    PolynomialSystem<Z> system;
    try {
        const auto read = parse_bertini({reinterpret_cast<const char*>(data), size}, limits);
        require_that(read.grouping.size() == read.polynomials.variables.size());
        system = read.polynomials;
    } catch (const InvalidArgument& error) {
        const std::string_view what = error.what();
        require_that(what.starts_with("line ") || what.starts_with("number of "));
        return 0;
    }
    // names that the writer takes, whatever they were
    for (std::size_t v = 0; v < system.variables.size(); ++v) system.variables[v] = "v" + std::to_string(v);
    std::ostringstream out;
    write_bertini(out, system);
    // its powers are written out term by term, which takes more products than the input may have
    PolynomialLimits for_written = limits;
    for_written.products *= 1000;
    const auto back = parse_bertini(out.str(), for_written).polynomials;
    require_that(back.variables == system.variables);
    require_that(terms(back) == terms(system));
    return 0;
}
