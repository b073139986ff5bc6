// The events for a number of links that is known at run time. Two units have two numbers each, so that they compile
// side by side: events_1_4.cpp, events_2_3.cpp.
#pragma once

#include <cstdint>
#include <equilibria/io/results/json.hpp>
#include <functional>
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

inline constexpr int most_links = 4;

// LineEvents as one document for all numbers of links. Of pitchforks also "supercritical": whether the pair that is
// born there has the branch's index before; nothing where that cannot be told. With `prove` each interval has a
// "proof", with "proved": that its table is the one of its middle, complete, and each index as it was counted; and
// there is "proving_seconds".
template <int Links>
equilibria::Json chain_events(const Chain& chain, const Options& options);
