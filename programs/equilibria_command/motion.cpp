// equilibria motion
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <equilibria/io/results/motion_output.hpp>
#include <equilibria/studies/formula_model/formula_motion.hpp>

#include "command.hpp"
#include "plots/model_motion.hpp"
#include "support/axis_name.hpp"
#include "support/interrupt.hpp"
#include "support/pictures.hpp"

namespace commands {

namespace {

using Motion = equilibria::Motion<equilibria::RuntimeUnknowns>;

/// NAME=VALUE, commas between: a number for each name, 0 where none is given.
RuntimeArray<double> values_of(const std::string& option, const std::string& text,
                               const std::vector<std::string>& names) {
    RuntimeArray<double> y(static_cast<int>(names.size()));
    std::vector<bool> given(names.size(), false);
    for (const std::string& part : split(text, ',')) {
        const std::size_t equal = part.find('=');
        const auto value = equal == part.npos ? std::nullopt : support::parsed(part.substr(equal + 1));
        if (!value || !std::isfinite(*value))
            support::fail(option, support::shown(part), "must be NAME=VALUE, commas between, finite");
        const int k = number_of(names, option, part.substr(0, equal));
        if (given[static_cast<std::size_t>(k)]) support::fail(option, part.substr(0, equal), "must be named once");
        given[static_cast<std::size_t>(k)] = true;
        y[k] = *value;
    }
    return y;
}

equilibria::GnuplotData plotted(const Input& input, const Motion& motion, double until) {
    equilibria::GnuplotData data;
    std::vector<std::string> labels;
    for (const std::string& name : unknowns(input.model)) labels.push_back(support::axis_name(name));
    data.string("heading", input.model.name.empty() ? "Motion" : "Motion: " + input.model.name);
    const std::string& time = input.model.kinetics->time;
    data.string("time_label", time.empty() ? "time" : support::axis_name(time)).value("until", until);
    data.integer("unknowns", static_cast<long long>(labels.size())).strings("labels", labels);
    std::ostringstream rows;
    rows.precision(10);
    for (const auto& x : motion.points) {
        rows << x.time;
        for (const double q : x.q) rows << ' ' << q;
        rows << ' ' << x.kinetic << ' ' << x.potential << ' ' << x.kinetic + x.potential << '\n';
    }
    return data.block("motion", rows.str(), static_cast<int>(labels.size()) + 4);
}

void print(const Input& input, const Motion& motion, const std::string& formulation) {
    std::printf("%s\n\n%10s", in_words(input).c_str(), "time");
    print_names(input.model);
    for (const std::string& name : input.model.kinetics->rates) std::printf("%13s", name.c_str());
    std::printf("      kinetic    potential    balance\n");
    const std::size_t all = motion.points.size(), step = std::max<std::size_t>(1, (all - 1 + 19) / 20);
    for (std::size_t k = 0; k < all; k += step) {
        const auto& x = motion.points[k];
        std::printf("%10.6g", x.time);
        print_unknowns(input.model, x.q);
        print_unknowns(input.model, x.velocity);
        std::printf("%13.6g%13.6g  %9.1e\n", x.kinetic, x.potential, x.balance);
    }
    if (step > 1) std::printf("every %zuth of %zu points; --csv has all\n", step, all);
    std::printf("\n%s: %s at t = %g; %llu steps, %llu evaluations; energy balance %.1e of the energy\n",
                formulation.c_str(), to_string(motion.status), motion.time,
                static_cast<unsigned long long>(motion.steps), static_cast<unsigned long long>(motion.evaluations),
                motion.largest_balance);
}

}  // namespace

int motion(int argc, char** argv) {
    Command c;
    std::string start, rates, formulation = "lagrange2";
    double until = 10, tolerance = 1e-12;
    int points = 201;
    std::optional<support::OutputFile> csv;
    support::Pictures pictures;
    support::CommandLine app{
        "The motion of a model that has a kinetic energy, by Lagrange's equations of the second kind or by Hamilton's, "
        "with its energy balance."};
    c.add_model_to(app);
    app.add_option("--start", start, "NAME=VALUE, commas between: unknowns at the time 0, angles in radians; others 0");
    app.add_option("--rates", rates, "NAME=VALUE, commas between: their rates at the time 0, by names; others 0");
    app.add_option("--until", until, "the last time (default 10)").transform(support::positive());
    app.add_option("--points", points, "at even times from 0 to the last one, 2 to 1e6 (default 201)")
        .transform(support::integer(2, 1000000));
    app.add_option("--formulation", formulation, "lagrange2 (default) or hamilton")
        .transform(support::one_of({"lagrange2", "hamilton"}, "must be lagrange2 or hamilton"));
    app.add_option("--tolerance", tolerance, "of a step, relative and absolute (default 1e-12)")
        .transform(support::number("must be a number from 1e-15 to 1, 1 excluded",
                                   [](double x) { return x >= 1e-15 && x < 1; }));
    app.add_limit(c.limit, "seconds after which the run is stopped, with status 124 (default: none)");
    c.add_json_to(app);
    support::add_output(app, "--csv", csv, "write a line for each time to this file, or to stdout for -");
    pictures.add_to(app, "unknowns and energies over time");
    app.parse("equilibria motion", argc, argv);
    const Input input = read(c);
    if (!input.model.kinetics)
        support::fail(c.file, "", "must have \"kinetic_energy\" and \"rates\": the model does not move");
    const MotionRequest asked{
        {values_of("--start", start, unknowns(input.model)), values_of("--rates", rates, input.model.kinetics->rates)},
        until,
        tolerance,
        points,
        formulation == "hamilton"};

    const support::TimeLimit limit(c.limit);
    equilibria::RunOptions run;
    run.cancel = &support::cancelled_by_signal();
    const Motion found = moved(input, asked, run);
    if (found.status == equilibria::MotionStatus::cancelled) {
        char at[64];
        std::snprintf(at, sizeof at, "at t = %g, nothing was written", found.time);
        return support::say_stopped("equilibria motion", at);
    }
    if (pictures.asked()) {
        const int panels = input.model.unknowns() + 1, across = std::min(3, panels),
                  down = (panels + across - 1) / across;
        pictures.draw({120 + 430 * across, 130 + 300 * down}, plotted(input, found, until), plots::model_motion);
    }
    if (csv) csv->write(equilibria::motion_csv(found, input.model.unknowns()).text());
    if (c.json) c.json->write(document(input, asked, found));
    if (!to_stdout(c.json) && !to_stdout(csv)) print(input, found, formulation);
    return found.status == equilibria::MotionStatus::finished ? 0 : 1;
}

}  // namespace commands
