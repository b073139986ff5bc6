#include "documents.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

#include <equilibria/core/grid_value.hpp>
#include <equilibria/io/results/diagram_output.hpp>
#include <equilibria/io/results/every_root_output.hpp>
#include <equilibria/io/results/line_events_output.hpp>
#include <equilibria/io/results/locus_output.hpp>
#include <equilibria/io/results/motion_output.hpp>
#include <equilibria/io/results/proof_output.hpp>
#include <equilibria/io/results/root_set_output.hpp>
#include <equilibria/io/results/stability_output.hpp>

namespace commands {

std::vector<std::string> unknowns(const FormulaModel& model) {
    std::vector<std::string> y = model.angles;
    y.insert(y.end(), model.coordinates.begin(), model.coordinates.end());
    return y;
}
equilibria::RuntimeSizes sizes(const FormulaModel& model) {
    return {static_cast<int>(model.angles.size()), static_cast<int>(model.coordinates.size())};
}

Json heading(const Input& input) {
    Json out = Json::object();
    if (!input.file.empty()) out["file"] = input.file;
    if (!input.model.name.empty()) out["model"] = input.model.name;
    out["unknowns"] = unknowns(input.model);
    Json parameters = Json::object();
    for (int k = 0; k < input.p.size(); ++k)
        parameters[input.model.parameters[static_cast<std::size_t>(k)]] = input.p[k];
    out["parameters"] = std::move(parameters);
    return out;
}

Solved solved(const Input& input, const equilibria::RunOptions& run, const SolveOptions& options) {
    Solved y;
    if (options.prove) {
        auto found = equilibria::every_equilibrium(input.model, input.p, run, options.start);
        y.set = std::move(found.set);
        y.proof = std::move(found.proof);
        y.confirmed = std::move(found.confirmed);
        y.at_infinity = std::move(found.at_infinity);
    } else {
        y.set = equilibria::enumerate(input.model, input.p, run, options.start, options.more_digits);
    }
    if (input.model.kinetics)
        for (const auto& e : y.set.equilibria)
            y.poles.push_back(equilibria::count_poles_at_rest(input.model, e.q, input.p));
    return y;
}

equilibria::Motion<RuntimeUnknowns> moved(const Input& input, const MotionRequest& request,
                                          const equilibria::RunOptions& run) {
    std::vector<double> times;
    const auto points = static_cast<std::uint64_t>(request.points);
    for (std::uint64_t k = 0; k < points; ++k) times.push_back(equilibria::grid_value(0, request.until, k, points));
    return equilibria::integrate_motion(
        input.model, input.p, request.from, times, {request.tolerance, request.tolerance, 0, 100'000'000}, run,
        request.hamilton ? equilibria::FormulaFormulation::hamilton : equilibria::FormulaFormulation::lagrange);
}

std::string document(const Input& input, const Solved& found) {
    Json out = heading(input), roots = equilibria::json_of(found.set, {input.model.parameters});
    roots.erase("parameters");
    for (std::size_t k = 0; k < found.poles.size(); ++k) {
        Json& e = roots["equilibria"][k];
        e["verdict"] = found.poles[k] ? Json(to_string(found.poles[k]->verdict())) : Json();
        e["poles"] = found.poles[k] ? equilibria::json_list(found.poles[k]->poles) : Json();
    }
    equilibria::add_keys(out, roots);
    if (found.proof) {
        out["proof"] = equilibria::json_of(*found.proof);
        equilibria::add_certificates(out["equilibria"], *found.proof);
        Json& proved = out["multiplicities_proved"] = Json::array();
        for (const char confirmed : found.confirmed) proved.push_back(confirmed != 0);
    }
    equilibria::add_verdict(out, found.set.completeness);
    out["directions_at_infinity"] = equilibria::json_of(found.at_infinity);
    return equilibria::json_text(out);
}

std::string document(const Input& input, const Varied& by, const equilibria::LineEvents<RuntimeUnknowns>& found) {
    Json out = heading(input);
    equilibria::add_keys(out, equilibria::json_of(found, by.name));
    return equilibria::json_text(out);
}

std::string document(const Input& input, const Varied& by,
                     const equilibria::BifurcationDiagram<RuntimeUnknowns>& found) {
    Json out = heading(input);
    equilibria::add_keys(out, equilibria::json_of(found, by.name, sizes(input.model)));
    return equilibria::json_text(out);
}

std::string document(const Input& input, const Varied& across, const Varied& up,
                     const equilibria::Locus<RuntimeUnknowns>& found) {
    Json out = heading(input);
    equilibria::add_keys(out, equilibria::json_of(found, {.x = across.name, .y = up.name}, sizes(input.model)));
    return equilibria::json_text(out, 1);
}

std::string document(const Input& input, const MotionRequest& request,
                     const equilibria::Motion<RuntimeUnknowns>& found) {
    Json out = heading(input);
    out["rates"] = input.model.kinetics->rates;
    out["formulation"] = request.hamilton ? "hamilton" : "lagrange2";
    equilibria::add_keys(out, equilibria::json_of(found));
    return equilibria::json_text(out);
}

}  // namespace commands
