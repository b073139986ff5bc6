/// \file
/// See storage/checkpoint_fields.hpp.
#pragma once

#include <equilibria/core/error.hpp>
#include <equilibria/storage/checkpoint_fields.hpp>
#include <equilibria/storage/fingerprint.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE CheckpointFields model_fields(const std::string& name, const RuntimeSizes& sizes, int terms,
                                                const std::vector<std::uint64_t>& support,
                                                std::span<const double> parameters, const std::string& build) {
    Fingerprint sum;
    for (const std::uint64_t word : support) sum(word);
    CheckpointFields fields{
        {"model", name + " (" + std::to_string(sizes.angles) + " angles, " + std::to_string(sizes.coordinates) +
                      " coordinates, " + std::to_string(terms) + " terms, support " + sum.text() + ")"},
        {"model's build", build}};
    int k = 0;
    for (const double value : parameters) fields.push_back({"parameters[" + std::to_string(k++) + "]", to_text(value)});
    return fields;
}

}  // namespace equilibria::detail
