/// \file
/// What is proved of one root.
#pragma once

#include <cstdint>
#include <string_view>

namespace equilibria {

/// Of a root that was proved to exist. Exactly one holds: never both of the first two.
enum class Reality : std::uint8_t {
    undecided,  ///< neither could be proved
    real,       ///< its conjugate, a root as well, lies where only one root does
    non_real    ///< the enclosure of some unknown holds no real point
};

/// What is proved of one root, and in how many digits.
struct Certificate {
    std::uint64_t path = 0;                ///< of the root
    bool exists = false;                   ///< exactly one root lies in the polydisc of `radius`
    bool distinct = false;                 ///< it is not one of the roots before it in the set
    Reality reality = Reality::undecided;  ///< real, not real, or not known
    bool index_proved = false;             ///< the index of the Hessian at the root, which is real, is `index`
    int index = -1;     ///< number of negative eigenvalues of the Hessian; meaningful where index_proved
    int digits = 0;     ///< decimal digits of the arithmetic of the proof; 0: nothing was proved
    double radius = 0;  ///< the largest distance of an unknown from its given value; angles in radians
};

/// In words: "real", "non-real" or "undecided".
constexpr std::string_view name(Reality reality) {
    switch (reality) {
        case Reality::real: return "real";
        case Reality::non_real: return "non-real";
        default: return "undecided";
    }
}

}  // namespace equilibria
