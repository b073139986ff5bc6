// Any bytes for a polynomial system: one that comes back as it is when it is written, or an InvalidArgument with its
// place.
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

#include <equilibria/io/polynomial_formats.hpp>
#include <equilibria/io/read_phcpack.hpp>

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
        system = parse_phcpack({reinterpret_cast<const char*>(data), size}, {}, limits);
    } catch (const InvalidArgument& error) {
        const std::string_view what = error.what();
        require_that(what.starts_with("line ") || what.starts_with("number of "));
        return 0;
    }
    std::ostringstream out;
    write_phcpack(out, system);
    // its powers are written out term by term, which takes more products than the input may have
    PolynomialLimits for_written = limits;
    for_written.products *= 1000;
    const auto back = parse_phcpack(out.str(), system.variables, for_written);
    require_that(terms(back) == terms(system));
    return 0;
}
