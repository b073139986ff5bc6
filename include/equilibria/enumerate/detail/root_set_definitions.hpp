/// \file
/// See enumerate/root_set.hpp.
#pragma once

#include <ostream>

#include <equilibria/enumerate/root_set.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE std::ostream& write(std::ostream& out, const RootSetSummary& set) {
    const auto& [verdict, real, counted, families, on_families] = set;
    const PathCounts& paths = *verdict.paths;
    out << paths.total << " paths: " << paths.finite << " finite, " << paths.at_infinity << " at infinity, "
        << paths.singular << " singular, " << paths.failed << " failed; " << verdict.distinct << " distinct roots, "
        << real << " real";
    if (!counted.empty()) {
        out << ": " << counted << " ";
        for (std::size_t k = 0; k < verdict.by_index.size(); ++k)
            out << (k == 0 ? "" : ", ") << k << ": " << verdict.by_index[k];
    }
    if (verdict.degenerate > 0) out << ", degenerate: " << verdict.degenerate;
    if (verdict.morse_applies())
        out << (verdict.morse() ? "; Morse relations hold" : "; MORSE RELATIONS VIOLATED: equilibria are missing");
    if (!families.empty()) out << "; NOT ISOLATED: " << families;
    if (paths.singular > on_families) out << "; SINGULAR: equilibria coincide";
    if (verdict.cancelled()) out << "; CANCELLED: " << paths.cancelled << " paths are not finished";
    if (paths.singular == 0 && paths.finite > verdict.distinct && !verdict.cancelled())
        out << "; " << paths.finite - verdict.distinct << " paths ended on another's root: roots may be missing";
    if (verdict.alarms->raised()) out << "; ALARM: " << verdict.alarms->sentences();
    return out;
}

}  // namespace equilibria::detail
