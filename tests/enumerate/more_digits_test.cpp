// Paths that fail in double are tracked with more digits, and only then called failed. To have such paths whatever the
// compiler, double is given too few steps for some of the paths to a surface of equilibria.
#include <string>

#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/paths/generic_instance.hpp>

#include "support/enumeration.hpp"
#include "support/families.hpp"
#include "support/models.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;

namespace {

using M = models::EqualAngles<4>;

constexpr TrackerOptions starved{.most_steps = 60};

}  // namespace

TEST_CASE("paths that double gives up are ended with more digits") {
    for (const std::uint64_t seed : {1u, 2u}) {
        CAPTURE(seed);
        const auto in_double = enumerate<M>({1, 0.7}, {.seed = seed}, starved);
        CHECK(in_double.paths.failed > 0);
        CHECK(in_double.paths.more_digits == 0);
        for (const auto& f : in_double.failures) CHECK(f.reason != FailureReason::none);
        const auto r = enumerate_with_more_digits<M>({1, 0.7}, {.seed = seed}, starved);
        tests::check_accounts(r);
        CHECK(r.paths.more_digits > 0);
        CHECK(r.paths.failed == 0);
        CHECK(r.paths.finite == 16);
        CHECK(r.paths.singular == 110);
        CHECK(r.paths.at_infinity == 130);
        REQUIRE(r.families.size() == 1);
        CHECK(r.families[0].dimension == 2);
        CHECK(r.families[0].paths() == 110);
    }
}

TEST_CASE("where no path is stopped nothing is tracked with more digits") {
    using Chain = mechanisms::TwoLinkChain;
    const auto in_double = enumerate<Chain>({.37, 1.5, 2.1});
    REQUIRE(in_double.paths.retracked == 0);
    const auto r = enumerate_with_more_digits<Chain>({.37, 1.5, 2.1});
    CHECK(r.paths.more_digits == 0);
    CHECK(tests::identical(r, in_double));
}

TEST_CASE("more digits end paths at a family as tighter steps in double do, of which some take long") {
    const auto in_double = enumerate<M>({1, 0.7});
    const auto r = enumerate_with_more_digits<M>({1, 0.7});
    CHECK(in_double.paths.failed + r.paths.failed == 0);
    CHECK(r.paths.more_digits <= in_double.paths.retracked);
    CHECK(r.paths.finite == in_double.paths.finite);
    CHECK(r.paths.singular == in_double.paths.singular);
    CHECK(r.paths.at_infinity == in_double.paths.at_infinity);
}

TEST_CASE("more digits are the same for any number of threads") {
    const auto one = enumerate_with_more_digits<M>({1, 0.7}, {}, starved),
               three = enumerate_with_more_digits<M>({1, 0.7}, {.executor = threads(3)}, starved);
    CHECK(one.paths.more_digits > 0);
    CHECK(one.paths.more_digits == three.paths.more_digits);
    CHECK(tests::identical(one, three));
}

TEST_CASE("a checkpoint belongs to runs with more digits, or to those without") {
    const tests::ScratchFile scratch("digits.ckpt");
    const auto first = enumerate_with_more_digits<M>({1, 0.7}, {.checkpoint = scratch.name()}, starved);
    CHECK(tests::identical(enumerate_with_more_digits<M>({1, 0.7}, {.checkpoint = scratch.name()}, starved), first));
    try {
        enumerate<M>({1, 0.7}, {.checkpoint = scratch.name()}, starved);
        FAIL("not refused");
    } catch (const CheckpointError& error) {
        CHECK(error.wrong().find("its more_digits is yes, this run's is no") != std::string::npos);
    }
}

TEST_CASE("bad arguments are refused as by enumerate") {
    CHECK(tests::refusal([] { enumerate_with_more_digits<M>({1, std::nan("")}); }) ==
          "parameters[1] = nan: must be finite");
}

TEST_CASE("paths from a solved instance, too") {
    using Chain = mechanisms::TwoLinkChain;
    const auto solved = enumerate<Chain>({.37, 1.5, 2.1});
    const TrackerOptions options{.most_steps = 40};
    // at rest 12 of the 16 roots are at infinity
    const Parameters<Chain> at_rest{.3, 1.5, 0.};
    CHECK(enumerate(solved, at_rest, {}, options).paths.failed > 0);
    const auto r = enumerate_with_more_digits(solved, at_rest, {}, options);
    tests::check_accounts(r);
    CHECK(r.paths.more_digits > 0);
    CHECK(r.paths.failed == 0);
    CHECK(r.paths.finite == 4);
    CHECK(r.paths.at_infinity == 12);
}

TEST_CASE("badly conditioned regular roots are told from multiple ones with more digits") {
    // Chandrasekhar's equation in 7 unknowns: roots of size 1e5, with conditions up to 7e8
    const auto system = sparse_system(families::chandra(7));
    const auto in_double = solve_polyhedral(system);
    CHECK(in_double.paths.singular > 0);
    const auto found = solve_polyhedral(system, {}, {}, more_digits);
    CHECK(found.paths.accounted_for());
    CHECK(found.paths.finite == 64);
    CHECK(found.roots.size() == 64);
    CHECK(found.paths.more_digits >= in_double.paths.singular);
    // of 8 unknowns roots of size 3e5 at which paths fail in double: they go on from where they stand
    const auto larger = solve_polyhedral(sparse_system(families::chandra(8)), {}, {}, more_digits);
    CHECK(larger.paths.accounted_for());
    CHECK(larger.paths.failed == 0);
    CHECK(larger.paths.finite == 128);
    // of 9 roots of size 1e7, whose paths seem to diverge in some unknowns
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const auto largest = solve_polyhedral(sparse_system(families::chandra(9)), {.seed = seed}, {}, more_digits);
        CHECK(largest.paths.accounted_for());
        CHECK(largest.paths.failed == 0);
        CHECK(largest.paths.finite == 256);
        CHECK(largest.roots.size() == 256);
    }
    // (x - 1)^2 = 0, y^2 - x = 0: two double roots
    const SparseSystem twice(RuntimeSizes(0, 2), {{0, SparseMonomial({2, 0}), 1},
                                                  {0, SparseMonomial({1, 0}), -2},
                                                  {0, SparseMonomial({0, 0}), 1},
                                                  {1, SparseMonomial({0, 2}), 1},
                                                  {1, SparseMonomial({1, 0}), -1}});
    const auto both = solve_total_degree(twice, {}, {}, more_digits);
    CHECK(both.paths.singular == 4);
    CHECK(both.paths.more_digits == 0);
}
