/// \file
/// Whether the structure that a text says is sound at its start: it can be built, its forces and stiffnesses are
/// finite, and no constraint is redundant. Such a one is refused at the entry of the text that it comes from.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/redundant_constraints.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/fem/structure.hpp>
#include <equilibria/fem/structure_model.hpp>
#include <equilibria/io/strict_json.hpp>
#include <equilibria/io/structure/structure_input.hpp>

namespace equilibria::fem::detail {

using equilibria::detail::JsonError;
using equilibria::detail::JsonPlace;

/// Which entry of the text each element of the model comes from.
class EntryOwners {
public:
    /// The elements that are new since the last call come from this entry.
    void add(const Model& model, const JsonPlace& entry) {
        const auto& groups = model.groups();
        owners_.resize(groups.size());
        for (std::size_t g = 0; g < groups.size(); ++g)
            if (const std::size_t size = groups[g]->size(); size > (owners_[g].empty() ? 0 : owners_[g].back().first))
                owners_[g].emplace_back(size, entry);
    }
    /// An entry's "name" if it has one, else its place in the text.
    ElementNames names() const {
        ElementNames y;
        for (const auto& group : owners_) {
            y.groups.emplace_back();
            for (const auto& [behind, entry] : group) {
                const auto name = entry.json().find("name");
                const bool named = name != entry.json().end() && name->is_string();
                y.groups.back().emplace_back(behind, named ? name->template get<std::string>() : entry.name());
            }
        }
        return y;
    }
    /// The entry that a multiplier of the model's structure belongs to.
    const JsonPlace& of_multiplier(const Model& model, int multiplier) const {
        const auto& groups = model.groups();
        for (std::size_t g = 0;; ++g) {
            const int each = groups[g]->multipliers(), all = each * static_cast<int>(groups[g]->size());
            if (multiplier >= all) {
                multiplier -= all;
                continue;
            }
            const std::size_t e = static_cast<std::size_t>(multiplier / each);
            return std::upper_bound(owners_[g].begin(), owners_[g].end(), e,
                                    [](std::size_t k, const auto& o) { return k < o.first; })
                ->second;
        }
    }

private:
    std::vector<std::vector<std::pair<std::size_t, JsonPlace>>> owners_;  // of a group's elements up to a number
};

template <bool Conservative>
void check_start(const BasicStructure<Conservative>& structure, const std::string& name, const EntryOwners& owners,
                 int most_constraints) {
    const StructureState start = structure.initial();
    const Eigen::SparseMatrix<double> k = structure.tangent(start, 0);
    if (!structure.residual(start, 0).allFinite() || !k.coeffs().allFinite())
        throw JsonError("structure", equilibria::detail::in_short(name),
                        "must have finite forces and stiffnesses at the start: some number is too large or too small");
    const ConstraintGradients constraints(k, structure.multipliers(), structure.weights(start));
    if (constraints.count() > most_constraints) return;
    const std::vector<int> redundant = constraints.redundant();
    if (!redundant.empty())
        owners.of_multiplier(structure.model(), redundant.front())
            .refuse("must not be over-constrained: at the start " + std::to_string(redundant.size()) +
                    " of the structure's " + std::to_string(constraints.count()) +
                    " constraints depend on the others, or it is a dead point; let a joint or a support hold less");
}

/// Makes a structure of the model, to see which one it is, y.conservative, and that its start is sound.
inline void check_start(StructureInput& y, const EntryOwners& owners, int most_constraints) {
    try {
        std::optional<Structure> structure;
        try {
            structure.emplace(y.model);
        } catch (const InvalidArgument&) {
            y.conservative = false;
        }
        if (structure)
            check_start(*structure, y.name, owners, most_constraints);
        else
            check_start(NonconservativeStructure(y.model), y.name, owners, most_constraints);
    } catch (const JsonError&) {
        throw;
    } catch (const InvalidArgument& e) {
        throw JsonError("structure", equilibria::detail::in_short(y.name), std::string("cannot be built: ") + e.what());
    }
}

}  // namespace equilibria::fem::detail
