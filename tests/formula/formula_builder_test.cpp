// Formulas put together by operations: their values are those of the same function in C++, and what breaks a rule is
// refused in a sentence.
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/dual.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/formula/formula_builder.hpp>
#include <equilibria/formula/formula_model.hpp>
#include <equilibria/model/angle.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// Two angles, one coordinate, two parameters.
struct Built {
    FormulaBuilder b{2, 1, 2};
    Formula t1 = b.angle(0), t2 = b.angle(1), x = b.coordinate(0), a = b.parameter(0), c = b.parameter(1);

    Formula n(double value) { return b.number(value); }
    template <class S>
    S value(const Formula& f, const S& theta1, const S& theta2, const S& x1, const std::array<double, 2>& p) const {
        const std::array<CircleAngle<S>, 2> theta{CircleAngle<S>{cos(theta1), sin(theta1)}, {cos(theta2), sin(theta2)}};
        S y;
        b.steps().evaluate(theta, std::array{x1}, p, {f.step}, &y);
        return y;
    }
};

std::string refusal(const auto& operation) {
    try {
        operation();
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("a formula has the values and the derivatives of the function that it says") {
    using D = Dual<double, 3>;
    Built m;
    // a cos(2 t1 - 3 t2 + c) + sqrt(c) sin(t2 - 0.3)^2 x + exp(a) x^3 / (1 + c^2) + (log(a) - tan(c)) x - a^c
    const Formula combined = m.b.sum(m.b.difference(m.b.product(m.n(2), m.t1), m.b.product(m.t2, m.n(3))), m.c);
    Formula f = m.b.product(m.a, m.b.cosine(combined));
    const Formula square = m.b.power(m.b.sine(m.b.difference(m.t2, m.n(0.3))), m.n(2));
    f = m.b.sum(f, m.b.product(m.b.product(m.b.square_root(m.c), square), m.x));
    const Formula cube = m.b.product(m.b.exponential(m.a), m.b.power(m.x, m.n(3)));
    f = m.b.sum(f, m.b.quotient(cube, m.b.sum(m.n(1), m.b.power(m.c, m.n(2)))));
    f = m.b.sum(f, m.b.product(m.b.difference(m.b.logarithm(m.a), m.b.tangent(m.c)), m.x));
    f = m.b.difference(f, m.b.power(m.a, m.c));

    Generator random(7);
    for (int k = 0; k < 20; ++k) {
        const auto draw = [&] { return uniform(random, 0.3, 1.4); };
        const std::array<double, 2> p{draw(), draw()};
        D q[3];
        for (int u = 0; u < 3; ++u) q[u] = D(draw()), q[u].derivative[u] = 1;
        const D sine = sin(q[1] - 0.3);
        const D expected = p[0] * cos(2.0 * q[0] - 3.0 * q[1] + p[1]) + std::sqrt(p[1]) * sine * sine * q[2] +
                           std::exp(p[0]) * q[2] * q[2] * q[2] / (1 + p[1] * p[1]) +
                           (std::log(p[0]) - std::tan(p[1])) * q[2] - std::pow(p[0], p[1]);
        const D found = m.value(f, q[0], q[1], q[2], p);
        CHECK(found.value == Approx(expected.value).margin(1e-13));
        for (int u = 0; u < 3; ++u) CHECK(found.derivative[u] == Approx(expected.derivative[u]).margin(1e-13));
    }
}

TEST_CASE("what two formulas share is computed once, and numbers are computed when they are read") {
    Built m;
    const Formula once = m.b.sine(m.t1), again = m.b.sine(m.t1);
    CHECK(once.step == again.step);
    const Formula number = m.b.sum(m.n(1), m.b.product(m.n(2), m.n(3)));
    CHECK(m.b.steps().steps()[static_cast<std::size_t>(number.step)].value == 7);
    CHECK(m.b.power(m.x, m.n(0)).kind == FormulaKind::constant);
    // angles that cancel leave their phase
    const Formula phase = m.b.difference(m.b.sum(m.t1, m.c), m.t1);
    CHECK(phase.kind == FormulaKind::constant);
    CHECK(m.value(phase, 0.1, 0.2, 0.3, {0.4, 0.5}) == 0.5);
}

TEST_CASE("operations that are none of a model's") {
    Built m;
    const auto& b = [&]() -> FormulaBuilder& { return m.b; };
    const std::string angle = "an angle may enter a model only inside sin and cos";
    CHECK_THAT(refusal([&] { b().product(m.t1, m.n(0.5)); }), Catch::Contains(angle));
    CHECK_THAT(refusal([&] { b().product(m.t1, m.t2); }), Catch::Contains(angle));
    CHECK_THAT(refusal([&] { b().product(m.t1, m.a); }), Catch::Contains(angle));
    CHECK_THAT(refusal([&] { b().sum(m.t1, m.x); }), Catch::Contains(angle));
    CHECK_THAT(refusal([&] { b().power(m.t1, m.n(2)); }), Catch::Contains(angle));
    CHECK_THAT(refusal([&] { b().quotient(m.n(1), m.t1); }), Catch::Contains("division by an angle"));
    CHECK_THAT(refusal([&] { b().square_root(m.t1); }), Catch::Contains("sqrt of an angle"));
    CHECK_THAT(refusal([&] { b().quotient(m.n(1), m.x); }), Catch::Contains("division by an expression of unknowns"));
    CHECK_THAT(refusal([&] { b().exponential(m.x); }), Catch::Contains("exp of an expression of unknowns"));
    CHECK_THAT(refusal([&] { b().sine(m.x); }), Catch::Contains("sin of an expression of unknowns"));
    CHECK_THAT(refusal([&] { b().power(m.x, m.n(-1)); }), Catch::Contains("must be an integer from 0 to 100"));
    CHECK_THAT(refusal([&] { b().power(m.x, m.a); }), Catch::Contains("a power by a parameter"));
    CHECK_THAT(refusal([&] { b().quotient(m.x, m.n(0)); }), Catch::Contains("divisor = 0: must not be 0"));
    CHECK_THAT(refusal([&] { b().number(std::nan("")); }), Catch::Contains("must be finite"));
    CHECK_THAT(refusal([&] { b().parameter(2); }), Catch::Contains("must be the number of a parameter"));
    CHECK_THAT(refusal([&] { b().function("sinh", m.x); }), Catch::Contains("function = sinh"));
}

TEST_CASE("formulas and names that make no model") {
    const auto model = [](FormulaModel named, int formulas) {
        FormulaBuilder b(static_cast<int>(named.angles.size()), 0, static_cast<int>(named.parameters.size()));
        std::vector<Formula> f;
        for (int k = 0; k < formulas; ++k) f.push_back(b.sine(b.angle(0)));
        return refusal([&] { formula_model(std::move(named), b, f); });
    };
    const auto named = [](std::vector<std::string> angles, std::vector<std::string> parameters, std::vector<double> p) {
        FormulaModel y;
        y.angles = std::move(angles);
        y.parameters = std::move(parameters);
        y.values = RuntimeArray<double>(static_cast<int>(p.size()));
        for (int k = 0; k < y.values.size(); ++k) y.values[k] = p[static_cast<std::size_t>(k)];
        return y;
    };
    CHECK(model(named({"t"}, {"a"}, {1}), 1).empty());
    CHECK_THAT(model(named({"t"}, {"t"}, {1}), 1), Catch::Contains("name = t: must not be used twice"));
    CHECK_THAT(model(named({"t"}, {"sin"}, {1}), 1), Catch::Contains("name = sin"));
    CHECK_THAT(model(named({"2t"}, {}, {}), 1), Catch::Contains("name = 2t: must be letters"));
    CHECK_THAT(model(named({"t"}, {"a"}, {}), 1), Catch::Contains("number of values = 0"));
    CHECK_THAT(model(named({"t"}, {"a"}, {INFINITY}), 1), Catch::Contains("a = inf: must be finite"));
    CHECK_THAT(model(named({"t"}, {}, {}), 2), Catch::Contains("number of potentials = 2: must be 1"));
    auto equations = named({"t", "u"}, {}, {});
    equations.has_potential = false;
    CHECK_THAT(model(equations, 1), Catch::Contains("number of equations = 1: must be one for each unknown: 2"));
    CHECK_THAT(refusal([] { number_of_name({"a", "b", "c"}, "d", "parameter"); }),
               Catch::Contains("parameter = d: must be a, b or c"));
}
