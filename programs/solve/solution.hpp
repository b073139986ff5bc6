// What solve reads, how it starts, and what it finds.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <equilibria/enumerate/prove.hpp>
#include <equilibria/paths/choose_start.hpp>
#include <equilibria/paths/complex_roots.hpp>
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

struct Solution {
    equilibria::StartChoice start;
    equilibria::ComplexRoots<> found;
    std::optional<equilibria::ProofOfRoots> proof;
    double seconds, tracking_seconds;
};

/// asked: none for the start of the least predicted cost. Paths that fail in double are tracked with more digits.
/// prove: the roots, by Krawczyk's test.
Solution solve(const Input& input, std::optional<equilibria::StartKind> asked, bool prove,
               const equilibria::RunOptions& run);

}  // namespace solve
