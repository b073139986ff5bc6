// Models from JSON: the roots of the same models in C++, and what is wrong is refused with its place.
#if __has_include(<tao/pegtl.hpp>) && __has_include(<nlohmann/json.hpp>)

#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <string>
#include <vector>

#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/io/read_model.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/studies/formula_model/formula_searches.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"
#include "support/scratch_file.hpp"
#include "support/spring_loaded_double_pendulum.hpp"

using namespace equilibria;

namespace {

/// A model of the type M, as one at run time.
template <class M>
struct AtRunTime {
    int angles() const { return n_angles<M>; }
    int coordinates() const { return n_coordinates<M>; }
    int parameters() const { return n_parameters<M>; }
    auto potential(const auto& theta, const auto& x, const auto& p) const
    requires requires(const M& m) { m.potential(theta, p); } || requires(const M& m) { m.potential(theta, x, p); }
    {
        if constexpr (n_coordinates<M> > 0)
            return M{}.potential(theta, x, p);
        else
            return M{}.potential(theta, p);
    }
    auto equations(const auto& theta, const auto&, const auto& p) const
    requires requires(const M& m) { m.equations(theta, p); }
    {
        return M{}.equations(theta, p);
    }
};

/// That a model read from text has the roots of another one at run time, and as many paths.
template <class T>
void compare(const std::string& text, const T& model, const RuntimeArray<double>& p) {
    const FormulaModel read = parse_model(text);
    const auto found = enumerate(read, p, {.seed = 3}), expected = enumerate(model, p, {.seed = 3});
    CHECK(found.paths.total == expected.paths.total);
    CHECK(found.paths.failed == 0);
    CHECK(found.by_index() == expected.by_index());
    REQUIRE(found.roots.size() == expected.roots.size());
    for (const auto& root : found.roots) {
        const auto distance = [&](const auto& other) {
            double y = 0;
            for (int u = 0; u < root.q.size(); ++u) {
                const bool angle = u < found.model.sizes.angles;
                const std::complex<double> i(0, 1);
                y = std::max(y, angle ? std::abs(std::exp(i * root.q[u]) - std::exp(i * other.q[u]))
                                      : std::abs(root.q[u] - other.q[u]));
            }
            return y;
        };
        double nearest = 1;
        for (const auto& other : expected.roots) nearest = std::min(nearest, distance(other));
        CHECK(nearest < 1e-9);
    }
}

/// The error's text; empty where there is none.
std::string refusal(const std::string& text) {
    try {
        parse_model(text);
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return {};
}

std::string with_potential(const std::string& formula) {
    return "{\"angles\": [\"t\", \"u\"],\n \"coordinates\": [\"x\"],\n \"parameters\": {\"a\": 1, \"b\": 2},\n "
           "\"potential\": \"" +
           formula + "\"}";
}

}  // namespace

TEST_CASE("a model as a file has the roots of the same model in C++") {
    compare(R"json({"angles": ["t1", "t2"], "parameters": {"alpha": 0.33, "ratio": 1.5, "omega": 2},
                "definitions": {"x1": "sin(t1)", "x2": "x1 + ratio*sin(t2)"},
                "potential": "-0.5*omega^2*((1 - alpha)*x1^2 + alpha*x2^2) - cos(t1) - alpha*ratio*cos(t2)"})json",
            AtRunTime<mechanisms::TwoLinkChain>{}, {0.33, 1.5, 2});
    compare(R"json({"angles": ["t1", "t2", "t3"],
                "parameters": {"l1": 1, "l2": 1, "l3": 1, "m1": 1, "m2": 1, "m3": 1, "w": 1, "g": 1},
                "definitions": {"x1": "l1*sin(t1)", "x2": "x1 + l2*sin(t2)", "x3": "x2 + l3*sin(t3)",
                                "z1": "l1*cos(t1)", "z2": "z1 + l2*cos(t2)", "z3": "z2 + l3*cos(t3)"},
                "potential": "-(m1*(w**2*x1**2/2 + g*z1) + m2*(w**2*x2**2/2 + g*z2) + m3*(w**2*x3**2/2 + g*z3))"})json",
            mechanisms::RuntimeRotatingChain{3}, {1.1, 1.2, 1.3, 1.05, 1.2, 1.45, 1.7, 1});
    compare(R"json({"angles": ["q1", "q2"],
                "parameters": {"m1": 1, "m2": 1, "m3": 1, "g": 1, "l": 1, "c1": 1, "c2": 1, "beta": 1, "F": 1, "a": 0},
                "potential":
                  "g*l*((m1 + m2)*sin(q1) - m2*cos(q2)) + l^2*(c1*(1 - sin(q1 + q2)) + c2*(1 - sin(q1))) - F*l*(cos(q1) - sin(q2))"})json",
            AtRunTime<mechanisms::HolonomicMechanism>{},
            runtime_array(mechanisms::HolonomicMechanism::paper_parameters(100)));
    compare(R"json({"angles": ["t1", "t2"], "parameters": {"k": 1, "o": 0},
                "potential": "2*cos(t1) + cos(t2) + 0.5*k*((sin(t1) - o)^2 + (sin(t1) + sin(t2) - o)^2)"})json",
            AtRunTime<models::SpringLoadedDoublePendulum>{}, {1.3, 0.2});
    compare(R"json({"angles": ["t"], "coordinates": ["x"], "parameters": {"k": 1, "g": 1},
                "potential": "0.5*k*(x - 1)^2 - g*x*cos(t)"})json",
            AtRunTime<models::ElasticPendulum>{}, {3, 0.7});
    compare(R"json({"angles": ["t"], "parameters": {"torque": 0.3}, "equations": ["sin(t) - torque"]})json",
            AtRunTime<models::Pendulum>{}, {0.4});
    compare(R"json({"angles": ["t"], "parameters": {"torque": 0.3, "k": 1}, "equations": ["k*sin(t) - torque"]})json",
            AtRunTime<models::TorquePendulum>{}, {0.4, 1.3});
    compare(R"json({"angles": ["t", "u"], "coordinates": ["x"], "parameters": {"a": 1, "b": 1, "phase": 0},
                "potential": "a*cos(2*t - 3*u + phase) + sqrt(b)*sin(u - 0.3)^2*x + exp(a)*x^3/(1 + b*b) - sin(-t)*x*x + cos(phase - u)"})json",
            AtRunTime<models::Everything>{}, {0.4, 1.2, 0.7});

    // all-to-all coupled angles with loads, written out
    std::string angles, parameters, equations;
    const auto name = [](const char* of, int i, int j) { return of + std::to_string(i) + std::to_string(j); };
    for (int i = 0; i < 3; ++i) {
        angles += (i > 0 ? ", \"t" : "\"t") + std::to_string(i) + '"';
        for (int j = 0; j < 3; ++j) parameters += '"' + name("k", i, j) + "\": 1, ";
        const std::string ti = "t" + std::to_string(i);
        equations +=
            (i > 0 ? ", \"" : "\"") + name("l", i, 0) + "*cos(" + ti + ") + " + name("l", i, 1) + "*sin(" + ti + ")";
        for (int j = 0; j < 3; ++j)
            if (j != i) equations += " + " + name("k", i, j) + "*sin(" + ti + " - t" + std::to_string(j) + ")";
        equations += '"';
    }
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 2; ++k) parameters += '"' + name("l", i, k) + (i == 2 && k == 1 ? "\": 1" : "\": 1, ");
    RuntimeArray<double> p(15);
    Generator random(5);
    for (double& value : p) value = uniform(random, 0.3, 1.7);
    compare("{\"angles\": [" + angles + "], \"parameters\": {" + parameters + "}, \"equations\": [" + equations + "]}",
            AtRunTime<models::CoupledAngles<3>>{}, p);
}

TEST_CASE("a model from a file: names, values, and everything that is done with it") {
    const tests::ScratchFile file("rotating_double_pendulum.json");
    std::ofstream(file.name()) << R"json({"name": "rotating double pendulum", "angles": ["t1", "t2"],
        "parameters": {"alpha": 0.33, "ratio": 1.5, "omega": 2},
        "potential":
        "-0.5*omega^2*((1 - alpha)*sin(t1)^2 + alpha*(sin(t1) + ratio*sin(t2))^2) - cos(t1) - alpha*ratio*cos(t2)"})json";
    const FormulaModel model = read_model(file.name());
    CHECK(model.name == "rotating double pendulum");
    CHECK(model.angles == std::vector<std::string>{"t1", "t2"});
    CHECK(model.parameters == std::vector<std::string>{"alpha", "ratio", "omega"});
    CHECK(model.values[1] == 1.5);
    const auto set = enumerate(model, model.values);
    CHECK(set.distinct() == 16);
    CHECK(set.real() == 12);
    const auto proof = prove(model, set);
    CHECK(proof.complete);
    CHECK(proof.index == 12);
    for (const auto& e : set.equilibria) {
        for (const double f : equations_of(model, e.q, model.values)) CHECK(std::abs(f) < 1e-14);
        CHECK(potential_of(model, e.q, model.values) == Approx(e.energy));
        const auto j = jacobian_of(model, e.q, model.values);
        CHECK(j[0][1] == Approx(j[1][0]).margin(1e-14));
    }
    using Chain = mechanisms::TwoLinkChain;
    const auto events = find_events(model, model.values, 2, {0, 5});
    const auto typed = find_events<Chain, Chain::omega>({0.33, 1.5, 2}, {0, 5});
    CHECK(events.complete());
    REQUIRE(events.events.size() == typed.events.size());
    for (std::size_t k = 0; k < typed.events.size(); ++k)
        CHECK(events.events[k].value == Approx(typed.events[k].value).epsilon(1e-12));
    const auto diagram = trace_diagram(model, model.values, 2, {0, 3});
    CHECK(diagram.failed_paths == 0);
    CHECK(diagram.events.size() == events.events.size());
    for (const auto& piece : diagram.pieces)
        for (std::size_t k = 1; k + 1 < piece.points.size(); ++k) {  // the first and the last one are on chords
            RuntimeArray<double> p = model.values;
            p[2] = piece.points[k].parameter;
            double largest = 0;
            for (const double f : equations_of(model, piece.points[k].q, p)) largest = std::max(largest, std::abs(f));
            CHECK(largest < 1e-10);
        }
    const auto locus = trace_locus(model, model.values, {0, 2}, {{0, 1}, {0, 5}}, {}, {.lines = 4});
    CHECK(locus.evidence.complete());
    CHECK(locus.of(SingularityKind::cusp).size() == 2);
    CHECK(locus.regions.size() == 7);
    CHECK(polynomials_of(model, model.values).equations.size() == 4);
}

TEST_CASE("how formulas are read") {
    const auto value = [](const std::string& formula) {
        return potential_of(parse_model(with_potential(formula)), {0.3, 0.5, 0.7}, {1.1, 1.3});
    };
    const double t = 0.3, x = 0.7, a = 1.1, b = 1.3;
    CHECK(value("-x^2") == Approx(-x * x));
    CHECK(value("(-x)^2") == Approx(x * x));
    CHECK(value("2^3^2*x") == Approx(512 * x));
    CHECK(value("2**-1*x") == Approx(0.5 * x));
    CHECK(value("a - b - x") == Approx(a - b - x));
    CHECK(value("x/a/b") == Approx(x / a / b));
    CHECK(value("x/(a/b)") == Approx(x / (a / b)));
    CHECK(value("- - +x") == Approx(x));
    CHECK(value("1.5e-1*x + .5 + 2.") == Approx(0.15 * x + 2.5));
    CHECK(value("a^b*x") == Approx(std::pow(a, b) * x));
    CHECK(value("sin ( t + pi/2 )") == Approx(std::cos(t)));
    CHECK(value("cos(-(t - u)*2 - a)") == Approx(std::cos(-2 * (t - 0.5) - a)));
    CHECK(value("tan(a)*x + log(b)*x") == Approx((std::tan(a) + std::log(b)) * x));
}

TEST_CASE("models that are refused, with line and column") {
    const auto formula = [](const std::string& text) { return refusal(with_potential(text)); };
    CHECK(formula("cos(t)").empty());
    CHECK_THAT(formula("cos(t) + c"),
               Catch::StartsWith("potential, line 4, column 25 = c: no name c: must be one of t, u, x, a, b"));
    CHECK_THAT(formula("cos(t) + 0.5*t"),
               Catch::Contains("line 4, column 28") && Catch::Contains("an angle may enter"));
    CHECK_THAT(formula("cos(t)/x"), Catch::Contains("division by an expression of unknowns"));
    CHECK_THAT(formula("1/t"), Catch::Contains("division by an angle"));
    CHECK_THAT(formula("sinh(x)"), Catch::Contains("is no function, must be sin, cos, tan, sqrt, exp or log"));
    CHECK_THAT(formula("2 x"), Catch::Contains("an operator or the end must stand here"));
    CHECK_THAT(formula("x +"), Catch::Contains("a number, a name, a function or ( must stand here"));
    CHECK_THAT(formula("(x"), Catch::Contains("an operator or ) must stand here"));
    CHECK_THAT(formula(""), Catch::Contains("a number, a name, a function or ( must stand here"));
    CHECK_THAT(formula("x^0.5"), Catch::Contains("must be an integer from 0 to 1000"));
    CHECK_THAT(formula("x*1e999"), Catch::Contains("must be a number that a double can hold"));
    CHECK_THAT(formula("x/0"), Catch::Contains("divisor = 0"));
    CHECK_THAT(formula("t"), Catch::Contains("a whole formula that is an angle"));
    CHECK_THAT(formula(std::string(200, '(') + "x" + std::string(200, ')')), Catch::Contains("nested deeper"));
    CHECK_THAT(formula(R"json(\u0063os(t) + c)json"), Catch::Contains("line 4, column 30"));

    CHECK_THAT(formula(R"json(x + \u0000)json"),
               Catch::Contains("line 4, column 20 = ?: ") && Catch::Contains("must stand here"));

    const std::string two_lines = with_potential(R"json(cos(t) +\n  c)json");
    CHECK_THAT(refusal(two_lines), Catch::Contains("line 4, column 28 = c"));
    CHECK_THROWS_WITH(equilibria::parse_model(two_lines, 1000, equilibria::FormulaPlaces::in_formula),
                      Catch::StartsWith("potential, line 2, column 3 = c: no name c"));

    CHECK_THAT(refusal("{"), Catch::Contains("must be JSON"));
    CHECK_THAT(refusal(R"json({"angles": ["t"]})json"), Catch::Contains(R"(either "potential" or "equations")"));
    CHECK_THAT(refusal(R"json({"angles": ["t"], "potential": "cos(t)", "equations": ["t"]})json"),
               Catch::Contains("either"));
    CHECK_THAT(refusal(R"json({"angel": ["t"], "potential": "cos(t)"})json"), Catch::Contains("is no key of a model"));
    CHECK_THAT(refusal(R"json({"angles": ["t", "t"], "potential": "cos(t)"})json"), Catch::Contains("used already"));
    CHECK_THAT(refusal(R"json({"angles": ["t"], "parameters": {"a": "1"}, "potential": "cos(t)"})json"),
               Catch::Contains("parameters.a = \"1\": must be a number"));
    CHECK_THAT(refusal(R"json({"angles": ["t", "u"], "equations": ["sin(t)"]})json"),
               Catch::Contains("must be one for each unknown: 2"));
    CHECK_THAT(refusal(R"json({"potential": "1"})json"), Catch::Contains("at least one unknown"));
    CHECK_THAT(refusal(R"json({"angles": ["t"], "definitions": {"s": "sin(v)"}, "potential": "s"})json"),
               Catch::StartsWith("definitions.s, line 1, column 45 = v)"));
    CHECK_THAT(refusal(R"json({"angles": ["t"], "definitions": {"cos": "1"}, "potential": "cos(t)"})json"),
               Catch::Contains("nor that of a function"));
    CHECK_THROWS_WITH(read_model("no such file.json"), Catch::Contains("must be a file that can be read"));
}

#endif
