#include <cmath>
#include <complex>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/start/binomial_system.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Number = std::complex<double>;

TEST_CASE("the diagonal of a Hermite form multiplies to the determinant, a singular matrix is refused") {
    const auto diagonal = hermite_diagonal({{2, 1}, {0, 3}});
    CHECK(diagonal[0] * diagonal[1] == 6);
    CHECK(hermite_diagonal({{1, 1}, {1, -1}}) == std::vector<std::int64_t>{1, 2});
    CHECK_THROWS_AS(hermite_diagonal({{1, 2}, {2, 4}}), InvalidArgument);
}

TEST_CASE("a binomial system of 2^64 solutions or more is refused, one of fewer has its number") {
    const std::vector<Number> ratio(3, Number(1));
    const auto diagonal = [](int a, int b, int c) {
        return std::vector<std::vector<int>>{{a, 0, 0}, {0, b, 0}, {0, 0, c}};
    };
    CHECK(BinomialSystem(diagonal(1 << 30, 1 << 30, 8), ratio).solutions() == std::uint64_t{1} << 63);
    CHECK_THROWS_WITH(BinomialSystem(diagonal(1 << 30, 1 << 30, 16), ratio),
                      "exponents = the absolute value of their determinant: must be below 2^64");
}

TEST_CASE("binomial systems: as many solutions as the determinant, all different on the torus, each fulfils them") {
    Generator generator(5);
    for (int draw = 0; draw < 100; ++draw) {
        const int n = 1 + draw % 4;
        std::vector<std::vector<int>> exponents;
        std::vector<Number> ratio;
        for (int i = 0; i < n; ++i) {
            exponents.emplace_back();
            for (int u = 0; u < n; ++u) exponents.back().push_back(static_cast<int>(generator() % 5) - 2);
            ratio.push_back(unit_complex(generator) * uniform(generator, 0.5, 2));
        }
        std::uint64_t volume = 1;
        try {
            std::vector<std::vector<std::int64_t>> matrix;
            for (const auto& row : exponents) matrix.emplace_back(row.begin(), row.end());
            for (const auto d : hermite_diagonal(matrix)) volume *= static_cast<std::uint64_t>(d);
        } catch (const InvalidArgument&) {
            continue;
        }
        const BinomialSystem system(exponents, ratio);
        REQUIRE(system.solutions() == volume);
        std::vector<std::vector<Number>> points;
        for (std::uint64_t k = 0; k < volume; ++k) {
            const auto theta = system.solution(k);
            points.emplace_back();
            for (const auto& angle : theta) points.back().push_back(std::exp(Number(0, 1) * angle));
            for (int i = 0; i < n; ++i) {
                Number product = 1;
                for (int u = 0; u < n; ++u)
                    product *= std::pow(points.back()[static_cast<std::size_t>(u)],
                                        exponents[static_cast<std::size_t>(i)][static_cast<std::size_t>(u)]);
                CHECK(std::abs(product / ratio[static_cast<std::size_t>(i)] - 1.0) < 1e-12);
            }
        }
        for (std::size_t a = 0; a < points.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                double apart = 0;
                for (std::size_t u = 0; u < points[a].size(); ++u)
                    apart = std::max(apart, std::abs(points[a][u] / points[b][u] - 1.0));
                CHECK(apart > 1e-3);
            }
    }
}
