// From one member of a model to another where parameters enter nonlinearly: the line in the space of coefficients
// leaves the model and loses roots, the arc of parameters does not.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <type_traits>
#include <vector>

#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/paths/solve_along.hpp>

#include "support/enumeration.hpp"

using namespace equilibria;

namespace {

/// (x + a y) g_1 = linear, (x + a y) g_2 = linear: the forms of the highest degree share a factor, whose root at
/// infinity is a solution of every member; 3 of 4 solutions are finite. On a line between two members none is at
/// infinity.
struct SharedFactor {
    static constexpr int n_angles = 0, n_coordinates = 2;
    enum Parameter { a, b, c, d, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        using S = std::remove_cvref_t<decltype(x[0] * p[0])>;
        const S shared = x[0] + p[a] * x[1];
        return std::array<S, 2>{S(shared * (x[0] + p[b] * x[1]) + p[d] * x[0] - 0.7 * x[1] - 1.1),
                                S(shared * (x[0] - p[c] * x[1]) - 0.4 * x[0] + x[1] * p[d] + 0.6)};
    }
};
struct SharedFactorAtRunTime {
    int angles() const { return 0; }
    int coordinates() const { return 2; }
    int parameters() const { return SharedFactor::n_parameters; }
    auto equations(const auto& theta, const auto& x, const auto& p) const {
        const auto f = SharedFactor().equations(theta, x, p);
        return std::vector(f.begin(), f.end());
    }
};

}  // namespace

TEST_CASE("an arc of parameters keeps the roots that a line in the space of coefficients loses") {
    const Parameters<SharedFactor> from{0.8, 1.3, 0.6, 0.9}, to{-1.1, 0.4, 1.7, 1.5};
    const auto solved = enumerate<SharedFactor>(from), cold = enumerate<SharedFactor>(to);
    REQUIRE(solved.distinct() == 3);
    REQUIRE(cold.distinct() == 3);
    CHECK(solved.paths.at_infinity == 1);
    std::vector<Root<RuntimeUnknowns>> roots;
    for (const auto& root : solved.roots) {
        roots.emplace_back().q = UnknownArray<RuntimeUnknowns, std::complex<double>>(2);
        std::copy(root.q.begin(), root.q.end(), roots.back().q.begin());
    }
    const RuntimeArray<double> runtime_from{0.8, 1.3, 0.6, 0.9}, runtime_to{-1.1, 0.4, 1.7, 1.5};
    RootSet<RuntimeUnknowns> runtime_solved = enumerate(SharedFactorAtRunTime(), runtime_from);
    int lost = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        const auto line =
            solve_from(roots, sparse_system<SharedFactor>(from), sparse_system<SharedFactor>(to), {.seed = seed});
        lost += line.roots.size() < 3;
        const auto found = enumerate(solved, to, {.seed = seed});
        CHECK(found.paths.total == 3);
        CHECK(found.paths.finite == 3);
        CHECK(found.clean());
        CHECK(tests::same_roots(found, cold, 1e-9));
        for (const auto& root : found.roots) CHECK(root.residual < 1e-13);
        const auto of_runtime_system = enumerate(SharedFactorAtRunTime(), runtime_solved, runtime_to, {.seed = seed});
        CHECK(of_runtime_system.clean());
        CHECK(of_runtime_system.distinct() == 3);
        CHECK(of_runtime_system.by_index() == found.by_index());
        CHECK(of_runtime_system.real() == cold.real());
    }
    CHECK(lost > 0);
}

TEST_CASE("a line serves where the parameters that change enter linearly, and where no solution is at infinity") {
    const auto family = system_family<SharedFactor>();
    const auto affine = [&](const std::vector<std::complex<double>>& p, const std::vector<std::complex<double>>& q) {
        return family.is_affine_between(p, q);
    };
    CHECK(affine({0.8, 1.3, 0.6, 0.9}, {0.8, 1.3, 0.6, 2.9}));
    CHECK(affine({0.8, 1.3, 0.6, 0.9}, {0.8, -2, 0.9, 2.9}));  // of a b + a c one factor changes
    CHECK(!affine({0.8, 1.3, 0.6, 0.9}, {0.9, 1.2, 0.6, 0.9}));
    const auto chain = enumerate<tests::Chain<2>>(tests::benchmark_chain<2>());
    Generator generator(3);
    const auto p = tests::random_chain<2>(generator);
    const auto chains = system_family<tests::Chain<2>>();
    const RuntimeArray<double> a = runtime_array(chain.parameters), b = runtime_array(p);
    CHECK(!chains.is_affine_between(complex_parameters(a), complex_parameters(b)));
    CHECK(detail::line_serves(16, std::array{2, 2}, chains, a, b));
    CHECK(!detail::line_serves(14, std::array{2, 2}, chains, a, b));
}

TEST_CASE("an arc has checkpoints, more digits and the same roots for any number of threads") {
    const Parameters<SharedFactor> from{0.8, 1.3, 0.6, 0.9}, to{-1.1, 0.4, 1.7, 1.5};
    const auto solved = enumerate<SharedFactor>(from);
    const auto one = enumerate(solved, to), four = enumerate(solved, to, {.executor = threads(4)});
    REQUIRE(one.roots.size() == four.roots.size());
    for (std::size_t k = 0; k < one.roots.size(); ++k)
        for (int u = 0; u < 2; ++u) CHECK(one.roots[k].q[u] == four.roots[k].q[u]);
    // steps so few that double fails: 32 digits have more of them
    const auto digits = enumerate_with_more_digits(solved, to, {}, {.most_steps = 2});
    CHECK(digits.paths.failed == 0);
    CHECK(digits.paths.more_digits > 0);
    CHECK(tests::same_roots(digits, one, 1e-9));
}
