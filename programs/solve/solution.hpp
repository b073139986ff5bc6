// What solve reads, how it starts, and what it finds.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <equilibria/enumerate/every_root.hpp>
#include <equilibria/paths/choose_start.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/paths/predicted_work.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace solve {

/// A system from a file.
struct Input {
    std::string format;  ///< PHCpack or Bertini
    std::vector<std::string> variables;
    equilibria::SparseSystem system;
    std::vector<int> grouping;  ///< of the file; empty where it names none, or one group
};

/// format: auto, phcpack or bertini. Throws InvalidArgument where the file is no such system, or none with as many
/// equations as variables and real coefficients.
Input read(const std::string& path, const std::string& format);

/// What --start may say, beside auto.
struct NamedStart {
    equilibria::StartKind start;
    std::string_view name;
};
inline constexpr std::array starts{NamedStart{equilibria::StartKind::total_degree, "total-degree"},
                                   NamedStart{equilibria::StartKind::multihomogeneous, "multihomogeneous"},
                                   NamedStart{equilibria::StartKind::polyhedral, "polyhedral"},
                                   NamedStart{equilibria::StartKind::monodromy, "monodromy"}};

/// asked: none for the start of the fewest paths. prove: the roots, by Krawczyk's test, with a verdict on their
/// completeness. Without, the verdict is open, and paths that fail in double are tracked with more digits. foretell: is
/// told what the run will take before it begins.
equilibria::EveryRoot solve(const Input& input, std::optional<equilibria::StartKind> asked, bool prove,
                            const equilibria::RunOptions& run,
                            const std::function<void(const equilibria::PredictedWork&)>& foretell);

}  // namespace solve
