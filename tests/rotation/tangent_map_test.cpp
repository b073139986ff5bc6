#include <boost/multiprecision/cpp_bin_float.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/rotation/tangent_map.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "support/catch.hpp"

using equilibria::AxialMap;
using equilibria::Matrix3;
using equilibria::Vector3;
using Fifty = boost::multiprecision::cpp_bin_float_50;
using D = equilibria::Dual<double, 1>;
using DD = equilibria::Dual<D, 1>;
using V = Vector3<double>;
using M = Matrix3<double>;

namespace {

std::vector<V> rotations() {
    std::mt19937 draw(5);
    std::normal_distribution<double> normal;
    std::vector<V> y;
    for (const double angle : {0.0, 1e-12, 1e-8, 1e-4, 0.01, 0.5, 1.0, 2.0, 3.0, std::numbers::pi, 4.0, 5.5, 6.0})
        for (int k = 0; k < 3; ++k) y.push_back(angle * V(normal(draw), normal(draw), normal(draw)).normalized());
    return y;
}

V random(std::mt19937& draw) {
    std::normal_distribution<double> normal;
    return {normal(draw), normal(draw), normal(draw)};
}

/// psi + e d, with its derivative by e.
Vector3<D> moved(const V& psi, const V& d) {
    Vector3<D> y;
    for (int k = 0; k < 3; ++k) {
        y(k) = D(psi(k));
        y(k).derivative[0] = d(k);
    }
    return y;
}
/// psi + e d + f g: the mixed derivative is second.
Vector3<DD> moved(const V& psi, const V& d, const V& g) {
    Vector3<DD> y;
    for (int k = 0; k < 3; ++k) {
        y(k) = DD(moved(psi, d)(k));
        y(k).derivative[0] = D(g(k));
    }
    return y;
}

const auto maps = {0, 1, 2};
template <class T>
AxialMap<T> map(int which, const Vector3<T>& psi) {
    if (which == 0) return equilibria::exponential_map(psi);
    if (which == 1) return equilibria::tangent_map(psi);
    return equilibria::inverse_tangent_map(psi);
}

}  // namespace

TEST_CASE("T is what angular velocities are made of, material and spatial (7)") {
    std::mt19937 draw(7);
    for (const V& psi : rotations()) {
        const V d = random(draw);
        const Matrix3<D> r = equilibria::rotation_matrix(moved(psi, d));
        M value, rate;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) value(i, j) = r(i, j).value, rate(i, j) = r(i, j).derivative[0];
        const auto t = equilibria::tangent_map(psi);
        CHECK((value.transpose() * rate - equilibria::skew(V(t.value() * d))).norm() < 1e-14 * d.norm() * 10);
        CHECK((rate * value.transpose() - equilibria::skew(V(t.transposed().value() * d))).norm() <
              1e-14 * d.norm() * 10);
        // T Psi = Psi, T^T = R T, det T = 2 (1 - cos psi) / psi^2
        CHECK((t.value() * psi - psi).norm() < 1e-14);
        CHECK((t.transposed().value() - value * t.value()).norm() < 1e-14);
        CHECK(t.value().determinant() == Approx(2 * equilibria::stumpff<2>(psi.squaredNorm())[2]).margin(1e-15));
        CHECK((t.transposed().value() - t.value().transpose()).norm() < 1e-15);
    }
}

TEST_CASE("Inverses of T") {
    for (const V& psi : rotations()) {
        const M t = equilibria::tangent_map(psi).value(), inverse = equilibria::inverse_tangent_map(psi).value();
        CHECK((t * inverse - M::Identity()).norm() < 1e-14 * (1 + inverse.norm()));
    }
}

TEST_CASE("First and second derivatives of exp, T and its inverse (24)") {
    std::mt19937 draw(11);
    for (const V& psi : rotations())
        for (const int which : maps) {
            const V d = random(draw).normalized(), e = random(draw).normalized(), v = random(draw).normalized();
            const auto at = map(which, psi);
            INFO("map " << which << ", angle " << psi.norm());
            const Matrix3<DD> moving = map(which, moved(psi, d, e)).value();
            M first, second;
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) {
                    first(i, j) = moving(i, j).value.derivative[0];
                    second(i, j) = moving(i, j).derivative[0].derivative[0];
                }
            const double size = 1 + at.second_derivative(d, e).norm();
            CHECK((at.derivative(d) - first).norm() < 1e-13 * size);
            CHECK((at.second_derivative(d, e) - second).norm() < 1e-12 * size);
            CHECK((at.second_derivative(d, e) - at.second_derivative(e, d)).norm() < 1e-14 * size);
            CHECK((at.gradient(v) * d - at.derivative(d) * v).norm() < 1e-14 * size);
            CHECK((at.transposed().derivative(d) - at.derivative(d).transpose()).norm() < 1e-15 * size);
        }
}

TEST_CASE("T, its inverse and derivatives agree with 50 digits") {
    std::mt19937 draw(13);
    for (const V& psi : rotations())
        for (const int which : maps) {
            const V d = random(draw).normalized(), e = random(draw).normalized();
            const auto at = map(which, psi);
            const auto exact = map<Fifty>(which, psi.cast<Fifty>());
            INFO("map " << which << ", angle " << psi.norm());
            const auto near = [&](const M& a, const Matrix3<Fifty>& b, double ulps) {
                const M rounded = b.cast<double>();
                CHECK((a - rounded).norm() <= ulps * 2.3e-16 * (1 + rounded.norm()));
            };
            // the inverse's conditions grow like 1 / (2 pi - psi)
            const double ulps = 8 * (which == 2 ? 1 + 2 / (6.2832 - psi.norm()) : 1);
            near(at.value(), exact.value(), ulps);
            near(at.derivative(d), exact.derivative(d.cast<Fifty>()), 2 * ulps);
            near(at.second_derivative(d, e), exact.second_derivative(d.cast<Fifty>(), e.cast<Fifty>()), 4 * ulps);
        }
}
