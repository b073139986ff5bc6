#include <cmath>
#include <complex>
#include <type_traits>

#include <equilibria/core/linear_solve.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Z = std::complex<double>;
using Pack = Lanes<native_lanes>;

namespace {

template <class R>
double tolerance() {
    return std::is_same_v<R, long double> ? 1e-16 : 1e-13;
}

template <class R>
Complex<R> draw(Generator& generator) {
    Complex<R> z;
    for (int k = 0; k < LaneTraits<R>::width; ++k)
        set_lane(z, k, Z(uniform(generator, -1, 1), uniform(generator, -1, 1)));
    return z;
}

/// max_i |A x - b|_i over all lanes.
template <class R, int N>
double residual(const Complex<R> (&a)[N][N], const Complex<R> (&x)[N], const Complex<R> (&b)[N]) {
    double largest = 0;
    for (int i = 0; i < N; ++i) {
        Complex<R> sum = -b[i];
        for (int j = 0; j < N; ++j) sum += a[i][j] * x[j];
        for (int k = 0; k < LaneTraits<R>::width; ++k) {
            const double size = std::abs(lane(sum, k));
            largest = size <= largest ? largest : size;  // a NaN is large
        }
    }
    return largest;
}

/// A x = b for random A (complex symmetric for LDL^T, and dominant: it does not pivot), x overwriting b.
template <template <class> class Factorization, class R, int N>
void check(Generator& generator, bool symmetric) {
    for (int trial = 0; trial < 10; ++trial) {
        Complex<R> a[N][N], b[N], x[N];
        for (int i = 0; i < N; ++i) {
            x[i] = b[i] = draw<R>(generator);
            for (int j = 0; j < N; ++j) a[i][j] = symmetric && j < i ? a[j][i] : draw<R>(generator);
            if (symmetric) a[i][i] += 2.0 * N * broadcast_complex<R>({0.8, 0.6});
        }
        Factorization<R> factors(N);
        factors.factor(a);
        factors.solve(x);
        double size = 1;
        for (const auto& z : x)
            for (int k = 0; k < LaneTraits<R>::width; ++k) size = std::max(size, std::abs(lane(z, k)));
        CHECK(residual(a, x, b) < N * size * tolerance<R>());
    }
}

}  // namespace

TEMPLATE_TEST_CASE("LDL^T leaves a small residual", "", double, long double, Pack) {
    Generator generator(1);
    check<SymmetricFactorization, TestType, 1>(generator, true);
    check<SymmetricFactorization, TestType, 2>(generator, true);
    check<SymmetricFactorization, TestType, 3>(generator, true);
    check<SymmetricFactorization, TestType, 4>(generator, true);
    check<SymmetricFactorization, TestType, 5>(generator, true);
    check<SymmetricFactorization, TestType, 8>(generator, true);
}

TEMPLATE_TEST_CASE("LU with partial pivoting leaves a small residual", "", double, long double, Pack) {
    Generator generator(2);
    check<PivotedFactorization, TestType, 1>(generator, false);
    check<PivotedFactorization, TestType, 2>(generator, false);
    check<PivotedFactorization, TestType, 3>(generator, false);
    check<PivotedFactorization, TestType, 4>(generator, false);
    check<PivotedFactorization, TestType, 5>(generator, false);
    check<PivotedFactorization, TestType, 8>(generator, false);
}

TEST_CASE("only the upper triangle of a symmetric matrix is read") {
    Complex<double> a[2][2] = {{{2, 1}, {0.5, 0}}, {{99, 99}, {3, 0}}}, x[2] = {{1, 0}, {0, 1}};
    const Complex<double> b[2] = {x[0], x[1]};
    SymmetricFactorization<double> factors(2);
    factors.factor(a);
    factors.solve(x);
    a[1][0] = a[0][1];
    CHECK(residual(a, x, b) < 1e-15);
}

TEST_CASE("a zero on the diagonal: LU exchanges rows, LDL^T gives what no test accepts") {
    const Complex<double> a[2][2] = {{{0, 0}, {1, 0}}, {{1, 0}, {1, 0}}}, b[2] = {{2, 0}, {5, 0}};
    Complex<double> x[2] = {b[0], b[1]}, y[2] = {b[0], b[1]};
    PivotedFactorization<double> lu(2);
    lu.factor(a);
    lu.solve(x);
    CHECK(residual(a, x, b) < 1e-15);
    SymmetricFactorization<double> ldl(2);
    ldl.factor(a);
    ldl.solve(y);
    CHECK_FALSE(norm2(y[0]) < 1e300);
}

TEST_CASE("each lane pivots for itself, and a singular lane leaves the others alone") {
    using Two = Lanes<2>;
    const auto solve = [](const double(&first)[2][2], const double(&second)[2][2], Complex<Two>(&x)[2]) {
        Complex<Two> a[2][2];
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j) set_lane(a[i][j], 0, first[i][j]), set_lane(a[i][j], 1, second[i][j]);
        for (int i = 0; i < 2; ++i) x[i] = Complex<Two>(i + 1.0);
        PivotedFactorization<Two> lu(2);
        lu.factor(a);
        lu.solve(x);
    };
    const double identity[2][2] = {{1, 0}, {0, 1}}, exchanged[2][2] = {{1e-18, 1}, {1, 0}},
                 singular[2][2] = {{1, 1}, {1, 1}};
    Complex<Two> x[2];
    solve(exchanged, identity, x);
    CHECK(std::abs(lane(x[0], 0) - 2.0) < 1e-15);
    CHECK(std::abs(lane(x[1], 0) - 1.0) < 1e-15);
    CHECK(std::abs(lane(x[0], 1) - 1.0) < 1e-15);
    CHECK(std::abs(lane(x[1], 1) - 2.0) < 1e-15);
    solve(singular, identity, x);
    CHECK_FALSE(std::abs(lane(x[1], 0)) < 1e300);
    CHECK(std::abs(lane(x[1], 1) - 2.0) < 1e-15);
}

TEMPLATE_TEST_CASE("the inverse and its rows' weighted sums are those of solutions for unit vectors", "", double,
                   Pack) {
    using R = TestType;
    constexpr int n = 5;
    Generator generator(11);
    for (int trial = 0; trial < 20; ++trial) {
        RuntimeMatrix<Complex<R>> a(n), y(n);
        RuntimeArray<R> weights(n), sums(n), expected(n);
        for (int i = 0; i < n; ++i) {
            weights[i] = broadcast<R>(uniform(generator, 0.5, 2));
            for (int j = 0; j < n; ++j) a[i][j] = draw<R>(generator);
            a[i][i] = 1e-3 * a[i][i];  // rows are exchanged
        }
        PivotedFactorization<R> lu(n);
        lu.factor(a);
        lu.inverse_into(y);
        double difference = 0;
        for (int c = 0; c < n; ++c) {
            Complex<R> e[n];
            for (int r = 0; r < n; ++r) e[r] = Complex<R>(r == c ? 1.0 : 0.0);
            lu.solve(e);
            for (int r = 0; r < n; ++r) {
                expected[r] = expected[r] + weights[c] * square_root(norm2(e[r]));
                for (int k = 0; k < LaneTraits<R>::width; ++k)
                    difference = std::max(difference,
                                          std::abs(lane(y[r][c], k) - lane(e[r], k)) / (1 + std::abs(lane(e[r], k))));
            }
        }
        CHECK(difference < 1e-13);
        lu.sum_inverse(weights, sums);
        for (int r = 0; r < n; ++r)
            for (int k = 0; k < LaneTraits<R>::width; ++k)
                CHECK(lane(sums[r], k) == Approx(lane(expected[r], k)).epsilon(1e-12));
    }
}
