// Shape functions: one at their node, 0 at the others, exact for the polynomials of their degree; Gauss rules exact to
// degree 2 n - 1; the length of a line.
#include <array>
#include <cmath>

#include <equilibria/core/random.hpp>
#include <equilibria/fem/interpolation.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

template <int Nodes>
void check_shapes() {
    using Shape = fem::ShapeFunctions<Nodes>;
    for (int k = 0; k < Nodes; ++k) {
        const Shape shape(Shape::node(k));
        for (int j = 0; j < Nodes; ++j)
            CHECK(shape.value[static_cast<std::size_t>(j)] == Approx(j == k ? 1 : 0).margin(1e-14));
    }
    for (const double xi : {-1.0, -0.3, 0.45, 1.0}) {
        const Shape shape(xi);
        for (int power = 0; power < Nodes; ++power) {
            double value = 0, slope = 0;
            for (int k = 0; k < Nodes; ++k) {
                const double at = std::pow(Shape::node(k), power);
                value += shape.value[static_cast<std::size_t>(k)] * at;
                slope += shape.slope[static_cast<std::size_t>(k)] * at;
            }
            CHECK(value == Approx(std::pow(xi, power)).margin(1e-14));
            CHECK(slope == Approx(power == 0 ? 0 : power * std::pow(xi, power - 1)).margin(1e-13));
        }
    }
}

template <int Points>
void check_rule() {
    const auto& rule = fem::gauss_rule<Points>();
    for (int power = 0; power < 2 * Points; ++power) {
        double sum = 0;
        for (std::size_t k = 0; k < rule.point.size(); ++k) sum += rule.weight[k] * std::pow(rule.point[k], power);
        CHECK(sum == Approx(power % 2 == 1 ? 0 : 2.0 / (power + 1)).margin(1e-15));
    }
}

template <int Nodes>
void check_line() {
    std::array<Eigen::Vector3d, static_cast<std::size_t>(Nodes)> x;
    const Eigen::Vector3d a(0.3, -1, 2), b(1.5, 0.25, -0.5);
    for (int k = 0; k < Nodes; ++k) x[static_cast<std::size_t>(k)] = a + (b - a) * k / (Nodes - 1);
    const fem::GaussLine<Nodes> line(x);
    CHECK(line.length() == Approx((b - a).norm()).epsilon(1e-14));
    for (int g = 0; g < line.points; ++g) CHECK(line.jacobian(g) == Approx((b - a).norm() / 2).epsilon(1e-14));
    x.fill(a);
    CHECK_THROWS_WITH(fem::GaussLine<Nodes>(x), "length of an element = 0: must be positive and finite");
}

}  // namespace

TEST_CASE("shape functions interpolate, and are exact for polynomials of their degree") {
    check_shapes<2>();
    check_shapes<3>();
    check_shapes<4>();
}

TEST_CASE("Gauss rules of n points are exact to degree 2 n - 1") {
    check_rule<1>();
    check_rule<2>();
    check_rule<3>();
}

TEST_CASE("a straight line of nodes has its length, and one without length is refused") {
    check_line<2>();
    check_line<3>();
    check_line<4>();
}
