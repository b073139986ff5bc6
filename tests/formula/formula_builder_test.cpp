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
    CHECK_THAT(refusal([&] { b().power(m.x, m.n(-1)); }), Catch::Contains("must be an integer from 0 to 1000"));
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

TEST_CASE("formulas of a motion: any function of unknowns, rates and the time, with its derivatives") {
    using D = Dual<double, 4>;
    FormulaBuilder b(1, 1, 1);
    CHECK(!b.has_motion());
    b.set_rules(FormulaRules::motion);
    const Formula t = b.angle(0), x = b.coordinate(0), a = b.parameter(0), w = b.rate(0), v = b.rate(1), s = b.time();
    // a w^2 / sqrt(3 + cos(t)^2) + v w tan(t) log(1 + x^2) + sin(a s) v^2 x^1.5 + exp(-s) (1 + x)^-2 + 2^x - x^0.5
    Formula f = b.quotient(b.product(a, b.power(w, b.number(2))),
                           b.square_root(b.sum(b.number(3), b.power(b.cosine(t), b.number(2)))));
    const Formula square = b.sum(b.number(1), b.power(x, b.number(2)));
    f = b.sum(f, b.product(b.product(v, w), b.product(b.tangent(t), b.logarithm(square))));
    f = b.sum(f, b.product(b.product(b.sine(b.product(a, s)), b.power(v, b.number(2))), b.power(x, b.number(1.5))));
    f = b.sum(f, b.product(b.exponential(b.negative(s)), b.power(b.sum(b.number(1), x), b.number(-2))));
    f = b.sum(f, b.difference(b.power(b.number(2), x), b.power(x, b.number(0.5))));
    CHECK(f.kind == FormulaKind::motion);
    CHECK(b.has_motion());

    Generator random(11);
    std::vector<int> results{f.step};
    const FormulaSteps reached = b.steps().reached(results);
    CHECK(reached.depends_on(results[0], FormulaOperation::time));
    CHECK(!b.steps().depends_on(square.step, FormulaOperation::time));
    for (int k = 0; k < 20; ++k) {
        const double p = uniform(random, 0.3, 2), time = uniform(random, 0, 3);
        D at[4];
        for (int i = 0; i < 4; ++i) at[i] = D::variable(uniform(random, 0.2, 1.3), i);
        const auto [angle, y, rate, speed] = std::array{at[0], at[1], at[2], at[3]};
        const D expected = p * rate * rate / sqrt(3 + cos(angle) * cos(angle)) +
                           speed * rate * sin(angle) / cos(angle) * log(1 + y * y) +
                           std::sin(p * time) * speed * speed * y * sqrt(y) + std::exp(-time) / ((1 + y) * (1 + y)) +
                           exp(std::log(2.0) * y) - sqrt(y);
        const std::array<CircleAngle<D>, 1> theta{CircleAngle<D>{cos(angle), sin(angle)}};
        for (const bool all : {true, false}) {
            D found;
            (all ? b.steps() : reached)
                .evaluate(theta, std::array{y}, std::array{rate, speed}, time, std::array{p},
                          all ? std::vector{f.step} : results, &found);
            CHECK(found.value == Approx(expected.value).epsilon(1e-13));
            for (int i = 0; i < 4; ++i)
                CHECK(found.derivative[i] == Approx(expected.derivative[i]).epsilon(1e-12).margin(1e-12));
        }
    }

    CHECK_THAT(refusal([&] { b.power(t, b.number(2)); }), Catch::Contains("a power of an angle"));
    CHECK_THAT(refusal([&] { b.square_root(t); }), Catch::Contains("sqrt of an angle"));
    CHECK_THAT(refusal([&] { b.sum(t, w); }), Catch::Contains("an angle + an expression of unknowns"));
    CHECK_THAT(refusal([&] { b.rate(2); }), Catch::Contains("must be the number of an unknown"));
    b.set_rules(FormulaRules::equilibria);
    const char* const of_motion = "a formula of a motion";
    CHECK_THAT(refusal([&] { b.product(a, w); }), Catch::Contains(of_motion));
    CHECK_THAT(refusal([&] { b.negative(s); }), Catch::Contains(of_motion));
    CHECK_THAT(refusal([&] { b.power(w, b.number(2)); }), Catch::Contains(of_motion));
    CHECK_THAT(refusal([&] { b.quotient(x, w); }), Catch::Contains("division by an expression of unknowns"));
    CHECK_THAT(refusal([&] { b.sine(x); }), Catch::Contains("sin of an expression of unknowns"));
}

TEST_CASE("a model with kinetics keeps the steps of each function apart") {
    FormulaBuilder b(1, 0, 2);
    const Formula potential = b.product(b.parameter(0), b.cosine(b.sum(b.angle(0), b.parameter(1))));
    b.set_rules(FormulaRules::motion);
    KineticFormulas kinetic;
    kinetic.rates = {"w"};
    kinetic.kinetic_energy = b.product(b.power(b.rate(0), b.number(2)), b.parameter(0));
    const auto named = [] {
        FormulaModel y;
        y.angles = {"t"};
        y.parameters = {"a", "c"};
        y.values = {1.5, 0.3};
        return y;
    };
    const FormulaModel still = formula_model(named(), b, {potential});
    CHECK(!still.kinetics);
    CHECK(still.steps->steps().size() == 4);  // a, c, cos(t + c), their product
    const FormulaModel model = with_kinetics(still, b, kinetic);
    REQUIRE(model.kinetics);
    CHECK(model.steps == still.steps);
    CHECK(model.kinetics->kinetic_energy.steps->steps().size() == 4);  // w, w^2, a, their product
    CHECK(!model.kinetics->dissipation);
    const FormulaDynamics dynamics(model);
    const std::array theta{0.4}, x{0.0}, v{2.0};
    CHECK(dynamics.potential(theta, x, model.values) == Approx(1.5 * std::cos(0.7)));
    CHECK(dynamics.kinetic_energy(theta, x, v, model.values) == 6);
    CHECK(dynamics.dissipation(theta, x, v, model.values) == 0);
    CHECK(dynamics.generalised_forces(1, theta, x, v, model.values)[0] == 0);

    const auto fault = [&](const auto& change) {
        KineticFormulas other = kinetic;
        change(other);
        return refusal([&] { with_kinetics(still, b, other); });
    };
    CHECK_THAT(fault([](auto& k) { k.rates.clear(); }), Catch::Contains("number of rates = 0: must be one for each"));
    CHECK_THAT(fault([](auto& k) { k.rates = {"a"}; }), Catch::Contains("must not be used twice"));
    CHECK_THAT(fault([](auto& k) { k.time = "w"; }), Catch::Contains("must not be used twice"));
    CHECK_THAT(fault([&](auto& k) { k.kinetic_energy = b.rate(0); }), Catch::Contains("must be a quadratic form"));
    CHECK_THAT(fault([&](auto& k) { k.kinetic_energy = b.time(); }), Catch::Contains("must not depend on the time"));
    CHECK_THAT(fault([&](auto& k) { k.dissipation = b.time(); }),
               Catch::Contains("dissipation = a formula of the time"));
    CHECK_THAT(fault([&](auto& k) { k.dissipation = b.angle(0); }),
               Catch::Contains("a whole formula that is an angle"));
    CHECK_THAT(fault([&](auto& k) { k.generalised_forces = {b.time(), b.time()}; }),
               Catch::Contains("number of generalised_forces = 2: must be one for each unknown: 1"));
    CHECK_THAT(refusal([&] { formula_model(named(), b, {b.rate(0)}); }),
               Catch::Contains("must not be a potential or an equation"));
    FormulaModel equations = named();
    equations.has_potential = false;
    CHECK_THAT(refusal([&] { with_kinetics(formula_model(equations, b, {potential}), b, kinetic); }),
               Catch::Contains("must stand beside a potential"));
}
