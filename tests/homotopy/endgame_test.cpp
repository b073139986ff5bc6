// Where paths end, on equations whose paths are known: sin theta = 1 (winding number 2), x^3 = 0 (3), no solution at
// all.
#include <array>
#include <cmath>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/endgame.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

/// x^3 - a x - b = 0.
struct Cubic {
    static constexpr int n_angles = 0, n_coordinates = 1;
    enum Parameter { a, b, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        return std::array{pow(x[0], 3) - p[a] * x[0] - p[b]};
    }
};

/// load sin theta = torque: without a load all paths go to infinity.
struct Loaded {
    static constexpr int n_angles = 1;
    enum Parameter { load, torque, n_parameters };
    constexpr auto equations(const auto& theta, const auto& p) const {
        return std::array{p[load] * sin(theta[0]) - p[torque]};
    }
};

/// small x^4 = 1: x grows like (1 - t)^(-1/4) until 1 - t is as small.
struct SlowQuartic {
    static constexpr int n_angles = 0, n_coordinates = 1;
    enum Parameter { small, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        return std::array{p[small] * pow(x[0], 4) - 1.0};
    }
};

template <class M>
struct Ends {
    std::vector<Endpoint> ends;

    explicit Ends(const Parameters<M>& p, std::uint64_t seed = 1) {
        Generator generator(seed);
        const ModelSystem<M> target(p);
        const TotalDegree<M> start(target, generator);
        const PolynomialHomotopy h = model_homotopy(target, start);
        const detail::Polisher polisher(h);
        for (std::uint64_t path = 0; path < static_cast<std::uint64_t>(total_degree<M>()); ++path)
            ends.push_back(detail::Endgame(h, polisher, TrackerOptions{}).from_start(runtime_point(start.point(path))));
    }
    void check(PathStatus status, int winding) const {
        for (const auto& end : ends) {
            CHECK(end.status == status);
            CHECK(end.winding_number == winding);
            CHECK(end.steps < 2000);
        }
    }
};

}  // namespace

TEST_CASE("endgame: regular endpoints") {
    for (const std::uint64_t seed : {1, 2, 3}) {
        Ends<models::Pendulum>({0.5}, seed).check(PathStatus::finite, 1);
        Ends<Cubic>({1, 0}, seed).check(PathStatus::finite, 1);
        Ends<Cubic>({1e8, 1}, seed).check(PathStatus::finite, 1);
    }
}

TEST_CASE("endgame: a fold has winding number 2, a cusp 3") {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Ends<models::Pendulum> fold({1}, seed);
        fold.check(PathStatus::singular, 2);
        for (const auto& end : fold.ends) CHECK(std::sqrt(norm2(end.q.c[0])) < 1e-7);
        const Ends<Cubic> cusp({0, 0}, seed);
        cusp.check(PathStatus::singular, 3);
        for (const auto& end : cusp.ends) CHECK(std::sqrt(norm2(end.q.x[0])) < 1e-7);
    }
}

TEST_CASE("endgame: one double root and a simple one") {
    // x^3 - 3x - 2 = (x + 1)^2 (x - 2)
    const Ends<Cubic> mixed({3, 2});
    int singular = 0;
    for (const auto& end : mixed.ends) {
        singular += end.status == PathStatus::singular;
        const double expected = end.status == PathStatus::singular ? -1 : 2;
        CHECK(std::abs(end.q.x[0].re - expected) < 1e-7);
        CHECK(end.winding_number == (end.status == PathStatus::singular ? 2 : 1));
    }
    CHECK(singular == 2);
}

TEST_CASE("endgame: no solution, all paths at infinity") {
    for (const std::uint64_t seed : {1, 2, 3}) {
        for (const auto& end : Ends<Loaded>({0, 1}, seed).ends) CHECK(end.status == PathStatus::at_infinity);
        for (const auto& end : Ends<SlowQuartic>({0}, seed).ends) CHECK(end.status == PathStatus::at_infinity);
    }
}

TEST_CASE("endgame: solutions far away are solutions") {
    for (const double load : {1e-1, 1e-2, 1e-4, 1e-6}) {
        CAPTURE(load);
        const Ends<Loaded> far({load, 1});
        far.check(PathStatus::finite, 1);
        for (const auto& end : far.ends) CHECK(std::sqrt(norm2(end.q.s[0])) == Approx(1 / load));
    }
}

TEST_CASE("endgame: solutions far away are solutions, however slowly they are reached") {
    for (const double small : {1e-4, 1e-6, 1e-8, 1e-10, 1e-11}) {
        CAPTURE(small);
        const Ends<SlowQuartic> far({small});
        far.check(PathStatus::finite, 1);
        for (const auto& end : far.ends) CHECK(std::sqrt(norm2(end.q.x[0])) == Approx(std::pow(small, -0.25)));
    }
}
