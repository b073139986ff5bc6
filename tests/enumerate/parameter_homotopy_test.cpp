#include "support/enumeration.hpp"

using namespace equilibria;
using tests::Chain;

TEST_CASE("a solved instance leads to the roots of any other") {
    const auto solved = enumerate<Chain<3>>(tests::benchmark_chain<3>());
    Generator generator(11);
    for (int k = 0; k < 3 * tests::thoroughness; ++k) {
        const auto p = tests::random_chain<3>(generator);
        const auto r = enumerate(solved, p, {.seed = static_cast<std::uint64_t>(k)});
        const auto direct = enumerate<Chain<3>>(p);
        tests::check_generic_chain<3>(r);
        CHECK(tests::same_roots(r, direct, 1e-9));
        CHECK(r.by_index() == direct.by_index());
    }
}

TEST_CASE("a solved instance of fewer roots needs fewer paths") {
    const auto solved = enumerate<Chain<3>>(tests::benchmark_chain<3>(0));
    REQUIRE(solved.distinct() == 8);
    auto p = tests::benchmark_chain<3>(0);
    p[Chain<3>::gravity] = 2;
    const auto r = enumerate(solved, p);
    CHECK(r.paths.total == 8);
    CHECK(r.real() == 8);
    CHECK(r.clean());
}

TEST_CASE("an instance with singular roots is refused as a start") {
    const auto singular = enumerate<Chain<3>>(tests::chain<3>({1, 1, 1}, {1, 1, 1}, 1.7, 0));
    REQUIRE(singular.paths.singular > 0);
    const auto said = tests::refusal([&] { enumerate(singular, tests::benchmark_chain<3>()); });
    CHECK(said.starts_with("solved.paths = 0 failed, "));
    CHECK(said.ends_with(" singular: a start instance must have regular roots only"));
}

TEST_CASE("parameters that are not finite are refused") {
    const auto solved = enumerate<Chain<3>>(tests::benchmark_chain<3>());
    auto p = tests::benchmark_chain<3>();
    p[Chain<3>::omega] = std::nan("");
    CHECK(tests::refusal([&] { enumerate(solved, p); }) == "parameters[6] = nan: must be finite");
    CHECK(tests::refusal([&] { enumerate<Chain<3>>(p); }) == "parameters[6] = nan: must be finite");
}
