// The engine of the explorer: requests and responses as JSON, called by a page's worker (docs/explorer.md). The
// documents are those of the program `equilibria`.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>

#include <equilibria/core/error.hpp>
#include <equilibria/io/read_model.hpp>
#include <equilibria/io/strict_json.hpp>

#include "engine.hpp"
#include "engine_request.hpp"
#include "equilibria_command/documents.hpp"

namespace explorer {

namespace {

using commands::Input;
using commands::Json;
using commands::Varied;
using equilibria::InvalidArgument;

/// The model and its parameters. A model is an object, whose errors name line and column in a formula, or the text of a
/// model file, whose errors name them in the text.
Input input_of(const JsonPlace& request, const Json& ordered) {
    Input y;
    const JsonPlace model = request.at("model");
    if (model.json().is_string())
        y.model = equilibria::parse_model(model.string());
    else
        y.model = equilibria::parse_model(ordered["model"].dump(), std::size_t{16} << 20,
                                          equilibria::FormulaPlaces::in_formula);
    y.p = y.model.values;
    if (const auto file = request.find("file")) y.file = file->string();
    set_values(y.model.parameters, request, "set", y.p);
    return y;
}

std::string describe(const JsonPlace& request, const Json& ordered) {
    request.keys("describe", {"command", "model"}, {"set", "file"});
    const Input input = input_of(request, ordered);
    const auto& model = input.model;
    Json parameters = Json::object();
    for (int k = 0; k < input.p.size(); ++k) parameters[model.parameters[static_cast<std::size_t>(k)]] = input.p[k];
    return Json{{"angles", model.angles},
                {"coordinates", model.coordinates},
                {"parameters", parameters},
                {"has_potential", model.has_potential},
                {"moves", static_cast<bool>(model.kinetics)}}
        .dump();
}

std::string solve(const JsonPlace& request, const Json& ordered) {
    request.keys("solve", {"command", "model"}, {"set", "file", "prove", "seed"});
    const Input input = input_of(request, ordered);
    const auto prove = request.find("prove");
    return document(input, solved(input, run_of(request), {.prove = prove && prove->boolean()}));
}

std::string events(const JsonPlace& request, const Json& ordered) {
    request.keys("events", {"command", "model", "vary"}, {"set", "file", "seed"});
    const Input input = input_of(request, ordered);
    const Varied by = varied(input.model.parameters, request, "vary");
    return document(input, by, find_events(input.model, input.p, by.parameter, {by.low, by.high}, run_of(request)));
}

std::string diagram(const JsonPlace& request, const Json& ordered) {
    request.keys("diagram", {"command", "model", "vary"}, {"set", "file", "seed"});
    const Input input = input_of(request, ordered);
    const Varied by = varied(input.model.parameters, request, "vary");
    return document(input, by, trace_diagram(input.model, input.p, by.parameter, {by.low, by.high}, run_of(request)));
}

std::string locus(const JsonPlace& request, const Json& ordered) {
    request.keys("locus", {"command", "model", "x", "y"}, {"set", "file", "seed", "lines"});
    const Input input = input_of(request, ordered);
    const Varied across = varied(input.model.parameters, request, "x"),
                 up = varied(input.model.parameters, request, "y");
    if (across.parameter == up.parameter) request.at("y").refuse("must be another parameter than that of x");
    equilibria::LocusOptions options;
    options.lines = commands::locus_lines;
    if (const auto lines = request.find("lines")) options.lines = lines->integer(2, 1000);
    return document(input, across, up,
                    trace_locus(input.model, input.p, {across.parameter, up.parameter},
                                {{across.low, across.high}, {up.low, up.high}}, run_of(request), options));
}

/// A number for each name, 0 where none is given.
commands::RuntimeArray<double> values_of(const JsonPlace& request, const char* key,
                                         const std::vector<std::string>& names) {
    commands::RuntimeArray<double> y(static_cast<int>(names.size()));
    set_values(names, request, key, y);
    return y;
}

std::string motion(const JsonPlace& request, const Json& ordered) {
    request.keys("motion", {"command", "model"},
                 {"set", "file", "start", "rates", "until", "points", "formulation", "tolerance"});
    const Input input = input_of(request, ordered);
    if (!input.model.kinetics)
        request.at("model").refuse("must have \"kinetic_energy\" and \"rates\": the model does not move");
    commands::MotionRequest asked;
    asked.from = {values_of(request, "start", commands::unknowns(input.model)),
                  values_of(request, "rates", input.model.kinetics->rates)};
    if (const auto until = request.find("until")) asked.until = until->positive();
    if (const auto points = request.find("points")) asked.points = points->integer(2, 1000000);
    if (const auto words = request.find("formulation")) asked.hamilton = words->choice({"lagrange2", "hamilton"}) == 1;
    if (const auto tolerance = request.find("tolerance")) {
        asked.tolerance = tolerance->number();
        if (!(asked.tolerance >= 1e-15 && asked.tolerance < 1))
            tolerance->refuse("must be a number from 1e-15 to 1, 1 excluded");
    }
    return document(input, asked, moved(input, asked, {}));
}

std::string structure(const JsonPlace& request, const Json&) {
    request.keys("structure", {"command", "case"});
    return structure_document(request.at("case").choice({"star_dome", "right_angle_frame"}) == 0
                                  ? Structure::star_dome
                                  : Structure::right_angle_frame);
}

struct Command {
    std::string_view name;
    std::string (*run)(const JsonPlace& request, const Json& ordered);
};
constexpr Command known[] = {{"describe", describe}, {"solve", solve},   {"events", events},      {"diagram", diagram},
                             {"locus", locus},       {"motion", motion}, {"structure", structure}};

std::string answer(std::string_view text) {
    const auto parsed = equilibria::detail::parse_json(text, std::size_t{16} << 20, 6);
    const JsonPlace request(parsed.root, "");
    const std::string& name = request.at("command").string();
    if (const auto model = request.find("model"); model && model->json().is_object() && model->find("study"))
        return body_beam_document(name, request);
    std::string names;
    for (const Command& c : known) {
        if (c.name == name) return c.run(request, Json::parse(text));
        names += (names.empty() ? "" : ", ") + std::string(c.name);
    }
    throw InvalidArgument("command", name, "must be one of " + names);
}

std::string response, failure;

}  // namespace

}  // namespace explorer

extern "C" {

/// Memory for a request.
void* engine_alloc(std::size_t bytes) { return std::malloc(bytes); }
void engine_free(void* memory) { std::free(memory); }

/// The response to a request of so many bytes, ended by 0, until the next call. Where something is wrong with it the
/// call ends in a trap, and engine_error says what; the instance is of no use then.
const char* engine_run(const char* request, std::size_t length) {
    explorer::failure.clear();
    try {
        explorer::response = explorer::answer({request, length});
        return explorer::response.c_str();
    } catch (const std::exception& error) {
        explorer::failure = error.what();
    } catch (...) {
        explorer::failure = "an exception of no known kind";
    }
    __builtin_trap();
}
const char* engine_error() { return explorer::failure.c_str(); }
}
