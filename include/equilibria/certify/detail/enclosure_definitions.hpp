/// \file
/// See certify/enclosure.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <boost/pending/disjoint_sets.hpp>

#include <equilibria/certify/enclosure.hpp>
#include <equilibria/core/random.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::vector<std::size_t> groups_of_enclosures(const std::vector<Enclosure<double>>& enclosures) {
    int n = 0;
    for (const auto& e : enclosures) n = std::max(n, e.unknowns.size());
    Generator generator(0x5eed);
    SizedArray<double, at_run_time> weight(4 * n);
    for (double& w : weight) w = uniform(generator, 0.5, 1.5);
    struct Entry {
        double low, high;
        std::size_t k;
    };
    std::vector<Entry> entries;
    entries.reserve(enclosures.size());
    for (std::size_t k = 0; k < enclosures.size(); ++k) {
        const auto& e = enclosures[k];
        if (e.unknowns.size() == 0) continue;
        double key = 0, size = 0, reach = 0;
        const auto add = [&](const Complex<double>& z, double rad, int w) {
            key += weight[w] * z.re + weight[w + 1] * z.im;
            size += magnitude_bound(z) * 3;
            reach += 3 * rad;  // the weights of the real and imaginary part together
        };
        for (int u = 0; u < n; ++u) {
            const auto& at = e.unknowns[u];
            add(at.value, at.off, 4 * u);
            add(at.sine, at.off, 4 * u + 2);
        }
        reach =
            rounded_up(reach * (1 + 4 * n * rounding_unit<double>)) + rounded_up(8 * n * rounding_unit<double> * size);
        entries.push_back({key - reach, key + reach, k});
    }
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return std::pair(a.low, a.k) < std::pair(b.low, b.k); });
    boost::disjoint_sets_with_storage<> groups(enclosures.size());
    for (std::size_t i = 0; i < entries.size(); ++i)
        for (std::size_t j = i + 1; j < entries.size() && entries[j].low <= entries[i].high; ++j) {
            if (!disjoint(enclosures[entries[i].k], enclosures[entries[j].k]))
                groups.union_set(entries[i].k, entries[j].k);
        }
    // each group goes by its first enclosure
    std::vector<std::size_t> first(enclosures.size()), least(enclosures.size(), enclosures.size());
    for (std::size_t k = 0; k < first.size(); ++k) {
        std::size_t& here = least[groups.find_set(k)];
        first[k] = here = std::min(here, k);
    }
    return first;
}

}  // namespace equilibria
