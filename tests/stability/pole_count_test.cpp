// Poles, Routh and Hurwitz against each other and against the theorems on M x'' + D x' + C x = 0.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include <equilibria/core/random.hpp>
#include <equilibria/stability/inertia.hpp>
#include <equilibria/stability/pole_count.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

template <class Matrix>
Matrix random_matrix(Generator& generator, int n) {
    return Matrix::NullaryExpr(n, n, [&] { return uniform(generator, -1, 1); });
}
template <class Matrix>
Matrix random_positive(Generator& generator, int n) {
    const Matrix a = random_matrix<Matrix>(generator, n);
    return a * a.transpose() + 0.1 * Matrix::Identity(n, n);
}
template <class Matrix>
Matrix random_symmetric(Generator& generator, int n) {
    const Matrix a = random_matrix<Matrix>(generator, n);
    return a + a.transpose();
}

/// The largest |polynomial(pole)|, over the sum of the terms' sizes.
template <class Matrix>
double residual(const PoleCount<Matrix>& y) {
    double worst = 0;
    for (const auto& s : y.poles) {
        std::complex<double> value = 0;
        double size = 0;
        for (const double c : y.polynomial) value = value * s + c, size = size * std::abs(s) + std::abs(c);
        worst = std::max(worst, std::abs(value) / size);
    }
    return worst;
}

template <int N>
void compare(Generator& generator, int& unstable, int& stable) {
    using Matrix = Eigen::Matrix<double, N, N>;
    for (int k = 0; k < 167; ++k) {
        // any D and C: gyroscopic and circulatory forces among them
        const SecondOrderSystem<Matrix> system{random_positive<Matrix>(generator, N),
                                               random_matrix<Matrix>(generator, N) + (k % 2) * Matrix::Identity(),
                                               random_matrix<Matrix>(generator, N) + (k % 3) * Matrix::Identity()};
        const auto y = count_poles(system);
        CAPTURE(N, k);
        REQUIRE(y.right_half_plane());
        CHECK(*y.right_half_plane() == y.right_of_axis);
        CHECK(y.hurwitz.right_half_plane == y.right_of_axis);
        CHECK_FALSE(y.marginal());
        CHECK((y.verdict() == StabilityVerdict::asymptotically_stable) == (y.right_of_axis == 0));
        CHECK(residual(y) < 1e-10);  // of a pole of size 1e-3 beside others of 1, three digits of its sixteen are lost
        ++(y.right_of_axis > 0 ? unstable : stable);

        // dynamic sizes say the same
        const SecondOrderSystem<Eigen::MatrixXd> dynamic{system.mass, system.damping, system.stiffness};
        const auto same = count_poles(dynamic);
        CHECK(same.right_half_plane() == y.right_half_plane());
        CHECK((same.polynomial - y.polynomial).norm() <= 1e-10 * y.polynomial.norm());

        // Kelvin, Tait and Chetaev: with complete damping the poles on the right are as many as the index of C
        const Matrix c = random_symmetric<Matrix>(generator, N), gyroscopic = random_matrix<Matrix>(generator, N);
        const auto damped = count_poles(SecondOrderSystem<Matrix>{
            system.mass, random_positive<Matrix>(generator, N) + gyroscopic - gyroscopic.transpose(), c});
        CHECK(damped.right_half_plane() == inertia(c).negative);
    }
}

}  // namespace

TEST_CASE("Poles, Routh and Hurwitz agree on 1,002 random systems of 1 to 6 unknowns") {
    Generator generator(1);
    int unstable = 0, stable = 0;
    compare<1>(generator, unstable, stable);
    compare<2>(generator, unstable, stable);
    compare<3>(generator, unstable, stable);
    compare<4>(generator, unstable, stable);
    compare<5>(generator, unstable, stable);
    compare<6>(generator, unstable, stable);
    CHECK(unstable + stable == 1002);
    CHECK(unstable > 200);
    CHECK(stable > 100);
}

TEST_CASE("Undamped systems are marginal, or unstable with as many poles on the right as C has negative eigenvalues") {
    Generator generator(2);
    for (int k = 0; k < 300; ++k) {
        const int n = 1 + k % 6;
        using Matrix = Eigen::MatrixXd;
        const Matrix mass = random_positive<Matrix>(generator, n);
        const Matrix c = k % 2 == 0 ? random_positive<Matrix>(generator, n) : random_symmetric<Matrix>(generator, n);
        const int index = inertia(c).negative;
        const auto y = count_poles(SecondOrderSystem<Matrix>{mass, Matrix::Zero(n, n), c});
        CAPTURE(n, y.poles.transpose(), y.routh.rows);
        CHECK(y.marginal());
        CHECK(y.right_half_plane() == index);
        CHECK(y.on_axis == 2 * (n - index));
        CHECK(y.routh.imaginary_axis == y.on_axis);
        CHECK(y.routh.special.at(0).kind == RouthSpecialCase::zero_row);
        CHECK(y.routh.special.at(0).row == 1);
        CHECK_FALSE(y.hurwitz.right_half_plane);
        CHECK(y.verdict() == (index == 0 ? StabilityVerdict::marginal : StabilityVerdict::unstable));
    }
}

TEST_CASE("Damping that leaves a mode alone, a free motion and gyroscopic stabilisation are marginal") {
    using System = SecondOrderSystem<Eigen::Matrix2d>;
    const Eigen::Matrix2d one = Eigen::Matrix2d::Identity(), none = Eigen::Matrix2d::Zero();
    // two equal pendulums, a damper between them: the mode in phase has poles +-i
    const auto between = count_poles(System{one, Eigen::Matrix2d{{1, -1}, {-1, 1}}, one});
    CHECK(between.verdict() == StabilityVerdict::marginal);
    CHECK(between.right_half_plane() == 0);
    CHECK(between.on_axis == 2);
    CHECK(between.routh.imaginary_axis == 2);
    // no stiffness in one direction: a pole in 0
    const auto free = count_poles(System{one, one, Eigen::Matrix2d{{1, 0}, {0, 0}}});
    CHECK(free.verdict() == StabilityVerdict::marginal);
    CHECK(free.on_axis == 1);
    CHECK(free.routh.imaginary_axis == 1);
    // a hilltop held by gyroscopic forces: g^2 > 4 |c| puts all four poles on the axis
    const Eigen::Matrix2d turn{{0, -3}, {3, 0}};
    const auto held = count_poles(System{one, turn, -one});
    CHECK(held.verdict() == StabilityVerdict::marginal);
    CHECK(held.on_axis == 4);
    CHECK(held.routh.imaginary_axis == 4);
    // and complete damping destroys it, however small
    const auto lost = count_poles(System{one, turn + 1e-3 * one, -one});
    CHECK(lost.right_half_plane() == 2);
    // nothing at all: four poles in 0
    const auto adrift = count_poles(System{one, none, none});
    CHECK(adrift.on_axis == 4);
    CHECK(adrift.verdict() == StabilityVerdict::marginal);
}

TEST_CASE("The polynomial of one unknown is m s^2 + d s + c over m, in any unit") {
    for (const double unit : {1e-6, 1.0, 1e6}) {
        using Matrix = Eigen::Matrix<double, 1, 1>;
        const auto y =
            count_poles(SecondOrderSystem<Matrix>{Matrix(2.0), Matrix(3.0 * unit), Matrix(5.0 * unit * unit)});
        CHECK(y.polynomial[0] == 1);
        CHECK(y.polynomial[1] == Approx(1.5 * unit).epsilon(1e-14));
        CHECK(y.polynomial[2] == Approx(2.5 * unit * unit).epsilon(1e-14));
        CHECK(y.poles[1].real() == Approx(-0.75 * unit));
        CHECK(y.poles[1].imag() == Approx(std::sqrt(2.5 - 0.5625) * unit));
        CHECK(y.verdict() == StabilityVerdict::asymptotically_stable);
    }
}

TEST_CASE("Systems that are none are refused in a line") {
    const auto message = [](const SecondOrderSystem<Eigen::MatrixXd>& system) -> std::string {
        try {
            count_poles(system);
        } catch (const InvalidArgument& error) {
            return error.what();
        }
        return "";
    };
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(2, 2);
    CHECK(message({Eigen::MatrixXd{{-1, 0}, {0, -1}}, one, one}) ==
          "mass = [-1 0; 0 -1]: must be symmetric and positive definite");
    CHECK(message({Eigen::MatrixXd{{1, 1}, {0, 1}}, one, one}) ==
          "mass = [1 1; 0 1]: must be symmetric and positive definite");
    CHECK(message({one, one.topRows(1), one}) == "damping = 1 x 2: must be square, of the size of mass");
    CHECK(message({one, one, std::nan("") * one}) == "stiffness = [nan nan; nan nan]: must be finite");
    CHECK(message({Eigen::MatrixXd(0, 0), {}, {}}) == "mass = 0 x 0: must have a row at least");
}
