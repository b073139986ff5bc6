// What the subcommands of `equilibria` find, and the documents that say it: for the program, and for who calls without
// one (programs/explorer). Nothing here ends a program or knows an option; what is wrong is an exception.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <equilibria/enumerate/prove.hpp>
#include <equilibria/formula/formula_model.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/studies/formula_model/formula_motion.hpp>
#include <equilibria/studies/formula_model/formula_searches.hpp>

namespace commands {

using equilibria::FormulaModel;
using equilibria::Json;
using equilibria::RuntimeArray;
using equilibria::RuntimeUnknowns;

/// A model, the values of its parameters, and the file that it is from, as a document names it; none where empty.
struct Input {
    FormulaModel model;
    RuntimeArray<double> p;
    std::string file;
};

/// A parameter and its range.
struct Varied {
    int parameter = 0;
    std::string name;
    double low = 0, high = 0;
};

/// Names of the unknowns, angles first; how many there are of each.
std::vector<std::string> unknowns(const FormulaModel& model);
equilibria::RuntimeSizes sizes(const FormulaModel& model);

/// The beginning of each document: file, model's name, unknowns, parameters.
Json heading(const Input& input);

/// How equilibria are enumerated.
struct SolveOptions {
    equilibria::FormulaStart start = equilibria::FormulaStart::least_cost;
    bool more_digits = false;
    bool prove = true;  ///< the roots, with a verdict on their completeness
};
/// Equilibria, their proof where it is asked for, and their poles where the model moves.
struct Solved {
    equilibria::RootSet<RuntimeUnknowns> set;
    std::optional<equilibria::ProofOfRoots> proof;
    std::vector<char> confirmed;  ///< of each root that is singular: its multiplicity was confirmed; by a proof alone
    std::vector<equilibria::DivergingPaths> at_infinity;
    std::vector<std::optional<equilibria::PoleCount<Eigen::MatrixXd>>> poles;
};
Solved solved(const Input& input, const equilibria::RunOptions& run, const SolveOptions& options);

/// Lines in each direction that a locus is seeded from.
inline constexpr int locus_lines = 12;

/// A motion of so many points at even times from 0 to the last one.
struct MotionRequest {
    equilibria::MotionState<RuntimeUnknowns> from;
    double until = 10, tolerance = 1e-12;
    int points = 201;
    bool hamilton = false;
};
equilibria::Motion<RuntimeUnknowns> moved(const Input& input, const MotionRequest& request,
                                          const equilibria::RunOptions& run);

/// The documents as text.
/// \{
std::string document(const Input& input, const Solved& found);
std::string document(const Input& input, const Varied& by, const equilibria::LineEvents<RuntimeUnknowns>& found);
std::string document(const Input& input, const Varied& by,
                     const equilibria::BifurcationDiagram<RuntimeUnknowns>& found);
std::string document(const Input& input, const Varied& across, const Varied& up,
                     const equilibria::Locus<RuntimeUnknowns>& found);
std::string document(const Input& input, const MotionRequest& request,
                     const equilibria::Motion<RuntimeUnknowns>& found);
/// \}

}  // namespace commands
