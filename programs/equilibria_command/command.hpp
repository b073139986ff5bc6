// What the subcommands of `equilibria` have in common: the model's file, its parameters, the run, the output.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <equilibria/run/run_options.hpp>

#include "documents.hpp"
#include "support/interrupt.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/progress_bar.hpp"

namespace commands {

/// What every subcommand is told.
struct Command {
    std::string file, fixed;
    std::uint64_t seed = 1;
    unsigned threads = 1;
    double limit = 0;
    std::optional<support::OutputFile> json;

    void add_to(support::CommandLine& app);
    /// Of these the model's options, and the output's, for what draws no random numbers.
    void add_model_to(support::CommandLine& app);
    void add_json_to(support::CommandLine& app);
    equilibria::RunOptions run() const;
};

/// A run that --limit, Ctrl-C and SIGTERM stop, with a bar on terminals.
class StoppableRun {
public:
    /// How it is stopped: by the options' flag, or where it reports progress, by support::Stopped.
    enum class By { flag, progress };

    StoppableRun(const Command& c, const std::string& label, By by);
    const equilibria::RunOptions& options() const { return options_; }
    /// Takes the bar away.
    void end() { bar_.reset(); }

private:
    std::optional<support::ProgressBar> bar_;
    support::TimeLimit limit_;
    equilibria::RunOptions options_;
};

/// The model in the file with the parameters as --set has them; ends the program where something is wrong.
Input read(const Command& c);

/// The number of the name that an option gives; ends the program where it is none of these.
int number_of(const std::vector<std::string>& names, const std::string& option, const std::string& name);

/// NAME=LOW:HIGH of a parameter.
Varied varied(const Input& input, const std::string& option, const std::string& text);

/// The parts of a text between separators.
std::vector<std::string> split(const std::string& text, char separator);

/// A table's column names: those of the unknowns; each number under its name.
void print_names(const FormulaModel& model);
/// Coordinates that are very small or large with an exponent.
void print_unknowns(const FormulaModel& model, const RuntimeArray<double>& q);
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
