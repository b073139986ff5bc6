// What the subcommands of `equilibria` have in common: the model's file, its parameters, the run, the output.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <equilibria/formula/formula_model.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/run/run_options.hpp>

#include "support/options.hpp"
#include "support/output_file.hpp"

namespace commands {

using equilibria::FormulaModel;
using equilibria::Json;
using equilibria::RuntimeArray;

/// What every subcommand is told.
struct Command {
    std::string file, fixed;
    std::uint64_t seed = 1;
    unsigned threads = 1;
    std::optional<support::OutputFile> json;

    void add_to(support::CommandLine& app);
    /// Of these the model's options, and the output's, for what draws no random numbers.
    void add_model_to(support::CommandLine& app);
    void add_json_to(support::CommandLine& app);
    equilibria::RunOptions run() const;
};

/// A model and the values of its parameters.
struct Input {
    FormulaModel model;
    RuntimeArray<double> p;
};

/// The model in the file with the parameters as --set has them; ends the program where something is wrong.
Input read(const Command& c);

/// The number of the name that an option gives; ends the program where it is none of these.
int number_of(const std::vector<std::string>& names, const std::string& option, const std::string& name);

/// NAME=LOW:HIGH of a parameter.
struct Varied {
    int parameter = 0;
    std::string name;
    double low = 0, high = 0;
};
Varied varied(const Input& input, const std::string& option, const std::string& text);

/// The parts of a text between separators.
std::vector<std::string> split(const std::string& text, char separator);

/// The beginning of each document: file, model's name, parameters, seed.
Json heading(const Command& c, const Input& input);

/// A table's column names: those of the unknowns.
std::vector<std::string> unknowns(const FormulaModel& model);
/// "1.234567 0.5": each %12.8f under its name.
void print_names(const FormulaModel& model);
void print_unknowns(const RuntimeArray<double>& q);
/// "alpha = 0.33, omega = 2".
std::string in_words(const Input& input);

int solve(int argc, char** argv);
int prove(int argc, char** argv);
int events(int argc, char** argv);
int diagram(int argc, char** argv);
int locus(int argc, char** argv);
int sweep(int argc, char** argv);
int motion(int argc, char** argv);
int export_polynomials(int argc, char** argv);

}  // namespace commands
