// Every number that Tables 1 to 5 of Vesovic and Radulovic, "Modelling and stability analysis of the nonlinear system"
// (2022), print, against the enumeration's equilibria: those that are right to their last printed digit, those that are
// wrong by name.
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/dynamics/hamilton.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/stability/lagrange_dirichlet.hpp>
#include <equilibria/stability/linearise.hpp>
#include <equilibria/stability/pole_count.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using M = mechanisms::HolonomicMechanism;

namespace {

/// Whether a printed decimal is the value, rounded to the digits that it has.
bool agrees(const std::string& printed, double value) {
    const auto point = printed.find('.');
    const auto decimals = point == printed.npos ? 0 : static_cast<int>(printed.size() - point - 1);
    // the value's own error is far below, but a five behind the last digit may go either way
    return std::abs(std::atof(printed.c_str()) - value) <= 0.5000001 * std::pow(10.0, -decimals);
}

struct Printed {
    std::string q1, q2;
    std::array<std::string, 3> hessian;  // C11, C12, C22
    std::array<std::string, 2> minors;
    std::array<std::string, 4> polynomial;  // from s^3 on
    std::array<std::string, 4> routh;       // the first column from its second entry on
    std::vector<std::array<std::string, 2>> poles;
    int right_half_plane;
};
const Printed copied{"",
                     "",
                     {},
                     {},
                     {"1.5464", "-65.7945", "-30.6665", "325.543"},
                     {"1.5464", "-45.9636", "-19.7139", "325.543"},
                     {{"-8.3971", "0"}, {"-2.5222", "0"}, {"2.1190", "0"}, {"7.2538", "0"}},
                     2};
const std::vector<Printed> tables{
    {"0.779777",
     "-2.95918",
     {"111.015", "-208.317", "-306.19"},
     {"111.015", "-77387.7"},
     copied.polynomial,
     copied.routh,
     copied.poles,
     copied.right_half_plane},
    {"1.46544",
     "-0.256309",
     {"576.559", "237.481", "387.748"},
     {"576.559", "167163"},
     {"6.01551", "38.3023", "149.28", "305.992"},
     {"6.0155", "13.4864", "12.7950", "305.992"},
     {{"-2.92464", "-1.89756"}, {"-2.92464", "1.89756"}, {"-0.0831", "-5.0169"}, {"-0.0831", "5.0169"}},
     0},
    {"-1.42176",
     "-2.54488",
     {"-119.042", "186.514", "155.356"},
     {"-119.042", "-53281.4"},
     {"5.33619", "2.36749", "53.0565", "-83.5357"},
     {"5.3362", "-7.5753", "-5.7879", "-83.5357"},
     {{"-6.5217", "0"}, {"-0.035769", "-3.19186"}, {"-0.035769", "3.19186"}, {"1.25709", "0"}},
     1},
    {"-2.35647",
     "1.3861",
     {"-529.601", "-209.497", "-309.859"},
     {"-529.601", "120212"},
     copied.polynomial,
     copied.routh,
     copied.poles,
     copied.right_half_plane},
};

}  // namespace

TEST_CASE("Each number of Tables 1 to 5 is right to its last digit, or one of those known to be wrong") {
    const auto p = M::paper_parameters(100);
    const auto r = enumerate<M>(p);
    REQUIRE(r.real() == 4);
    int right = 0;
    std::vector<std::string> wrong;
    for (std::size_t k = 0; k < tables.size(); ++k) {
        const auto& row = tables[k];
        const Equilibrium<M>* found = nullptr;
        for (const auto& e : r.equilibria)
            if (agrees(row.q1, e.q[0]) && agrees(row.q2, e.q[1])) found = &e;
        REQUIRE(found);
        const auto note = [&](const std::string& name, const std::string& printed, double value) {
            if (agrees(printed, value))
                ++right;
            else
                wrong.push_back("eq" + std::to_string(k + 1) + " " + name + " " + printed);
        };
        note("q1", row.q1, found->q[0]);
        note("q2", row.q2, found->q[1]);
        const auto system = linearise<M>(found->q, p);
        const auto energy = lagrange_dirichlet(system.stiffness);
        note("C11", row.hessian[0], system.stiffness(0, 0));
        note("C12", row.hessian[1], system.stiffness(0, 1));
        note("C22", row.hessian[2], system.stiffness(1, 1));
        note("Delta1", row.minors[0], energy.minors[0]);
        note("Delta2", row.minors[1], energy.minors[1]);
        const auto poles = count_poles(system);
        for (int i = 0; i < 4; ++i) {
            const auto at = static_cast<std::size_t>(i);
            note("a" + std::to_string(i + 1), row.polynomial[at], poles.polynomial[i + 1]);
            note("Routh" + std::to_string(i + 1), row.routh[at], poles.routh.first_column()[i + 1]);
            note("Re" + std::to_string(i + 1), row.poles[at][0], poles.poles[i].real());
            note("Im" + std::to_string(i + 1), row.poles[at][1], poles.poles[i].imag());
        }
        note("right", std::to_string(row.right_half_plane), poles.right_half_plane().value());
    }
    // of eq1 Tables 3 to 5 print eq4's numbers; two last digits are cut off instead of rounded
    CHECK(wrong == std::vector<std::string>{"eq1 a1 1.5464", "eq1 Routh1 1.5464", "eq1 Re1 -8.3971", "eq1 a2 -65.7945",
                                            "eq1 Routh2 -45.9636", "eq1 Re2 -2.5222", "eq1 Im2 0", "eq1 a3 -30.6665",
                                            "eq1 Routh3 -19.7139", "eq1 Re3 2.1190", "eq1 Im3 0", "eq1 a4 325.543",
                                            "eq1 Routh4 325.543", "eq1 Re4 7.2538", "eq1 right 2", "eq3 Routh3 -5.7879",
                                            "eq4 Routh3 -19.7139"});
    CHECK(right == 4 * 24 - 17);
}

TEST_CASE("The printed Hamiltonian is right with B / A for A / B") {
    Generator generator(1);
    const auto p = M::paper_parameters(0);
    const double m = p[M::mass_1], l = p[M::length];
    for (int k = 0; k < 20; ++k) {
        const Unknowns<M> q{uniform(generator, -3, 3), uniform(generator, -3, 3)};
        const Unknowns<M> v{uniform(generator, -3, 3), uniform(generator, -3, 3)};
        const auto momentum = momenta<M>(q, v, p);
        const double s = std::sin(q[0]), c = std::cos(q[0]), both = std::sin(q[0] + q[1]), root = std::sqrt(4 - s * s);
        const double a = l * l * m *
                         (-49 + std::cos(4 * q[0]) - 16 * std::cos(2 * (q[0] + q[1])) +
                          s * s * (-16 + 8 * s * s - 16 * c * root - 8 * both * both));
        const double b =
            momentum[0] * momentum[0] * (-16 + 4 * s * s) +
            momentum[1] * momentum[1] * (-35 + 2 * std::cos(2 * q[0]) + std::cos(4 * q[0]) - 8 * c * s * s * root) +
            momentum[1] * momentum[0] * (32 - 8 * s * s) * both;
        CAPTURE(a, b, kinetic_energy<M>(q, v, p));
        CHECK(b / a == Approx(kinetic_energy<M>(q, v, p)).epsilon(1e-10));
    }
}
