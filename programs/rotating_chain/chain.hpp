// The enumeration for a number of links that is known at run time. Two units have half of the numbers each, so that
// they compile side by side: odd_links.cpp, even_links.cpp.
#pragma once

#include <atomic>
#include <cstdint>
#include <equilibria/io/results/json.hpp>
#include <equilibria/paths/path_counts.hpp>
#include <functional>
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

// A result whose type has the number of links is one document for all numbers of links.
struct ChainResult {
    equilibria::PathCounts paths;
    equilibria::Json json;  // of the RootSet, with what is proved and the digits
};

inline constexpr int most_links = 8;

template <int Links>
ChainResult enumerate_chain(const Chain& chain, const Options& options);
