// Every event of a rotating chain as it turns faster: the angular speeds at which equilibria are born, merge or change
// their index, with the equilibria between them counted. A table for people, JSON for programs.
//
//   equilibrium_events --links 2 --lengths 1,1.5 --masses .6,.4 --omega 0:5
//   equilibrium_events --links 3 --omega 0:20 --threads 2 --prove --json events.json
#include "equilibrium_events/events.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "support/command_line.hpp"
#include "support/links.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/progress_bar.hpp"

namespace {

using Json = nlohmann::ordered_json;

using support::joined;

ChainEvents find(int links, const Chain& chain, const Options& options) {
    return support::for_links<most_links, ChainEvents>(
        links, [&](auto n) { return chain_events<n>(chain, options); });
}

std::size_t proved(const ChainEvents& r) {
    return static_cast<std::size_t>(std::count_if(r.intervals.begin(), r.intervals.end(),
                                                  [](const auto& i) { return i.proof && i.proof->proved; }));
}

std::string json(const Chain& chain, const Options& options, const ChainEvents& r) {
    Json out{{"links", chain.lengths.size()},
             {"lengths", chain.lengths},
             {"masses", chain.masses},
             {"gravity", chain.gravity},
             {"omega", {options.low, options.high}},
             {"seed", options.seed},
             {"events", Json::array()},
             {"intervals", Json::array()}};
    // null beyond an end of the segment
    const auto table = [&](std::size_t k) { return k < r.intervals.size() ? Json(r.intervals[k].by_index) : Json(); };
    for (const auto& e : r.events) {
        out["events"].push_back({{"omega", e.omega},
                                 {"kind", e.kind},
                                 {"where", e.angles},
                                 {"null_vector", e.null_vector},
                                 {"before", table(e.interval - 1)},
                                 {"after", table(e.interval)},
                                 {"interval", e.interval},
                                 {"residual", e.residual},
                                 {"correction", e.correction},
                                 {"third_derivative", e.third},
                                 {"fourth_derivative", e.fourth},
                                 {"slope", e.slope}});
        if (e.supercritical) out["events"].back()["supercritical"] = *e.supercritical;
    }
    for (const auto& i : r.intervals) {
        out["intervals"].push_back({{"low", i.low},
                                    {"high", i.high},
                                    {"at", i.at},
                                    {"count", i.count},
                                    {"by_index", i.by_index},
                                    {"clean", i.clean}});
        if (const auto& p = i.proof)
            out["intervals"].back()["proof"] = {{"proved", p->proved}, {"complete", p->complete},
                                                {"reason", p->reason}, {"distinct", p->distinct},
                                                {"real", p->real},     {"undecided", p->undecided},
                                                {"index", p->index},   {"contradictions", p->contradictions}};
    }
    if (options.prove) {
        out["proved_intervals"] = proved(r);
        out["proved_share"] = static_cast<double>(proved(r)) / static_cast<double>(r.intervals.size());
        out["proving_seconds"] = r.proving_seconds;
    }
    out["paths"] = {{"total", r.paths.total},       {"finite", r.paths.finite}, {"at_infinity", r.paths.at_infinity},
                    {"singular", r.paths.singular}, {"failed", r.paths.failed}, {"attempts", r.attempts}};
    out["complex_solutions"] = r.complex_solutions;
    out["regular_solutions"] = r.regular_solutions;
    out["pitchfork_paths"] = r.pitchfork_paths;
    out["other_singular"] = r.other_singular;
    out["unexplained"] = r.unexplained;
    out["wrong_tables"] = r.wrong_tables;
    out["unclean"] = r.unclean;
    out["argument"] = r.argument;
    out["complete"] = r.complete;
    out["solve_seconds"] = r.solve_seconds;
    out["seconds"] = r.seconds;
    return out.dump(2) + "\n";
}

void print(const Chain& chain, const Options& options, const ChainEvents& r) {
    std::printf("Rotating chain: lengths %s, masses %s, gravity %g, omega from %g to %g\n\n",
                joined(chain.lengths).c_str(), joined(chain.masses).c_str(), chain.gravity, options.low, options.high);
    std::printf("omega             event                      angles from the hanging vertical, radians\n");
    std::size_t next = 0;
    for (std::size_t k = 0; k <= r.intervals.size(); ++k) {
        for (; next < r.events.size() && r.events[next].interval == k; ++next) {
            const auto& e = r.events[next];
            std::string what = e.kind;
            if (e.supercritical) what += *e.supercritical ? ", supercritical" : ", subcritical";
            std::printf("%-16.14g  %-25s", e.omega, what.c_str());
            for (const double angle : e.angles) std::printf(" %10.6f", angle);
            std::printf("\n");
        }
        if (k == r.intervals.size()) break;
        const auto& i = r.intervals[k];
        std::printf("    %llu equilibria, by index %s%s%s\n", static_cast<unsigned long long>(i.count),
                    joined(i.by_index).c_str(), i.proof && i.proof->proved ? ", proved" : "",
                    i.clean ? "" : ", NOT CLEAN");
        if (i.proof && !i.proof->proved)
            std::printf("    Not proved at omega %.14g: %s.\n", i.at, i.proof->reason.c_str());
    }
    std::printf("\n%s: %s.\n", r.complete ? "All events" : "NOT COMPLETE", r.argument.c_str());
    if (options.prove)
        std::printf("The equilibria in the middle of %zu of %zu intervals are proved, %.3g s.\n", proved(r),
                    r.intervals.size(), r.proving_seconds);
    std::printf("%.3g s\n", r.seconds);
}

}  // namespace

int main(int argc, char** argv) {
    std::string links = "2", lengths, masses, omega = "0:10", gravity = "1", seed = "1", threads = "1", json_name;
    bool prove = false;
    CLI::App app{
        "Every event of a chain of massless links with point masses, hanging in a plane that turns about the vertical "
        "through its first joint (Baillieul, equations 3.1): all angular speeds of a segment at which equilibria are "
        "born, "
        "merge or change their index, and the equilibria between them by index."};
    app.add_option("--links", links, "number of links, 1 to 4 (default 2); four take a minute");
    app.add_option("--lengths", lengths,
                   "length of each link, positive, commas between (default: 1 + i/10, i = 1, 2, ..)");
    app.add_option("--masses", masses,
                   "mass at the end of each link, positive, commas between (default: 1 + i^2/20, i = 1, 2, ..)");
    app.add_option("--omega", omega, "the range of the angular speed, radians a unit of time (default 0:10)");
    app.add_option("--gravity", gravity, "acceleration due to gravity, positive (default 1)");
    app.add_option("--seed", seed, "of the random start systems, an integer (default 1)");
    app.add_option("--threads", threads, "1 to 1024, 0 for one each core (default 1); does not change the result");
    app.add_flag("--prove", prove,
                 "prove the equilibria in the middle of each interval, and that none is missing there");
    app.add_option("--json", json_name, "write JSON to this file, or to stdout for -, instead of a table");
    support::parse(app, "equilibrium_events", argc, argv);

    const int n = support::integer("--links", links, 1, most_links);
    const auto list = [&](const char* option, const std::string& text, const auto& by_default) {
        if (app.count(option) > 0) return support::positive_list(option, text, n);
        std::vector<double> values;
        for (int i = 1; i <= n; ++i) values.push_back(by_default(i));
        return values;
    };
    const Chain chain{
        list("--lengths", lengths, [](int i) { return 1 + i / 10.0; }),
        list("--masses", masses, [](int i) { return 1 + i * i / 20.0; }),
        support::number("--gravity", gravity, "must be a positive number", [](double g) { return g > 0; })};
    const auto range = support::range("--omega", omega, "must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6);
    std::optional<support::ProgressBar> bar("tracking");
    std::uint64_t critical_paths = 0;
    const auto progress = [&](std::uint64_t done, std::uint64_t all) {
        if (critical_paths == 0) critical_paths = all;
        if (all == critical_paths) bar->update(done, all);  // not the enumerations between the events, which are short
    };
    const Options options{range.low,
                          range.high,
                          support::integer<std::uint64_t>("--seed", seed, 0, UINT64_MAX),
                          support::integer<unsigned>("--threads", threads, 0, 1024),
                          progress,
                          prove};
    std::optional<support::OutputFile> file;
    if (app.count("--json") > 0) file.emplace("--json", json_name);
    try {
        const ChainEvents result = find(n, chain, options);
        bar.reset();
        if (file) file->write(json(chain, options, result));
        if (!file || !file->to_stdout()) print(chain, options, result);
    } catch (const std::exception& error) {
        bar.reset();
        std::fprintf(stderr, "equilibrium_events: %s\n", error.what());
        return 1;
    }
}

// clang-format off
/* Refused:
--links 0
    equilibrium_events: --links 0: must be an integer from 1 to 4
--links 5
    equilibrium_events: --links 5: must be an integer from 1 to 4
--links 2.5
    equilibrium_events: --links 2.5: must be an integer from 1 to 4
--links
    equilibrium_events: --links: must be followed by a value
--links 2 --links 3
    equilibrium_events: --links: must be given once only
--lengths 1,-2
    equilibrium_events: --lengths 1,-2: must be 2 positive numbers, with commas between
--links 3 --masses 0,1,1
    equilibrium_events: --masses 0,1,1: must be 3 positive numbers, with commas between
--links 1 --masses inf
    equilibrium_events: --masses inf: must be 1 positive number
--omega 3
    equilibrium_events: --omega 3: must be LOW:HIGH, finite, with 0 <= LOW < HIGH
--omega 5:2
    equilibrium_events: --omega 5:2: must be LOW:HIGH, finite, with 0 <= LOW < HIGH
--omega 2:2
    equilibrium_events: --omega 2:2: must be LOW:HIGH, finite, with 0 <= LOW < HIGH
--omega -1:2
    equilibrium_events: --omega -1:2: must be LOW:HIGH, finite, with 0 <= LOW < HIGH
--omega 0:inf
    equilibrium_events: --omega 0:inf: must be LOW:HIGH, finite, with 0 <= LOW < HIGH
--gravity 0
    equilibrium_events: --gravity 0: must be a positive number
--gravity nan
    equilibrium_events: --gravity nan: must be a positive number
--seed -1
    equilibrium_events: --seed -1: must be an integer from 0 to 18446744073709551615
--threads 1025
    equilibrium_events: --threads 1025: must be an integer from 0 to 1024
--json missing/folder.json
    equilibrium_events: --json missing/folder.json: cannot be written (No such file or directory); must be a file that can, or -
--json good.json --gravity -1
    equilibrium_events: --gravity -1: must be a positive number
--speed 2
    equilibrium_events: --speed: is not an option; --help lists them
*/
