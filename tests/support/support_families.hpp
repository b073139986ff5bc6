// Supports of well-known families of systems, for tests and benchmarks of mixed volumes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/polyhedral/supports.hpp>

namespace support_families {

using equilibria::Supports;
using Equations = std::vector<std::vector<Supports::Point>>;

// The sum of factor * e_index.
inline Supports::Point point(int n, std::vector<std::pair<int, int>> terms) {
    Supports::Point y(static_cast<std::size_t>(n));
    for (const auto& [index, factor] : terms) y[static_cast<std::size_t>(index)] += factor;
    return y;
}

inline Supports without_copies(int n, Equations equations) {
    for (auto& points : equations) {
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
    }
    return Supports(n, std::move(equations));
}

// Sums of products of m consecutive unknowns, m = 1 .. n-1, and x_1 .. x_n = 1.
inline Supports cyclic(int n) {
    Equations y;
    for (int m = 1; m < n; ++m) {
        auto& points = y.emplace_back();
        for (int j = 0; j < n; ++j) {
            points.push_back(point(n, {}));
            for (int k = 0; k < m; ++k) points.back()[static_cast<std::size_t>((j + k) % n)] = 1;
        }
    }
    y.push_back({point(n, {}), Supports::Point(static_cast<std::size_t>(n), 1)});
    return Supports(n, std::move(y));
}

// Noonburg's neural network: x_i (sum of x_j^2 over the others) - c x_i + 1.
inline Supports noon(int n) {
    Equations y;
    for (int i = 0; i < n; ++i) {
        auto& points = y.emplace_back();
        for (int j = 0; j < n; ++j)
            if (j != i) points.push_back(point(n, {{i, 1}, {j, 2}}));
        points.push_back(point(n, {{i, 1}}));
        points.push_back(point(n, {}));
    }
    return Supports(n, std::move(y));
}

// Chandrasekhar's H equation: x_i (1 + sum of x_j, j < n) and x_i, 1.
inline Supports chandra(int n) {
    Equations y;
    for (int i = 0; i < n; ++i) {
        auto& points = y.emplace_back();
        points.push_back(point(n, {}));
        points.push_back(point(n, {{i, 1}}));
        for (int j = 0; j < n - 1; ++j) points.push_back(point(n, {{i, 1}, {j, 1}}));
    }
    return Supports(n, std::move(y));
}

// Katsura's magnets, n + 1 unknowns.
inline Supports katsura(int n) {
    Equations y;
    for (int m = 0; m < n; ++m) {
        auto& points = y.emplace_back();
        for (int l = -n; l <= n; ++l)
            if (std::abs(m - l) <= n) points.push_back(point(n + 1, {{std::abs(l), 1}, {std::abs(m - l), 1}}));
        points.push_back(point(n + 1, {{m, 1}}));
    }
    auto& sum = y.emplace_back();
    for (int l = 0; l <= n; ++l) sum.push_back(point(n + 1, {{l, 1}}));
    sum.push_back(point(n + 1, {}));
    return without_copies(n + 1, std::move(y));
}

// Gauss's quadrature with n weights and nodes.
inline Supports gaukwa(int n) {
    Equations y;
    for (int power = 0; power < 2 * n; ++power) {
        auto& points = y.emplace_back();
        for (int i = 0; i < n; ++i) points.push_back(point(2 * n, {{i, 1}, {n + i, power}}));
        points.push_back(point(2 * n, {}));
    }
    return Supports(2 * n, std::move(y));
}

// An economic model.
inline Supports eco(int n) {
    Equations y;
    for (int k = 1; k < n; ++k) {
        auto& points = y.emplace_back();
        points.push_back(point(n, {}));
        points.push_back(point(n, {{k - 1, 1}, {n - 1, 1}}));
        for (int i = 1; i < n - k; ++i) points.push_back(point(n, {{i - 1, 1}, {i + k - 1, 1}, {n - 1, 1}}));
    }
    auto& sum = y.emplace_back();
    for (int i = 0; i < n - 1; ++i) sum.push_back(point(n, {{i, 1}}));
    sum.push_back(point(n, {}));
    return Supports(n, std::move(y));
}

// A rotating chain of n links, Laurent polynomials in exp(i theta): cos theta_i (sum of sin theta_j), sin theta_i.
inline Supports chain(int n) {
    Equations y;
    for (int i = 0; i < n; ++i) {
        auto& points = y.emplace_back();
        for (const int a : {-1, 1}) {
            points.push_back(point(n, {{i, a}}));
            points.push_back(point(n, {{i, 2 * a}}));
            for (int j = 0; j < n; ++j)
                for (const int b : {-1, 1})
                    if (j != i) points.push_back(point(n, {{i, a}, {j, b}}));
        }
    }
    return Supports(n, std::move(y));
}

using Bonds = std::vector<std::pair<int, int>>;

// Coupled angles with loads: sin theta_i, sin(theta_i - theta_j) of each bond, and a constant.
inline Supports coupled(int n, const Bonds& bonds) {
    Equations y;
    for (int i = 0; i < n; ++i) {
        auto& points = y.emplace_back();
        points = {point(n, {}), point(n, {{i, 1}}), point(n, {{i, -1}})};
        for (const auto& [a, b] : bonds)
            if (i == a || i == b)
                for (const int sign : {1, -1}) points.push_back(point(n, {{i, sign}, {i == a ? b : a, -sign}}));
    }
    return Supports(n, std::move(y));
}
inline Supports all_to_all(int n) {
    Bonds bonds;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < i; ++j) bonds.emplace_back(i, j);
    return coupled(n, bonds);
}
inline Supports nearest_neighbour(int n) {
    Bonds bonds;
    for (int i = 0; i + 1 < n; ++i) bonds.emplace_back(i, i + 1);
    return coupled(n, bonds);
}

// Kuramoto's oscillators with these bonds between 0 .. nodes-1, of which the last is held at 0.
inline Supports kuramoto(int nodes, const Bonds& bonds) {
    const int n = nodes - 1;
    Equations y;
    for (int i = 0; i < n; ++i) {
        auto& points = y.emplace_back();
        points.push_back(point(n, {}));
        for (const auto& [a, b] : bonds) {
            if (i != a && i != b) continue;
            const int other = i == a ? b : a;
            for (const int sign : {1, -1})
                points.push_back(other == n ? point(n, {{i, sign}}) : point(n, {{i, sign}, {other, -sign}}));
        }
    }
    return without_copies(n, std::move(y));
}
inline Supports kuramoto_complete(int nodes) {
    Bonds bonds;
    for (int i = 0; i < nodes; ++i)
        for (int j = 0; j < i; ++j) bonds.emplace_back(i, j);
    return kuramoto(nodes, bonds);
}
inline Supports kuramoto_grid(int rows, int columns, bool periodic) {
    Bonds bonds;
    const auto node = [&](int r, int c) { return r % rows * columns + c % columns; };
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            if (c + 1 < columns || periodic) bonds.emplace_back(node(r, c), node(r, c + 1));
            if (r + 1 < rows || periodic) bonds.emplace_back(node(r, c), node(r + 1, c));
        }
    return kuramoto(rows * columns, bonds);
}

// Power flow in voltages v_i and u_i for their conjugates, x_2i and x_2i+1; bus 0 is the slack. A bus with a load has
// its complex power given, of the other buses active power and v_i u_i.
inline Supports power_flow(int buses, const std::vector<int>& generators, const Bonds& lines) {
    const int n = 2 * (buses - 1);
    Equations y;
    for (int i = 1; i < buses; ++i) {
        std::vector<Supports::Point> own[2];  // v_i times currents, u_i times their conjugates
        for (const int end : {0, 1}) {
            const int mine = 2 * (i - 1) + end;
            own[end] = {point(n, {}), point(n, {{mine, 1}, {2 * (i - 1) + 1 - end, 1}})};
            for (const auto& [a, b] : lines) {
                if (i != a && i != b) continue;
                const int other = i == a ? b : a;
                own[end].push_back(other == 0 ? point(n, {{mine, 1}})
                                              : point(n, {{mine, 1}, {2 * (other - 1) + 1 - end, 1}}));
            }
        }
        if (std::find(generators.begin(), generators.end(), i) != generators.end()) {
            own[0].insert(own[0].end(), own[1].begin(), own[1].end());
            own[1] = {point(n, {}), point(n, {{2 * (i - 1), 1}, {2 * (i - 1) + 1, 1}})};
        }
        y.push_back(own[0]);
        y.push_back(own[1]);
    }
    return without_copies(n, std::move(y));
}
inline Supports power_flow_9() {
    return power_flow(9, {1, 2}, {{0, 3}, {3, 4}, {4, 5}, {2, 5}, {5, 6}, {6, 7}, {7, 1}, {7, 8}, {8, 3}});
}
inline Supports power_flow_14() {
    return power_flow(14, {1, 2, 5, 7},
                      {{0, 1},  {0, 4},  {1, 2},  {1, 3}, {1, 4}, {2, 3}, {3, 4},  {3, 6},  {3, 8},   {4, 5},
                       {5, 10}, {5, 11}, {5, 12}, {6, 7}, {6, 8}, {8, 9}, {8, 13}, {9, 10}, {11, 12}, {12, 13}});
}

// A system as gfan_mixedvolume --vectorinput reads it.
inline std::string gfan_text(const Supports& supports) {
    std::string y = "{";
    for (const auto& points : supports.equations()) {
        y += y.size() > 1 ? ",\n{" : "{";
        for (std::size_t k = 0; k < points.size(); ++k) {
            y += k > 0 ? ",(" : "(";
            for (std::size_t l = 0; l < points[k].size(); ++l) {
                if (l > 0) y += ',';
                y += std::to_string(points[k][l]);
            }
            y += ")";
        }
        y += "}";
    }
    return y + "}\n";
}

}  // namespace support_families
