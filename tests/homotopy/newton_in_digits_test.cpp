// Solutions that Newton's method in 32 digits tells to be regular, multiple, or on a family.
#include <array>
#include <cmath>

#include <equilibria/core/double_double.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/homotopy/newton_in_digits.hpp>
#include <equilibria/start/total_degree.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// share (x^2 - 1) + y = 0, y (y + 2) = 0: at (1, 0) the condition is of the size 1/share.
struct Scaled {
    static constexpr int n_angles = 0, n_coordinates = 2;
    enum Parameter { share, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        return std::array{p[share] * (x[0] * x[0] - 1.0) + x[1], x[1] * (x[1] + 2.0)};
    }
};

/// (x - 1)^Order = 0, y (y + 2) = 0.
template <int Order>
struct Multiple {
    static constexpr int n_angles = 0, n_coordinates = 2;
    enum Parameter { unused, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        return std::array{pow(x[0] - 1.0, Order) + 0.0 * p[unused], x[1] * (x[1] + 2.0)};
    }
};

/// The circle x^2 + y^2 = size^2, and the point (0, -3).
struct Circle {
    static constexpr int n_angles = 0, n_coordinates = 2;
    enum Parameter { size, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        const auto f = x[0] * x[0] + x[1] * x[1] - p[size] * p[size];
        return std::array{f * x[0], f * (x[1] + 3.0)};
    }
};

/// Whether Newton's method finds a regular solution next to (x, y), which it then is.
template <class M>
bool converges(double parameter, double& x, double& y) {
    const ModelSystem<M> target({parameter});
    Generator generator(1);
    const PolynomialHomotopy h = model_homotopy(target, TotalDegree<M>(target, generator));
    auto q = point_of_zeros<RuntimeUnknowns, DoubleDouble>(h.sizes());
    q.x[0] = {x, 0.0};
    q.x[1] = {y, 0.0};
    const bool found = detail::converges_in_digits(h, q);
    x = static_cast<double>(q.x[0].re);
    y = static_cast<double>(q.x[1].re);
    return found;
}

}  // namespace

TEST_CASE("a regular solution is told from near it, whatever its condition") {
    for (const double share : {1.0, 1e-4, 1e-7, 1e-10}) {
        CAPTURE(share);
        double x = 1 + 1e-9, y = 1e-9 * share;
        REQUIRE(converges<Scaled>(share, x, y));
        CHECK(x == 1);
        CHECK(std::abs(y) < 1e-30);
    }
    double x = 1.01, y = 0;  // too far to tell which
    CHECK_FALSE(converges<Scaled>(1, x, y));
    CHECK(x == 1.01);
}

TEST_CASE("a multiple solution is not regular, at it and beside it") {
    for (const double off : {0.0, 1e-30, 1e-16, 1e-9, 1e-6}) {
        CAPTURE(off);
        double x = 1 + off, y = 0;
        CHECK_FALSE(converges<Multiple<2>>(0, x, y));
        x = 1 + off, y = 0;
        CHECK_FALSE(converges<Multiple<3>>(0, x, y));
    }
}

TEST_CASE("a point of a family is not regular, though Newton's method comes to the family quadratically") {
    for (const double angle : {0.1, 0.7, 2.0, 4.0})
        for (const double off : {0.0, 1e-16, 1e-9}) {
            CAPTURE(angle, off);
            double x = (2 + off) * std::cos(angle), y = 2 * std::sin(angle);
            CHECK_FALSE(converges<Circle>(2, x, y));
        }
}
