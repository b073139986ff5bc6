// Routh's table and Hurwitz's minors on polynomials whose roots are known, the special cases above all.
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/random.hpp>
#include <equilibria/stability/hurwitz.hpp>
#include <equilibria/stability/routh.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;

namespace {

Eigen::VectorXd product(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(a.size() + b.size() - 1);
    for (Eigen::Index i = 0; i < a.size(); ++i)
        for (Eigen::Index j = 0; j < b.size(); ++j) y[i + j] += a[i] * b[j];
    return y;
}

struct Known {
    Eigen::VectorXd coefficients{{1.0}};
    int right = 0, axis = 0, left = 0;

    void times(const Eigen::VectorXd& factor, int more_right, int more_axis, int more_left) {
        coefficients = product(coefficients, factor);
        right += more_right;
        axis += more_axis;
        left += more_left;
    }
};

/// A product of linear and quadratic factors with small integers: every operation on it is exact.
Known random_product(Generator& generator, int factors) {
    Known y;
    for (int k = 0; k < factors; ++k) {
        const double a = 1 + static_cast<double>(generator() % 3), b = 1 + static_cast<double>(generator() % 2);
        switch (generator() % 6) {
            case 0: y.times(Eigen::Vector2d{1, -a}, 1, 0, 0); break;
            case 1: y.times(Eigen::Vector2d{1, a}, 0, 0, 1); break;
            case 2: y.times(Eigen::Vector3d{1, 0, a}, 0, 2, 0); break;
            case 3: y.times(Eigen::Vector3d{1, -b, a + 1}, 2, 0, 0); break;
            case 4: y.times(Eigen::Vector3d{1, b, a + 1}, 0, 0, 2); break;
            case 5: y.times(Eigen::Vector2d{1, 0}, 0, 1, 0); break;
        }
    }
    return y;
}

}  // namespace

TEST_CASE("Routh's table counts the roots of products of known factors, those on the axis among them") {
    Generator generator(1);
    int zero_rows = 0, zeros = 0;
    for (int k = 0; k < 3000; ++k) {
        const Known known = random_product(generator, 1 + k % 5);
        const auto table = routh_table(known.coefficients);
        CAPTURE(known.coefficients.transpose(), table.rows);
        CHECK(table.right_half_plane == known.right);
        CHECK(table.imaginary_axis == known.axis);
        CHECK(table.left_half_plane() == known.left);
        for (const auto& special : table.special) ++(special.kind == RouthSpecialCase::zero_row ? zero_rows : zeros);
        if (known.axis > 0)
            CHECK(std::any_of(table.special.begin(), table.special.end(),
                              [](const auto& s) { return s.kind == RouthSpecialCase::zero_row; }));

        const auto hurwitz = hurwitz_criterion(known.coefficients);
        if (hurwitz.right_half_plane) CHECK(*hurwitz.right_half_plane == known.right);
        if (known.axis > 0) CHECK_FALSE(hurwitz.right_half_plane);
        CHECK(hurwitz.stable() == (known.left + 1 == known.coefficients.size()));
    }
    CHECK(zero_rows > 500);
    CHECK(zeros > 20);
}

TEST_CASE("Every polynomial with coefficients -1, 0, 1 up to degree 6 has the count of its roots") {
    int zeros = 0, compared = 0;
    for (int degree = 1; degree <= 6; ++degree) {
        int all = 1;
        for (int k = 0; k < degree; ++k) all *= 3;
        for (int number = 0; number < all; ++number) {
            Eigen::VectorXd c(degree + 1);
            c[0] = 1;
            for (int k = 1, rest = number; k <= degree; ++k, rest /= 3) c[k] = rest % 3 - 1;
            Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
            companion.row(0) = -c.tail(degree).transpose();
            companion.diagonal(-1).setOnes();
            const Eigen::VectorXcd roots = tests::eigenvalues(companion);
            // multiple roots on the axis are found to a few digits only
            const auto right = std::count_if(roots.begin(), roots.end(), [](auto s) { return s.real() > 1e-3; });
            const auto left = std::count_if(roots.begin(), roots.end(), [](auto s) { return s.real() < -1e-3; });
            const auto table = routh_table(c);
            CAPTURE(c.transpose(), table.rows, roots.transpose());
            CHECK(table.right_half_plane == right);
            CHECK(table.left_half_plane() == left);
            const auto hurwitz = hurwitz_criterion(c);
            if (hurwitz.right_half_plane) {
                CHECK(*hurwitz.right_half_plane == right);
                ++compared;
            }
            zeros += !table.special.empty();
        }
    }
    CHECK(zeros > 500);
    CHECK(compared > 400);
}

TEST_CASE("The special cases are named, with their rows") {
    // s^4 + s^3 + 2 s^2 + 2 s + 5: a zero in the first column, two roots on the right (Ogata's kind of example)
    const auto zero = routh_table(Eigen::Vector<double, 5>{1, 1, 2, 2, 5});
    REQUIRE(zero.special.size() == 1);
    CHECK(zero.special[0].row == 2);
    CHECK(zero.special[0].kind == RouthSpecialCase::zero_in_first_column);
    CHECK(zero.right_half_plane == 2);
    CHECK(zero.margin == 0);
    CHECK(std::string(to_string(zero.special[0].kind)) == "zero in the first column");
    // (s + 1)(s^2 + 4): a row of zeros, roots +-2i
    const auto row = routh_table(Eigen::Vector4d{1, 1, 4, 4});
    REQUIRE(row.special.size() == 1);
    CHECK(row.special[0].row == 2);
    CHECK(row.special[0].kind == RouthSpecialCase::zero_row);
    CHECK(row.right_half_plane == 0);
    CHECK(row.imaginary_axis == 2);
    CHECK(row.rows(2, 0) == 2);  // d/ds (s^2 + 4)
    // nothing special: the holonomic mechanism's second equilibrium (Vesovic and Radulovic 2022, Tables 3 and 4)
    const auto plain = routh_table(Eigen::Vector<double, 5>{1, 6.01551, 38.3023, 149.28, 305.992});
    CHECK(plain.special.empty());
    CHECK(plain.right_half_plane == 0);
    CHECK(plain.first_column()[2] == Approx(13.4864).epsilon(1e-5));
    CHECK(plain.first_column()[3] == Approx(12.7950).epsilon(1e-5));
}

TEST_CASE("Routh's first column is made of the quotients of Hurwitz's minors") {
    Generator generator(2);
    for (int k = 0; k < 200; ++k) {
        Eigen::Vector<double, 7> c;
        for (double& value : c) value = uniform(generator, 0.5, 2);
        const auto column = routh_table(c).first_column().eval();
        const auto minors = hurwitz_criterion(c).minors;
        CHECK(column[1] == Approx(minors[0]));
        for (int i = 1; i < 6; ++i) CHECK(column[i + 1] == Approx(minors[i] / minors[i - 1]).epsilon(1e-8));
    }
}

TEST_CASE("Polynomials that are none are refused in a line") {
    const auto message = [](const auto& f) -> std::string {
        try {
            f();
        } catch (const InvalidArgument& error) {
            return error.what();
        }
        return "";
    };
    const std::string allowed = ": must be two or more, finite, the first one not 0";
    CHECK(message([] { routh_table(Eigen::VectorXd{{1.0}}); }) == "coefficients = [1]" + allowed);
    CHECK(message([] { routh_table(Eigen::Vector3d{0, 1, 2}); }) == "coefficients = [0 1 2]" + allowed);
    CHECK(message([] { hurwitz_criterion(Eigen::Vector2d{1, std::nan("")}); }) == "coefficients = [1 nan]" + allowed);
    CHECK(message([] { hurwitz_criterion(Eigen::VectorXd()); }) == "coefficients = []" + allowed);
}
