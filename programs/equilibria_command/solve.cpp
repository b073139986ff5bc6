// equilibria solve, equilibria prove
#include <cstdio>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <equilibria/io/results/proof_output.hpp>
#include <equilibria/io/results/root_set_output.hpp>
#include <equilibria/io/results/stability_output.hpp>
#include <equilibria/studies/formula_model/formula_motion.hpp>
#include <equilibria/studies/formula_model/formula_searches.hpp>

#include "command.hpp"
#include "support/interrupt.hpp"

namespace commands {

namespace {

int enumerated(const char* name, bool proved, int argc, char** argv) {
    Command c;
    std::string start = "auto";
    bool more_digits = false;
    support::CommandLine app{proved
                                 ? "Every isolated equilibrium of a model, each proved to exist, to be distinct from "
                                   "the others, and real or not, with its index; and, where a bound is reached, that "
                                   "none is missing."
                                 : "Every isolated equilibrium of a model, with its index and its energy."};
    c.add_to(app);
    app.add_option("--start", start, "total-degree or polyhedral (default auto: that of the least predicted cost)")
        .transform(support::one_of({"auto", "total-degree", "polyhedral"}, "must be auto, total-degree or polyhedral"));
    app.add_flag("--more-digits", more_digits, "track paths that fail in double with more digits");
    app.parse(name, argc, argv);
    const Input input = read(c);

    equilibria::RunOptions run = c.run();
    run.cancel = &support::cancelled_by_signal();
    const auto set = equilibria::enumerate(input.model, input.p, run,
                                           start == "total-degree" ? equilibria::FormulaStart::total_degree
                                           : start == "polyhedral" ? equilibria::FormulaStart::polyhedral
                                                                   : equilibria::FormulaStart::least_cost,
                                           more_digits);
    if (set.cancelled()) {
        std::fprintf(stderr, "%s: interrupted\n", name);
        return 130;
    }
    std::optional<equilibria::ProofOfRoots> proof;
    if (proved) proof = equilibria::prove(input.model, set, c.run());

    std::vector<std::optional<equilibria::PoleCount<Eigen::MatrixXd>>> poles;  // of models that move
    if (input.model.kinetics)
        for (const auto& e : set.equilibria)
            poles.push_back(equilibria::count_poles_at_rest(input.model, e.q, input.p));

    if (c.json) {
        Json out = heading(c, input), found = equilibria::json_of(set, {input.model.parameters});
        found.erase("parameters");
        for (std::size_t k = 0; k < poles.size(); ++k) {
            Json& e = found["equilibria"][k];
            e["verdict"] = poles[k] ? Json(to_string(poles[k]->verdict())) : Json();
            e["poles"] = poles[k] ? equilibria::json_list(poles[k]->poles) : Json();
        }
        equilibria::add_keys(out, found);
        if (proof) out["proof"] = equilibria::json_of(*proof);
        c.json->write(equilibria::json_text(out));
    }
    if (!to_stdout(c.json)) {
        std::printf("%s\n\n", in_words(input).c_str());
        print_names(input.model);
        std::printf("  index        energy  residual  condition%s\n", poles.empty() ? "" : "  motion");
        for (std::size_t k = 0; k < set.equilibria.size(); ++k) {
            const auto& e = set.equilibria[k];
            print_unknowns(e.q);
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
        if (proof) {
            std::ostringstream words;
            words << *proof;
            std::printf("%s\n", words.str().c_str());
        }
        std::printf("%.3g s\n", set.seconds + (proof ? proof->seconds : 0));
    }
    return 0;
}

}  // namespace

int solve(int argc, char** argv) { return enumerated("equilibria solve", false, argc, argv); }
int prove(int argc, char** argv) { return enumerated("equilibria prove", true, argc, argv); }

}  // namespace commands
