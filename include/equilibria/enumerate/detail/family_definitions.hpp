/// \file
/// See enumerate/family.hpp.
#pragma once

#include <equilibria/enumerate/family.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::string family_kind(int dimension) {
    if (dimension == 1) return "curve";
    if (dimension == 2) return "surface";
    return std::to_string(dimension) + "-dimensional family";
}

namespace detail {

EQUILIBRIA_INLINE std::string summary(const std::vector<FamilySummary>& families) {
    std::string all;
    std::vector<bool> told(families.size());
    for (std::size_t k = 0; k < families.size(); ++k) {
        if (told[k]) continue;
        std::uint64_t alike = 0, paths = 0;
        for (std::size_t m = k; m < families.size(); ++m)
            if (families[m].dimension == families[k].dimension && families[m].real == families[k].real) {
                told[m] = true;
                ++alike;
                paths += families[m].paths;
            }
        const std::string kind = (families[k].real ? "real " : "") + family_kind(families[k].dimension);
        all += (all.empty() ? "" : ", ") +
               (alike == 1 ? "a " + kind : "at most " + std::to_string(alike) + " times a " + kind) +
               " of solutions (" + std::to_string(paths) + " paths)";
    }
    return all;
}

}  // namespace detail
}  // namespace equilibria
