// The events for a number of links that is known at run time. Two units have two numbers each, so that they compile
// side by side: events_1_4.cpp, events_2_3.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <equilibria/enumerate/root_set.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

struct Chain {
    std::vector<double> lengths, masses;
    double gravity;
};

struct Options {
    double low, high;  // of omega
    std::uint64_t seed;
    unsigned threads;
    std::function<void(std::uint64_t done, std::uint64_t all)> progress;
    bool prove;
};

// What LineEvent tells, the angles being vectors.
struct ChainEvent {
    std::string kind;
    double omega;
    std::vector<double> angles, null_vector;  // radians, in (-pi, pi]; of length 1
    double residual, correction, third, fourth, slope;
    std::optional<bool>
        supercritical;     // of pitchforks: whether the pair that is born there has the branch's index before
    std::size_t interval;  // the first one above
};

// What Proof tells of the equilibria in the middle of an interval.
struct IntervalProof {
    std::uint64_t distinct, real, undecided, index, contradictions;
    bool complete;
    std::string reason;
    bool proved;  // that the interval's table is the one of its middle: complete, and each index as it was counted
};

struct ChainInterval {
    double low, high, at;
    std::uint64_t count;
    std::vector<std::int64_t> by_index;
    bool clean;
    std::optional<IntervalProof> proof;
};

struct ChainEvents {
    std::vector<ChainEvent> events;
    std::vector<ChainInterval> intervals;
    equilibria::PathCounts paths;
    std::uint64_t attempts, complex_solutions, regular_solutions, pitchfork_paths, other_singular, unexplained,
        wrong_tables, unclean;
    bool complete;
    std::string argument;
    double solve_seconds, seconds, proving_seconds;
};

inline constexpr int most_links = 4;

template <int Links>
ChainEvents chain_events(const Chain& chain, const Options& options);
