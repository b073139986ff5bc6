#include "command.hpp"

#include <cmath>
#include <cstdio>
#include <exception>
#include <sstream>

#include <equilibria/io/read_model.hpp>
#include <equilibria/run/threads.hpp>

namespace commands {

void Command::add_model_to(support::CommandLine& app) {
    app.add_option("FILE", file, "the model, as JSON").transform(support::name_of("a file"));
    app.add_option("--set", fixed, "NAME=VALUE, commas between: parameters other than as the file has them");
}
void Command::add_json_to(support::CommandLine& app) {
    support::add_output(app, "--json", json, "write JSON to this file, or to stdout for -, instead of a table");
}
void Command::add_to(support::CommandLine& app) {
    add_model_to(app);
    app.add_seed(seed, "of the random start systems, an integer (default 1); the same seed, the same result");
    app.add_threads(threads, "1 to 1024, 0 for one each core (default 1); does not change the result");
    app.add_limit(limit, "seconds after which the run is stopped, with status 124 (default: none)");
    add_json_to(app);
}

equilibria::RunOptions Command::run() const { return {.seed = seed, .executor = equilibria::threads(threads)}; }

StoppableRun::StoppableRun(const Command& c, const std::string& label, By by)
    : bar_(label), limit_(c.limit), options_(c.run()) {
    const std::atomic<bool>& stopped = support::cancelled_by_signal();
    if (by == By::flag) options_.cancel = &stopped;
    options_.progress = [this, by, &stopped](std::uint64_t done, std::uint64_t all) {
        if (by == By::progress && stopped) throw support::Stopped{};
        if (bar_) bar_->update(done, all);
    };
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> y;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);) y.push_back(part);
    return y;
}

int number_of(const std::vector<std::string>& names, const std::string& option, const std::string& name) {
    try {
        return equilibria::number_of_name(names, name, option);
    } catch (const std::exception& error) {
        const std::string what = error.what(), before = option + " = ";  // as options are refused: without "="
        support::refuse(what.starts_with(before) ? option + " " + what.substr(before.size()) : what);
    }
}

Input read(const Command& c) {
    if (c.file.empty()) support::fail("FILE", "", "must be given: a model as JSON");
    Input y;
    try {
        y.model = equilibria::read_model(c.file);
    } catch (const std::exception& error) {
        const std::string what = error.what();
        support::refuse(what.starts_with("path = ") ? what : c.file + ": " + what);
    }
    y.file = c.file;
    y.p = y.model.values;
    for (const std::string& part : split(c.fixed, ',')) {
        const std::size_t equal = part.find('=');
        const auto value = equal == part.npos ? std::nullopt : support::parsed(part.substr(equal + 1));
        if (!value || !std::isfinite(*value))
            support::fail("--set", support::shown(part), "must be NAME=VALUE, commas between, finite");
        y.p[number_of(y.model.parameters, "--set", part.substr(0, equal))] = *value;
    }
    return y;
}

Varied varied(const Input& input, const std::string& option, const std::string& text) {
    const std::string allowed = "must be NAME=LOW:HIGH, finite, with LOW < HIGH";
    const std::size_t equal = text.find('=');
    if (text.empty() || equal == text.npos) support::fail(option, support::shown(text), allowed);
    const auto ends = split(text.substr(equal + 1), ':');
    const auto low = ends.size() == 2 ? support::parsed(ends[0]) : std::nullopt,
               high = ends.size() == 2 ? support::parsed(ends[1]) : std::nullopt;
    if (!low || !high || !std::isfinite(*low) || !std::isfinite(*high) || !(*low < *high))
        support::fail(option, support::shown(text), allowed);
    const std::string name = text.substr(0, equal);
    return {number_of(input.model.parameters, option, name), name, *low, *high};
}

void print_names(const FormulaModel& model) {
    for (const std::string& name : unknowns(model)) std::printf("%13s", name.c_str());
}
void print_unknowns(const FormulaModel& model, const RuntimeArray<double>& q) {
    for (int u = 0; u < q.size(); ++u) {
        const double x = q[u] + 0.0, size = std::abs(x);
        const bool fixed = static_cast<std::size_t>(u) < model.angles.size() || x == 0 || (size >= 1e-6 && size < 1e3);
        std::printf(fixed ? "%13.8f" : "%13.5e", x);
    }
}
std::string in_words(const Input& input) {
    std::ostringstream out;
    out.precision(10);
    out << (input.model.name.empty() ? "Model" : input.model.name);
    for (int k = 0; k < input.p.size(); ++k)
        out << (k == 0 ? ": " : ", ") << input.model.parameters[static_cast<std::size_t>(k)] << " = " << input.p[k];
    return out.str();
}

}  // namespace commands
