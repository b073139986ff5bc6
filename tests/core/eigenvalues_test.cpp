// The double-shift QR algorithm: matrices with known eigenvalues, invariants, exact conjugates, and Eigen's solver.
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/eigenvalues.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using Z = std::complex<double>;

namespace {

std::vector<double> entries(const Eigen::MatrixXd& a) { return {a.data(), a.data() + a.size()}; }
std::vector<Z> eigenvalues_of(const Eigen::MatrixXd& a) {
    return eigenvalues(static_cast<std::size_t>(a.rows()), entries(a));
}
Eigen::MatrixXd random_matrix(int n, Generator& generator) {
    Eigen::MatrixXd a(n, n);
    for (double& x : a.reshaped()) x = uniform(generator, -1, 1);
    return a;
}
/// The largest distance from a value of one list to the nearest of the other, each taken once.
double apart(std::vector<Z> a, std::vector<Z> b) {
    if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
    double y = 0;
    for (const Z& z : a) {
        const auto nearest = std::min_element(
            b.begin(), b.end(), [&](const Z& v, const Z& w) { return std::abs(v - z) < std::abs(w - z); });
        y = std::max(y, std::abs(*nearest - z));
        b.erase(nearest);
    }
    return y;
}
/// The companion matrix of the monic polynomial with these roots.
Eigen::MatrixXd companion(const std::vector<double>& roots) {
    std::vector<double> c{1};
    for (const double r : roots) {
        c.push_back(0);
        for (std::size_t k = c.size() - 1; k > 0; --k) c[k] -= r * c[k - 1];
    }
    const auto n = static_cast<Eigen::Index>(roots.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index k = 0; k < n; ++k) a(0, k) = -c[static_cast<std::size_t>(k + 1)];
    for (Eigen::Index k = 1; k < n; ++k) a(k, k - 1) = 1;
    return a;
}

}  // namespace

TEST_CASE("the roots of a polynomial are the eigenvalues of its companion matrix") {
    const std::vector<double> roots{-3, -1, 0.5, 2, 4};
    CHECK(apart(eigenvalues_of(companion(roots)), {roots.begin(), roots.end()}) < 1e-12);
}

TEST_CASE("a turn has a pair on the unit circle, a nilpotent and a zero matrix have zeros") {
    for (const double angle : {0.1, 1.0, 3.0}) {
        Eigen::MatrixXd turn(2, 2);
        turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        CHECK(apart(eigenvalues_of(turn), {std::polar(1.0, angle), std::polar(1.0, -angle)}) < 1e-15);
    }
    Eigen::MatrixXd above = Eigen::MatrixXd::Zero(4, 4);
    CHECK(apart(eigenvalues_of(above), std::vector<Z>(4)) == 0);
    above(0, 1) = above(1, 2) = above(2, 3) = 7;
    CHECK(apart(eigenvalues_of(above), std::vector<Z>(4)) == 0);
}

TEST_CASE("a cyclic permutation, which plain shifts leave as it is, has the roots of unity") {
    for (const int n : {3, 4, 8}) {
        Eigen::MatrixXd cycle = Eigen::MatrixXd::Zero(n, n);
        std::vector<Z> unity;
        for (int k = 0; k < n; ++k) {
            cycle((k + 1) % n, k) = 1;
            unity.push_back(std::polar(1.0, 2 * 3.14159265358979323846 * k / n));
        }
        CHECK(apart(eigenvalues_of(cycle), unity) < 1e-14);
    }
}

TEST_CASE("eigenvalues are those of Eigen's solver, add up to the trace and come as exact conjugates") {
    Generator generator(1);
    for (const int n : {1, 2, 3, 4, 7, 12, 30})
        for (int round = 0; round < 20; ++round)
            for (const double scale : {1.0, 1e-200, 1e200}) {
                const Eigen::MatrixXd a = scale * random_matrix(n, generator);
                const auto found = eigenvalues_of(a);
                const auto values = tests::eigenvalues(a);
                CHECK(apart(found, {values.begin(), values.end()}) < 1e-10 * scale);
                Z trace = 0;
                for (const Z& z : found) {
                    trace += z;
                    CHECK(std::count(found.begin(), found.end(), std::conj(z)) >= 1);
                }
                CHECK(std::abs(trace - a.trace()) < 1e-13 * n * scale);
            }
}

TEST_CASE("eigenvalues do not change under similarity, the order of the entries or the scalar") {
    Generator generator(2);
    const Eigen::MatrixXd d = Eigen::Vector4d(-2, -0.5, 1, 3).asDiagonal();
    for (int round = 0; round < 10; ++round) {
        const Eigen::MatrixXd s = random_matrix(4, generator) + 2 * Eigen::MatrixXd::Identity(4, 4);
        const Eigen::MatrixXd a = s * d * tests::inverse(s), transposed = a.transpose();
        CHECK(apart(eigenvalues_of(a), {-2, -0.5, 1, 3}) < 1e-12);
        CHECK(apart(eigenvalues_of(transposed), {-2, -0.5, 1, 3}) < 1e-12);
        const auto list = entries(a);
        const auto precise = eigenvalues(4, std::vector<long double>(list.begin(), list.end()));
        CHECK(apart({precise.begin(), precise.end()}, {-2, -0.5, 1, 3}) < 1e-12);
    }
}

TEST_CASE("eigenvalues of what is not finite are NaN, and of too few entries refused") {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        const auto y = eigenvalues<double>(2, {1, 2, bad, 4});
        REQUIRE(y.size() == 2);
        CHECK(std::isnan(y[0].real()));
        CHECK(std::isnan(y[1].imag()));
    }
    CHECK(eigenvalues<double>(0, {}).empty());
    CHECK_THROWS_WITH(eigenvalues<double>(2, {1, 2, 3}), Catch::Contains("entries") && Catch::Contains("4"));
}
