// What a RootSet says of itself, without enumerating.
#include <array>
#include <limits>
#include <sstream>
#include <string>

#include <equilibria/enumerate/root_set.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

using M = models::TwoAngleMechanism;

/// x^2 = b.
struct Parabola {
    static constexpr int n_angles = 0, n_coordinates = 1;
    enum Parameter { b, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const { return std::array{x[0] * x[0] - p[b]}; }
};

/// Four equilibria of index 0, 1, 1, 2, the least that the torus allows.
RootSet<M> smallest() {
    RootSet<M> r;
    r.paths.total = r.paths.finite = 4;
    r.roots.resize(4);
    r.equilibria.resize(4);
    const int index[] = {0, 1, 1, 2};
    for (std::size_t k = 0; k < 4; ++k) r.equilibria[k].index = index[k];
    return r;
}

template <class Model>
std::string printed(const RootSet<Model>& r) {
    std::ostringstream out;
    out << r;
    return out.str();
}

}  // namespace

TEST_CASE("a root set against which nothing speaks") {
    const auto r = smallest();
    CHECK(r.paths.accounted_for());
    CHECK(r.clean());
    CHECK(r.morse());
    CHECK(r.by_index() == std::vector<std::int64_t>{1, 2, 1});
    CHECK(printed(r) ==
          "4 paths: 4 finite, 0 at infinity, 0 singular, 0 failed; 4 distinct roots, 4 real: index 0: 1, 1: 2, 2: 1; "
          "Morse relations hold");
}

TEST_CASE("a root set without roots that are not real has none with a smallest imaginary part") {
    CHECK(smallest().smallest_nonreal_imaginary == std::numeric_limits<double>::infinity());
    CHECK(typed<M>(RootSet<RuntimeUnknowns>{}).smallest_nonreal_imaginary == std::numeric_limits<double>::infinity());
}

TEST_CASE("what an index counts is said of models without a potential, and no index of polynomials is printed") {
    RootSet<models::Pendulum> pendulum;
    pendulum.paths.total = pendulum.paths.finite = 2;
    pendulum.roots.resize(2);
    pendulum.equilibria.resize(2);
    pendulum.equilibria[1].index = 1;
    CHECK(printed(pendulum) ==
          "2 paths: 2 finite, 0 at infinity, 0 singular, 0 failed; 2 distinct roots, 2 real: unstable eigenvalues of "
          "dq/dt = -F(q) 0: 1, 1: 1");
    RootSet<Parabola> parabola;
    parabola.paths.total = parabola.paths.finite = 2;
    parabola.roots.resize(2);
    parabola.equilibria.resize(2);
    CHECK(printed(parabola) == "2 paths: 2 finite, 0 at infinity, 0 singular, 0 failed; 2 distinct roots, 2 real");
}

TEST_CASE("what speaks against a root set is printed") {
    auto r = smallest();
    SECTION("a failed path") {
        ++r.paths.total;
        CHECK_FALSE(r.paths.accounted_for());
        ++r.paths.failed;
        CHECK(r.paths.accounted_for());
        CHECK_FALSE(r.clean());
        CHECK(printed(r).find("1 failed") != std::string::npos);
    }
    SECTION("a degenerate equilibrium") {
        r.equilibria[0].nullity = 1;
        CHECK_FALSE(r.clean());
        CHECK_FALSE(r.morse_applies());
        CHECK_FALSE(r.morse());
        CHECK_FALSE(r.equilibria[0].stable());
        CHECK(r.degenerate() == 1);
        CHECK(r.by_index() == std::vector<std::int64_t>{0, 2, 1});
        CHECK(printed(r).find("degenerate: 1") != std::string::npos);
    }
    SECTION("a singular endpoint that is not real") {
        ++r.paths.total;
        ++r.paths.singular;
        r.roots.emplace_back();
        CHECK_FALSE(r.clean());
        CHECK_FALSE(r.morse_applies());
        CHECK(printed(r).find("SINGULAR") != std::string::npos);
    }
    SECTION("a missing saddle") {
        r.equilibria.erase(r.equilibria.begin() + 1);
        CHECK(r.morse_applies());
        CHECK_FALSE(r.morse());
        CHECK_FALSE(r.clean());
        CHECK(printed(r).find("MORSE RELATIONS VIOLATED") != std::string::npos);
    }
    SECTION("a run that was cancelled") {
        ++r.paths.total;
        ++r.paths.cancelled;
        CHECK(r.paths.accounted_for());
        CHECK(r.cancelled());
        CHECK_FALSE(r.clean());
        CHECK_FALSE(r.morse_applies());
        CHECK(printed(r).find("; CANCELLED: 1 paths are not finished") != std::string::npos);
    }
    SECTION("two paths at one root") {
        r.paths.total += 2;
        r.paths.finite += 2;
        CHECK_FALSE(r.clean());
        CHECK(printed(r).find("2 paths ended on another's root") != std::string::npos);
    }
}

TEST_CASE("statuses and reasons have names") {
    for (const auto s : {PathStatus::finite, PathStatus::at_infinity, PathStatus::singular, PathStatus::failed})
        CHECK_FALSE(to_string(s).empty());
    for (const auto r : {FailureReason::none, FailureReason::step_too_small, FailureReason::too_many_steps,
                         FailureReason::endgame_undecided})
        CHECK_FALSE(to_string(r).empty());
}
