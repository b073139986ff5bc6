// Points of complex angles: on the complex circle, those of std::complex, and where real angles have them.
#include <cmath>
#include <complex>

#include <equilibria/core/random.hpp>
#include <equilibria/evaluation/point_of.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

struct Mixed {
    static constexpr int n_angles = 2, n_coordinates = 1;
    enum Parameter { n_parameters };
    constexpr auto potential(const auto& theta, const auto& x, const auto&) const {
        return cos(theta[0] - theta[1]) + x[0] * x[0];
    }
};

}  // namespace

TEST_CASE("points of complex angles lie on the complex circle, and both ways to them agree") {
    Generator generator(1);
    for (int trial = 0; trial < 100; ++trial) {
        Array<std::complex<double>, 3> q;
        ComplexUnknowns<Mixed, double> z;
        for (int i = 0; i < 3; ++i) {
            q[i] = {uniform(generator, -4, 4), trial < 20 ? 0 : uniform(generator, -2, 2)};
            z[i] = {q[i].real(), q[i].imag()};
        }
        const auto a = point_of<Mixed>(q);
        const auto b = point_of<Mixed, double>(z);
        for (int i = 0; i < 2; ++i) {
            const auto square = a.c[i] * a.c[i] + a.s[i] * a.s[i];
            const double size = 1 + norm2(a.c[i]) + norm2(a.s[i]);
            CHECK(std::abs(square.re - 1) < 1e-15 * size);
            CHECK(std::abs(square.im) < 1e-15 * size);
            CHECK(std::sqrt(norm2(a.c[i] - b.c[i])) < 1e-15 * size);
            CHECK(std::sqrt(norm2(a.s[i] - b.s[i])) < 1e-15 * size);
            if (trial < 20) {
                CHECK(a.c[i].re == Approx(std::cos(q[i].real())).margin(1e-16));
                CHECK(a.s[i].im == 0);
            }
        }
        CHECK(a.x[0].re == q[2].real());
        CHECK(b.x[0].im == q[2].imag());
    }
}
