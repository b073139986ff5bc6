// Every event of a rotating chain as it turns faster: the angular speeds at which equilibria are born, merge or change
// their index, with the equilibria between them counted. A table for people, JSON for programs.
//
//   equilibrium_events --links 2 --lengths 1,1.5 --masses .6,.4 --omega 0:5
//   equilibrium_events --links 3 --omega 0:20 --threads 2 --prove --json events.json
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <equilibria/enumerate/prove.hpp>
#include <equilibria/io/results/line_events_output.hpp>
#include <equilibria/io/results/proof_output.hpp>
#include <equilibria/locus/line/line_events_at_run_time.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/joined.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/progress_bar.hpp"

namespace {

using equilibria::Json;
using equilibria::mechanisms::RuntimeRotatingChain;
using support::joined;

constexpr int most_links = equilibria::most_angles;

struct Chain {
    std::vector<double> lengths, masses;
    double gravity;
};

struct Options {
    double low, high;  // of omega
    std::uint64_t seed;
    unsigned threads;
    std::function<void(std::uint64_t done, std::uint64_t all)> progress;
    bool prove;
};

/// What the command line says.
struct Command {
    int links = 2;
    Chain chain{{}, {}, 1};
    Options options{.low = 0, .high = 10, .seed = 1, .threads = 1, .progress = {}, .prove = false};
    std::optional<support::OutputFile> json;
};

Command read(int argc, char** argv) {
    Command c;
    support::List lengths, masses;
    support::Range omega{0, 10};
    support::CommandLine app{
        "Every event of a chain of massless links with point masses, hanging in a plane that turns about the vertical "
        "through its first joint (Baillieul, equations 3.1): all angular speeds of a segment at which equilibria are "
        "born, "
        "merge or change their index, and the equilibria between them by index."};
    app.add_option("--links", c.links,
                   "number of links, 1 to 16 (default 2); two, three and four have 48, 288 and 1,536 paths, four take "
                   "seconds")
        .transform(support::integer(1, most_links));
    app.add_option("--lengths", lengths,
                   "length of each link, positive, commas between (default: 1 + i/10, i = 1, 2, ..)")
        .transform(support::positive_list([&c] { return c.links; }));
    app.add_option("--masses", masses,
                   "mass at the end of each link, positive, commas between (default: 1 + i^2/20, i = 1, 2, ..)")
        .transform(support::positive_list([&c] { return c.links; }));
    app.add_option("--omega", omega, "the range of the angular speed, radians a unit of time (default 0:10)")
        .transform(support::range("must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e6));
    app.add_option("--gravity", c.chain.gravity, "acceleration due to gravity, positive (default 1)")
        .transform(support::positive());
    app.add_seed(c.options.seed, "of the random start systems, an integer (default 1)");
    app.add_threads(c.options.threads, "1 to 1024, 0 for one each core (default 1); does not change the result");
    app.add_flag("--prove", c.options.prove,
                 "prove the equilibria in the middle of each interval, and that none is missing there");
    support::add_output(app, "--json", c.json, "write JSON to this file, or to stdout for -, instead of a table");
    app.parse("equilibrium_events", argc, argv);

    for (int i = 1; i <= c.links; ++i) {
        c.chain.lengths.push_back(1 + i / 10.0);
        c.chain.masses.push_back(1 + i * i / 20.0);
    }
    if (app.given("--lengths")) c.chain.lengths = lengths.values;
    if (app.given("--masses")) c.chain.masses = masses.values;
    c.options.low = omega.low;
    c.options.high = omega.high;
    return c;
}

/// Whether a pitchfork is supercritical: its pair lives where the branch has one more negative eigenvalue. The energy
/// along the null vector is slope (omega - omega_c) x^2 / 2 + fourth x^4 / 24. Nothing where one of them is next to 0.
std::optional<bool> supercritical(const Chain& chain, double omega, double slope, double fourth) {
    double size = 0, reach = 0;
    for (std::size_t k = 0; k < chain.lengths.size(); ++k) {
        reach += chain.lengths[k];
        size += chain.masses[k] * reach * (chain.gravity + omega * omega * reach);
    }
    if (!(std::abs(fourth) > 1e-9 * size && std::abs(slope) * omega > 1e-9 * size)) return {};
    return fourth > 0;
}

/// The equilibria in the middle of each interval, proved: each gets a "proof", with "proved": that its table is the one
/// of its middle, complete, and each index as it was counted.
void add_proofs(Json& out, const RuntimeRotatingChain& model,
                const equilibria::LineEvents<equilibria::RuntimeUnknowns>& found, equilibria::RuntimeArray<double> p,
                const equilibria::RunOptions& how) {
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t k = 0; k < found.intervals.size(); ++k) {
        const auto& interval = found.intervals[k];
        p[2 * model.links] = interval.at;
        const auto proof = equilibria::prove(model, equilibria::enumerate(model, p, how), {.executor = how.executor});
        auto& json = out["intervals"][k]["proof"] = equilibria::json_of(proof);
        json["proved"] = proof.complete && proof.contradictions == 0 && proof.by_index == interval.by_index;
    }
    out["proving_seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// LineEvents as a document. Of pitchforks also "supercritical"; nothing where that cannot be told.
Json chain_events(const Chain& chain, const Options& options) {
    const RuntimeRotatingChain model{static_cast<int>(chain.lengths.size())};
    const int omega = 2 * model.links;
    equilibria::RuntimeArray<double> p(model.parameters());
    std::copy(chain.lengths.begin(), chain.lengths.end(), p.begin());
    std::copy(chain.masses.begin(), chain.masses.end(), p.begin() + model.links);
    p[omega] = options.low;
    p[omega + 1] = chain.gravity;
    equilibria::RunOptions how{
        .seed = options.seed, .executor = equilibria::threads(options.threads), .progress = options.progress};
    const auto found = equilibria::find_events(model, p, omega, {options.low, options.high}, how);

    auto out = equilibria::json_of(found, "omega");
    for (std::size_t k = 0; k < found.events.size(); ++k) {
        const auto& e = found.events[k];
        if (e.kind != equilibria::CriticalKind::pitchfork) continue;
        if (const auto so = supercritical(chain, e.value, e.slope, e.reduced.fourth))
            out["events"][k]["supercritical"] = *so;
    }
    how.progress = nullptr;
    if (options.prove) add_proofs(out, model, found, p, how);
    return out;
}

std::size_t proved(const Json& intervals) {
    return static_cast<std::size_t>(std::count_if(intervals.begin(), intervals.end(), [](const Json& i) {
        return i.contains("proof") && i["proof"]["proved"].get<bool>();
    }));
}

Json document(const Chain& chain, const Options& options, const Json& found) {
    Json out{{"links", chain.lengths.size()},
             {"lengths", chain.lengths},
             {"masses", chain.masses},
             {"gravity", chain.gravity},
             {"omega", {options.low, options.high}},
             {"seed", options.seed}};
    equilibria::add_keys(out, found);
    for (auto& e : out["events"]) e["where"] = e["angles"];  // the name of before
    if (options.prove) {
        out["proved_intervals"] = proved(out["intervals"]);
        out["proved_share"] =
            static_cast<double>(proved(out["intervals"])) / static_cast<double>(out["intervals"].size());
    }
    return out;
}

void print_event(const Json& e) {
    std::string what = e["kind"];
    if (e.contains("supercritical")) what += e["supercritical"] ? ", supercritical" : ", subcritical";
    std::printf("%-16.14g  %-25s", e["omega"].get<double>(), what.c_str());
    for (const double angle : e["angles"]) std::printf(" %10.6f", angle);
    std::printf("\n");
}

void print(const Chain& chain, const Options& options, const Json& found) {
    std::printf("Rotating chain: lengths %s, masses %s, gravity %g, omega from %g to %g\n\n",
                joined(chain.lengths).c_str(), joined(chain.masses).c_str(), chain.gravity, options.low, options.high);
    std::printf("omega             event                      angles from the hanging vertical, radians\n");
    const auto &events = found["events"], &intervals = found["intervals"];
    std::size_t next = 0;
    for (std::size_t k = 0; k <= intervals.size(); ++k) {
        for (; next < events.size() && events[next]["interval"] == k; ++next) print_event(events[next]);
        if (k == intervals.size()) break;
        const auto& i = intervals[k];
        const bool with_proof = i.contains("proof"), holds = with_proof && i["proof"]["proved"].get<bool>();
        std::printf("    %llu equilibria, by index %s%s%s\n", i["count"].get<unsigned long long>(),
                    joined(i["by_index"].get<std::vector<std::int64_t>>()).c_str(), holds ? ", proved" : "",
                    i["clean"] ? "" : ", NOT CLEAN");
        if (with_proof && !holds)
            std::printf("    Not proved at omega %.14g: %s.\n", i["at"].get<double>(),
                        i["proof"]["reason"].get<std::string>().c_str());
    }
    std::printf("\n%s: %s.\n", found["complete"] ? "All events" : "NOT COMPLETE",
                found["argument"].get<std::string>().c_str());
    if (options.prove)
        std::printf("The equilibria in the middle of %zu of %zu intervals are proved, %.3g s.\n", proved(intervals),
                    intervals.size(), found["proving_seconds"].get<double>());
    std::printf("%.3g s\n", found["seconds"].get<double>());
}

}  // namespace

int main(int argc, char** argv) {
    Command c = read(argc, argv);
    std::optional<support::ProgressBar> bar("tracking");
    std::uint64_t critical_paths = 0;
    c.options.progress = [&](std::uint64_t done, std::uint64_t all) {
        if (critical_paths == 0) critical_paths = all;
        if (all == critical_paths) bar->update(done, all);  // not the enumerations between the events, which are short
    };
    try {
        const Json found = chain_events(c.chain, c.options);
        bar.reset();
        if (c.json) c.json->write(equilibria::json_text(document(c.chain, c.options, found)));
        if (!to_stdout(c.json)) print(c.chain, c.options, found);
    } catch (const std::exception& error) {
        bar.reset();
        std::fprintf(stderr, "equilibrium_events: %s\n", error.what());
        return 1;
    }
}

// clang-format off
/* Refused:
--links 0
    equilibrium_events: --links 0: must be an integer from 1 to 16
--links 17
    equilibrium_events: --links 17: must be an integer from 1 to 16
--links 2.5
    equilibrium_events: --links 2.5: must be an integer from 1 to 16
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
