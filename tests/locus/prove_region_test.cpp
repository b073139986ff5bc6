#include <cmath>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/proof/prove_region.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using M = mechanisms::TwoLinkChain;

namespace {

RegionProof proved(const Window& window, double min_cell, unsigned count = 1) {
    return prove_region<M, M::alpha, M::omega>({{.5, 1.5, 1}}, window, {.executor = threads(count)},
                                               {.min_cell = min_cell});
}
double area(const Window& w) { return w.width() * w.height(); }

}  // namespace

TEST_CASE("each proved count is what an enumeration finds at random points of the cell") {
    const auto proof = proved({{.1, .6}, {.4, 2.8}}, 0.012);
    CHECK(proof.proved_area_share > 0.6);
    Generator generator(1);
    for (std::size_t k = 0; k < proof.cells.size(); k += 1 + proof.cells.size() / 100) {
        const auto& cell = proof.cells[k];
        const double alpha = uniform(generator, cell.window.x.low, cell.window.x.high);
        const auto set = enumerate<M>({{alpha, 1.5, uniform(generator, cell.window.y.low, cell.window.y.high)}});
        CHECK(static_cast<std::int64_t>(set.real()) == cell.count);
        CHECK(set.by_index() == cell.by_index);
    }
}

TEST_CASE("cells and undecided cells tile the window") {
    const Window window{{.1, .6}, {.4, 2.8}};
    const auto proof = proved(window, 0.1);
    double sum = 0, share = 0;
    for (const auto& cell : proof.cells) share += area(cell.window);
    for (const auto& cell : proof.undecided) {
        sum += area(cell);
        CHECK(std::max(cell.width(), cell.height()) <= 0.1);
    }
    CHECK(sum + share == Approx(area(window)).epsilon(1e-12));
    CHECK(proof.proved_area_share == Approx(share / area(window)).epsilon(1e-12));
    CHECK(proof.tested == 2 * (proof.cells.size() + proof.undecided.size()) - 1);
}

TEST_CASE("no cell that a known fold or pitchfork runs through is proved") {
    // r = 1.5, alpha = .1 and .4, computed independently: interval branch and bound, multiprecision
    const double at[][2] = {{.1, .76450069744675}, {.1, 1.1257844089591}, {.1, 1.0322526364616}, {.1, .83377163246986},
                            {.1, 2.3179684357649}, {.4, .6960675016716},  {.4, 1.5143539252415}, {.4, 1.1695539717333},
                            {.4, .90127739195077}, {.4, 2.4293853881739}};
    for (const auto& [alpha, omega] : at) {
        const auto proof = proved({{alpha - 0.004, alpha + 0.004}, {omega - 0.004, omega + 0.004}}, 1e-3);
        for (const auto& cell : proof.cells) CHECK_FALSE(cell.window.contains(alpha, omega));
        // next to the curve something is proved, on both sides of it
        std::int64_t fewest = 100, most = 0;
        for (const auto& cell : proof.cells) fewest = std::min(fewest, cell.count), most = std::max(most, cell.count);
        CHECK(most > fewest);
    }
}

TEST_CASE("where complex roots go to infinity the real torus is searched") {
    // no curve of the locus here; at alpha = 1 and at omega = 0 the total degree is not reached
    const auto proof = proved({{.9, 1}, {0, .6}}, 1e-2);
    CHECK(proof.undecided.empty());
    bool searched = false;
    for (const auto& cell : proof.cells) {
        CHECK(cell.by_index == std::vector<std::int64_t>{1, 2, 1});
        searched = searched || cell.argument == CountArgument::real_search;
    }
    CHECK(searched);
}

TEST_CASE("the threads change nothing, and bad windows are refused") {
    const Window window{{.2, .3}, {.5, .9}};
    const auto one = proved(window, 0.02, 1), two = proved(window, 0.02, 2);
    REQUIRE(one.cells.size() == two.cells.size());
    for (std::size_t k = 0; k < one.cells.size(); ++k) {
        CHECK(one.cells[k].window.x.low == two.cells[k].window.x.low);
        CHECK(one.cells[k].by_index == two.cells[k].by_index);
    }
    CHECK_THROWS_AS(proved({{.3, .2}, {0, 1}}, 0.1), InvalidArgument);
    CHECK_THROWS_WITH(proved({{.1, .2}, {0, 1}}, 0), "min_cell = 0: must be positive and finite");
}
