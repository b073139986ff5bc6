// The motion of a rotating body with a damped elastic beam, and the relative equilibria in which it ends
// (docs/body-beam.md).
//
//   body_beam_motion --momentum 10 --damping 0.3,0.3,0.3 --runs 200 --threads 0 --json runs.json
//   body_beam_motion --strain coupled --t-end 50 --samples 500 --csv motion.csv
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <equilibria/core/random.hpp>
#include <equilibria/io/results/csv.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/run/threads.hpp>
#include <equilibria/stability/inertia.hpp>
#include <equilibria/studies/rotating_body_beam/momentum_hessian.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_motion.hpp>
#include <exception>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/body_beam_options.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"

namespace {

using equilibria::Json;
using equilibria::mechanisms::BeamDamping, equilibria::mechanisms::BeamStrain, equilibria::mechanisms::BodyBeamEvidence,
    equilibria::mechanisms::BodyBeamStatus;

struct Options {
    support::BodyBeamOptions body;
    support::List damping_values{{0.3, 0.3, 0.3}};
    double momentum = 10, t_end = 0, tolerance = 1e-9, deflection = 0.1;
    int samples = 1000, runs = 200;
    std::uint64_t seed = 1;
    unsigned threads = 1;

    BeamDamping damping() const {
        return {damping_values.values[0], damping_values.values[1], damping_values.values[2]};
    }
};

/// A relative equilibrium in which motions ended.
struct Reached {
    int runs = 0;
    std::vector<double> axis, modes;  ///< n, u
    double speed = 0, moment = 0, energy = 0;
    equilibria::Inertia index;
    double residual = 0;  ///< of the model's equations, the largest over the runs
};

struct Run {
    BodyBeamStatus status;
    double time, misalignment, modal_velocity, deflection, velocity_change;
    BodyBeamEvidence evidence;
    int equilibrium = -1;  ///< where it ended; none where it did not settle
};

std::vector<std::string> columns(int modes) {
    std::vector<std::string> y{"t",   "q_w", "q_x", "q_y", "q_z",       "w_1",       "w_2",
                               "w_3", "a_1", "a_2", "a_3", "space_a_1", "space_a_2", "space_a_3"};
    for (const char* name : {"u", "v"})
        for (int d = 1; d <= 3; ++d) equilibria::add_columns(y, name + std::to_string(d) + "_", modes);
    y.insert(y.end(), {"energy", "dissipated", "wobble"});
    return y;
}

/// The motion of the first of the starts, and the ends of all.
struct Study {
    BodyBeamStatus status = BodyBeamStatus::finished;
    double time = 0;
    BodyBeamEvidence evidence;
    std::vector<std::vector<double>> rows;  ///< of the CSV: what `columns` names
    double first_wobble = 0, last_wobble = 0, first_energy = 0, last_energy = 0;
    std::vector<Run> runs;
    std::vector<Reached> reached;
};

template <int K, BeamStrain Strain>
struct Solver {
    using Motion = equilibria::mechanisms::RotatingBodyBeamMotion<K, Strain>;
    using M = typename Motion::Model;
    using Start = equilibria::mechanisms::BodyBeamState<K>;

    const Options& options;
    Motion motion{support::body_beam_parameters<M>(options.body, 0), options.damping()};

    /// All from one generator: what run k starts from does not depend on the threads.
    std::vector<Start> starts() const {
        equilibria::Generator generator(options.seed);
        std::vector<Start> y;
        for (int k = 0; k < options.runs; ++k)
            y.push_back(equilibria::mechanisms::random_body_beam_state<K>(generator, options.momentum,
                                                                          options.body.length, options.deflection));
        return y;
    }

    Study one() const {
        std::vector<double> times;
        for (int k = 0; k <= options.samples; ++k) times.push_back(options.t_end * k / options.samples);
        const auto found = motion.integrate(starts().front(), times, {1e-12, 1e-13, 1'000'000'000});
        Study y;
        y.status = found.status, y.time = found.time, y.evidence = found.evidence;
        for (const auto& x : found.samples) {
            const auto& q = x.state.orientation;
            std::vector<double> row{x.time, q.w(), q.x(), q.y(), q.z()};
            for (const auto* v : {&x.angular_velocity, &x.state.momentum, &x.space_momentum})
                row.insert(row.end(), v->begin(), v->end());
            for (const auto* v : {&x.state.modes, &x.state.velocity}) row.insert(row.end(), v->begin(), v->end());
            row.insert(row.end(), {x.energy, x.dissipated, x.wobble()});
            y.rows.push_back(std::move(row));
        }
        if (!found.samples.empty()) {
            y.first_wobble = found.samples.front().wobble(), y.last_wobble = found.samples.back().wobble();
            y.first_energy = found.samples.front().energy, y.last_energy = found.samples.back().energy;
        }
        return y;
    }

    Study many() const {
        const auto from = starts();
        std::vector<equilibria::mechanisms::BodyBeamSettling<K>> ends(from.size());
        equilibria::threads(options.threads).for_blocks(from.size(), 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k)
                ends[k] = motion.settle(from[k], options.t_end, options.tolerance, {1e-12, 1e-13, 1'000'000'000});
        });
        Study y;
        for (const auto& end : ends) {
            Run run{end.status,
                    end.last.time,
                    end.residual.misalignment,
                    end.residual.velocity,
                    end.residual.deflection,
                    end.velocity_change,
                    end.evidence};
            if (end.settled()) run.equilibrium = note(y.reached, end);
            y.runs.push_back(run);
        }
        return y;
    }

private:
    /// Which of the equilibria this is; n and -n are one.
    int note(std::vector<Reached>& reached, const equilibria::mechanisms::BodyBeamSettling<K>& end) const {
        auto q = motion.relative_equilibrium(end.last.state);
        const int largest = static_cast<int>(std::distance(
            q.begin(),
            std::max_element(q.begin(), q.begin() + 3, [](double a, double b) { return std::abs(a) < std::abs(b); })));
        const double sign = q[largest] < 0 ? -1 : 1;
        for (int i = 0; i < 3; ++i) q[i] *= sign;
        auto p = motion.parameters();
        p[M::speed] = end.last.angular_velocity.norm();
        double residual = 0;
        for (const double f : equilibria::equations<M>(q, p)) residual = std::max(residual, std::abs(f));
        const auto here = [&](const Reached& other) {
            double square = 0;
            for (std::size_t i = 0; i < 3; ++i) square += std::pow(other.axis[i] - q[i], 2);
            for (std::size_t i = 0; i < other.modes.size(); ++i)
                square += std::pow(other.modes[i] - q[M::first_mode + i], 2);
            return square < 1e-12;
        };
        auto at = std::find_if(reached.begin(), reached.end(), here);
        if (at == reached.end()) {
            Reached y;
            y.axis.assign(q.begin(), q.begin() + 3);
            y.modes.assign(q.begin() + M::first_mode, q.begin() + M::multiplier);
            y.speed = p[M::speed];
            y.moment = q[M::multiplier];
            y.energy = end.last.energy;
            y.index = equilibria::inertia(
                equilibria::mechanisms::momentum_hessian<K, Strain>(q, end.last.state.momentum.norm(), p));
            at = reached.insert(at, y);
        }
        ++at->runs;
        at->residual = std::max(at->residual, residual);
        return static_cast<int>(at - reached.begin());
    }
};

template <int K, BeamStrain Strain>
Study study(const Options& options, bool many) {
    const Solver<K, Strain> solver{options};
    return many ? solver.many() : solver.one();
}

template <BeamStrain Strain>
Study study(const Options& options, bool many) {
    switch (options.body.modes) {
        case 1: return study<1, Strain>(options, many);
        case 2: return study<2, Strain>(options, many);
        case 3: return study<3, Strain>(options, many);
        default: return study<4, Strain>(options, many);
    }
}

std::string csv(const Study& study, int modes) {
    equilibria::CsvTable table(columns(modes));
    for (const auto& row : study.rows) table.add(equilibria::CsvRow().add_all(row));
    return table.text();
}

/// The largest over runs or equilibria.
template <class Items, class Value>
double worst(const Items& items, const Value& value) {
    double y = 0;
    for (const auto& item : items) y = std::max(y, value(item));
    return y;
}

Json document(const BodyBeamEvidence& x) {
    return {{"steps", x.steps},
            {"evaluations", x.evaluations},
            {"momentum_drift", x.momentum_drift},
            {"energy_balance", x.energy_balance},
            {"energy_increase", x.energy_increase}};
}

Json document(const Options& o, const Study& study) {
    Json out{{"body",
              {{"mass", o.body.body_mass},
               {"inertia", o.body.inertia.values},
               {"centre", o.body.centre.values},
               {"length", o.body.length},
               {"mu", o.body.mu.values},
               {"modes", o.body.modes},
               {"strain", o.body.strain}}},
             {"damping", o.damping_values.values},
             {"momentum", o.momentum},
             {"deflection", o.deflection},
             {"seed", o.seed},
             {"longest_time", o.t_end},
             {"tolerance", o.tolerance},
             {"equilibria", Json::array()},
             {"runs", Json::array()}};
    for (const auto& x : study.reached)
        out["equilibria"].push_back({{"runs", x.runs},
                                     {"axis", x.axis},
                                     {"modes", x.modes},
                                     {"speed", x.speed},
                                     {"moment_of_inertia", x.moment},
                                     {"energy", x.energy},
                                     {"index", x.index.negative},
                                     {"zero_eigenvalues", x.index.zero},
                                     {"residual_of_model", x.residual}});
    for (const auto& x : study.runs) {
        Json run{{"status", to_string(x.status)}, {"time", x.time}};
        run["equilibrium"] = x.equilibrium < 0 ? Json() : Json(x.equilibrium);
        run["misalignment"] = x.misalignment;
        run["modal_velocity"] = x.modal_velocity;
        run["deflection_from_rest"] = x.deflection;
        run["velocity_change"] = x.velocity_change;
        run["evidence"] = document(x.evidence);
        out["runs"].push_back(std::move(run));
    }
    return out;
}

void print(const Study& study) {
    const auto settled = std::count_if(study.runs.begin(), study.runs.end(),
                                       [](const Run& x) { return x.status == BodyBeamStatus::settled; });
    std::printf("%zu runs, %lld settled", study.runs.size(), static_cast<long long>(settled));
    for (const auto status : {BodyBeamStatus::time_over, BodyBeamStatus::too_many_steps, BodyBeamStatus::step_too_small,
                              BodyBeamStatus::not_finite})
        if (const auto n =
                std::count_if(study.runs.begin(), study.runs.end(), [&](const Run& x) { return x.status == status; }))
            std::printf(", %lld %s", static_cast<long long>(n), to_string(status));
    std::printf(
        "; relative equilibria, n and -n as one:\n  runs  index        speed       moment       energy   axis n"
        "                         modes u\n");
    for (const auto& x : study.reached) {
        std::printf("%6d %6d %12.8f %12.8f %12.7f  ", x.runs, x.index.negative, x.speed, x.moment, x.energy);
        for (const double n : x.axis) std::printf(" %9.6f", std::abs(n) < 5e-7 ? 0.0 : n);
        std::printf("  ");
        for (const double u : x.modes) std::printf(" %.4f", std::abs(u) < 5e-5 ? 0.0 : u);
        std::printf("\n");
    }
    std::printf(
        "at worst: momentum in space %.1e, energy balance %.1e, energy rising in a step %.1e, misalignment %.1e,\n"
        "angular velocity over the last turn %.1e, the model's equations %.1e; the last at t = %.6g\n",
        worst(study.runs, [](const Run& x) { return x.evidence.momentum_drift; }),
        worst(study.runs, [](const Run& x) { return x.evidence.energy_balance; }),
        worst(study.runs, [](const Run& x) { return x.evidence.energy_increase; }),
        worst(study.runs, [](const Run& x) { return x.misalignment; }),
        worst(study.runs, [](const Run& x) { return x.velocity_change; }),
        worst(study.reached, [](const Reached& x) { return x.residual; }),
        worst(study.runs, [](const Run& x) { return x.time; }));
}

/// What the command line says.
struct Command {
    Options options;
    bool one = false, many = true;  ///< the motion of the first start; the ends of many
    bool t_end_given = false;
    std::optional<support::OutputFile> csv, json;

    bool quiet() const { return to_stdout(csv) || to_stdout(json); }
    /// With a time of its own unless one is given.
    Options until(double time) const {
        Options y = options;
        if (!t_end_given) y.t_end = time;
        return y;
    }
};

Command read(int argc, char** argv) {
    Command c;
    Options& o = c.options;
    std::string csv_name, json_name;
    support::CommandLine app{
        "The motion of a rotating body with a damped elastic beam, free in space, from random starts: with --csv one "
        "motion, otherwise the relative equilibria in which many end."};
    support::add_body_beam_options(app, o.body);
    app.add_option("--momentum", o.momentum, "size of the angular momentum (default 10)")
        .transform(support::positive());
    app.add_option("--damping", o.damping_values, "k1,k2,k3 of bending and stretching (default 0.3,0.3,0.3)")
        .transform(
            support::list("must be 3 numbers, 0 or more, with commas between", 3, 3, [](double k) { return k >= 0; }))
        .transform(support::three_numbers());
    app.add_option("--t-end", o.t_end, "end of the motion (default 50), or the longest time to settle (default 10000)")
        .transform(support::positive());
    app.add_option("--samples", o.samples, "intervals of the CSV (default 1000)")
        .transform(support::integer(1, 1'000'000));
    app.add_seed(o.seed, "of the random starts (default 1)");
    app.add_option("--deflection", o.deflection,
                   "size of the lowest modes at the start, over length^(3/2) (default 0.1)")
        .transform(support::number_from(0, 1, "must be a number from 0 to 1"));
    app.add_option("--runs", o.runs, "starts (default 200)").transform(support::integer(1, 1'000'000));
    app.add_option("--tolerance", o.tolerance, "of the residual below which a motion has settled (default 1e-9)")
        .transform(support::number_from(1e-12, 1e-3, "must be a number from 1e-12 to 1e-3"));
    app.add_threads(o.threads, "0: all of the machine's (default 1); the answer is the same");
    app.add_option("--csv", csv_name, "write the motion of the first start to this file, or to stdout for -");
    app.add_option("--json", json_name, "write the ends of the runs to this file, or to stdout for - (then no table)");
    app.parse("body_beam_motion", argc, argv);
    support::check_body_beam(o.body);

    c.one = app.given("--csv");
    c.many = !c.one || app.given("--runs") || app.given("--json");
    c.t_end_given = app.given("--t-end");
    if (c.one) c.csv.emplace("--csv", csv_name);
    if (app.given("--json")) c.json.emplace("--json", json_name);
    if (c.csv && c.json && csv_name == json_name) support::fail("--json", json_name, "must not be the file of --csv");
    return c;
}

Study solve(const Options& options, bool many) {
    return options.body.coupled() ? study<BeamStrain::coupled>(options, many)
                                  : study<BeamStrain::linear>(options, many);
}

/// The motion of the first start; whether it came to its end.
bool write_one(const Command& c) {
    const Study y = solve(c.until(50), false);
    c.csv->write(csv(y, c.options.body.modes));
    if (!c.quiet())
        std::printf(
            "%s at t = %g; %llu steps; energy %.9g to %.9g, wobble %.6g to %.6g rad; momentum in space "
            "%.1e, energy balance %.1e\n",
            to_string(y.status), y.time, static_cast<unsigned long long>(y.evidence.steps), y.first_energy,
            y.last_energy, y.first_wobble, y.last_wobble, y.evidence.momentum_drift, y.evidence.energy_balance);
    return y.status == BodyBeamStatus::finished;
}

/// The ends of many; whether all settled.
bool write_many(const Command& c) {
    const Options options = c.until(10000);
    const Study y = solve(options, true);
    if (c.json) c.json->write(equilibria::json_text(document(options, y)));
    if (!c.quiet()) print(y);
    return std::all_of(y.runs.begin(), y.runs.end(),
                       [](const Run& run) { return run.status == BodyBeamStatus::settled; });
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const Command c = read(argc, argv);
        bool good = true;
        if (c.one) good = write_one(c) && good;
        if (c.many) good = write_many(c) && good;
        return good ? 0 : 1;
    } catch (const std::exception& error) {
        support::fail("command line", "", error.what());
    }
}

// clang-format off
/* Refused:
--momentum 0
    body_beam_motion: --momentum 0: must be a positive number
--damping 1,1
    body_beam_motion: --damping 1,1: must be 3 finite numbers, with commas between
--damping 1,-1,1
    body_beam_motion: --damping 1,-1,1: must be 3 numbers, 0 or more, with commas between
--t-end 0
    body_beam_motion: --t-end 0: must be a positive number
--samples 0
    body_beam_motion: --samples 0: must be an integer from 1 to 1000000
--seed -1
    body_beam_motion: --seed -1: must be an integer from 0 to 18446744073709551615
--deflection 2
    body_beam_motion: --deflection 2: must be a number from 0 to 1
--runs none
    body_beam_motion: --runs none: must be an integer from 1 to 1000000
--tolerance 1
    body_beam_motion: --tolerance 1: must be a number from 1e-12 to 1e-3
--threads -1
    body_beam_motion: --threads -1: must be an integer from 0 to 1024
--modes 5
    body_beam_motion: --modes 5: must be an integer from 1 to 4
--strain mixed
    body_beam_motion: --strain mixed: must be linear or coupled
--inertia 1,2,9
    body_beam_motion: --inertia 1,2,9: must be moments of which none is larger than the sum of the others
--inertia 1,2
    body_beam_motion: --inertia 1,2: must be 3 positive numbers, with commas between
--centre 0,0,
    body_beam_motion: --centre 0,0,: must be 3 finite numbers, with commas between
--centre 0,0,1 --inertia 1.2,1.2,0.8
    body_beam_motion: --centre 0,0,1: must be where the inertia about it, --inertia less the share of --body-mass, is positive definite
--mu 1,1.2,0
    body_beam_motion: --mu 1,1.2,0: must be 3 positive numbers, with commas between
--body-mass 0
    body_beam_motion: --body-mass 0: must be a positive number
--length
    body_beam_motion: --length: must be followed by a value
--csv .
    body_beam_motion: --csv .: is a folder; must be a file that can be written
--csv one --json one
    body_beam_motion: --json one: must not be the file of --csv
*/
