// Paths that fail in double are tracked with more digits, and only then called failed.
#include <equilibria/enumerate/multiprecision.hpp>

#include "support/enumeration.hpp"
#include "support/models.hpp"

using namespace equilibria;

TEST_CASE("paths to a surface of equilibria that double gives up are ended with more digits") {
    using M = models::EqualAngles<4>;
    std::uint64_t failed_in_double = 0, more_digits = 0;
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
        CAPTURE(seed);
        const auto in_double = enumerate<M>({1, 0.7}, {.seed = seed});
        const auto r = enumerate_carefully<M>({1, 0.7}, {.seed = seed, .threads = 2});
        tests::check_accounts(r);
        CHECK(in_double.paths.more_digits == 0);
        CHECK((r.paths.more_digits > 0) == (in_double.paths.failed > 0));
        CHECK(r.paths.failed == 0);
        CHECK(r.paths.finite == 16);
        CHECK(r.paths.singular == 110);
        CHECK(r.paths.at_infinity == 130);
        REQUIRE(r.families.size() == 1);
        CHECK(r.families[0].dimension == 2);
        CHECK(r.families[0].paths() == 110);
        failed_in_double += in_double.paths.failed;
        more_digits += r.paths.more_digits;
        if (r.paths.more_digits == 0) CHECK(tests::identical(r, in_double));
    }
    // otherwise this tests nothing
    CHECK(failed_in_double > 0);
    CHECK(more_digits > 0);
}

TEST_CASE("more digits are the same for any number of threads") {
    using M = models::EqualAngles<4>;
    const auto one = enumerate_carefully<M>({1, 0.7}, {.threads = 1});
    const auto three = enumerate_carefully<M>({1, 0.7}, {.threads = 3});
    CHECK(one.paths.more_digits > 0);
    CHECK(one.paths.more_digits == three.paths.more_digits);
    CHECK(tests::identical(one, three));
}

TEST_CASE("where double starves for steps, more digits are given more of them") {
    using M = models::EqualAngles<4>;
    EnumerateOptions starved{.seed = 3};
    starved.tracker.most_steps = 210;
    const auto in_double = enumerate<M>({1, 5}, starved);
    CHECK(in_double.paths.failed > 10);
    for (const auto& f : in_double.failures) CHECK(f.reason != FailureReason::none);
    const auto r = enumerate_carefully<M>({1, 5}, starved);
    CHECK(r.paths.failed == 0);
    CHECK(r.paths.finite == 16);
    CHECK(r.paths.singular == 110);
}
