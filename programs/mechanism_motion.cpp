// The motion of the holonomic mechanism in three formulations, with its energy balance (docs/mechanism.md).
//
//   mechanism_motion --formulation lagrange2 --t-end 10 --csv motion.csv
//   mechanism_motion --formulation lagrange1 --every 1
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <equilibria/dynamics/hamilton.hpp>
#include <equilibria/dynamics/lagrange_first_kind.hpp>
#include <equilibria/dynamics/lagrange_second_kind.hpp>
#include <equilibria/dynamics/motion.hpp>
#include <equilibria/io/results/motion_output.hpp>
#include <exception>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "support/mechanism_options.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"

namespace {

using M = equilibria::mechanisms::HolonomicMechanism;
using Points = equilibria::mechanisms::HolonomicMechanismPoints;
using equilibria::MotionState;

/// What the command line says.
struct Command {
    equilibria::Parameters<M> parameters;
    std::string formulation = "lagrange2", form = "covariant";
    double end = 10, every = 1, tolerance = 1e-12;
    support::List start{{4 * std::numbers::pi / 13, std::numbers::pi / 7}}, velocity{{0, 0}};
    std::optional<support::OutputFile> csv;

    MotionState<M> state() const {
        return {{start.values[0], start.values[1]}, {velocity.values[0], velocity.values[1]}};
    }
    std::vector<double> times() const {
        std::vector<double> y;
        for (int k = 0; k * every < end * (1 - 1e-12); ++k) y.push_back(k * every);
        y.push_back(end);
        return y;
    }
};

Command read(int argc, char** argv) {
    Command c;
    const auto pair = [] { return support::list("must be two finite numbers with a comma between", 2); };
    const auto few = [&c](double every) { return c.end / every <= 1e7; };
    const char* const too_many = "must leave 10000000 lines or fewer";
    support::CommandLine app{
        "The motion of the holonomic mechanism under a force F exp(-alpha t), by Lagrange's equations of the second or "
        "the "
        "first kind or by Hamilton's equations, with its energy balance."};
    const support::MechanismOptions mechanism(app, 100, true);
    app.add_option("--formulation", c.formulation,
                   "lagrange2 (default), lagrange1 (multipliers, Cartesian coordinates) or hamilton")
        .transform(support::one_of({"lagrange2", "lagrange1", "hamilton"}, "must be lagrange2, lagrange1 or hamilton"));
    app.add_option("--form", c.form, "of lagrange2: covariant (default) or contravariant")
        .transform(support::one_of({"covariant", "contravariant"}, "must be covariant or contravariant"));
    app.add_option("--t-end", c.end, "s (default 10)").transform(support::positive());
    app.add_option("--every", c.every, "interval of the output, s (default 1)")
        .transform(support::both(support::positive(), support::number(too_many, few)));
    app.add_option("--start", c.start, "q1,q2 at t = 0, radians (default 4 pi/13, pi/7)").transform(pair());
    app.add_option("--velocity", c.velocity, "their rates at t = 0, radians a second (default 0,0)").transform(pair());
    app.add_option("--tolerance", c.tolerance, "of a step, relative and absolute (default 1e-12)")
        .transform(support::number("must be a number from 1e-15 to 1, 1 excluded",
                                   [](double x) { return x >= 1e-15 && x < 1; }));
    support::add_output(app, "--csv", c.csv, "write CSV to this file, or to stdout for -, instead of a table");
    app.parse("mechanism_motion", argc, argv);
    if (!few(c.every)) support::fail("--every", equilibria::to_text(c.every), too_many);
    c.parameters = mechanism.parameters();
    return c;
}

/// A motion in any formulation, in angles and in points.
struct Sample {
    double time;
    MotionState<M> angles;
    equilibria::Unknowns<M> momentum;
    MotionState<Points> points;
    equilibria::ConstraintValues<Points> multipliers;  ///< of the first kind alone
    double kinetic, potential, work, dissipated, balance, drift;
};
struct Result {
    std::vector<Sample> samples;
    equilibria::MotionStatus status;
    double time, largest_balance, largest_drift, largest_velocity_drift;
    std::uint64_t steps, evaluations;
};

Sample sample(const equilibria::MotionPoint<M>& x, const equilibria::Parameters<M>& p) {
    const MotionState<M> angles{x.q, x.velocity};
    return {x.time,
            angles,
            x.momentum,
            equilibria::mechanisms::points_of(angles, p),
            {},
            x.kinetic,
            x.potential,
            x.work,
            x.dissipated,
            x.balance,
            0};
}
Sample sample(const equilibria::MotionPoint<Points>& x, const equilibria::Parameters<M>& p) {
    const MotionState<Points> points{x.q, x.velocity};
    const auto angles = equilibria::mechanisms::angles_of(points);
    return {x.time,      angles,        equilibria::momenta<M>(angles.q, angles.velocity, p),
            points,      x.multipliers, x.kinetic,
            x.potential, x.work,        x.dissipated,
            x.balance,   x.drift};
}

template <class F>
Result integrate(const F& formulation, const MotionState<typename F::Model>& start, const std::vector<double>& times,
                 const equilibria::MotionOptions& options, const equilibria::Parameters<M>& p) {
    const auto motion = equilibria::integrate_motion(formulation, start, times, options);
    Result y{{},
             motion.status,
             motion.time,
             motion.largest_balance,
             motion.largest_drift,
             motion.largest_velocity_drift,
             motion.steps,
             motion.evaluations};
    for (const auto& point : motion.points) y.samples.push_back(sample(point, p));
    return y;
}

Result integrate(const Command& c) {
    const auto& p = c.parameters;
    const equilibria::MotionOptions options{c.tolerance, c.tolerance, 0, 100'000'000};
    if (c.formulation == "lagrange1")
        return integrate(equilibria::LagrangeFirstKind<Points>(p), equilibria::mechanisms::points_of(c.state(), p),
                         c.times(), options, p);
    if (c.formulation == "hamilton")
        return integrate(equilibria::HamiltonEquations<M>(p), c.state(), c.times(), options, p);
    const auto form =
        c.form == "contravariant" ? equilibria::LagrangeForm::contravariant : equilibria::LagrangeForm::covariant;
    return integrate(equilibria::LagrangeSecondKind<M>(p, form), c.state(), c.times(), options, p);
}

std::string csv(const Result& result, bool multipliers) {
    equilibria::CsvTable table(
        equilibria::motion_columns(2, multipliers ? 4 : 0, {"x1", "y1", "x2", "y2", "x3", "y3"}));
    for (const auto& s : result.samples) {
        equilibria::CsvRow row;
        row.add(s.time).add_all(s.angles.q).add_all(s.angles.velocity).add_all(s.momentum).add_all(s.points.q);
        row.add(s.kinetic).add(s.potential).add(s.work).add(s.dissipated).add(s.balance);
        if (multipliers) row.add_all(s.multipliers).add(s.drift);
        table.add(row);
    }
    return table.text();
}

void print(const Command& c, const Result& result) {
    std::printf("       t               q1 [rad]               q2 [rad]        x3 [m]    energy [J]  balance [J]\n");
    for (const auto& s : result.samples)
        std::printf("%8.4g %22.15f %22.15f %13.9f %13.6f %12.1e\n", s.time, s.angles.q[0], s.angles.q[1], s.points.q[4],
                    s.kinetic + s.potential, s.balance);
    std::printf("%s, %s: %s at t = %g; %llu steps, %llu evaluations; energy balance %.1e of the energy\n",
                c.formulation.c_str(),
                c.formulation == "lagrange2"   ? c.form.c_str()
                : c.formulation == "lagrange1" ? "with multipliers"
                                               : "in q and p",
                to_string(result.status), result.time, static_cast<unsigned long long>(result.steps),
                static_cast<unsigned long long>(result.evaluations), result.largest_balance);
    if (c.formulation == "lagrange1")
        std::printf("drift of the constraints %.1e m^2, of their rates %.1e m^2/s in a step, before it is put right\n",
                    result.largest_drift, result.largest_velocity_drift);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const Command c = read(argc, argv);
        const Result result = integrate(c);
        if (c.csv) c.csv->write(csv(result, c.formulation == "lagrange1"));
        if (!to_stdout(c.csv)) print(c, result);
        return result.status == equilibria::MotionStatus::finished ? 0 : 1;
    } catch (const std::exception& error) {
        support::fail("command line", "", error.what());
    }
}

// clang-format off
/* Refused:
--formulation newton
    mechanism_motion: --formulation newton: must be lagrange2, lagrange1 or hamilton
--form mixed
    mechanism_motion: --form mixed: must be covariant or contravariant
--t-end 0
    mechanism_motion: --t-end 0: must be a positive number
--every -1
    mechanism_motion: --every -1: must be a positive number
--every 1e-9
    mechanism_motion: --every 1e-9: must leave 10000000 lines or fewer
--start 1
    mechanism_motion: --start 1: must be two finite numbers with a comma between
--velocity 1,nan
    mechanism_motion: --velocity 1,nan: must be two finite numbers with a comma between
--tolerance 0
    mechanism_motion: --tolerance 0: must be a number from 1e-15 to 1, 1 excluded
--masses 10,-1,10
    mechanism_motion: --masses 10,-1,10: must be 3 positive numbers, with commas between
--data book
    mechanism_motion: --data book: must be paper or appendix
--decay -0.7
    mechanism_motion: --decay -0.7: must be a number, 0 or more
--csv .
    mechanism_motion: --csv .: is a folder; must be a file that can be written
*/
