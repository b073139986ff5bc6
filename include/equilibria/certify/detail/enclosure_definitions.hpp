/// \file
/// See certify/enclosure.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <boost/pending/disjoint_sets.hpp>

#include <equilibria/certify/enclosure.hpp>
#include <equilibria/core/key_sort.hpp>
#include <equilibria/core/random.hpp>

namespace equilibria {

EQUILIBRIA_INLINE EnclosureForm::EnclosureForm(int unknowns) : weight_(4 * unknowns) {
    Generator generator(0x5eed);
    for (double& w : weight_) w = uniform(generator, 0.5, 1.5);
}

namespace detail {

/// Calls meet(a, b) for each two intervals that meet.
EQUILIBRIA_INLINE void for_each_meeting(const std::vector<EnclosureInterval>& intervals,
                                        const std::function<void(std::size_t, std::size_t)>& meet) {
    struct Entry {
        double key, high;  // the interval, from its low end on
        std::size_t k;
    };
    std::vector<Entry> entries;
    entries.reserve(intervals.size());
    for (std::size_t k = 0; k < intervals.size(); ++k)
        if (intervals[k].low <= intervals[k].high) entries.push_back({intervals[k].low, intervals[k].high, k});
    sort_by_key(entries);
    for (std::size_t i = 0; i < entries.size(); ++i)
        for (std::size_t j = i + 1; j < entries.size() && entries[j].key <= entries[i].high; ++j)
            meet(entries[i].k, entries[j].k);
}

}  // namespace detail

EQUILIBRIA_INLINE std::vector<std::size_t> meeting(const std::vector<EnclosureInterval>& intervals) {
    std::vector<std::uint8_t> meets(intervals.size());
    detail::for_each_meeting(intervals, [&](std::size_t a, std::size_t b) { meets[a] = meets[b] = 1; });
    std::vector<std::size_t> y;
    for (std::size_t k = 0; k < meets.size(); ++k)
        if (meets[k]) y.push_back(k);
    return y;
}

EQUILIBRIA_INLINE std::vector<std::size_t> groups_of_enclosures(const std::vector<Enclosure<double>>& enclosures) {
    const std::size_t size = enclosures.size();
    int n = 0;
    for (const auto& e : enclosures) n = std::max(n, e.unknowns.size());
    const EnclosureForm form(n);
    std::vector<EnclosureInterval> intervals(size);
    for (std::size_t k = 0; k < size; ++k)
        if (enclosures[k].unknowns.size() > 0) intervals[k] = form(enclosures[k]);
    boost::disjoint_sets_with_storage<> groups(size);
    detail::for_each_meeting(intervals, [&](std::size_t a, std::size_t b) {
        if (!disjoint(enclosures[a], enclosures[b])) groups.union_set(a, b);
    });
    // each group goes by its first enclosure
    std::vector<std::size_t> first(size), least(size, size);
    for (std::size_t k = 0; k < size; ++k) {
        std::size_t& here = least[groups.find_set(k)];
        first[k] = here = std::min(here, k);
    }
    return first;
}

}  // namespace equilibria
