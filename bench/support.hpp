// The chain of the speed tables: l_i = 1 + i/10, m_i = 1 + i^2/20, g = 1, omega = 1.7.
#pragma once

#include <equilibria/mechanisms/rotating_chain.hpp>

template <int N>
using Chain = equilibria::mechanisms::RotatingChain<N>;

template <int N>
equilibria::Parameters<Chain<N>> benchmark_chain() {
    equilibria::Parameters<Chain<N>> p;
    for (int i = 0; i < N; ++i) {
        p[Chain<N>::length + i] = 1 + (i + 1) / 10.0;
        p[Chain<N>::mass + i] = 1 + (i + 1) * (i + 1) / 20.0;
    }
    p[Chain<N>::omega] = 1.7;
    p[Chain<N>::gravity] = 1;
    return p;
}
