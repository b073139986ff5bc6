// The chain of the speed tables (chain_parameters.hpp), as a model of its own for each number of links.
#pragma once

#include <algorithm>

#include <equilibria/mechanisms/rotating_chain.hpp>

#include "chain_parameters.hpp"

template <int N>
using Chain = equilibria::mechanisms::RotatingChain<N>;

template <int N>
equilibria::Parameters<Chain<N>> benchmark_chain() {
    equilibria::Parameters<Chain<N>> p;
    const auto numbers = chain_parameters(N);
    std::copy(numbers.begin(), numbers.end(), p.begin());
    return p;
}
