// The enumeration for a number of links that is known at run time. Two units have half of the numbers each, so that they
// compile side by side: odd_links.cpp, even_links.cpp.
#pragma once

#include <atomic>
#include <cstdint>
#include <equilibria/certify/certificate.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

struct Chain {
    std::vector<double> lengths, masses;
    double omega, gravity;
};

struct Options {
    std::uint64_t seed;
    unsigned threads;
    std::function<void(std::uint64_t done, std::uint64_t all)> progress;
    std::string checkpoint;
    const std::atomic<bool>* cancel;
    bool prove;
    int digits;  // 0: none
};

struct ManyDigits {
    std::vector<std::string> angles;
    bool proved;
    std::string error;
};

struct ChainEquilibrium {
    std::vector<double> angles;  // radians, in (-pi, pi]
    int index, nullity, multiplicity;
    double energy, residual, condition, margin;
    std::optional<equilibria::Certificate> certificate;
    std::optional<ManyDigits> digits;
};

// What Proof tells.
struct ChainProof {
    std::uint64_t distinct, real, non_real, undecided, duplicates, index, contradictions, more_digits, bound;
    bool complete;
    std::string reason;
    double seconds;
};

struct Failure {
    std::uint64_t path;
    std::string reason;
};

// What RootSet tells, the angles being vectors.
struct ChainResult {
    equilibria::PathCounts paths;
    std::uint64_t distinct, degenerate;
    bool clean, morse_applies, morse;
    std::vector<std::int64_t> by_index;
    double tracking_seconds, seconds;
    std::vector<ChainEquilibrium> equilibria;
    std::vector<Failure> failures;
    std::vector<int> multiplicities, winding_numbers;  // of the distinct roots
    std::vector<std::string> families;                 // in words
    std::string alarms;                                // raised ones, in words
    std::optional<ChainProof> proof;
};

inline constexpr int most_links = 8;

template <int Links>
ChainResult enumerate_chain(const Chain& chain, const Options& options);
