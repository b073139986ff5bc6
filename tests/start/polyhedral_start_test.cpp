#include <algorithm>
#include <complex>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/polyhedral/mixed_cells.hpp>
#include <equilibria/start/polyhedral_start.hpp>
#include <equilibria/system/laurent_terms.hpp>

#include "support/catch.hpp"
#include "support/families.hpp"

using namespace equilibria;

TEST_CASE("a polyhedral start has as many paths as the mixed volume, weights are 0 at the cell, 1 at the most") {
    const families::LoadedAngles model{4, families::complete(4)};
    const auto supports = laurent_supports(families::system_of(model, families::generic(model.parameters(), 1)));
    Generator generator(1);
    std::vector<std::complex<double>> coefficients;
    for (int k = 0; k < supports.columns(); ++k) coefficients.push_back(unit_complex(generator));
    const PolyhedralStart start(supports, coefficients, generator);
    CHECK(start.numbering().total() == mixed_volume(supports).value);
    CHECK(start.numbering().total() == 70);
    CHECK(start.weight_ratio() >= 1);
    for (std::uint64_t path = 0; path < start.numbering().total(); ++path) {
        const auto weights = start.weights(path);
        REQUIRE(weights.size() == static_cast<std::size_t>(supports.columns()));
        CHECK(std::ranges::count(weights, 0.0f) == 2 * supports.unknowns());
        CHECK(*std::ranges::max_element(weights) == 1);
        CHECK(*std::ranges::min_element(weights) == 0);
        CHECK(start.rate(path) > 2);
        const auto q = start.point(path);
        for (int u = 0; u < supports.unknowns(); ++u) CHECK(norm2(q.c[u] * q.c[u] + q.s[u] * q.s[u] - 1.0) < 1e-20);
    }
    CHECK_THROWS_AS(PolyhedralStart(supports, {}, generator), InvalidArgument);
}
