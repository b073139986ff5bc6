// Jets against the series of duals that they stand for, at every order and with and without directions.
#include <cmath>

#include <equilibria/core/jet.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using J = Jet<double>;
using Series = J::Series;

/// The same numbers as both: constants (order 0) or series, moving or not.
struct Both {
    J jet;
    Series series;
};

Both random_both(Generator& generator, int order, bool moves, double low = 0.3) {
    const double first = uniform(generator, low, 1.5);
    Both y{J::variable(first, 0, order), Series(first)};
    for (int k = 1; k <= order; ++k) {
        y.series.coefficient[k] = uniform(generator, -1, 1);
        y.jet.set(k, y.series.coefficient[k].value);
    }
    if (moves)
        for (int k = 0; k <= order; ++k) {
            for (double& d : y.series.coefficient[k].derivative) d = uniform(generator, -1, 1);
            y.jet.move(k, y.series.coefficient[k].derivative);
        }
    return y;
}

void check_equal(const J& a, const Series& b, int order) {
    CHECK(a.order() == order);
    for (int k = 0; k <= order; ++k) {
        CAPTURE(k);
        const auto c = a.coefficient(k);
        CHECK(std::abs(c.value - b.coefficient[k].value) < 1e-12 * (1 + std::abs(c.value)));
        for (int d = 0; d < J::directions; ++d)
            CHECK(std::abs(c.derivative[d] - b.coefficient[k].derivative[d]) < 1e-12 * (1 + std::abs(c.derivative[d])));
    }
    CHECK(a.value(order + 1) == 0);
}

}  // namespace

TEST_CASE("a jet computes as the series of duals that it is, to its order") {
    Generator generator(1);
    for (int order = 0; order <= J::highest - 1; ++order)
        for (const bool a_moves : {false, true})
            for (const bool b_moves : {false, true})
                for (const int b_order : {0, order}) {
                    CAPTURE(order, b_order, a_moves, b_moves);
                    const auto [a, s] = random_both(generator, order, a_moves);
                    const auto [b, t] = random_both(generator, b_order, b_moves);
                    check_equal(a + b, s + t, order);
                    check_equal(a - b, s - t, order);
                    check_equal(b - a, t - s, order);
                    check_equal(a * b, s * t, order);
                    check_equal(a / b, s / t, order);
                    check_equal(b / a, t / s, order);
                    check_equal(2 * a - a * 0.5f + a / 4, 1.75 * s, order);
                    check_equal(-(1 - a), s - Series(1), order);
                    J c = a;
                    c += b, c *= a, c -= b, c /= b;
                    check_equal(c, ((s + t) * s - t) / t, order);
                }
}

TEST_CASE("functions of a jet are those of its series") {
    Generator generator(2);
    for (const int order : {0, 1, 3, J::highest - 1})
        for (const bool moves : {false, true}) {
            CAPTURE(order, moves);
            const auto [a, s] = random_both(generator, order, moves);
            check_equal(sin(a), sin(s), order);
            check_equal(cos(a), cos(s), order);
            check_equal(exp(a), exp(s), order);
            check_equal(log(a), log(s), order);
            check_equal(sqrt(a), sqrt(s), order);
            check_equal(pow(a, 3), pow(s, 3), order);
            check_equal(pow(a, -2), pow(s, -2), order);
            check_equal(pow(a, 1.5), pow(s, 1.5), order);
        }
}

TEST_CASE("jets of many digits keep them") {
    using F = Multiprecision<40>;
    const auto x = Jet<F>::variable(F(1) / 3, F(1), 3);
    const auto one = sin(x) * sin(x) + cos(x) * cos(x);
    CHECK(abs(one.value(0) - 1) < F(1e-38));
    for (int k = 1; k <= 3; ++k) CHECK(abs(one.value(k)) < F(1e-38));
}
