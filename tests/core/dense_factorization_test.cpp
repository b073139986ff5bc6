// LU with row exchanges: residuals, derivatives through the solution, singular matrices.
#include <cmath>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using equilibria::detail::DenseFactorization;

namespace {

template <class S, int N>
using Matrix = Array<Array<S, N>, N>;

template <int N>
Matrix<double, N> random_matrix(Generator& generator) {
    Matrix<double, N> a;
    for (auto& row : a)
        for (double& x : row) x = uniform(generator, -1, 1);
    return a;
}

template <class S, int N>
Array<S, N> product(const Matrix<S, N>& a, const Array<S, N>& x) {
    Array<S, N> y;
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) y[i] = y[i] + a[i][j] * x[j];
    return y;
}

}  // namespace

TEST_CASE("A dense factorisation solves to rounding") {
    Generator generator(1);
    for (int round = 0; round < 50; ++round) {
        const auto a = random_matrix<6>(generator);
        Array<double, 6> b;
        for (double& x : b) x = uniform(generator, -1, 1);
        const DenseFactorization<double, 6> factors(a);
        REQUIRE(factors.regular());
        const auto x = factors.solve(b), back = product(a, x);
        double size = 0;
        for (double value : x) size = std::max(size, std::abs(value));
        for (int i = 0; i < 6; ++i) CHECK(std::abs(back[i] - b[i]) < 1e-14 * (1 + 10 * size));
    }
}

TEST_CASE("A dense factorisation exchanges rows where a pivot is 0") {
    const DenseFactorization<double, 3> factors({{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}});
    REQUIRE(factors.regular());
    CHECK(factors.solve({1, 2, 3}) == Array<double, 3>{3, 1, 2});
}

TEST_CASE("A singular matrix and one that is not finite are no regular factorisations") {
    CHECK_FALSE(DenseFactorization<double, 2>({{{1, 2}, {2, 4}}}).regular());
    CHECK_FALSE(DenseFactorization<double, 2>({{{0, 0}, {0, 0}}}).regular());
    CHECK_FALSE(DenseFactorization<double, 2>({{{NAN, 1}, {NAN, 2}}}).regular());
}

TEST_CASE("A solution comes with its derivatives") {
    using D = Dual<double, 2>;
    Generator generator(2);
    Matrix<D, 4> a;
    Array<D, 4> b;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            a[i][j] = D(uniform(generator, -1, 1));
            for (double& x : a[i][j].derivative) x = uniform(generator, -1, 1);
        }
        b[i] = D(uniform(generator, -1, 1));
        for (double& x : b[i].derivative) x = uniform(generator, -1, 1);
    }
    const DenseFactorization<D, 4> factors(a);
    REQUIRE(factors.regular());
    const auto back = product(a, factors.solve(b));  // (a x)' = b'
    for (int i = 0; i < 4; ++i) {
        CHECK(back[i].value == Approx(b[i].value).margin(1e-13));
        for (int k = 0; k < 2; ++k) CHECK(back[i].derivative[k] == Approx(b[i].derivative[k]).margin(1e-12));
    }
}

TEST_CASE("A dense factorisation of a size known at run time is the same, operation by operation") {
    Generator generator(3);
    const auto a = random_matrix<5>(generator);
    RuntimeMatrix<double> same(5);
    RuntimeArray<double> b(5);
    Array<double, 5> right;
    for (int i = 0; i < 5; ++i) {
        b[i] = right[i] = uniform(generator, -1, 1);
        for (int j = 0; j < 5; ++j) same[i][j] = a[i][j];
    }
    const DenseFactorization<double, at_run_time> factors(same);
    REQUIRE(factors.regular());
    const auto x = factors.solve(b);
    const auto expected = DenseFactorization<double, 5>(a).solve(right);
    for (int i = 0; i < 5; ++i) CHECK(x[i] == expected[i]);
    CHECK_FALSE(DenseFactorization<double, at_run_time>(RuntimeMatrix<double>(2)).regular());
}
