// All relative equilibria of a rigid body with an elastic beam, free in space: section 2 of Baillieul's "Parametric
// dependence in the equilibrium dynamics of rotating structures", the beam cut down to a few modes.
//
//   body_beam --body-mass 2 --inertia 1.2,1.3,.8 --mu 1,1.2,100 --modes 1 --speed 6
//   body_beam --modes 1 --momentum 6 --strain coupled --json equilibria.json
//   body_beam --modes 2 --speed 6 --checkpoint generic.ckpt    (the long part is kept for the next speed)
#include "body_beam/body_beam.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <equilibria/io/results/path_counts_output.hpp>
#include <equilibria/storage/locked_file.hpp>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/body_beam_options.hpp"
#include "support/joined.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/progress_bar.hpp"

namespace {

using equilibria::mechanisms::BeamControl, equilibria::mechanisms::BodyBeamEquilibria,
    equilibria::mechanisms::BodyBeamSolver;
using Beam = equilibria::mechanisms::RotatingBodyBeam<1>;
using BodyBeamValues = Beam::Values;
using equilibria::Json;

struct BodyBeamRun {
    std::uint64_t seed = 1;
    unsigned threads = 1;
    std::function<void(std::uint64_t done, std::uint64_t all)> progress{};
    std::string checkpoint{};  // of the paths to the generic member
    bool prove = false;
};

/// Of the spin about the undeformed beam; none where there is no such spin or where any tilt is as good.
using WhirlSpeeds = std::array<std::vector<double>, 2>;

template <int K>
WhirlSpeeds whirl_speeds(const BodyBeamValues& p) {
    WhirlSpeeds y;
    for (int plane : {1, 2}) {
        try {
            y[static_cast<std::size_t>(plane - 1)] = equilibria::mechanisms::whirl_speeds<K>(p, plane);
        } catch (const equilibria::InvalidArgument&) {
        }
    }
    return y;
}

struct Answer {
    BodyBeamEquilibria found;
    WhirlSpeeds whirl;
};

template <int K, BeamControl Control>
Answer solved(const BodyBeamValues& p, const BodyBeamRun& run) {
    const BodyBeamSolver<K, Control> solver(p, {.seed = run.seed,
                                                .executor = equilibria::threads(run.threads),
                                                .progress = run.progress,
                                                .checkpoint = run.checkpoint});
    return {run.prove ? solver.prove(p) : solver(p), whirl_speeds<K>(p)};
}

Answer answer(const BodyBeamValues& p, int modes, BeamControl control, const BodyBeamRun& run) {
    if (control == BeamControl::speed)
        return modes == 1 ? solved<1, BeamControl::speed>(p, run) : solved<2, BeamControl::speed>(p, run);
    return modes == 1 ? solved<1, BeamControl::momentum>(p, run) : solved<2, BeamControl::momentum>(p, run);
}

/// What the command line says.
struct Command {
    support::BodyBeamOptions body;
    std::optional<double> speed, momentum;
    BodyBeamRun run;
    std::optional<support::OutputFile> json;

    BeamControl control() const { return momentum ? BeamControl::momentum : BeamControl::speed; }
    const char* control_name() const { return momentum ? "momentum" : "speed"; }
    BodyBeamValues values() const {
        auto p = support::body_beam_parameters<Beam>(body, speed.value_or(0));
        if (momentum) p[Beam::momentum] = *momentum;
        p[Beam::coupling] = body.coupled() ? 1 : 0;
        return p;
    }
};

Command read(int argc, char** argv) {
    Command c;
    support::CommandLine app{
        "All relative equilibria of a rigid body with an elastic beam, free in space, with their index at fixed "
        "angular "
        "momentum: 0 where they are stable. Lengths, masses and times in any consistent units in which the beam has "
        "line "
        "density 1."};
    support::add_body_beam_options(app, c.body);
    app.add_option("--speed", c.speed, "angular speed, radians a unit of time: this or --momentum")
        .transform(support::positive());
    app.add_option("--momentum", c.momentum, "size of the angular momentum: this or --speed")
        .transform(support::positive());
    app.add_option(
           "--checkpoint", c.run.checkpoint,
           "keep the paths to the generic member in this file, and go on from it if it is there already: beams that "
           "differ in speed, stiffness and moments alone share them")
        .transform(support::name_of("a file"));
    app.add_seed(c.run.seed, "of the generic member and the start system, an integer (default 1)");
    app.add_threads(c.run.threads, "1 to 1024, 0 for one each core (default 1); does not change the result");
    app.add_flag("--prove", c.run.prove, "prove that each root exists and is distinct, and which are real (Krawczyk)");
    support::add_output(app, "--json", c.json, "write JSON to this file, or to stdout for -, instead of a table");
    app.parse("body_beam", argc, argv);

    if (c.body.modes > most_solved_modes)
        support::fail("--modes", std::to_string(c.body.modes),
                      "must be 1 or 2 here: the total degree grows 27 times a mode; body_beam_motion takes 4");
    const char* const one = "one of --speed and --momentum must be given, and not both";
    if (!c.speed && !c.momentum) support::fail("--speed", "", one);
    if (c.speed && c.momentum) support::fail("--momentum", equilibria::to_text(*c.momentum), one);
    return c;
}

Json counts(const equilibria::PathCounts& paths) {
    Json out = Json::object();
    equilibria::add_paths(out, paths);
    return out;
}

Json document(const equilibria::mechanisms::BodyBeamEquilibrium& e) {
    return {{"axis", equilibria::json_list(e.axis)},
            {"modes", e.modes},
            {"inertia", equilibria::json_rows(e.inertia)},
            {"moment", e.moment},
            {"momentum", e.momentum},
            {"speed", e.speed},
            {"index", e.index},
            {"nullity", e.nullity},
            {"stable", e.stable()},
            {"family", e.circle ? "circle" : "point"},
            {"energy", e.energy},
            {"residual", e.residual},
            {"condition", e.condition}};
}

Json document(const Command& c, const Answer& a) {
    const auto& body = c.body;
    const auto& r = a.found;
    Json out{{"body_mass", body.body_mass},  {"inertia", body.inertia.values},
             {"centre", body.centre.values}, {"length", body.length},
             {"mu", body.mu.values},         {"modes", body.modes},
             {"strain", body.strain},        {"seed", c.run.seed},
             {"threads", c.run.threads},     {c.control_name(), c.momentum ? *c.momentum : *c.speed},
             {"bound", r.generic.total}};
    equilibria::add_paths(out, r.generic);
    out["generic_roots"] = r.generic_roots;
    out["followed"] = counts(r.paths);
    out["distinct"] = r.distinct;
    out["real"] = r.real;
    if (c.run.prove)
        equilibria::add_keys(out, {{"proved_distinct", r.proved_distinct}, {"proved_real", r.proved_real}});
    out["alarms"] = r.alarms;
    out["failures"] = r.failures;
    out["families"] = r.families;
    out["whirl_speeds"] = a.whirl;
    out["seconds"] = r.generic_seconds + r.seconds + r.proving_seconds;
    out["equilibria"] = Json::array();
    for (const auto& e : r.equilibria) {
        out["equilibria"].push_back(document(e));
        if (c.run.prove) out["equilibria"].back()["proved"] = e.proved;
    }
    return out;
}

unsigned long long count(std::uint64_t value) { return value; }

void print_equilibria(const BodyBeamEquilibria& r) {
    std::printf("axis                             moment    speed     momentum  index  modes\n");
    const auto zero = [](double x) { return std::abs(x) < 5e-8 ? 0.0 : x; };
    for (const auto& e : r.equilibria) {
        std::printf("%10.6f%10.6f%10.6f  %9.6f %9.6f %9.6f  %5d ", zero(e.axis(0)), zero(e.axis(1)), zero(e.axis(2)),
                    e.moment, e.speed, e.momentum, e.index);
        for (const double u : e.modes) std::printf("%10.6f", zero(u));
        std::printf("%s%s%s\n", e.stable() ? "  stable" : "", e.circle ? "  circle" : "", e.proved ? "  proved" : "");
    }
}

void print_paths(const BodyBeamEquilibria& r, bool prove) {
    const auto line = [&](const std::string& what, const equilibria::PathCounts& n) {
        std::printf("%s: %llu paths: %llu finite, %llu at infinity, %llu singular, %llu failed\n", what.c_str(),
                    count(n.total), count(n.finite), count(n.at_infinity), count(n.singular), count(n.failed));
    };
    std::printf("\n");
    line("To a generic member, " + r.start + " start", r.generic);
    line(r.followed ? "From its roots" : "Too irregular: to this member", r.paths);
    std::printf("Generic members have");
    for (const auto roots : r.generic_roots) std::printf(" %llu", count(roots));
    std::printf(" roots.\n%llu distinct roots here, %llu real, %zu relative equilibria up to the sense of turning\n",
                count(r.distinct), count(r.real), r.equilibria.size());
    if (prove)
        std::printf("Proved: %llu distinct roots, %llu of them real\n", count(r.proved_distinct), count(r.proved_real));
}

void print(const Command& c, const Answer& a) {
    const auto& body = c.body;
    const auto& r = a.found;
    std::printf(
        "Body of mass %g, inertia %s; beam of length %g, stiffnesses %s, %s strain, %d mode%s a direction; %s %g\n\n",
        body.body_mass, support::joined(body.inertia.values).c_str(), body.length,
        support::joined(body.mu.values).c_str(), body.strain.c_str(), body.modes, body.modes == 1 ? "" : "s",
        c.control_name(), c.momentum ? *c.momentum : *c.speed);
    print_equilibria(r);
    print_paths(r, c.run.prove);
    if (r.paths.failed == 0 && r.paths.singular == 0 && r.alarms.empty()) std::printf("Each path is accounted for.\n");
    if (r.paths.failed > 0)
        std::printf("INCOMPLETE: %llu paths failed; equilibria may be missing.\n", count(r.paths.failed));
    if (r.paths.singular > 0)
        std::printf("SINGULAR: %llu paths end where roots coincide, or where doubles cannot tell.\n",
                    count(r.paths.singular));
    for (const std::string& family : r.families) std::printf("NOT ISOLATED: %s.\n", family.c_str());
    if (!r.alarms.empty()) std::printf("ALARM: %s.\n", r.alarms.c_str());
    for (std::size_t plane = 0; plane < 2; ++plane) {
        if (a.whirl[plane].empty()) continue;
        std::printf("The spin about the beam whirls in the plane %zu-3 from the speed", plane + 1);
        for (const double w : a.whirl[plane]) std::printf(" %.10g", w);
        std::printf("\n");
    }
    std::printf("%.3g s, %.3g s of it for the generic member\n", r.generic_seconds + r.seconds + r.proving_seconds,
                r.generic_seconds);
}

}  // namespace

int main(int argc, char** argv) {
    Command c = read(argc, argv);
    std::optional<support::ProgressBar> bar("tracking");
    c.run.progress = [&](std::uint64_t done, std::uint64_t all) { bar->update(done, all); };
    try {
        const Answer a = answer(c.values(), c.body.modes, c.control(), c.run);
        bar.reset();
        if (c.json) c.json->write(equilibria::json_text(document(c, a)));
        if (!to_stdout(c.json)) print(c, a);
        return a.found.generic.failed + a.found.paths.failed > 0 ? 1 : 0;
    } catch (const equilibria::CheckpointError& error) {
        bar.reset();
        support::fail("--checkpoint", c.run.checkpoint, error.wrong());
    } catch (const std::exception& error) {
        support::fail("command line", "", error.what());
    }
}

// clang-format off
/* Refused:
--speed 2 --modes 3
    body_beam: --modes 3: must be 1 or 2 here: the total degree grows 27 times a mode; body_beam_motion takes 4
--modes 1
    body_beam: --speed: one of --speed and --momentum must be given, and not both
--speed 2 --momentum 3
    body_beam: --momentum 3: one of --speed and --momentum must be given, and not both
--speed 0
    body_beam: --speed 0: must be a positive number
--momentum nan
    body_beam: --momentum nan: must be a positive number
--speed 2 --inertia 1,1
    body_beam: --inertia 1,1: must be 3 positive numbers, with commas between
--speed 2 --inertia 1,1,3
    body_beam: --inertia 1,1,3: must be moments of which none is larger than the sum of the others
--speed 2 --body-mass -1
    body_beam: --body-mass -1: must be a positive number
--speed 2 --mu 1,0,100
    body_beam: --mu 1,0,100: must be 3 positive numbers, with commas between
--speed 2 --strain stiff
    body_beam: --strain stiff: must be linear or coupled
--speed 2 --json missing/folder.json
    body_beam: --json missing/folder.json: cannot be written (No such file or directory); must be a file that can, or -
--speed 2 --damping 1
    body_beam: --damping: is not an option; --help lists them
*/
