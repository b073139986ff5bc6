// What solve reads, how it starts, and what it finds.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/enumerate/prove.hpp>
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

enum class Start { total_degree, multihomogeneous, polyhedral };

/// What --start may say, beside auto.
struct NamedStart {
    Start start;
    std::string_view name;
};
inline constexpr std::array starts{NamedStart{Start::total_degree, "total-degree"},
                                   NamedStart{Start::multihomogeneous, "multihomogeneous"},
                                   NamedStart{Start::polyhedral, "polyhedral"}};

/// Upper bounds of the number of isolated roots.
struct Bounds {
    equilibria::PathCount total_degree;
    equilibria::GroupingNumber<std::vector<int>> multihomogeneous;  ///< smallest of those compared and the file's
    std::optional<std::uint64_t> mixed_volume;                      ///< none above 2^64
};

/// A start, and why it was taken.
struct Choice {
    Start start;
    std::string why;
};

/// asked: none for the one of the least predicted cost.
Choice choose(const Bounds& bounds, std::optional<Start> asked);

struct Solution {
    Bounds bounds;
    Choice choice;
    equilibria::ComplexRoots<> found;
    std::optional<equilibria::ProofOfRoots> proof;
    double seconds, tracking_seconds;
};

/// Paths that fail in double are tracked with more digits. prove: the roots, by Krawczyk's test.
Solution solve(const Input& input, std::optional<Start> asked, bool prove, const equilibria::RunOptions& run);

}  // namespace solve
