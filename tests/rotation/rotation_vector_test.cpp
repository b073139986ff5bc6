#include <boost/multiprecision/cpp_bin_float.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/rotation/rotation_vector.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "support/catch.hpp"

using equilibria::Matrix3;
using equilibria::Vector3;
using Fifty = boost::multiprecision::cpp_bin_float_50;
using V = Vector3<double>;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Angles with the corners 0, series' ends, pi and 2 pi.
std::vector<double> angles() {
    std::vector<double> y{0,    1e-300, 1e-160, 1e-20, 1e-12,    1e-8, 1e-6,    1e-4,
                          1e-3, 1e-2,   0.1,    0.5,   0.999999, 1.0,  1.000001};
    for (double a = 1.1; a < 6.2; a += 0.13) y.push_back(a);
    for (const double near : {std::sqrt(10.0), std::numbers::pi, std::sqrt(45.0), 2 * std::numbers::pi})
        for (const double off : {-1e-3, -1e-8, -1e-14, 1e-14, 1e-8})
            if (near + off < 2 * std::numbers::pi) y.push_back(near + off);
    return y;
}

std::vector<V> axes() {
    std::mt19937 draw(1);
    std::normal_distribution<double> normal;
    std::vector<V> y{V::UnitX(), V::UnitY(), V::UnitZ(), V(1, 1, 1).normalized()};
    for (int k = 0; k < 4; ++k) y.push_back(V(normal(draw), normal(draw), normal(draw)).normalized());
    return y;
}

template <class T>
Vector3<T> random_vector(std::mt19937& draw, double size) {
    std::normal_distribution<double> normal;
    return (V(normal(draw), normal(draw), normal(draw)).normalized() * size).template cast<T>();
}

}  // namespace

TEST_CASE("Stumpff functions from 0 to 2 pi agree with 50 digits") {
    for (const double psi : angles()) {
        const double x = psi * psi;
        const auto c = equilibria::stumpff<8>(x);
        // from the series alone, in 50 digits with 150 for its cancellation
        for (int k = 0; k <= 8; ++k) {
            Fifty term = 1, exact = 0, size = 0;
            for (int j = 1; j <= k; ++j) term /= j;
            for (int j = 0; j < 60; ++j) {
                exact += term;
                size = std::max(size, Fifty(abs(term)));
                term *= -Fifty(x) / ((2 * j + k + 1) * (2 * j + k + 2));
            }
            // what rounding of x changes: x dc/dx
            const auto up = equilibria::stumpff<10>(Fifty(x));
            const double sensitivity = static_cast<double>(abs(Fifty(x) * (k * up[k + 2] - up[k + 1]) / 2));
            INFO("psi " << psi << ", k " << k);
            CHECK(std::abs(c[k] - static_cast<double>(exact)) <=
                  8 * eps * (std::abs(static_cast<double>(exact)) + sensitivity));
        }
    }
}

TEST_CASE("Exp and log of rotation vectors are accurate to units in the last place from 0 to 2 pi") {
    for (const double angle : angles())
        for (const V& axis : axes()) {
            const V psi = angle * axis;
            INFO("psi = " << psi.transpose() << ", angle " << angle);
            const Matrix3<double> r = equilibria::rotation_matrix(psi);
            const Matrix3<Fifty> exact = equilibria::rotation_matrix(Vector3<Fifty>(psi.cast<Fifty>()));
            CHECK((r - exact.cast<double>()).cwiseAbs().maxCoeff() <= 8 * eps);
            CHECK((r.transpose() * r - Matrix3<double>::Identity()).norm() <= 16 * eps);
            CHECK(r.determinant() == Approx(1).margin(8 * eps));

            const auto q = equilibria::quaternion(psi);
            CHECK(q.norm() == Approx(1).margin(4 * eps));
            CHECK((q.toRotationMatrix() - r).norm() <= 16 * eps);
            if (std::abs(angle - 2 * std::numbers::pi) > 1e-3) {
                const V back = equilibria::rotation_vector(q);
                CHECK((back - psi).norm() <= 8 * eps * angle);
            }
            // a matrix holds sin(psi / 2) up to the rounding of its entries alone
            const V shortest = equilibria::rotation_vector(r);
            CHECK(shortest.norm() <= std::numbers::pi * (1 + 4 * eps));
            CHECK((equilibria::rotation_matrix(shortest) - r).norm() <= 32 * eps);
            if (angle < 3) CHECK((shortest - psi).norm() <= 16 * eps);
        }
}

TEMPLATE_TEST_CASE("Composition of rotation vectors is that of rotations", "", double, long double, Fifty) {
    std::mt19937 draw(3);
    const TestType tolerance = 64 * std::numeric_limits<TestType>::epsilon();
    for (int k = 0; k < 50; ++k) {
        std::uniform_real_distribution<double> size(0, 3);
        const auto a = random_vector<TestType>(draw, size(draw)), b = random_vector<TestType>(draw, size(draw)),
                   c = random_vector<TestType>(draw, size(draw));
        const auto r = [](const Vector3<TestType>& v) { return equilibria::rotation_matrix(v); };
        using equilibria::compose;
        CHECK((r(compose(a, b)) - r(a) * r(b)).norm() < tolerance);
        CHECK((r(compose(compose(a, b), c)) - r(compose(a, compose(b, c)))).norm() < tolerance);
        CHECK(compose(a, Vector3<TestType>(-a)).norm() < tolerance);
        CHECK((compose(a, Vector3<TestType>(Vector3<TestType>::Zero())) - a).norm() < tolerance);
        // a left increment is the right one seen from fixed axes: exp(R b) R = R exp(b)
        const Vector3<TestType> spatial = r(a) * b;
        CHECK((compose(spatial, a) - compose(a, b)).norm() < 4 * tolerance);
    }
}

TEST_CASE("Rotation vectors of increments past pi are continuous up to 2 pi") {
    const V axis = V(1, -2, 0.5).normalized();
    V psi = V::Zero();
    for (int k = 1; k < 62; ++k) {
        psi = equilibria::compose(psi, V(0.1 * axis));
        CHECK((psi - 0.1 * k * axis).norm() < 1e-13);
    }
}

TEST_CASE("Rotations take dual numbers, at 0 and at pi as well") {
    using D = equilibria::Dual<double, 3>;
    for (const double angle : {0.0, 1e-9, 0.3, 2.0, std::numbers::pi, 5.0}) {
        const V at = angle * V(2, -1, 2) / 3;
        Vector3<D> psi;
        for (int k = 0; k < 3; ++k) psi(k) = D::variable(at(k), k);
        // log after exp is the identity, derivatives included
        const Vector3<D> back = equilibria::rotation_vector(equilibria::quaternion(psi));
        for (int i = 0; i < 3; ++i) {
            CHECK(back(i).value == Approx(at(i)).margin(1e-14));
            for (int k = 0; k < 3; ++k) CHECK(back(i).derivative[k] == Approx(i == k ? 1 : 0).margin(1e-13));
        }
    }
}
