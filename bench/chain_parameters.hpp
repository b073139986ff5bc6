// The chain of the speed tables, of so many links: l_i = 1 + i/10, m_i = 1 + i^2/20, g = 1, omega = 1.7.
#pragma once

#include <equilibria/core/sized_array.hpp>

/// Of RuntimeRotatingChain.
inline equilibria::RuntimeArray<double> chain_parameters(int n) {
    equilibria::RuntimeArray<double> p(2 * n + 2);
    for (int i = 0; i < n; ++i) {
        p[i] = 1 + (i + 1) / 10.0;
        p[n + i] = 1 + (i + 1) * (i + 1) / 20.0;
    }
    p[2 * n] = 1.7;
    p[2 * n + 1] = 1;
    return p;
}
