// equilibria solve, equilibria prove
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>

#include <equilibria/homotopy/path_limit.hpp>

#include "command.hpp"

namespace commands {

namespace {

unsigned long long count(std::uint64_t value) { return value; }

int enumerated(const char* name, bool proving, int argc, char** argv) {
    Command c;
    std::string start = "auto";
    bool more_digits = false, no_proof = false;
    support::CommandLine app{proving
                                 ? "Every isolated equilibrium of a model, each proved to exist, to be distinct from "
                                   "the others, and real or not, with its index; and, where a bound is reached, that "
                                   "none is missing."
                                 : "Every isolated equilibrium of a model, with its index and its energy, proved, and "
                                   "what is known of others."};
    c.add_to(app);
    app.add_option("--start", start, "total-degree or polyhedral (default auto: that of the least predicted cost)")
        .transform(support::one_of({"auto", "total-degree", "polyhedral"}, "must be auto, total-degree or polyhedral"));
    app.add_flag("--more-digits", more_digits, "without proofs: track paths that fail in double with more digits");
    if (!proving)
        app.add_flag("--no-proof", no_proof,
                     "track paths alone: nothing is proved, and nothing is said of completeness");
    app.parse(name, argc, argv);
    const Input input = read(c);

    StoppableRun run(c, "tracking", StoppableRun::By::flag);
    const Solved found = solved(input, run.options(),
                                {.start = start == "total-degree" ? equilibria::FormulaStart::total_degree
                                          : start == "polyhedral" ? equilibria::FormulaStart::polyhedral
                                                                  : equilibria::FormulaStart::least_cost,
                                 .more_digits = more_digits,
                                 .prove = !no_proof});
    const auto& [set, proof, confirmed, at_infinity, poles] = found;
    run.end();
    if (c.json) c.json->write(document(input, found));
    if (!to_stdout(c.json)) {
        std::printf("%s\n\n", in_words(input).c_str());
        print_names(input.model);
        std::printf("  index        energy  residual  condition%s\n", poles.empty() ? "" : "  motion");
        for (std::size_t k = 0; k < set.equilibria.size(); ++k) {
            const auto& e = set.equilibria[k];
            print_unknowns(input.model, e.q);
            std::printf("  %4d%s  %13.8g  %.1e  %.1e", e.index, e.degenerate() ? "*" : " ", e.energy, e.residual,
                        e.condition);
            if (!poles.empty()) std::printf("     %s", poles[k] ? to_string(poles[k]->verdict()) : "-");
            std::printf("\n");
        }
        if (set.degenerate() > 0)
            std::printf("* degenerate: %llu\n", static_cast<unsigned long long>(set.degenerate()));
        std::ostringstream text;
        text << set;
        std::printf("\n%s\nstart: %s, %s\n", text.str().c_str(), set.start.name.c_str(), set.start.why.c_str());
        if (proof)
            std::printf("%llu distinct roots proved, %llu real, %llu non-real, %llu undecided, %llu with their index\n",
                        count(proof->distinct), count(proof->real), count(proof->non_real), count(proof->undecided),
                        count(proof->index));
        for (const auto& away : at_infinity)
            std::printf("to infinity: %llu paths along %s, to roots of its face system (residual %.0e)\n",
                        count(away.paths), equilibria::direction_in_words(away.direction).c_str(), away.residual);
        std::printf("%.3g s\n%s\n", set.seconds, in_words(set.completeness).c_str());
    }
    const bool open = set.cancelled() || (proof && set.completeness.completeness == equilibria::Completeness::open);
    if (open && support::stopped_status() != 0)
        return support::say_stopped(name, "the result is what was found until then");
    return 0;
}

}  // namespace

int solve(int argc, char** argv) { return enumerated("equilibria solve", false, argc, argv); }
int prove(int argc, char** argv) { return enumerated("equilibria prove", true, argc, argv); }

}  // namespace commands
