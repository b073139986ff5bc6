// Chebyshev interpolation is exact for polynomials: values, quadrature, integrals and derivatives.
#include <cmath>

#include <Eigen/Core>

#include <equilibria/studies/rotating_body_beam/chebyshev_integrals.hpp>

#include "support/catch.hpp"

using equilibria::mechanisms::detail::ChebyshevIntegrals;

namespace {

constexpr double length = 1.7;

/// z^d at the points, as one column of values.
Eigen::VectorXd power(const ChebyshevIntegrals& c, int d) { return c.places.array().pow(d); }

double value(const ChebyshevIntegrals& c, const Eigen::MatrixXd& coefficients, double z) {
    return c.polynomials(z).head(coefficients.rows()).dot(coefficients.col(0));
}

}  // namespace

TEST_CASE("Chebyshev points run from end to end and their quadrature is exact") {
    for (int points : {2, 3, 8, 17}) {
        const ChebyshevIntegrals c(points, length);
        CHECK(c.places(0) == 0);
        CHECK(c.places(points - 1) == Approx(length));
        for (int d = 0; d < points; ++d)
            CHECK(c.quadrature.dot(power(c, d)) == Approx(std::pow(length, d + 1) / (d + 1)).epsilon(1e-13));
    }
}

TEST_CASE("Chebyshev interpolants of polynomials are these, and so are integrals and derivatives") {
    const ChebyshevIntegrals c(9, length);
    for (int d = 0; d < 9; ++d) {
        const Eigen::MatrixXd a = c.coefficients * power(c, d);
        const Eigen::MatrixXd from_start = c.integral(a, -1), from_end = c.integral(a, 1), slope = c.derivative(a);
        for (double z : {0.0, 0.1, 0.9, 1.65, length}) {
            CHECK(value(c, a, z) == Approx(std::pow(z, d)).margin(1e-12));
            CHECK(value(c, from_start, z) == Approx(std::pow(z, d + 1) / (d + 1)).margin(1e-12));
            CHECK(value(c, from_end, z) ==
                  Approx((std::pow(z, d + 1) - std::pow(length, d + 1)) / (d + 1)).margin(1e-12));
            CHECK(value(c, slope, z) == Approx(d == 0 ? 0 : d * std::pow(z, d - 1)).margin(1e-11));
        }
    }
}
