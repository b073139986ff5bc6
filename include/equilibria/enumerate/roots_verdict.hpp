/// \file
/// What is known of roots that an enumeration did not find: the last line of every result.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace equilibria {

/// What is known of the roots that were not found.
enum class Completeness : std::uint8_t {
    complete,   ///< a theorem: there are no others
    explained,  ///< every path of a start that reaches every isolated root is accounted for, with evidence for each
    open        ///< something is left: the verdict says what
};

/// In words: "complete", "explained" or "open".
constexpr std::string_view to_string(Completeness completeness) {
    constexpr std::array names{"complete", "explained", "open"};
    return names[static_cast<std::size_t>(completeness)];
}

/// The verdict on a set of roots.
struct RootsVerdict {
    Completeness completeness = Completeness::open;  ///< what is known
    /// How many isolated roots may be missing, each counted with its multiplicity; 0 unless it is open, and where
    /// curves alone may be missing. Nothing: no bound is known.
    std::optional<std::uint64_t> missing_at_most;
    std::string sentence = "nothing was proved";  ///< the evidence, or what is left, in words
};

namespace detail {
/// What a complete verdict adds where so many paths ended at points that are not proved.
inline std::string no_further_roots(std::uint64_t paths) {
    return paths == 1
               ? "; so the point where 1 more path ends is no further isolated root"
               : "; so the points where " + std::to_string(paths) + " more paths end are no further isolated roots";
}
}  // namespace detail

/// The verdict in a sentence: what is said last of a set of roots.
inline std::string in_words(const RootsVerdict& v) {
    switch (v.completeness) {
        case Completeness::complete: return "COMPLETE: " + v.sentence + ".";
        case Completeness::explained: return "COMPLETE BUT FOR WHAT IS EXPLAINED: " + v.sentence + ".";
        case Completeness::open: break;
    }
    if (v.missing_at_most == 0) return "CURVES MAY BE MISSING: " + v.sentence + ".";
    return (v.missing_at_most ? "AT MOST " + std::to_string(*v.missing_at_most) + " ROOTS MAY BE MISSING: "
                              : std::string("ROOTS MAY BE MISSING: ")) +
           v.sentence + ".";
}

}  // namespace equilibria
