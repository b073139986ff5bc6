// The motion of the holonomic mechanism in three formulations, with its energy balance: section 1 of
// Vesovic and Radulovic, "Modelling and stability analysis of the nonlinear system" (2022).
//
//   mechanism_motion --formulation lagrange2 --t-end 10 --csv motion.csv
//   mechanism_motion --formulation lagrange1 --every 1
#include <cmath>
#include <cstdio>
#include <equilibria/dynamics/hamilton.hpp>
#include <equilibria/dynamics/lagrange_first_kind.hpp>
#include <equilibria/dynamics/lagrange_second_kind.hpp>
#include <equilibria/dynamics/motion.hpp>
#include <exception>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "support/command_line.hpp"
#include "support/mechanism_options.hpp"
#include "support/output_file.hpp"

namespace {

using M = equilibria::mechanisms::HolonomicMechanism;
using Points = equilibria::mechanisms::HolonomicMechanismPoints;
using equilibria::MotionState;

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

std::string csv(const Result& result, bool multipliers) {
    std::ostringstream out;
    out.precision(17);
    out << "t,q1,q2,q1_rate,q2_rate,p1,p2,x1,y1,x2,y2,x3,y3,kinetic,potential,work,dissipated,balance";
    if (multipliers) out << ",lambda1,lambda2,lambda3,lambda4,drift";
    out << '\n';
    for (const auto& s : result.samples) {
        out << s.time;
        for (const auto* pair : {&s.angles.q, &s.angles.velocity, &s.momentum})
            for (const double value : *pair) out << ',' << value;
        for (const double x : s.points.q) out << ',' << x;
        for (const double value : {s.kinetic, s.potential, s.work, s.dissipated, s.balance}) out << ',' << value;
        if (multipliers) {
            for (const double value : s.multipliers) out << ',' << value;
            out << ',' << s.drift;
        }
        out << '\n';
    }
    return out.str();
}

/// Two numbers with a comma between.
equilibria::Unknowns<M> pair(const char* option, const std::string& text) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto any = [](double) { return true; };
    const auto first = support::parsed_number(text.substr(0, comma), any),
               second = support::parsed_number(comma < text.size() ? text.substr(comma + 1) : "", any);
    if (!first || !second)
        support::fail(option, support::shown(text), "must be two finite numbers with a comma between");
    return {*first, *second};
}

}  // namespace

int main(int argc, char** argv) {
    std::string name = "lagrange2", form = "covariant", end_text = "10", every_text = "1", start_text,
                velocity_text = "0,0", tolerance_text = "1e-12", csv_name;
    CLI::App app{
        "The motion of the holonomic mechanism under a force F exp(-alpha t), by Lagrange's equations of the second or "
        "the "
        "first kind or by Hamilton's equations, with its energy balance."};
    const support::MechanismOptions mechanism(app, "100", true);
    app.add_option("--formulation", name,
                   "lagrange2 (default), lagrange1 (multipliers, Cartesian coordinates) or hamilton");
    app.add_option("--form", form, "of lagrange2: covariant (default) or contravariant");
    app.add_option("--t-end", end_text, "s (default 10)");
    app.add_option("--every", every_text, "interval of the output, s (default 1)");
    app.add_option("--start", start_text, "q1,q2 at t = 0, radians (default 4 pi/13, pi/7)");
    app.add_option("--velocity", velocity_text, "their rates at t = 0, radians a second (default 0,0)");
    app.add_option("--tolerance", tolerance_text, "of a step, relative and absolute (default 1e-12)");
    app.add_option("--csv", csv_name, "write CSV to this file, or to stdout for -, instead of a table");
    support::parse(app, "mechanism_motion", argc, argv);
    try {
        const auto p = mechanism.parameters();
        if (name != "lagrange2" && name != "lagrange1" && name != "hamilton")
            support::fail("--formulation", support::shown(name), "must be lagrange2, lagrange1 or hamilton");
        if (form != "covariant" && form != "contravariant")
            support::fail("--form", support::shown(form), "must be covariant or contravariant");
        const auto positive = [](double x) { return x > 0; };
        const double end = support::number("--t-end", end_text, "must be a positive number", positive),
                     every = support::number("--every", every_text, "must be a positive number", positive),
                     tolerance =
                         support::number("--tolerance", tolerance_text, "must be a number from 1e-15 to 1, 1 excluded",
                                         [](double x) { return x >= 1e-15 && x < 1; });
        if (end / every > 1e7) support::fail("--every", every_text, "must leave 10000000 lines or fewer");
        const MotionState<M> start{app.count("--start") > 0
                                       ? pair("--start", start_text)
                                       : equilibria::Unknowns<M>{4 * std::numbers::pi / 13, std::numbers::pi / 7},
                                   pair("--velocity", velocity_text)};
        std::optional<support::OutputFile> file;
        if (app.count("--csv") > 0) file.emplace("--csv", csv_name);

        std::vector<double> times;
        for (int k = 0; k * every < end * (1 - 1e-12); ++k) times.push_back(k * every);
        times.push_back(end);
        const equilibria::MotionOptions options{tolerance, tolerance, 0, 100'000'000};
        const auto chosen =
            form == "contravariant" ? equilibria::LagrangeForm::contravariant : equilibria::LagrangeForm::covariant;
        const Result result =
            name == "lagrange2"  ? integrate(equilibria::LagrangeSecondKind<M>(p, chosen), start, times, options, p)
            : name == "hamilton" ? integrate(equilibria::HamiltonEquations<M>(p), start, times, options, p)
                                 : integrate(equilibria::LagrangeFirstKind<Points>(p),
                                             equilibria::mechanisms::points_of(start, p), times, options, p);
        if (file) file->write(csv(result, name == "lagrange1"));
        if (!file || !file->to_stdout()) {
            std::printf(
                "       t               q1 [rad]               q2 [rad]        x3 [m]    energy [J]  balance [J]\n");
            for (const auto& s : result.samples)
                std::printf("%8.4g %22.15f %22.15f %13.9f %13.6f %12.1e\n", s.time, s.angles.q[0], s.angles.q[1],
                            s.points.q[4], s.kinetic + s.potential, s.balance);
            std::printf("%s, %s: %s at t = %g; %llu steps, %llu evaluations; energy balance %.1e of the energy\n",
                        name.c_str(),
                        name == "lagrange2"   ? form.c_str()
                        : name == "lagrange1" ? "with multipliers"
                                              : "in q and p",
                        to_string(result.status), result.time, static_cast<unsigned long long>(result.steps),
                        static_cast<unsigned long long>(result.evaluations), result.largest_balance);
            if (name == "lagrange1")
                std::printf(
                    "drift of the constraints %.1e m^2, of their rates %.1e m^2/s in a step, before it is put right\n",
                    result.largest_drift, result.largest_velocity_drift);
        }
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
