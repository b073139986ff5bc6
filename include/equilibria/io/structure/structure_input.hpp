/// \file
/// What is read from a structure's text, structure_json.hpp, and how much of a text is taken.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/fem/structure_model.hpp>

namespace equilibria::fem {

/// How much of a text is taken.
struct ParseLimits {
    std::size_t bytes = std::size_t{64} << 20;  ///< of the text, which takes up to 25 times its size while it is read
    std::size_t depth = 16;                     ///< of objects and lists in each other; the format has 4
    int elements = 100'000;                     ///< of the model, with joints; in a Structure each may take 70 kB
    int constraints = 2000;                     ///< that could be redundant: more are not looked at

    /// Throws InvalidArgument for a limit out of range.
    void validate() const {
        require(bytes >= 1, "bytes", bytes, "must be at least 1");
        require(depth >= 4, "depth", depth, "must be at least 4, as deep as the format");
        require(elements >= 1 && elements <= 10'000'000, "elements", elements, "must be 1 to 10000000");
        require(constraints >= 0, "constraints", constraints, "must not be negative");
    }
};

/// Which element of the text each element of a model comes from.
struct ElementNames {
    /// For each group of the model: the first number behind a text's element, and its name or its place in the text.
    std::vector<std::vector<std::pair<std::size_t, std::string>>> groups;

    /// Element e of group g; empty where it is not known.
    std::string of(std::size_t g, std::size_t e) const {
        if (g >= groups.size()) return {};
        const auto found = std::upper_bound(groups[g].begin(), groups[g].end(), e,
                                            [](std::size_t k, const auto& name) { return k < name.first; });
        return found == groups[g].end() ? std::string() : found->second;
    }
};

/// What a text says: see structure_json.hpp.
struct StructureInput {
    std::string name;                    ///< of the structure; may be empty
    Model model;                         ///< nodes, elements, supports and loads
    std::map<std::string, int> nodes;    ///< their numbers; further nodes of the model are those within beams
    ElementNames elements;               ///< names of its elements, joints and follower loads
    int measured = 0;                    ///< a node
    std::string parameter = "p";         ///< its name
    double low = 0;                      ///< lower end of the parameter's window
    double high = 0;                     ///< upper end
    bool up = true;                      ///< followed from 0 towards larger parameters
    bool down = false;                   ///< and towards smaller ones
    std::optional<double> first_step;    ///< length of the continuation's first step, where it is given
    std::optional<double> largest_step;  ///< likewise of the largest one
    /// Theta of BranchOptions, where it is given: lengths per unit of the parameter.
    std::optional<double> parameter_weight;
    std::vector<std::string> notes;  ///< defaults of the text that are to be known, a sentence each
    bool conservative = true;        ///< the model is one for Structure; else for NonconservativeStructure
};

/// How its branches are followed: within its window, with its steps, or else with a first one of 0.01 and none above
/// 0.1, in the lengths of Structure's weights: displacements in shares of the structure's size, rotations in radians.
inline ContinuationOptions continuation_options(const StructureInput& input) {
    ContinuationOptions y;
    y.range = {input.low, input.high};
    y.branch.first_step = input.first_step.value_or(std::min(0.01, input.largest_step.value_or(0.01)));
    y.branch.largest_step = input.largest_step.value_or(std::max(0.1, y.branch.first_step));
    y.branch.parameter_weight = input.parameter_weight.value_or(0);
    return y;
}

}  // namespace equilibria::fem
