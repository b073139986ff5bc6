// Models from files: their equilibria, with proofs, events, diagrams and loci, and their motion, without a compiler.
//
//   equilibria solve pendulum.json --set omega=2
//   equilibria motion elastic_pendulum.json --start t=0.3,x=1 --until 20 --png motion.png
//   equilibria locus pendulum.json --x alpha=0:1 --y omega=0:5 --png locus.png
#include <array>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "equilibria_command/command.hpp"
#include "support/interrupt.hpp"

namespace {

struct Subcommand {
    std::string_view name, text;
    int (*run)(int argc, char** argv);
};

constexpr std::array<Subcommand, 8> subcommands{{
    {"solve", "every isolated equilibrium, with its index and energy", commands::solve},
    {"prove", "the same, each proved, and, where a bound is reached, that none is missing", commands::prove},
    {"events", "where along one parameter equilibria are born, merge or change their index", commands::events},
    {"diagram", "all equilibria against one parameter", commands::diagram},
    {"locus", "folds, pitchforks, cusps and regions in a plane of two parameters", commands::locus},
    {"sweep", "how many equilibria there are at many points", commands::sweep},
    {"motion", "the motion from a start, where the model has a kinetic energy", commands::motion},
    {"export", "the equations as polynomials for PHCpack, Bertini, HomotopyContinuation.jl, Macaulay2",
     commands::export_polynomials},
}};

void print_help() {
    std::printf(
        "Equilibria of a model that a file describes (docs/model-files.md).\nUsage: equilibria SUBCOMMAND FILE "
        "[OPTIONS]; equilibria SUBCOMMAND --help lists them\n\n");
    for (const Subcommand& s : subcommands)
        std::printf("  %-9s %s\n", std::string(s.name).c_str(), std::string(s.text).c_str());
}

}  // namespace

int main(int argc, char** argv) {
    support::program = "equilibria";
    const std::string_view name = argc > 1 ? argv[1] : "";
    if (name == "--help" || name == "-h") {
        print_help();
        return 0;
    }
    for (const Subcommand& s : subcommands)
        if (s.name == name) {
            try {
                return s.run(argc - 1, argv + 1);
            } catch (const support::Stopped&) {
                return support::say_stopped("equilibria " + std::string(name), "nothing was written");
            } catch (const std::exception& error) {
                support::refuse(error.what());
            }
        }
    std::string known;
    for (const Subcommand& s : subcommands)
        known += (known.empty() ? "" : s.name == subcommands.back().name ? " or " : ", ") + std::string(s.name);
    support::fail(name.empty() ? "SUBCOMMAND" : name, "", "must be " + known);
}
