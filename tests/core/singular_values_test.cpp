#include <complex>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/core/singular_values.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Vector = SingularValues::Vector;

Vector random_matrix(int rows, int columns, int rank, bool real, Generator& generator) {
    const auto draw = [&] {
        const double re = uniform(generator, -1, 1), im = uniform(generator, -1, 1);
        return std::complex<double>(re, real ? 0 : im);
    };
    Vector a(static_cast<std::size_t>(rows * columns));
    for (int k = 0; k < rank; ++k) {
        Vector u, v;
        for (int i = 0; i < rows; ++i) u.push_back(draw());
        for (int j = 0; j < columns; ++j) v.push_back(draw());
        for (std::size_t j = 0; j < v.size(); ++j)
            for (std::size_t i = 0; i < u.size(); ++i) a[j * u.size() + i] += u[i] * v[j];
    }
    return a;
}

Vector times(const Vector& a, const Vector& x) {
    const std::size_t rows = a.size() / x.size();
    Vector y(rows);
    for (std::size_t j = 0; j < x.size(); ++j)
        for (std::size_t i = 0; i < rows; ++i) y[i] += a[j * rows + i] * x[j];
    return y;
}
double norm(const Vector& v) {
    double sum = 0;
    for (const auto& x : v) sum += std::norm(x);
    return std::sqrt(sum);
}

}  // namespace

TEST_CASE("singular values: |A v| = sigma, orthonormal vectors, the Frobenius norm") {
    Generator generator(3);
    for (int n = 1; n <= 8; ++n)
        for (const int more : {0, 3})
            for (const bool real : {true, false}) {
                const Vector a = random_matrix(n + more, n, n, real, generator);
                const SingularValues svd(n + more, n, a);
                double squares = 0;
                for (int k = 0; k < n; ++k) {
                    squares += svd[k] * svd[k];
                    if (k > 0) CHECK(svd[k] <= svd[k - 1]);
                    CHECK(std::abs(norm(times(a, svd.right(k))) - svd[k]) < 1e-13 * svd[0]);
                    for (int l = 0; l <= k; ++l) {
                        std::complex<double> inner = 0;
                        const Vector v = svd.right(k), w = svd.right(l);
                        for (std::size_t i = 0; i < v.size(); ++i) {
                            inner += std::conj(v[i]) * w[i];
                            if (real) CHECK(v[i].imag() == 0);
                        }
                        CHECK(std::abs(inner - (k == l ? 1.0 : 0.0)) < 1e-13);
                    }
                }
                CHECK(squares == Approx(norm(a) * norm(a)).epsilon(1e-13));
            }
}

TEST_CASE("singular values: rank, and the shortest least-squares solution") {
    Generator generator(4);
    for (int rank = 0; rank <= 5; ++rank) {
        const Vector a = random_matrix(7, 5, rank, false, generator);
        const SingularValues svd(7, 5, a);
        if (rank > 0) CHECK(svd.rank(1e-10) == rank);
        Vector x, b;
        for (int i = 0; i < 5; ++i) x.push_back(unit_complex(generator));
        b = times(a, x);
        const Vector y = svd.solve(b, rank), c = times(a, y);
        Vector off = c;
        for (std::size_t i = 0; i < off.size(); ++i) off[i] -= b[i];
        CHECK(norm(off) < 1e-12);
        CHECK(norm(y) <= norm(x) * (1 + 1e-12));
    }
    // small singular values to high relative accuracy
    const SingularValues graded(2, 2, {1e8, 0, 0, 1e-8});
    CHECK(graded[1] == Approx(1e-8).epsilon(1e-14));
}
