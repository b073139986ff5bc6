// The Pade predictor: its order, and the pole that it finds.
#include <cmath>
#include <complex>

#include <equilibria/core/complex.hpp>
#include <equilibria/homotopy/predictor.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using P = PadePredictor<double>;

/// How far off it is on q(h) = 1 / (2 - h), which has its pole at 2.
double error_at(double h) {
    Complex<double> taylor[P::order][1];
    for (int k = 0; k < P::order; ++k) taylor[k][0] = {std::pow(0.5, k + 2), 0};
    return std::abs(P::change(taylor, 0, h).re - (1 / (2 - h) - 0.5));
}

/// That q is the sum of two poles: a Pade approximant has one.
double error_of_two_poles(double h) {
    Complex<double> taylor[P::order][1];
    for (int k = 0; k < P::order; ++k) taylor[k][0] = {std::pow(0.5, k + 2) + std::pow(1 / 3.0, k + 2), 0};
    return std::abs(P::change(taylor, 0, h).re - (1 / (2 - h) - 1 / 2.0 + 1 / (3 - h) - 1 / 3.0));
}

}  // namespace

TEST_CASE("the predictor's error grows with its local order of the step, and it finds a pole") {
    const auto order = [](double at_h, double at_half) { return std::log2(at_h / at_half); };
    CHECK(order(error_of_two_poles(0.02), error_of_two_poles(0.01)) == Approx(P::local_order).margin(0.1));
    // one pole: exact, and found
    CHECK(error_at(1) < 1e-15);
    Complex<double> taylor[3][1]{{{0.25, 0}}, {{0.125, 0}}, {{0.0625, 0}}};
    CHECK(P::pole(taylor, 1) == Approx(2));
}
