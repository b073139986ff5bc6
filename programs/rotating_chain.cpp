// Every equilibrium of a rotating chain, Baillieul's equations (3.1): a table for people, JSON for programs.
//
//   rotating_chain --links 2 --lengths 1,1.5 --masses .7,.3 --omega 2
//   rotating_chain --links 6 --omega 1.7 --threads 2 --json equilibria.json
//   rotating_chain --links 3 --prove --digits 100
//   rotating_chain --links 8 --checkpoint chain.ckpt    (after Ctrl-C, or worse, the same command goes on)
#include "rotating_chain/chain.hpp"

#include <signal.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <equilibria/storage/locked_file.hpp>
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

using support::joined;

ChainResult enumerate(int links, const Chain& chain, const Options& options) {
    return support::for_links<most_links, ChainResult>(
        links, [&](auto n) { return enumerate_chain<n>(chain, options); });
}

std::string json(const Chain& chain, const Options& options, const ChainResult& r) {
    nlohmann::ordered_json out{
        {"links", chain.lengths.size()},
        {"lengths", chain.lengths},
        {"masses", chain.masses},
        {"omega", chain.omega},
        {"gravity", chain.gravity},
        {"seed", options.seed},
        {"threads", options.threads},
        {"paths", r.paths.total},
        {"finite", r.paths.finite},
        {"at_infinity", r.paths.at_infinity},
        {"singular", r.paths.singular},
        {"failed", r.paths.failed},
        {"tracked", r.paths.tracked},
        {"retracked", r.paths.retracked},
        {"crossed", r.paths.crossed},
        {"steps", r.paths.steps},
        {"distinct", r.distinct},
        {"real", r.equilibria.size()},
        {"by_index", r.by_index},
        {"degenerate", r.degenerate},
        {"multiplicities", r.multiplicities},
        {"winding_numbers", r.winding_numbers},
        {"families", r.families},
        {"clean", r.clean},
        {"alarms", r.alarms},
        {"morse", r.morse},
        {"complete", r.proof && r.proof->complete},
        {"reason", r.proof ? r.proof->reason : "nothing was proved: --prove was not given"},
        {"tracking_seconds", r.tracking_seconds},
        {"seconds", r.seconds},
        {"failures", nlohmann::ordered_json::array()},
        {"equilibria", nlohmann::ordered_json::array()},
    };
    if (const auto& p = r.proof) {
        out["bound"] = p->bound;
        out["proved_distinct"] = p->distinct;
        out["proved_real"] = p->real;
        out["proved_non_real"] = p->non_real;
        out["undecided"] = p->undecided;
        out["duplicates"] = p->duplicates;
        out["proved_index"] = p->index;
        out["contradictions"] = p->contradictions;
        out["more_digits"] = p->more_digits;
        out["proving_seconds"] = p->seconds;
    }
    for (const auto& f : r.failures) out["failures"].push_back({{"path", f.path}, {"reason", f.reason}});
    for (const auto& e : r.equilibria) {
        out["equilibria"].push_back({{"angles", e.angles},
                                     {"index", e.index},
                                     {"degenerate", e.nullity > 0},
                                     {"nullity", e.nullity},
                                     {"multiplicity", e.multiplicity},
                                     {"stable", e.index == 0 && e.nullity == 0},
                                     {"energy", e.energy},
                                     {"residual", e.residual},
                                     {"condition", e.condition},
                                     {"margin", e.margin}});
        if (const auto& c = e.certificate)
            out["equilibria"].back()["certificate"] = {{"exists", c->exists},
                                                       {"distinct", c->distinct},
                                                       {"reality", name(c->reality)},
                                                       {"index_proved", c->index_proved},
                                                       {"index", c->index},
                                                       {"radius", c->radius},
                                                       {"digits", c->digits}};
        if (const auto& d = e.digits) {
            out["equilibria"].back()["angles_in_digits"] = d->angles;
            out["equilibria"].back()["digits_proved"] = d->proved;
            out["equilibria"].back()["digits_error"] = d->error;
        }
    }
    return out.dump(2) + "\n";
}

void print(const Chain& chain, const ChainResult& r) {
    std::printf("Rotating chain: lengths %s, masses %s, omega %g, gravity %g\n\n", joined(chain.lengths).c_str(),
                joined(chain.masses).c_str(), chain.omega, chain.gravity);
    const std::string heading = " angles from the hanging vertical, radians";
    const int width = std::max(static_cast<int>(heading.size()), 10 * static_cast<int>(chain.lengths.size()));
    std::printf("%-*s  index  energy          residual  condition\n", width, heading.c_str());
    for (const auto& e : r.equilibria) {
        std::string angles;
        for (const double angle : e.angles) {
            char text[32];
            std::snprintf(text, sizeof text, "%10.6f", std::abs(angle) < 5e-7 ? 0.0 : angle);
            angles += text;
        }
        std::printf("%-*s  %5d  %-14.8g  %-8.1e  %.1e%s\n", width, angles.c_str(), e.index, e.energy, e.residual,
                    e.condition, e.nullity > 0 ? "  degenerate" : "");
        if (const auto& d = e.digits)
            for (const std::string& angle : d->angles)
                std::printf("    %s%s\n", angle.c_str(), d->proved ? "" : "  (not proved)");
    }
    const auto& n = r.paths;
    const auto count = [](auto value) { return static_cast<unsigned long long>(value); };
    std::printf("\n%llu paths: %llu finite, %llu at infinity, %llu singular, %llu failed; %llu tracked again\n",
                count(n.total), count(n.finite), count(n.at_infinity), count(n.singular), count(n.failed),
                count(n.retracked));
    std::printf("%llu distinct roots, %llu real", count(r.distinct), count(r.equilibria.size()));
    for (std::size_t k = 0; k < r.by_index.size(); ++k)
        std::printf("%s index %zu: %lld", k == 0 ? ":" : ",", k, static_cast<long long>(r.by_index[k]));
    if (r.degenerate > 0) std::printf(", degenerate: %llu", count(r.degenerate));
    std::printf("\n");
    if (r.clean)
        std::printf("Each path is accounted for, each root regular and reached by a path of its own.\n");
    for (const std::string& family : r.families) std::printf("NOT ISOLATED: %s.\n", family.c_str());
    if (!r.alarms.empty()) std::printf("ALARM: %s.\n", r.alarms.c_str());
    if (const auto& p = r.proof) {
        std::printf("%llu distinct roots proved, %llu real, %llu non-real, %llu undecided, %llu with their index.\n",
                    count(p->distinct), count(p->real), count(p->non_real), count(p->undecided), count(p->index));
        std::printf("%s: %s.\n", p->complete ? "PROVED COMPLETE" : "Not proved complete", p->reason.c_str());
    }
    if (n.failed > 0) std::printf("INCOMPLETE: %llu paths failed; equilibria may be missing.\n", count(n.failed));
    if (n.singular > 0 || r.degenerate > 0)
        std::printf(
            "DEGENERATE: the number of equilibria changes here, or they form curves; the numbers by index leave out "
            "the "
            "%llu degenerate ones.\n",
            count(r.degenerate));
    if (n.singular == 0 && n.failed == 0 && n.finite != r.distinct)
        std::printf("INCOMPLETE: %llu paths ended on another's root.\n", count(n.finite - r.distinct));
    if (r.morse_applies && n.singular == 0)
        std::printf(r.morse ? "The Morse relations of the torus hold.\n"
                            : "THE MORSE RELATIONS ARE VIOLATED: equilibria are missing.\n");
    std::printf("%.3g s, %.3g s of it tracking\n", r.seconds, r.tracking_seconds);
    if (r.proof) std::printf("%.3g s for the proofs\n", r.proof->seconds);
}

std::atomic<bool> cancelled = false;
static_assert(std::atomic<bool>::is_always_lock_free);

/// The first Ctrl-C ends the enumeration with what is finished, a second one the program.
void cancel_on_interrupt() {
    struct sigaction action {};
    action.sa_handler = [](int) { cancelled = true; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
}

/// One line on stderr: how much is done, and how to go on.
int interrupted(const ChainResult& r, const std::string& checkpoint) {
    const auto done = static_cast<unsigned long long>(r.paths.total - r.paths.cancelled);
    std::fprintf(stderr, "rotating_chain: interrupted, %llu of %llu paths are finished; %s\n", done,
                 static_cast<unsigned long long>(r.paths.total),
                 checkpoint.empty() ? "--checkpoint FILE would have kept them"
                                    : ("the same command goes on from " + checkpoint).c_str());
    return 130;
}

}  // namespace

int main(int argc, char** argv) {
    std::string links = "2", lengths, masses, omega = "2", gravity = "1", seed = "1", threads = "1", json_name,
                checkpoint;
    CLI::App app{
        "Every equilibrium of a chain of massless links with point masses, hanging in a plane that turns about the "
        "vertical through its first joint (Baillieul, equations 3.1), with its index: the number of directions in "
        "which "
        "it is unstable."};
    bool prove = false;
    std::string digits = "0";
    app.add_option("--links", links, "number of links, 1 to 8 (default 2)");
    app.add_option("--lengths", lengths, "length of each link, positive, commas between (default: all 1)");
    app.add_option("--masses", masses, "mass at the end of each link, positive, commas between (default: all 1)");
    app.add_option("--omega", omega, "angular speed, radians a unit of time (default 2)");
    app.add_option("--gravity", gravity, "acceleration due to gravity, 0 or more (default 1)");
    app.add_option("--seed", seed,
                   "of the random start system, an integer (default 1); the same seed, the same result");
    app.add_option("--threads", threads, "1 to 1024, 0 for one each core (default 1); does not change the result");
    app.add_flag("--prove", prove, "prove each root, its reality and index, and that none is missing");
    app.add_option("--digits", digits, "give the angles to that many digits, 1 to 1000, with a proved error");
    app.add_option("--json", json_name, "write JSON to this file, or to stdout for -, instead of a table");
    app.add_option("--checkpoint", checkpoint,
                   "keep what is finished in this file, and go on from it if it is there already; Ctrl-C ends the "
                   "program with status 130, and the same command resumes; does not change the result");
    support::parse(app, "rotating_chain", argc, argv);

    const int n = support::integer("--links", links, 1, most_links);
    const auto list = [&](const char* option, const std::string& text) {
        return app.count(option) == 0 ? std::vector<double>(static_cast<std::size_t>(n), 1.0)
                                      : support::positive_list(option, text, n);
    };
    const Chain chain{
        list("--lengths", lengths), list("--masses", masses),
        support::number("--omega", omega, "must be a finite number", [](double) { return true; }),
        support::number("--gravity", gravity, "must be a finite number, 0 or more", [](double g) { return g >= 0; })};
    if (app.count("--checkpoint") > 0 && checkpoint.empty())
        support::fail("--checkpoint", "''", "must be the name of a file");
    std::optional<support::ProgressBar> bar("tracking");
    const Options options{support::integer<std::uint64_t>("--seed", seed, 0, UINT64_MAX),
                          support::integer<unsigned>("--threads", threads, 0, 1024),
                          [&](std::uint64_t done, std::uint64_t all) { bar->update(done, all); },
                          checkpoint,
                          &cancelled,
                          prove,
                          app.count("--digits") > 0 ? support::integer("--digits", digits, 1, 1000) : 0};
    std::optional<support::OutputFile> file;
    if (app.count("--json") > 0) file.emplace("--json", json_name);
    cancel_on_interrupt();
    try {
        const ChainResult result = enumerate(n, chain, options);
        bar.reset();
        if (result.paths.cancelled > 0) return interrupted(result, checkpoint);
        if (file) file->write(json(chain, options, result));
        if (!file || !file->to_stdout()) print(chain, result);
    } catch (const equilibria::CheckpointError& error) {
        bar.reset();
        support::fail("--checkpoint", checkpoint, error.wrong());
    } catch (const std::exception& error) {
        support::fail("command line", "", error.what());
    }
}

// clang-format off
/* Refused:
--links 0
    rotating_chain: --links 0: must be an integer from 1 to 8
--links 9
    rotating_chain: --links 9: must be an integer from 1 to 8
--links 2.5
    rotating_chain: --links 2.5: must be an integer from 1 to 8
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
--checkpoint missing/folder.ckpt
    rotating_chain: --checkpoint missing/folder.ckpt: cannot be created (No such file or directory)
--checkpoint .
    rotating_chain: --checkpoint .: cannot be opened (Is a directory)
--checkpoint /dev/null
    rotating_chain: --checkpoint /dev/null: is not a regular file
--speed 2
    rotating_chain: --speed: is not an option; --help lists them
*/
