// Parameters at which the count of equilibria is in question: the answer must say so, or be right.
#include <string>

#include "support/enumeration.hpp"

using namespace equilibria;
using mechanisms::TwoLinkChain;
using tests::check_accounts;

namespace {

RootSet<TwoLinkChain> solve(double alpha, double ratio, double omega) {
    const auto r = enumerate<TwoLinkChain>({alpha, ratio, omega});
    INFO("alpha " << alpha << ", ratio " << ratio << ", omega " << omega);
    check_accounts(r);
    CHECK(r.paths.failed == 0);
    return r;
}

/// One degenerate equilibrium, or a mirror pair of them, each reached by `multiplicity` paths.
void check_degenerate(const RootSet<TwoLinkChain>& r, std::uint64_t degenerate, std::int32_t multiplicity,
                      int winding) {
    CHECK_FALSE(r.clean());
    CHECK_FALSE(r.morse_applies());
    CHECK(r.families.empty());
    CHECK(r.degenerate() == degenerate);
    CHECK(r.paths.singular == degenerate * static_cast<std::uint64_t>(multiplicity));
    CHECK(r.paths.finite == 16 - r.paths.singular);
    for (const auto& e : r.equilibria)
        if (e.degenerate()) {
            CHECK(e.nullity == 1);
            CHECK(e.multiplicity == multiplicity);
            CHECK(tests::residual<TwoLinkChain>(e.q, r.parameters) < 1e-12);
        } else {
            CHECK(e.multiplicity == 1);
        }
    for (const auto& root : r.roots)
        if (root.status == PathStatus::singular) CHECK(root.winding_number == winding);
}

std::string printed(const RootSet<TwoLinkChain>& r) {
    std::ostringstream out;
    out << r;
    return out.str();
}

/// Four curves of real equilibria, theta_1 constant on each, and nothing isolated.
void check_free_second_angle(const RootSet<TwoLinkChain>& r) {
    CHECK(r.distinct() == 0);
    CHECK(r.real() == 0);
    CHECK(r.by_index() == std::vector<std::int64_t>{0, 0, 0});
    CHECK(r.families.size() == 4);
    CHECK(printed(r).find("; NOT ISOLATED: at most 4 times a real curve of solutions (16 paths)") != std::string::npos);
    for (const auto& family : r.families) {
        CHECK(family.dimension == 1);
        CHECK(family.real());
        CHECK(family.paths() == 4);
        for (const auto& point : family.points) {
            CHECK(std::abs(point.tangent[0][0]) < 1e-9);
            CHECK(std::abs(point.neighbour[0] - point.q[0]) < 1e-6);
            CHECK(std::abs(point.neighbour[1] - point.q[1]) > 1e-3);
        }
    }
}

}  // namespace

TEST_CASE("two links, on a pitchfork: one degenerate equilibrium, three paths") {
    struct {
        double alpha, omega[4];
    } cases[] = {{.1, {.76450069744675, 1.1257844089591, 1.0322526364616, .83377163246986}},
                 {.4, {.6960675016716, 1.5143539252415, 1.1695539717333, .90127739195077}},
                 {.6, {.66948880558549, 1.9283286560808, 1.3316287206556, .96948528423161}},
                 {.7, {.65870047908076, 2.2631105219176, 1.4650681085145, 1.0175035388023}}};
    for (const auto& c : cases)
        for (const double omega : c.omega) check_degenerate(solve(c.alpha, 1.5, omega), 1, 3, 2);
}

TEST_CASE("two links, on a fold: a mirror pair of double equilibria") {
    for (const auto& [alpha, omega] : {std::pair{.1, 2.3179684357649}, {.4, 2.4293853881739}, {.6, 7.4951235452437}})
        check_degenerate(solve(alpha, 1.5, omega), 2, 2, 2);
    // where the fold curve has a vertical tangent
    check_degenerate(solve(1.0 / 3, 1.5, 2), 2, 2, 2);
}

TEST_CASE("two links, at the cusp: a mirror pair of triple equilibria") {
    const auto r = solve(0.32989617641140, 1.5, 1.93791347451593);
    check_degenerate(r, 2, 3, 3);
    CHECK(printed(r).find("SINGULAR") != std::string::npos);
}

TEST_CASE("two links, close to a curve: the right count, or an honest refusal") {
    const auto count = [](double alpha, double omega, std::uint64_t expected) {
        const auto r = solve(alpha, 1.5, omega);
        if (r.clean())
            CHECK(r.real() == expected);
        else
            CHECK(r.degenerate() > 0);
        return r.clean();
    };
    for (const double e : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13}) {
        CAPTURE(e);
        const bool fold_above = count(.1, 2.3179684357649 + e, 16), fold_below = count(.1, 2.3179684357649 - e, 12);
        const bool fork_above = count(.1, .76450069744675 + e, 6), fork_below = count(.1, .76450069744675 - e, 4);
        // what is resolved is not refused
        CHECK((fold_above && fold_below) == (e > 1e-10));
        if (e >= 1e-6) CHECK((fork_above && fork_below));
    }
}

TEST_CASE("two links, no second mass: the second angle is free, nothing is called regular") {
    const auto r = solve(0, 1.5, 2);
    CHECK_FALSE(r.clean());
    CHECK(r.paths.singular == 16);
    CHECK(r.paths.finite == 0);
    check_free_second_angle(r);
}

TEST_CASE("two links, no second length: the second angle is free, nothing is called regular") {
    const auto r = solve(.5, 0, 1.3);
    CHECK_FALSE(r.clean());
    CHECK(r.paths.singular == 16);
    check_free_second_angle(r);
}

TEST_CASE("two links, no first mass: half of the paths go to infinity") {
    for (const auto& [omega, real] : {std::pair{.5, 4u}, {2.0, 8u}}) {
        const auto r = solve(1, 1.5, omega);
        CHECK(r.paths.finite == 8);
        CHECK(r.paths.at_infinity == 8);
        CHECK(r.real() == real);
        CHECK(r.clean());
        CHECK(r.morse());
    }
}

TEST_CASE("two links, equal ones: nothing special") {
    for (const auto& [omega, real] : {std::pair{.5, 4u}, {1.3, 10u}, {2.0, 12u}, {3.0, 12u}}) {
        const auto r = solve(.5, 1, omega);
        CHECK(r.clean());
        CHECK(r.paths.finite == 16);
        CHECK(r.real() == real);
    }
}

TEST_CASE("two links, at rest and at great speed") {
    const auto rest = solve(.3, 1.5, 0);
    CHECK(rest.real() == 4);
    CHECK(rest.paths.at_infinity == 12);
    CHECK(rest.morse());
    for (const double omega : {1e3, 1e6}) {
        const auto fast = solve(.3, 1.5, omega);
        CHECK(fast.clean());
        CHECK(fast.by_index() == std::vector<std::int64_t>{4, 8, 4});
    }
}

TEST_CASE("equal links without gravity: the folded chain is a triple equilibrium") {
    // cos theta_2 and the sum of the sines vanish together at (pi/2, -pi/2): a row of the Hessian is zero there
    const auto r = enumerate<tests::Chain<2>>(tests::chain<2>({1, 1}, {1, 1}, 1.7, 0));
    check_accounts(r);
    CHECK(r.paths.failed == 0);
    CHECK(r.paths.finite == 10);
    CHECK(r.paths.singular == 6);
    CHECK(r.degenerate() == 2);
    CHECK(r.by_index() == std::vector<std::int64_t>{2, 4, 4});
    for (const auto& e : r.equilibria)
        if (e.degenerate()) {
            CHECK(e.multiplicity == 3);
            CHECK(e.condition > regular_condition);
            CHECK(std::abs(std::cos(e.q[0])) + std::abs(std::cos(e.q[1])) < 1e-6);
        }
    // unequal ones are generic
    const auto unequal = enumerate<tests::Chain<2>>(tests::benchmark_chain<2>());
    tests::check_generic_chain<2>(unequal);
}
