// Models from JSON that move: the motion of the same models in C++, energies, and what is wrong is refused with its
// place.
#if __has_include(<tao/pegtl.hpp>) && __has_include(<nlohmann/json.hpp>)

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <equilibria/dynamics/hamilton.hpp>
#include <equilibria/dynamics/lagrange_second_kind.hpp>
#include <equilibria/dynamics/motion.hpp>
#include <equilibria/io/read_model.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/model/runtime_kinetics.hpp>
#include <equilibria/stability/linearise.hpp>
#include <equilibria/studies/formula_model/formula_motion.hpp>
#include <equilibria/studies/formula_model/formula_searches.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using std::numbers::pi;

namespace {

using Mechanism = mechanisms::HolonomicMechanism;
using State = MotionState<RuntimeUnknowns>;

/// The mechanism with its parameters in the order of the type.
const std::string mechanism = R"json({
  "angles": ["q1", "q2"],
  "parameters": {"m1": 1, "m2": 1, "m3": 1, "g": 1, "l": 1, "c1": 1, "c2": 1, "beta": 1, "F": 1, "a": 0},
  "definitions": {"slider": "-l*sin(q1)*(1 + cos(q1)/sqrt(3 + cos(q1)^2))*w1", "change": "F*l*(exp(-a*t) - 1)"},
  "potential":
    "g*l*((m1 + m2)*sin(q1) - m2*cos(q2)) + l^2*(c1*(1 - sin(q1 + q2)) + c2*(1 - sin(q1))) - F*l*(cos(q1) - sin(q2))",
  "rates": ["w1", "w2"],
  "kinetic_energy": "0.5*l^2*(m1*w1^2 + m2*(w1^2 + 2*sin(q1 + q2)*w1*w2 + w2^2)) + 0.5*m3*slider^2",
  "dissipation": "0.5*beta*slider^2",
  "generalised_forces": ["-change*sin(q1)", "-change*cos(q2)"],
  "time": "t"
})json";

const std::string pendulum = R"json({"angles": ["q"], "parameters": {"m": 2, "g": 9.81, "l": 1.3, "b": 0},
  "potential": "-m*g*l*cos(q)", "rates": ["w"], "kinetic_energy": "m*l^2*w^2/2", "dissipation": "b/2*w^2"})json";

/// The functions of the type at run time, which the formulas must not be told from.
struct MechanismAtRunTime {
    int angles() const { return 2; }
    int parameters() const { return Mechanism::n_parameters; }
    auto potential(const auto& q, const auto& p) const { return Mechanism{}.potential(q, p); }
    auto kinetic_energy(const auto& q, const auto& v, const auto& p) const {
        return Mechanism{}.kinetic_energy(q, v, p);
    }
    auto dissipation(const auto& q, const auto& v, const auto& p) const { return Mechanism{}.dissipation(q, v, p); }
    auto generalised_forces(double t, const auto& q, const auto& v, const auto& p) const {
        return Mechanism{}.generalised_forces(t, q, v, p);
    }
};

std::vector<double> every(double step, int count) {
    std::vector<double> y;
    for (int k = 0; k <= count; ++k) y.push_back(step * k);
    return y;
}

std::string refused(const std::string& text) {
    try {
        parse_model(text);
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return {};
}

/// A pendulum on a spring with more keys.
std::string with_keys(const std::string& keys, const std::string& definitions = "") {
    return "{\"angles\": [\"t\"], \"coordinates\": [\"x\"], \"parameters\": {\"k\": 3},\n" + definitions +
           " \"potential\": \"0.5*k*(x - 1)^2 - x*cos(t)\",\n " + keys + "}";
}
const std::string rates = R"json("rates": ["w", "v"], )json";

}  // namespace

TEST_CASE("a mechanism that is formulas moves as the one that is a type") {
    const FormulaModel model = parse_model(mechanism);
    REQUIRE(model.kinetics);
    CHECK(model.kinetics->rates == std::vector<std::string>{"w1", "w2"});
    CHECK(model.kinetics->time == "t");
    const auto p = Mechanism::paper_parameters(100, 0.7);
    const auto times = every(0.1, 100);
    const State start{{4 * pi / 13, pi / 7}, {0.3, -0.2}};
    const auto typed = integrate_motion(LagrangeSecondKind<Mechanism>(p), {{4 * pi / 13, pi / 7}, {0.3, -0.2}}, times);
    const auto at = runtime_array(p);
    const auto compare = [&](const Motion<RuntimeUnknowns>& motion) {
        REQUIRE(motion.status == MotionStatus::finished);
        CHECK(motion.largest_balance < 1e-10);
        REQUIRE(motion.points.size() == typed.points.size());
        double farthest = 0;
        for (std::size_t k = 0; k < times.size(); ++k) {
            const auto& x = motion.points[k];
            const auto& y = typed.points[k];
            for (int i = 0; i < 2; ++i)
                farthest = std::max({farthest, std::abs(x.q[i] - y.q[i]), std::abs(x.velocity[i] - y.velocity[i]),
                                     std::abs(x.momentum[i] - y.momentum[i]) / 100});
            for (const double difference :
                 {x.kinetic - y.kinetic, x.potential - y.potential, x.work - y.work, x.dissipated - y.dissipated})
                farthest = std::max(farthest, std::abs(difference) / 1000);  // of some 100 J
        }
        CHECK(farthest < 1e-10);
    };
    const auto functions = kinetic_functions(model), of_type = kinetic_functions(MechanismAtRunTime{});
    compare(integrate_motion(model, at, start, times));
    compare(integrate_motion(model, at, start, times, {}, {}, FormulaFormulation::hamilton));
    compare(integrate_motion(LagrangeSecondKind<RuntimeUnknowns>(functions, at, LagrangeForm::contravariant), start,
                             times));
    compare(integrate_motion(LagrangeSecondKind<RuntimeUnknowns>(of_type, at), start, times));
    compare(integrate_motion(HamiltonEquations<RuntimeUnknowns>(of_type, at), start, times));
}

TEST_CASE("functions of a motion that is formulas are those of the type, at random states") {
    const auto functions = kinetic_functions(parse_model(mechanism));
    const auto p = Mechanism::paper_parameters(100, 0.7);
    const auto at = runtime_array(p);
    Generator random(3);
    for (int k = 0; k < 20; ++k) {
        Unknowns<Mechanism> q, v;
        for (int i = 0; i < 2; ++i) q[i] = uniform(random, -3, 3), v[i] = uniform(random, -2, 2);
        const auto rq = runtime_array(q), rv = runtime_array(v);
        const Eigen::Vector2d u(v[0], v[1]);
        const auto close = [](const auto& a, const auto& b) { return (a - b).norm() <= 1e-12 * (1 + b.norm()); };
        CHECK(functions->kinetic_energy(rq, rv, at) == Approx(kinetic_energy<Mechanism>(q, v, p)).epsilon(1e-13));
        CHECK(functions->potential(rq, at) == Approx(potential<Mechanism>(q, p)).epsilon(1e-13));
        CHECK(close(functions->mass_matrix(rq, at), mass_matrix<Mechanism>(q, p)));
        CHECK(close(functions->convective_forces(rq, rv, at),
                    contracted<Mechanism>(christoffel_first_kind<Mechanism>(q, p), u)));
        const auto derivatives = mass_matrix_derivatives<Mechanism>(q, p);
        CHECK(close(functions->kinetic_gradient(rq, rv, at),
                    Eigen::Vector2d(0.5 * u.dot(derivatives[0] * u), 0.5 * u.dot(derivatives[1] * u))));
        CHECK(close(functions->dissipation_gradient(rq, rv, at),
                    detail::vector_of<Mechanism>(dissipation_gradient<Mechanism>(q, v, p))));
        CHECK(close(functions->generalised_forces(0.8, rq, rv, at),
                    detail::vector_of<Mechanism>(generalised_forces<Mechanism>(0.8, q, v, p))));
        const auto typed = linearise<Mechanism>(q, p, 0.8);
        const auto linear = linearise(*functions, rq, at, 0.8);
        CHECK(close(linear.mass, typed.mass));
        CHECK(close(linear.damping, typed.damping));
        CHECK(close(linear.stiffness, typed.stiffness));
    }
}

TEST_CASE("equilibria of formulas that move: the same roots, and their poles") {
    const FormulaModel model = parse_model(mechanism);
    std::string still = mechanism;
    still.erase(still.find(",\n  \"rates\""), still.find("\"time\": \"t\"") + 11 - still.find(",\n  \"rates\""));
    still.erase(still.find("  \"definitions\""), still.find("  \"potential\"") - still.find("  \"definitions\""));
    const FormulaModel at_rest = parse_model(still);
    CHECK(!at_rest.kinetics);
    CHECK(model.steps->steps().size() < at_rest.steps->steps().size());  // without parameters that it does not have
    const auto p = Mechanism::paper_parameters(100);
    const auto found = enumerate(model, runtime_array(p)), expected = enumerate(at_rest, runtime_array(p));
    REQUIRE(found.equilibria.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) {
        const auto& q = found.equilibria[k].q;
        CHECK(q == expected.equilibria[k].q);
        const auto poles = count_poles(model, q, runtime_array(p));
        const auto typed = count_poles(linearise<Mechanism>({q[0], q[1]}, p));
        CHECK(poles.right_half_plane() == found.equilibria[k].index);  // Kelvin, Tait and Chetaev
        CHECK(poles.verdict() == typed.verdict());
        CHECK((poles.poles - typed.poles).norm() < 1e-9);
        REQUIRE(count_poles_at_rest(model, q, runtime_array(p)));
        CHECK(count_poles_at_rest(model, q, runtime_array(p))->poles == poles.poles);
        CHECK(!count_poles_at_rest(model, q, runtime_array(Mechanism::paper_parameters(100, 0.7))));
    }
}

TEST_CASE("a pendulum that is a formula: its period, its energy without and with damping") {
    const FormulaModel model = parse_model(pendulum);
    for (const double angle : {0.1, 1.0, 2.5, 3.0}) {
        const double period = 4 * std::sqrt(1.3 / 9.81) * std::comp_ellint_1(std::sin(angle / 2));
        const auto motion = integrate_motion(model, model.values, {{angle}, {0}}, {period / 4, period / 2, period});
        REQUIRE(motion.status == MotionStatus::finished);
        CHECK(std::abs(motion.points[0].q[0]) < 1e-9);
        CHECK(std::abs(motion.points[1].q[0] + angle) < 1e-9);
        CHECK(std::abs(motion.points[2].q[0] - angle) < 1e-9);
        CHECK(motion.largest_balance < 1e-10);
        const double energy = 2 * 9.81 * 1.3;
        for (const auto& point : motion.points)
            CHECK(point.kinetic + point.potential == Approx(-energy * std::cos(angle)).epsilon(1e-10));
    }
    const auto damped = integrate_motion(model, {2, 9.81, 1.3, 0.7}, {{2}, {1}}, every(0.5, 40));
    REQUIRE(damped.status == MotionStatus::finished);
    CHECK(damped.largest_balance < 1e-10);
    double before = 1e9;
    for (const auto& point : damped.points) {
        CHECK(point.kinetic + point.potential < before);
        before = point.kinetic + point.potential;
        CHECK(std::abs(point.balance) < 1e-8);
    }
    CHECK(damped.points.back().dissipated > 30);
    CHECK(kinetic_energy_of(model, {0.4}, {3}, model.values) == Approx(2 * 1.3 * 1.3 * 9 / 2));
}

TEST_CASE("driven, damped by forces, with a coordinate: the closed form of an oscillator") {
    // x'' + 2 d x' + x = cos(s t), the damping once as a force; at s = 1 from rest x_p = sin(t) / (2 d)
    const FormulaModel model = parse_model(R"json({"coordinates": ["x"], "parameters": {"d": 0.1, "s": 1},
        "potential": "x^2/2", "rates": ["v"], "kinetic_energy": "v^2/2", "time": "t",
        "generalised_forces": ["cos(s*t) - 2*d*v"]})json");
    const double d = 0.1, w = std::sqrt(1 - d * d);
    const auto motion = integrate_motion(model, model.values, {{0}, {0}}, every(0.7, 30));
    REQUIRE(motion.status == MotionStatus::finished);
    CHECK(motion.largest_balance < 1e-10);
    for (const auto& point : motion.points) {
        const double t = point.time, x = std::sin(t) / (2 * d) - std::exp(-d * t) * std::sin(w * t) / (2 * d * w);
        CHECK(std::abs(point.q[0] - x) < 1e-9);
        CHECK(point.dissipated == 0);
    }
    // of many unknowns, more than go side by side: beads on a string, their highest mode
    const int n = 11;
    std::string coordinates, names, energy, potential = "x0^2/2";
    for (int i = 0; i < n; ++i) {
        const std::string k = std::to_string(i), comma = i > 0 ? ", " : "";
        coordinates += comma + "\"x" + k + "\"", names += comma + "\"v" + k + "\"";
        energy += (i > 0 ? " + v" : "v") + k + "^2/2";
        potential += i + 1 < n ? " + (x" + std::to_string(i + 1) + " - x" + k + ")^2/2" : " + x" + k + "^2/2";
    }
    const FormulaModel string =
        parse_model("{\"coordinates\": [" + coordinates + "], \"rates\": [" + names + "], \"kinetic_energy\": \"" +
                    energy + "\", \"potential\": \"" + potential + "\"}");
    State start{RuntimeArray<double>(n), RuntimeArray<double>(n)};
    for (int i = 0; i < n; ++i) start.q[i] = std::sin(pi * n * (i + 1) / (n + 1));
    const double frequency = 2 * std::sin(pi * n / (2 * (n + 1)));
    for (const auto formulation : {FormulaFormulation::lagrange, FormulaFormulation::hamilton}) {
        const auto mode = integrate_motion(string, {}, start, {5}, {}, {}, formulation);
        REQUIRE(mode.status == MotionStatus::finished);
        for (int i = 0; i < n; ++i) CHECK(std::abs(mode.points[0].q[i] - start.q[i] * std::cos(5 * frequency)) < 1e-9);
    }
}

TEST_CASE("what stops a motion of formulas is a status, what is wrong with it an error") {
    const FormulaModel model = parse_model(with_keys(rates + R"json("kinetic_energy": "0.5*(v^2 + x^2*w^2)")json"));
    const auto through = integrate_motion(model, model.values, {{0, 0}, {1, 0}}, {1});
    CHECK(through.status == MotionStatus::singular_mass_matrix);
    CHECK(through.points.empty());
    CHECK(!count_poles_at_rest(model, {0, 0}, model.values));
    const auto few = integrate_motion(model, model.values, {{1, 1}, {0, 0}}, {1, 1000}, {.most_steps = 500});
    CHECK(few.status == MotionStatus::too_many_steps);
    CHECK(few.points.size() == 1);
    const std::atomic<bool> cancel = true;
    RunOptions run;
    run.cancel = &cancel;
    const auto cancelled = integrate_motion(model, model.values, {{1, 1}, {0, 0}}, {0, 1}, {}, run);
    CHECK(cancelled.status == MotionStatus::cancelled);
    CHECK(cancelled.points.size() == 1);
    CHECK(std::string(to_string(cancelled.status)) == "cancelled");
    std::vector<std::uint64_t> told;
    run = {};
    run.progress = [&](std::uint64_t done, std::uint64_t all) { told.push_back(100 * done + all); };
    integrate_motion(model, model.values, {{1, 1}, {0, 0}}, {0, 1, 2}, {}, run);
    CHECK(told == std::vector<std::uint64_t>{103, 203, 303});

    const auto fault = [&](const FormulaModel& of, const RuntimeArray<double>& p, const State& start,
                           const std::vector<double>& times) {
        try {
            integrate_motion(of, p, start, times);
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const State start{{1, 1}, {0, 0}};
    CHECK_THAT(fault(model, {}, start, {1}), Catch::Contains("p = 0: must be as many as the model's parameters: 1"));
    CHECK_THAT(fault(model, {3}, {{1}, {0, 0}}, {1}), Catch::Contains("start.q = 1: must be one for each unknown: 2"));
    CHECK_THAT(fault(model, {3}, {{1, 1}, {0}}, {1}), Catch::Contains("start.velocity = 1: must be one for each"));
    CHECK_THAT(fault(model, {3}, {{1, INFINITY}, {0, 0}}, {1}), Catch::Contains("start.q[1] = inf: must be finite"));
    CHECK_THAT(fault(model, {NAN}, start, {1}), Catch::Contains("p[0] = nan: must be finite"));
    CHECK_THAT(fault(model, {3}, start, {1, 0.5}), Catch::Contains("times[1] = 0.5: must be finite, 1 or more"));
    CHECK_THAT(fault(parse_model(with_keys(R"json("name": "no motion")json")), {3}, start, {1}),
               Catch::Contains("model = without a kinetic energy: must have one"));
    // a form that is quadratic with the file's values alone
    const FormulaModel cubic = parse_model(
        R"json({"coordinates": ["x"], "parameters": {"a": 0}, "potential": "x", "rates": ["v"],
                "kinetic_energy": "v^2 + a*v^3"})json");
    CHECK(fault(cubic, {0}, {{1}, {1}}, {1}).empty());
    CHECK_THAT(fault(cubic, {1}, {{1}, {1}}, {1}), Catch::Contains("must be a quadratic form in the velocities"));
}

TEST_CASE("files of models that move and are wrong are refused, with line and column where a formula is") {
    const std::string energy = R"json("kinetic_energy": "0.5*(v^2 + x^2*w^2)")json";
    const auto with_energy = [](const std::string& formula) {
        return refused(with_keys(rates + "\"kinetic_energy\": \"" + formula + "\""));
    };
    CHECK(refused(with_keys(rates + energy)).empty());
    CHECK(with_energy("0.5*(v^2/(1 + x^2) + x^2*w^2*exp(sin(t)) + sqrt(1 + x^2)*v*w)").empty());
    CHECK(with_energy("(v + w)^2 - 2*v*w").empty());
    const char* const form =
        "kinetic_energy, line 3, column 42 = no quadratic form: must be a quadratic form in the rates";
    CHECK_THAT(with_energy("0.5*v^2 + w"), Catch::StartsWith(form));
    CHECK_THAT(with_energy("0.5*v^2 + 1"), Catch::StartsWith(form));
    CHECK_THAT(with_energy("v^4"), Catch::StartsWith(form));
    CHECK_THAT(with_energy("sqrt(v^4 + w^4)"), Catch::StartsWith(form));
    CHECK_THAT(with_energy("v^2 + u^2"),
               Catch::StartsWith("kinetic_energy, line 3, column 48 = u^2: no name u: must be one of t, x, k, w, v"));
    CHECK_THAT(with_energy("v^2*t"), Catch::Contains("line 3, column 45") && Catch::Contains("an angle may enter"));

    CHECK_THAT(refused(with_keys(R"json("rates": ["w", "v"])json")),
               Catch::Contains(R"(rates = ["w","v"]: must stand beside "kinetic_energy")"));
    CHECK_THAT(refused(with_keys(R"json("dissipation": "x")json")), Catch::Contains("must stand beside"));
    CHECK_THAT(refused(with_keys(energy)), Catch::Contains(R"(must have "rates")"));
    CHECK_THAT(refused(with_keys(R"json("rates": ["w"], )json" + energy)),
               Catch::Contains(R"(rates = ["w"]: must be one name for each unknown: 2)"));
    CHECK_THAT(refused(with_keys(R"json("rates": ["w", "x"], )json" + energy)),
               Catch::Contains("a rate = x: must not have a name that is used already"));
    CHECK_THAT(refused(with_keys(R"json("rates": ["w", "sin"], "kinetic_energy": "w^2")json")),
               Catch::Contains("name = sin"));
    CHECK_THAT(refused(with_keys(rates + energy + R"json(, "time": "s")json")),
               Catch::Contains(R"(time = "s": must stand beside "generalised_forces")"));
    CHECK_THAT(refused(with_keys(rates + energy + R"json(, "generalised_forces": ["v"])json")),
               Catch::Contains("must be one formula for each unknown: 2"));
    CHECK_THAT(refused(with_keys(rates + energy + R"json(, "dissipation": "s*v^2", "time": "s",
        "generalised_forces": ["s", "0"])json")),
               Catch::StartsWith("dissipation, line 3, column 80 = s*v^2: s: must stand in generalised_forces alone"));
    CHECK_THAT(
        refused(R"json({"angles": ["t"], "equations": ["sin(t)"], "rates": ["w"], "kinetic_energy": "w^2"})json"),
        Catch::Contains(R"(must stand beside "potential")"));
    CHECK_THAT(
        refused(R"json({"angles": ["t"], "potential": "w*cos(t)", "rates": ["w"], "kinetic_energy": "w^2"})json"),
        Catch::StartsWith("potential, line 1, column 33 = w*cos(t): ") &&
            Catch::Contains("must not stand in a potential"));
    CHECK_THAT(refused(with_keys(rates + energy, R"json("definitions": {"s": "1/x"},)json")), Catch::Equals(""));
    CHECK_THAT(refused(R"json({"coordinates": ["x"], "definitions": {"s": "1/x"}, "potential": "2*s + x",
        "rates": ["w"], "kinetic_energy": "w^2"})json"),
               Catch::StartsWith("potential, line 1, column 69 = s + x: s: ") &&
                   Catch::Contains("must not stand in a potential"));
}

#endif
