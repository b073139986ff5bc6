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
#include <equilibria/storage/locked_file.hpp>
#include <exception>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "support/body_beam_options.hpp"
#include "support/command_line.hpp"
#include "support/links.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/progress_bar.hpp"

namespace {

using equilibria::mechanisms::BeamControl, equilibria::mechanisms::BodyBeamEquilibria,
    equilibria::mechanisms::BodyBeamSolver;
using Beam = equilibria::mechanisms::RotatingBodyBeam<1>;
using BodyBeamValues = Beam::Values;
using Json = nlohmann::ordered_json;

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

Json counts(const equilibria::PathCounts& paths) {
    return {{"paths", paths.total},       {"finite", paths.finite},           {"at_infinity", paths.at_infinity},
            {"singular", paths.singular}, {"failed", paths.failed},           {"retracked", paths.retracked},
            {"crossed", paths.crossed},   {"more_digits", paths.more_digits}, {"steps", paths.steps}};
}

std::string json(const support::BodyBeamOptions& body, BeamControl control, const BodyBeamValues& p,
                 const BodyBeamRun& run, const Answer& a) {
    const auto& r = a.found;
    Json out{{"body_mass", body.body_mass}, {"inertia", body.inertia}, {"centre", body.centre},
             {"length", body.length},       {"mu", body.mu},           {"modes", body.modes},
             {"strain", body.strain},       {"seed", run.seed},        {"threads", run.threads}};
    out[control == BeamControl::speed ? "speed" : "momentum"] =
        p[control == BeamControl::speed ? Beam::speed : Beam::momentum];
    out["bound"] = r.generic.total;
    out.update(counts(r.generic));
    out["generic_roots"] = r.generic_roots;
    out["followed"] = counts(r.paths);
    out["distinct"] = r.distinct;
    out["real"] = r.real;
    if (run.prove) out.update({{"proved_distinct", r.proved_distinct}, {"proved_real", r.proved_real}});
    out["alarms"] = r.alarms;
    out["failures"] = r.failures;
    out["families"] = r.families;
    out["whirl_speeds"] = a.whirl;
    out["seconds"] = r.generic_seconds + r.seconds + r.proving_seconds;
    out["equilibria"] = Json::array();
    for (const auto& e : r.equilibria) {
        Json inertia = Json::array();
        for (int k = 0; k < 3; ++k) inertia.push_back({e.inertia(k, 0), e.inertia(k, 1), e.inertia(k, 2)});
        out["equilibria"].push_back({{"axis", {e.axis(0), e.axis(1), e.axis(2)}},
                                     {"modes", e.modes},
                                     {"inertia", inertia},
                                     {"moment", e.moment},
                                     {"momentum", e.momentum},
                                     {"speed", e.speed},
                                     {"index", e.index},
                                     {"nullity", e.nullity},
                                     {"stable", e.stable()},
                                     {"family", e.circle ? "circle" : "point"},
                                     {"energy", e.energy},
                                     {"residual", e.residual},
                                     {"condition", e.condition}});
        if (run.prove) out["equilibria"].back()["proved"] = e.proved;
    }
    return out.dump(2) + "\n";
}

void print(const support::BodyBeamOptions& body, BeamControl control, const BodyBeamValues& p, const BodyBeamRun& run,
           const Answer& a) {
    const auto& r = a.found;
    std::printf(
        "Body of mass %g, inertia %s; beam of length %g, stiffnesses %s, %s strain, %d mode%s a direction; %s %g\n\n",
        body.body_mass, support::joined(body.inertia).c_str(), body.length, support::joined(body.mu).c_str(),
        body.strain.c_str(), body.modes, body.modes == 1 ? "" : "s",
        control == BeamControl::speed ? "speed" : "momentum",
        p[control == BeamControl::speed ? Beam::speed : Beam::momentum]);
    std::printf("axis                             moment    speed     momentum  index  modes\n");
    const auto zero = [](double x) { return std::abs(x) < 5e-8 ? 0.0 : x; };
    for (const auto& e : r.equilibria) {
        std::printf("%10.6f%10.6f%10.6f  %9.6f %9.6f %9.6f  %5d ", zero(e.axis(0)), zero(e.axis(1)), zero(e.axis(2)),
                    e.moment, e.speed, e.momentum, e.index);
        for (const double u : e.modes) std::printf("%10.6f", zero(u));
        std::printf("%s%s%s\n", e.stable() ? "  stable" : "", e.circle ? "  circle" : "", e.proved ? "  proved" : "");
    }
    const auto count = [](auto value) { return static_cast<unsigned long long>(value); };
    const auto line = [&](const char* what, const equilibria::PathCounts& n) {
        std::printf("%s: %llu paths: %llu finite, %llu at infinity, %llu singular, %llu failed\n", what, count(n.total),
                    count(n.finite), count(n.at_infinity), count(n.singular), count(n.failed));
    };
    std::printf("\n");
    line("To a generic member, total degree", r.generic);
    line(r.followed ? "From its roots" : "Too irregular: to this member, total degree", r.paths);
    std::printf("Generic members have");
    for (const auto roots : r.generic_roots) std::printf(" %llu", count(roots));
    std::printf(" roots.\n%llu distinct roots here, %llu real, %zu relative equilibria up to the sense of turning\n",
                count(r.distinct), count(r.real), r.equilibria.size());
    if (run.prove)
        std::printf("Proved: %llu distinct roots, %llu of them real\n", count(r.proved_distinct), count(r.proved_real));
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
    std::string speed, momentum, seed = "1", threads = "1", json_name, checkpoint;
    bool prove = false;
    support::BodyBeamOptions body;
    CLI::App app{
        "All relative equilibria of a rigid body with an elastic beam, free in space, with their index at fixed "
        "angular "
        "momentum: 0 where they are stable. Lengths, masses and times in any consistent units in which the beam has "
        "line "
        "density 1."};
    support::add_body_beam_options(app, body);
    app.add_option("--speed", speed, "angular speed, radians a unit of time: this or --momentum");
    app.add_option("--momentum", momentum, "size of the angular momentum: this or --speed");
    app.add_option("--seed", seed, "of the generic member and the start system, an integer (default 1)");
    app.add_option("--threads", threads, "1 to 1024, 0 for one each core (default 1); does not change the result");
    app.add_option(
        "--checkpoint", checkpoint,
        "keep the paths to the generic member in this file, and go on from it if it is there already: beams that "
        "differ in speed, stiffness and moments alone share them");
    app.add_flag("--prove", prove, "prove that each root exists and is distinct, and which are real (Krawczyk)");
    app.add_option("--json", json_name, "write JSON to this file, or to stdout for -, instead of a table");
    support::parse(app, "body_beam", argc, argv);

    if (body.modes > most_solved_modes)
        support::fail("--modes", std::to_string(body.modes),
                      "must be 1 or 2 here: the total degree grows 27 times a mode; body_beam_motion takes 4");
    if (speed.empty() == momentum.empty())
        support::fail(speed.empty() ? "--speed" : "--momentum", momentum,
                      "one of --speed and --momentum must be given, and not both");
    const auto control = momentum.empty() ? BeamControl::speed : BeamControl::momentum;
    const auto positive = [](double x) { return x > 0; };
    auto p = support::body_beam_parameters<Beam>(
        body,
        control == BeamControl::speed ? support::number("--speed", speed, "must be a positive number", positive) : 0);
    if (control == BeamControl::momentum)
        p[Beam::momentum] = support::number("--momentum", momentum, "must be a positive number", positive);
    p[Beam::coupling] = body.coupled() ? 1 : 0;
    if (app.count("--checkpoint") > 0 && checkpoint.empty())
        support::fail("--checkpoint", "''", "must be the name of a file");
    std::optional<support::ProgressBar> bar("tracking");
    const BodyBeamRun run{support::integer<std::uint64_t>("--seed", seed, 0, UINT64_MAX),
                          support::integer<unsigned>("--threads", threads, 0, 1024),
                          [&](std::uint64_t done, std::uint64_t all) { bar->update(done, all); }, checkpoint, prove};
    std::optional<support::OutputFile> file;
    if (app.count("--json") > 0) file.emplace("--json", json_name);
    try {
        const Answer a = answer(p, body.modes, control, run);
        bar.reset();
        if (file) file->write(json(body, control, p, run, a));
        if (!file || !file->to_stdout()) print(body, control, p, run, a);
        return a.found.generic.failed + a.found.paths.failed > 0 ? 1 : 0;
    } catch (const equilibria::CheckpointError& error) {
        bar.reset();
        support::fail("--checkpoint", checkpoint, error.wrong());
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
