#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/error.hpp>
#include <equilibria/core/grid_value.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/results/path_counts_output.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_diagram.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_solver.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_motion.hpp>

#include "engine.hpp"
#include "engine_request.hpp"

namespace explorer {

namespace {

using namespace equilibria::mechanisms;
using equilibria::Json;
using Solver = BodyBeamSolver<1, BeamControl::momentum>;
using Base = Solver::Base;
using Values = Solver::Values;

/// As Base::Parameter has them, the speed out of the way, and the damping of all three modes.
const std::vector<std::string> names{"body_mass",  "inertia_1", "inertia_2", "inertia_3", "centre_1",
                                     "centre_2",   "centre_3",  "length",    "bending_1", "bending_2",
                                     "stretching", "speed",     "momentum",  "coupling",  "damping"};
constexpr int damping = 14;
const std::vector<std::string> unknowns{"n1", "n2", "n3", "u1", "u2", "u3", "moment", "speed"};

struct Body {
    equilibria::Array<double, damping + 1> given{};  ///< by `names`
    Values p{};
};

Body body_of(const JsonPlace& request) {
    const JsonPlace model = request.at("model");
    model.keys("a study", {"study", "parameters"}, {"name", "coordinates"});
    model.at("study").choice({"body_beam"});
    Body y;
    set_values(names, model, "parameters", y.given);
    set_values(names, request, "set", y.given);
    for (int k = 0; k < damping; ++k) y.p[k] = y.given[k];
    return y;
}

/// The generic bodies are solved once for each kind of strain, and for those that any turn leaves as they are.
const Solver& solver_for(const Values& p) {
    static std::array<std::unique_ptr<Solver>, 4> known;
    Base::validate(p);
    const bool circles = equilibria::mechanisms::detail::turns(p), coupled = p[Base::coupling] != 0;
    auto& y = known[(circles ? 2 : 0) + (coupled ? 1 : 0)];
    if (!y) y = std::make_unique<Solver>(p);
    return *y;
}

Json heading(const Body& body) {
    Json parameters = Json::object();
    for (int k = 0; k < body.given.size(); ++k)
        if (k != Base::speed) parameters[names[static_cast<std::size_t>(k)]] = body.given[k];
    return {{"model", "rotating body with a beam"}, {"unknowns", unknowns}, {"parameters", std::move(parameters)}};
}

/// By `unknowns`.
std::vector<double> coordinates(const BodyBeamEquilibrium& e) {
    return {e.axis(0), e.axis(1), e.axis(2), e.modes[0], e.modes[1], e.modes[2], e.moment, e.speed};
}

std::string solve(const JsonPlace& request) {
    request.keys("solve", {"command", "model"}, {"set", "prove", "seed", "file"});
    const Body body = body_of(request);
    const Solver& solver = solver_for(body.p);
    const auto prove = request.find("prove");
    const bool proved = prove && prove->boolean();
    const BodyBeamEquilibria found = proved ? solver.prove(body.p) : solver(body.p);

    Json out = heading(body), paths = Json::object(), equilibria = Json::array(), by_index = Json::array();
    equilibria::add_paths(paths, found.paths);
    std::array<int, 6> counts{};
    std::size_t real_proved = 0;
    for (const auto& e : found.equilibria) {
        ++counts[static_cast<std::size_t>(e.index)];
        real_proved += e.proved;
        equilibria.push_back({{"coordinates", coordinates(e)},
                              {"index", e.index},
                              {"nullity", e.nullity},
                              {"stable", e.stable()},
                              {"circle", e.circle},
                              {"energy", e.energy},
                              {"residual", e.residual},
                              {"condition", e.condition}});
    }
    for (const int n : counts) by_index.push_back(n);
    equilibria::add_keys(out, {{"paths", std::move(paths)},
                               {"generic_roots", found.generic_roots},
                               {"distinct", found.distinct},
                               {"real", found.equilibria.size()},
                               {"by_index", std::move(by_index)},
                               {"clean", found.accounted_for()},
                               {"alarms", found.alarms},
                               {"families", found.families},
                               {"failures", found.failures},
                               {"equilibria", std::move(equilibria)}});
    if (proved)
        out["proof"] = {
            {"complete", false},
            {"reason", "bodies in general have " + std::to_string(found.generic_roots.front()) +
                           " solutions, as two of them say, and those of this one are followed from theirs; "
                           "that is a count, not a theorem"},
            {"proved", found.proved_distinct},
            {"undecided", found.distinct - found.proved_distinct},
            {"real", real_proved}};
    return out.dump();
}

constexpr const char* momentum_alone = "must be momentum: branches of the body with a beam are followed in it";

std::string diagram(const JsonPlace& request) {
    request.keys("diagram", {"command", "model", "vary"}, {"set", "seed", "file"});
    const Body body = body_of(request);
    const auto by = varied(names, request, "vary");
    if (by.parameter != Base::momentum) request.at("vary").refuse(momentum_alone);
    const auto found = body_beam_diagram(solver_for(body.p), body.p, {by.low, by.high});
    Json branches = Json::array(), events = Json::array();
    for (const auto& branch : found.branches) {
        Json points = Json::array();
        for (const auto& e : branch.points) {
            auto row = coordinates(e);
            row.insert(row.begin(), e.momentum);
            points.push_back(std::move(row));
        }
        branches.push_back({{"index", branch.index}, {"points", std::move(points)}});
    }
    for (const auto& point : found.critical_points)
        events.push_back(
            {{"kind", to_string(point.kind)}, {"momentum", point.at.momentum}, {"coordinates", coordinates(point.at)}});
    Json out = heading(body);
    equilibria::add_keys(out, {{"complete", found.complete()},
                               {"slices", found.slices},
                               {"branches", std::move(branches)},
                               {"events", std::move(events)}});
    return out.dump();
}

std::string locus(const JsonPlace& request) {
    request.keys("locus", {"command", "model", "x", "y"}, {"set", "seed", "lines", "file"});
    const Body body = body_of(request);
    const auto across = varied(names, request, "x"), up = varied(names, request, "y");
    const bool upright = up.parameter == Base::momentum;
    if (upright == (across.parameter == Base::momentum))
        request.at("y").refuse("must be momentum if x is another parameter, and the other way round");
    const auto &second = upright ? across : up, &momentum = upright ? up : across;
    if (second.parameter > Base::stretching)
        request.at(upright ? "x" : "y")
            .refuse("must be a mass, a moment, a place of the centre, the length or a stiffness");
    const auto found = body_beam_curves(solver_for(body.p), body.p, second.parameter,
                                        {{second.low, second.high}, {momentum.low, momentum.high}}, {.slices = 3});
    const auto place = [&](const std::array<double, 2>& at) { return upright ? at : std::array{at[1], at[0]}; };
    Json curves = Json::array(), cusps = Json::array();
    for (const auto& curve : found.curves) {
        Json points = Json::array();
        for (const auto& at : curve.points) points.push_back(place(at));
        curves.push_back({{"kind", curve.kind == equilibria::CriticalKind::fold ? "fold" : "pitchfork"},
                          {"points", std::move(points)}});
    }
    for (const auto& at : found.cusps) cusps.push_back({{second.name, at[0]}, {momentum.name, at[1]}});
    std::string values;
    for (const double value : found.slices) values += (values.empty() ? "" : ", ") + equilibria::to_text(value);
    Json out = heading(body);
    equilibria::add_keys(
        out, {{"curves", std::move(curves)},
              {"cusps", std::move(cusps)},
              {"regions", Json::array()},
              {"evidence", {{"complete", false}, {"followed", found.complete()}}},
              {"argument", "At " + second.name + " = " + values +
                               " all equilibria of a few momenta were found, and all branches through them followed; "
                               "the curves are those through the critical points of these branches. A curve that meets "
                               "none of these lines is not seen."}});
    return out.dump();
}

template <BeamStrain Strain>
std::string moved(const Body& body, const Eigen::Vector3d& direction, double until, int points) {
    using Motion = RotatingBodyBeamMotion<1, Strain>;
    const double k = body.given[damping];
    const Motion motion(body.p, {k, k, k});
    typename Motion::State start;
    start.momentum = body.p[Base::momentum] * direction;
    std::vector<double> times;
    const auto count = static_cast<std::uint64_t>(points);
    for (std::uint64_t i = 0; i < count; ++i) times.push_back(equilibria::grid_value(0, until, i, count));
    equilibria::MotionOptions options;
    options.relative_tolerance = 1e-9;
    options.absolute_tolerance = 1e-10;
    const auto found = motion.integrate(start, times, options);
    Json rows = Json::array();
    for (const auto& sample : found.samples) {
        const Eigen::Vector3d n = sample.angular_velocity.normalized();
        const auto& u = sample.state.modes;
        const double moment = n.dot(motion.inertia(u) * n);
        rows.push_back({{"t", sample.time},
                        {"q", {n(0), n(1), n(2), u(0), u(1), u(2), moment, sample.angular_velocity.norm()}},
                        {"momentum", equilibria::json_list(sample.state.momentum)},
                        {"energy", sample.energy}});
    }
    Json out = heading(body);
    equilibria::add_keys(out, {{"status", to_string(found.status)},
                               {"points", std::move(rows)},
                               {"largest_balance", found.evidence.energy_balance},
                               {"momentum_drift", found.evidence.momentum_drift}});
    return out.dump();
}

/// Let go with the beam straight and the momentum at an angle `tilt` to it, `heading` about it from the first axis.
std::string motion(const JsonPlace& request) {
    request.keys("motion", {"command", "model"}, {"set", "start", "rates", "until", "points", "file"});
    const Body body = body_of(request);
    equilibria::Array<double, 2> start{};
    set_values({"tilt", "heading"}, request, "start", start);
    const auto until = request.find("until"), points = request.find("points");
    const Eigen::Vector3d direction(std::sin(start[0]) * std::cos(start[1]), std::sin(start[0]) * std::sin(start[1]),
                                    std::cos(start[0]));
    const double end = until ? until->positive() : 80;
    const int rows = points ? points->integer(2, 100000) : 1001;
    return body.p[Base::coupling] == 0 ? moved<BeamStrain::linear>(body, direction, end, rows)
                                       : moved<BeamStrain::coupled>(body, direction, end, rows);
}

}  // namespace

std::string body_beam_document(const std::string& command, const JsonPlace& request) {
    if (command == "solve") return solve(request);
    if (command == "diagram") return diagram(request);
    if (command == "locus") return locus(request);
    if (command == "motion") return motion(request);
    throw equilibria::InvalidArgument("command", command,
                                      "must be one of solve, diagram, locus, motion for the study body_beam");
}

}  // namespace explorer
