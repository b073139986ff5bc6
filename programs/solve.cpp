// Every isolated complex root of a system of polynomials, from a file in PHCpack's or Bertini's format: a table for
// people, JSON for programs.
//
//   solve katsura5.txt
//   solve cyclic6.txt --prove --threads 2 --json roots.json
//   solve eigenproblem.bertini --start multihomogeneous --real
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <equilibria/io/results/every_root_output.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/paths/predicted_work.hpp>
#include <equilibria/run/threads.hpp>

#include "solve/solution.hpp"
#include "support/interrupt.hpp"
#include "support/joined.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/progress_bar.hpp"
#include "support/ranks.hpp"

namespace {

using equilibria::Json;
using support::joined;

/// What the command line says.
struct Command {
    std::string file, format = "auto";
    std::optional<equilibria::StartKind> start;
    bool prove = true, real = false;
    std::uint64_t seed = 1;
    unsigned threads = 1;
    double limit = 0;
    std::optional<support::OutputFile> json;
};

std::string name_of(equilibria::StartKind start) {
    for (const auto& [own, name] : solve::starts)
        if (own == start) return std::string(name);
    return {};
}

Command read(int argc, char** argv) {
    Command c;
    std::vector<std::string> starts{"auto"};
    std::string listed = "must be auto";
    for (const auto& [start, name] : solve::starts) {
        starts.emplace_back(name);
        listed += (start == solve::starts.back().start ? " or " : ", ") + std::string(name);
    }
    support::CommandLine app{
        "Every isolated complex root of a system of polynomials with as many equations as unknowns and real "
        "coefficients, read from FILE in the format of PHCpack or of Bertini."};
    app.add_option("FILE", c.file, "the system").transform(support::name_of("a file"));
    app.add_option("--format", c.format, "phcpack or bertini (default auto: PHCpack's files begin with a number)")
        .transform(support::one_of({"auto", "phcpack", "bertini"}, "must be auto, phcpack or bertini"));
    app.add_option_function(
           "--start",
           [&c](const std::string& text) {
               for (const auto& [start, name] : solve::starts)
                   if (name == text) c.start = start;
           },
           "total-degree; multihomogeneous: with the groups of unknowns that need the fewest paths, of those "
           "compared and those of Bertini's file; polyhedral: as many paths as the mixed volume, in two stages; "
           "or monodromy: all roots from one, by loops of the constants, which is no proof (default auto: that of the "
           "least predicted cost, never monodromy)")
        .transform(support::one_of(starts, listed));
    bool no_proof = false, asked = false;
    app.add_flag("--no-proof", no_proof, "track paths alone: no root is proved, and nothing is said of completeness");
    app.add_flag("--prove", asked, "prove each root, and explain every path (the default)");
    app.add_flag("--real", c.real, "give the real roots alone; what is counted stays the same");
    app.add_seed(c.seed, "of the random start system, an integer (default 1); the same seed, the same result");
    app.add_threads(c.threads, "1 to 1024, 0 for one each core (default 1); does not change the result");
    app.add_limit(c.limit, "seconds after which the run ends with what is found, with status 124 (default: none)");
    support::add_output(app, "--json", c.json, "write JSON to this file, or to stdout for -, instead of a table");
    app.parse("solve", argc, argv);
    c.prove = !no_proof;
    if (!app.given("FILE")) support::fail("FILE", "", "must be given: a system in the format of PHCpack or of Bertini");
    return c;
}

solve::Input read_input(const Command& c) {
    try {
        return solve::read(c.file, c.format);
    } catch (const std::exception& error) {
        const std::string what = error.what();
        support::refuse(what.starts_with("path = ") ? what : c.file + ": " + what);
    }
}

Json bound_json(const equilibria::PathCount& bound) { return bound.saturated ? Json(nullptr) : Json(bound.value); }

Json document(const Command& c, const solve::Input& input, const equilibria::EveryRoot& s) {
    Json out{{"file", c.file},
             {"format", input.format},
             {"seed", c.seed},
             {"threads", c.threads},
             {"unknowns", input.variables},
             {"total_degree", bound_json(s.start.bounds.total_degree)},
             {"multihomogeneous", bound_json(s.start.bounds.multihomogeneous)},
             {"grouping", s.start.bounds.grouping},
             {"mixed_volume", s.start.bounds.mixed_volume ? Json(*s.start.bounds.mixed_volume) : Json(nullptr)},
             {"start", name_of(s.start.kind)},
             {"start_reason", s.start.why}};
    if (!s.found.caution.empty()) out["caution"] = s.found.caution;
    Json found = equilibria::json_of(s, input.variables), roots = Json::array();
    for (auto& root : found["roots"])
        if (!c.real || root["real"]) roots.push_back(std::move(root));
    found.erase("roots");
    equilibria::add_keys(out, found);
    out["roots"] = std::move(roots);
    return out;
}

unsigned long long count(const Json& value) { return value.get<unsigned long long>(); }

/// An unknown of a root; its imaginary part unless the root is real or it is rounding beside the real part.
std::string shown(const Json& z, bool real) {
    const double re = z[0], im = z[1];
    char text[64];
    if (real || std::abs(im) <= 5e-9 * std::abs(re))
        std::snprintf(text, sizeof text, "%.8g", re);
    else
        std::snprintf(text, sizeof text, "%.8g%+.8gi", re, im);
    return text;
}

void print_roots(const Json& r) {
    std::vector<std::size_t> width;
    for (const std::string name : r["unknowns"]) {
        std::size_t most = name.size();
        for (const auto& root : r["roots"]) most = std::max(most, shown(root["unknowns"][name], root["real"]).size());
        width.push_back(most);
        std::printf(" %*s ", static_cast<int>(most), name.c_str());
    }
    std::printf(" residual  condition\n");
    for (const auto& root : r["roots"]) {
        std::size_t u = 0;
        for (const auto& z : root["unknowns"])
            std::printf(" %*s ", static_cast<int>(width[u++]), shown(z, root["real"]).c_str());
        std::printf(" %-8.1e  %.1e", root["residual"].get<double>(), root["condition"].get<double>());
        if (root["singular"])
            std::printf("  %s, multiplicity %d", root["multiplicity_proved"] ? "singular" : "singular, UNDECIDED",
                        root["multiplicity"].get<int>());
        else if (root.contains("certificate"))
            std::printf("  %s", root["certificate"]["exists"]
                                    ? ("proved, " + root["certificate"]["reality"].get<std::string>()).c_str()
                                    : "UNDECIDED");
        std::printf("\n");
    }
}

/// The groups of unknowns as "{x y} {z}".
std::string groups(const Json& r) {
    std::string text;
    for (std::size_t g = 0;; ++g) {
        std::vector<std::string> members;
        for (std::size_t u = 0; u < r["grouping"].size(); ++u)
            if (r["grouping"][u] == g) members.push_back(r["unknowns"][u]);
        if (members.empty()) return text;
        text += (g > 0 ? " {" : "{") + joined(members) + "}";
    }
}

/// What must be said of the count of roots; the verdict comes last.
void print_verdicts(const Json& r) {
    if (r.contains("caution")) std::printf("NO PROOF: %s\n", r["caution"].get<std::string>().c_str());
    if (r.contains("proved_distinct"))
        std::printf("%llu distinct roots proved, %llu real, %llu non-real, %llu undecided\n",
                    count(r["proved_distinct"]), count(r["proved_real"]), count(r["proved_non_real"]),
                    count(r["undecided"]));
    std::map<std::string, std::uint64_t> without_degree;  // no walk joined them: they may be one
    for (const auto& family : r["families"]) {
        const auto kind = family["kind"].get<std::string>();
        if (family["degree"].is_null())
            ++without_degree[kind];
        else
            std::printf("beside them: %s, degree %llu\n", kind.c_str(), count(family["degree"]));
    }
    for (const auto& [kind, times] : without_degree)
        std::printf("beside them: %s%s\n", times == 1 ? "" : ("at most " + std::to_string(times) + " times ").c_str(),
                    kind.c_str());
    for (const auto& away : r["directions_at_infinity"])
        std::printf("to infinity: %llu paths along %s, to roots of its face system (residual %.0e)\n",
                    count(away["paths"]), away["direction"].get<std::string>().c_str(), away["residual"].get<double>());
    std::printf("%s\n", r["verdict"].get<std::string>().c_str());
}

std::string number(const Json& bound) { return bound.is_null() ? "more than 2^62" : std::to_string(count(bound)); }

void print(const Json& r) {
    std::printf("%s, %s's format, unknowns %s\n", r["file"].get<std::string>().c_str(),
                r["format"].get<std::string>().c_str(), joined(std::vector<std::string>(r["unknowns"])).c_str());
    std::printf("total degree %s, multihomogeneous %s with %s, mixed volume %s\n", number(r["total_degree"]).c_str(),
                number(r["multihomogeneous"]).c_str(), groups(r).c_str(), number(r["mixed_volume"]).c_str());
    std::printf("start: %s, %s\n\n", r["start"].get<std::string>().c_str(),
                r["start_reason"].get<std::string>().c_str());
    print_roots(r);
    std::printf("\n%llu paths: %llu finite, %llu at infinity, %llu singular, %llu failed; %llu tracked again\n",
                count(r["paths"]), count(r["finite"]), count(r["at_infinity"]), count(r["singular"]),
                count(r["failed"]), count(r["retracked"]));
    std::printf("%.3g s, %.3g s of it tracking\n", r["seconds"].get<double>(), r["tracking_seconds"].get<double>());
    print_verdicts(r);
}

std::string in_seconds(double seconds) {
    char text[64];
    if (seconds < 120)
        std::snprintf(text, sizeof text, "%.2g s", seconds);
    else if (seconds < 7200)
        std::snprintf(text, sizeof text, "%.2g minutes", seconds / 60);
    else
        std::snprintf(text, sizeof text, "%.2g hours", seconds / 3600);
    return text;
}
std::string in_bytes(double bytes) {
    char text[64];
    std::snprintf(text, sizeof text, bytes < 1e9 ? "%.2g MB" : "%.3g GB", bytes / (bytes < 1e9 ? 1e6 : 1e9));
    return text;
}
std::string number(const equilibria::PathCount& paths) {
    return paths.saturated ? "more than 2^62" : std::to_string(paths.value);
}

/// What a long run will take, on stderr.
void foretell(const Command& c, const equilibria::PredictedWork& work) {
    constexpr double from = 10;  // seconds
    if (!work.seconds || *work.seconds < from) return;
    std::fprintf(stderr, "solve: %s paths: about %s and %s are predicted%s\n", number(work.paths).c_str(),
                 in_seconds(*work.seconds).c_str(), in_bytes(work.bytes).c_str(),
                 c.limit > 0 ? "" : "; --limit SECONDS ends a run with what is found until then");
}

/// Throws where the endpoints of all paths do not fit into the memory of the machine.
void check_memory(const equilibria::PredictedWork& work) {
    const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    if (work.bytes <= memory) return;
    throw std::length_error(number(work.paths) + " paths would take " +
                            (work.paths.saturated ? "too much memory" : in_bytes(work.bytes)) + ", and there are " +
                            in_bytes(memory) + ": the system must have fewer paths, or another --start");
}

}  // namespace

int main(int argc, char** argv) {
    const auto ranks = support::ranks(&argc, &argv);
    const Command c = read(argc, argv);
    const solve::Input input = read_input(c);
    std::optional<support::ProgressBar> bar("tracking");
    const support::TimeLimit limit(c.limit);
    try {
        const auto solution =
            solve::solve(input, c.start, c.prove,
                         {.seed = c.seed,
                          .executor = equilibria::threads(c.threads),
                          .ranks = ranks,
                          .progress = [&](std::uint64_t done, std::uint64_t all) { bar->update(done, all); },
                          .cancel = &support::cancelled_by_signal()},
                         [&](const equilibria::PredictedWork& work) {
                             check_memory(work);
                             if (ranks.first()) foretell(c, work);
                         });
        bar.reset();
        if (!ranks.first()) return 0;
        const Json result = document(c, input, solution);
        if (c.json) c.json->write(equilibria::json_text(result));
        if (!to_stdout(c.json)) print(result);
        if (solution.verdict.completeness == equilibria::Completeness::open && support::stopped_status() != 0)
            return support::say_stopped("solve", "the result is what was found until then");
    } catch (const std::exception& error) {
        bar.reset();
        if (ranks.first()) std::fprintf(stderr, "solve: %s\n", error.what());
        return 1;
    }
}

// clang-format off
/* Refused:
--seed 1
    solve: FILE: must be given: a system in the format of PHCpack or of Bertini
missing.txt
    solve: path = "missing.txt": must be a file that can be read: No such file or directory
missing.txt --start julia
    solve: --start julia: must be auto, total-degree, multihomogeneous, polyhedral or monodromy
missing.txt --format julia
    solve: --format julia: must be auto, phcpack or bertini
missing.txt --threads -1
    solve: --threads -1: must be an integer from 0 to 1024
missing.txt other.txt
    solve: other.txt: is not an option; --help lists them
*/
