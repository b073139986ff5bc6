// Every equilibrium of a rotating chain, Baillieul's equations (3.1): a table for people, JSON for programs.
//
//   rotating_chain --links 2 --lengths 1,1.5 --masses .7,.3 --omega 2
//   rotating_chain --links 6 --omega 1.7 --threads 2 --json equilibria.json
//   rotating_chain --links 3 --prove --digits 100
//   rotating_chain --links 8 --checkpoint chain.ckpt    (after Ctrl-C, or worse, the same command goes on)
//   mpirun -n 4 rotating_chain --links 10 --checkpoint chain.ckpt    (built with MPI: docs/scale.md)
#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/certify/refine_root.hpp>
#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/enumerate/stream.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/results/proof_output.hpp>
#include <equilibria/io/results/root_set_output.hpp>
#include <equilibria/io/results/streamed_roots_output.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/storage/locked_file.hpp>

#include "support/interrupt.hpp"
#include "support/joined.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/progress_bar.hpp"
#include "support/ranks.hpp"

namespace {

using equilibria::Json;
using equilibria::mechanisms::RuntimeRotatingChain;
using support::joined;

constexpr int most_links = equilibria::most_angles;

struct Chain {
    std::vector<double> lengths, masses;
    double omega, gravity;
};

struct Options {
    std::uint64_t seed;
    unsigned threads;
    equilibria::Ranks ranks;
    std::function<void(std::uint64_t done, std::uint64_t all)> progress;
    std::string checkpoint;
    const std::atomic<bool>* cancel;
    bool prove;
    int digits;   // 0: none
    bool counts;  // alone
};

/// What the command line says.
struct Command {
    int links = 2;
    Chain chain{{}, {}, 2, 1};
    Options options{.seed = 1,
                    .threads = 1,
                    .ranks = {},
                    .progress = {},
                    .checkpoint = {},
                    .cancel = nullptr,
                    .prove = false,
                    .digits = 0,
                    .counts = false};
    std::optional<support::OutputFile> json;
};

Command read(int argc, char** argv) {
    Command c;
    support::List lengths, masses;
    support::CommandLine app{
        "Every equilibrium of a chain of massless links with point masses, hanging in a plane that turns about the "
        "vertical through its first joint (Baillieul, equations 3.1), with its index: the number of directions in "
        "which it is unstable."};
    app.add_option(
           "--links", c.links,
           "number of links, 1 to 16 (default 2); the memory, 450 bytes for each of the 4^links roots, sets the limit")
        .transform(support::integer(1, most_links));
    app.add_option("--lengths", lengths, "length of each link, positive, commas between (default: all 1)")
        .transform(support::positive_list([&c] { return c.links; }));
    app.add_option("--masses", masses, "mass at the end of each link, positive, commas between (default: all 1)")
        .transform(support::positive_list([&c] { return c.links; }));
    app.add_option("--omega", c.chain.omega, "angular speed, radians a unit of time (default 2)")
        .transform(support::finite());
    app.add_option("--gravity", c.chain.gravity, "acceleration due to gravity, 0 or more (default 1)")
        .transform(support::not_negative("must be a finite number, 0 or more"));
    app.add_option("--checkpoint", c.options.checkpoint,
                   "keep what is finished in this file, and go on from it if it is there already; Ctrl-C ends the "
                   "program with status 130, and the same command resumes; does not change the result")
        .transform(support::name_of("a file"));
    app.add_seed(c.options.seed, "of the random start system, an integer (default 1); the same seed, the same result");
    app.add_threads(c.options.threads, "1 to 1024, 0 for one each core (default 1); does not change the result");
    app.add_flag("--prove", c.options.prove, "prove each root, its reality and index, and that none is missing");
    app.add_option("--digits", c.options.digits, "give the angles to that many digits, 1 to 1000, with a proved error")
        .transform(support::integer(1, 1000));
    app.add_flag("--counts", c.options.counts,
                 "count the equilibria by index and keep none: roots wait in the checkpoint, which must be given, and "
                 "memory is 25 bytes for two paths");
    support::add_output(app, "--json", c.json, "write JSON to this file, or to stdout for -, instead of a table");
    app.parse("rotating_chain", argc, argv);
    if (c.options.counts) {
        if (c.options.checkpoint.empty()) support::fail("--counts", "", "needs --checkpoint FILE");
        for (const std::string other : {"--prove", "--digits"})
            if (app.given(other)) support::fail("--counts", "", "keeps no root for " + other);
    }

    const std::vector<double> ones(static_cast<std::size_t>(c.links), 1.0);
    c.chain.lengths = app.given("--lengths") ? lengths.values : ones;
    c.chain.masses = app.given("--masses") ? masses.values : ones;
    return c;
}

struct Result {
    equilibria::PathCounts paths;
    Json json;  // of the RootSet, with what is proved and the digits
};

void add_digits(Json& equilibria, const RuntimeRotatingChain& model,
                const equilibria::RootSet<equilibria::RuntimeUnknowns>& found, int digits) {
    for (std::size_t k = 0; k < found.equilibria.size(); ++k) {
        const auto& at = found.equilibria[k].q;
        equilibria::RuntimeArray<std::complex<double>> q(at.size());
        std::copy(at.begin(), at.end(), q.begin());
        const auto refined = equilibria::refine(model, q, found.parameters, digits);
        equilibria[k]["angles_in_digits"] = equilibria::json_list(refined.real);
        equilibria[k]["digits_proved"] = refined.proved;
        equilibria[k]["digits_error"] = refined.error;
    }
}

Result enumerate(const Chain& chain, const Options& options) {
    const int links = static_cast<int>(chain.lengths.size());
    const RuntimeRotatingChain model{links};
    equilibria::RuntimeArray<double> p(model.parameters());
    std::copy(chain.lengths.begin(), chain.lengths.end(), p.begin());
    std::copy(chain.masses.begin(), chain.masses.end(), p.begin() + links);
    p[2 * links] = chain.omega;
    p[2 * links + 1] = chain.gravity;
    const equilibria::RunOptions run{.seed = options.seed,
                                     .executor = equilibria::threads(options.threads),
                                     .ranks = options.ranks,
                                     .progress = options.progress,
                                     .checkpoint = options.checkpoint,
                                     .cancel = options.cancel};
    if (options.counts) {
        const auto counted = equilibria::enumerate(model, p, run, [](const auto&, const auto*) {});
        return {counted.paths, equilibria::json_of(counted)};
    }
    const auto found = equilibria::enumerate(model, p, run);
    Result result{found.paths, equilibria::json_of(found, {.roots = false})};
    auto& out = result.json;
    out["complete"] = false;
    out["reason"] = "nothing was proved: --prove was not given";
    if (options.prove) {
        const auto proof =
            equilibria::prove(model, found, {.executor = equilibria::threads(options.threads), .ranks = options.ranks});
        equilibria::add_proof(out, proof);
        equilibria::add_certificates(out["equilibria"], proof);
        // names of before
        out["bound"] = proof.bound ? proof.bound->value : 0;
        out["more_digits"] = proof.more_digits;
    }
    if (options.digits > 0) add_digits(out["equilibria"], model, found, options.digits);
    return result;
}

Json document(const Chain& chain, const Options& options, const Json& result) {
    Json out{{"links", chain.lengths.size()}, {"lengths", chain.lengths}, {"masses", chain.masses},
             {"omega", chain.omega},          {"gravity", chain.gravity}, {"seed", options.seed},
             {"threads", options.threads}};
    equilibria::add_keys(out, result);
    return out;
}

unsigned long long count(const Json& value) { return value.get<unsigned long long>(); }

void print_equilibria(const Chain& chain, const Json& equilibria) {
    const std::string heading = " angles from the hanging vertical, radians";
    const int width = std::max(static_cast<int>(heading.size()), 10 * static_cast<int>(chain.lengths.size()));
    std::printf("%-*s  index  energy          residual  condition\n", width, heading.c_str());
    for (const auto& e : equilibria) {
        std::string angles;
        for (const double angle : e["angles"]) {
            char text[32];
            std::snprintf(text, sizeof text, "%10.6f", std::abs(angle) < 5e-7 ? 0.0 : angle);
            angles += text;
        }
        std::printf("%-*s  %5d  %-14.8g  %-8.1e  %.1e%s\n", width, angles.c_str(), e["index"].get<int>(),
                    e["energy"].get<double>(), e["residual"].get<double>(), e["condition"].get<double>(),
                    e["degenerate"] ? "  degenerate" : "");
        if (e.contains("angles_in_digits"))
            for (const std::string angle : e["angles_in_digits"])
                std::printf("    %s%s\n", angle.c_str(), e["digits_proved"] ? "" : "  (not proved)");
    }
}

/// What must be said of the count of equilibria.
void print_verdicts(const Json& r) {
    const auto failed = count(r["failed"]), singular = count(r["singular"]), degenerate = count(r["degenerate"]);
    if (r["clean"]) std::printf("Each path is accounted for, each root regular and reached by a path of its own.\n");
    if (r.contains("families"))
        for (const std::string family : r["families"]) std::printf("NOT ISOLATED: %s.\n", family.c_str());
    if (const std::string alarms = r["alarms"]; !alarms.empty()) std::printf("ALARM: %s.\n", alarms.c_str());
    if (r.contains("proved_distinct")) {
        std::printf("%llu distinct roots proved, %llu real, %llu non-real, %llu undecided, %llu with their index.\n",
                    count(r["proved_distinct"]), count(r["proved_real"]), count(r["proved_non_real"]),
                    count(r["undecided"]), count(r["proved_index"]));
        std::printf("%s: %s.\n", r["complete"] ? "PROVED COMPLETE" : "Not proved complete",
                    r["reason"].get<std::string>().c_str());
    }
    if (failed > 0) std::printf("INCOMPLETE: %llu paths failed; equilibria may be missing.\n", failed);
    if (singular > 0 || degenerate > 0)
        std::printf(
            "DEGENERATE: the number of equilibria changes here, or they form curves; the numbers by index leave out "
            "the %llu degenerate ones.\n",
            degenerate);
    if (singular == 0 && failed == 0 && r["finite"] != r["distinct"])
        std::printf("INCOMPLETE: %llu paths ended on another's root.\n", count(r["finite"]) - count(r["distinct"]));
    if (r["morse_applies"] && singular == 0)
        std::printf(r["morse"] ? "The Morse relations of the torus hold.\n"
                               : "THE MORSE RELATIONS ARE VIOLATED: equilibria are missing.\n");
}

void print(const Chain& chain, const Json& r) {
    std::printf("Rotating chain: lengths %s, masses %s, omega %g, gravity %g\n\n", joined(chain.lengths).c_str(),
                joined(chain.masses).c_str(), chain.omega, chain.gravity);
    if (r.contains("equilibria")) print_equilibria(chain, r["equilibria"]), std::printf("\n");
    std::printf("%llu paths: %llu finite, %llu at infinity, %llu singular, %llu failed; %llu tracked again\n",
                count(r["paths"]), count(r["finite"]), count(r["at_infinity"]), count(r["singular"]),
                count(r["failed"]), count(r["retracked"]));
    std::printf("%llu distinct roots, %llu real", count(r["distinct"]), count(r["real"]));
    const auto& by_index = r["by_index"];
    for (std::size_t k = 0; k < by_index.size(); ++k)
        std::printf("%s index %zu: %lld", k == 0 ? ":" : ",", k, by_index[k].get<long long>());
    if (count(r["degenerate"]) > 0) std::printf(", degenerate: %llu", count(r["degenerate"]));
    std::printf("\n");
    print_verdicts(r);
    std::printf("%.3g s, %.3g s of it tracking\n", r["seconds"].get<double>(), r["tracking_seconds"].get<double>());
    if (r.contains("proving_seconds")) std::printf("%.3g s for the proofs\n", r["proving_seconds"].get<double>());
}

/// One line on stderr: how much is done, and how to go on.
int interrupted(const equilibria::PathCounts& paths, const std::string& checkpoint) {
    std::fprintf(stderr, "rotating_chain: interrupted, %llu of %llu paths are finished; %s\n",
                 static_cast<unsigned long long>(paths.total - paths.cancelled),
                 static_cast<unsigned long long>(paths.total),
                 checkpoint.empty() ? "--checkpoint FILE would have kept them"
                                    : ("the same command goes on from " + checkpoint).c_str());
    return 130;
}

}  // namespace

int main(int argc, char** argv) {
    const auto ranks = support::ranks(&argc, &argv);
    Command c = read(argc, argv);
    c.options.ranks = ranks;
    std::optional<support::ProgressBar> bar("tracking");
    c.options.progress = [&](std::uint64_t done, std::uint64_t all) { bar->update(done, all); };
    c.options.cancel = &support::cancelled_by_signal();
    try {
        const Result result = enumerate(c.chain, c.options);
        bar.reset();
        if (!ranks.first()) return result.paths.cancelled > 0 ? 130 : 0;
        if (result.paths.cancelled > 0) return interrupted(result.paths, c.options.checkpoint);
        if (c.json) c.json->write(equilibria::json_text(document(c.chain, c.options, result.json)));
        if (!to_stdout(c.json)) print(c.chain, result.json);
    } catch (const equilibria::CheckpointError& error) {
        bar.reset();
        support::fail("--checkpoint", c.options.checkpoint, error.wrong());
    } catch (const std::exception& error) {
        support::fail("command line", "", error.what());
    }
}

// clang-format off
/* Refused:
--links 0
    rotating_chain: --links 0: must be an integer from 1 to 16
--links 17
    rotating_chain: --links 17: must be an integer from 1 to 16
--links 2.5
    rotating_chain: --links 2.5: must be an integer from 1 to 16
--links
    rotating_chain: --links: must be followed by a value
--links 2 --links 3
    rotating_chain: --links: must be given once only
--lengths 1,-2
    rotating_chain: --lengths 1,-2: must be 2 positive numbers, with commas between
--lengths 1,2,3
    rotating_chain: --lengths 1,2,3: must be 2 positive numbers, with commas between
--lengths 1,,2
    rotating_chain: --lengths 1,,2: must be 2 positive numbers, with commas between
--links 3 --masses 0,1,1
    rotating_chain: --masses 0,1,1: must be 3 positive numbers, with commas between
--masses nan,1
    rotating_chain: --masses nan,1: must be 2 positive numbers, with commas between
--links 1 --masses inf
    rotating_chain: --masses inf: must be 1 positive number
--omega inf
    rotating_chain: --omega inf: must be a finite number
--omega fast
    rotating_chain: --omega fast: must be a finite number
--gravity -1
    rotating_chain: --gravity -1: must be a finite number, 0 or more
--seed -1
    rotating_chain: --seed -1: must be an integer from 0 to 18446744073709551615
--threads 1025
    rotating_chain: --threads 1025: must be an integer from 0 to 1024
--json missing/folder.json
    rotating_chain: --json missing/folder.json: cannot be written (No such file or directory); must be a file that can, or -
--json .
    rotating_chain: --json .: is a folder; must be a file that can be written
--json good.json --omega nan
    rotating_chain: --omega nan: must be a finite number
--digits 0
    rotating_chain: --digits 0: must be an integer from 1 to 1000
--digits 1001
    rotating_chain: --digits 1001: must be an integer from 1 to 1000
--counts
    rotating_chain: --counts: needs --checkpoint FILE
--counts --checkpoint chain.ckpt --prove
    rotating_chain: --counts: keeps no root for --prove
--checkpoint missing/folder.ckpt
    rotating_chain: --checkpoint missing/folder.ckpt: cannot be created (No such file or directory)
--checkpoint .
    rotating_chain: --checkpoint .: cannot be opened (Is a directory)
--checkpoint /dev/null
    rotating_chain: --checkpoint /dev/null: is not a regular file
--speed 2
    rotating_chain: --speed: is not an option; --help lists them
*/
