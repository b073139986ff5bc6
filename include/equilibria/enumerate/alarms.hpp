/// \file
/// Tests of a root set that cost no path: laws that the complete set obeys. None is a proof: roots lost in pairs of
/// opposite index pass Poincare-Hopf, conjugate pairs pass the conjugates. (See torque_trace.hpp for a test that both
/// fail.)
#pragma once

#include <cstdint>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/model/sizes.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/run/executor.hpp>
#include <equilibria/run/ranks.hpp>

namespace equilibria {

namespace detail {

/// How many roots have no image among the roots, and how many a duplicate.
struct RootPartners {
    std::uint64_t without_conjugate = 0, without_mirror_image = 0, doubled = 0;
};
RootPartners find_partners(const RuntimeSizes& sizes, const std::vector<RootView>& roots, const Executor& executor,
                           const Ranks& ranks);

/// The sum of (-1)^index over nondegenerate equilibria, given by their indices.
Alarm poincare_hopf(const std::vector<std::int64_t>& by_index, bool only_angles, bool regular);

/// The alarms about partners. symmetric: the model is, under theta -> -theta.
Alarms alarms_of(const RootPartners& partners, bool symmetric);

}  // namespace detail

/// The tests that cost no path, done on the set as it is. set.alarms is not read: `enumerate` stores there what this
/// returns. The trace test comes out as not applied. Of several ranks, which all have the set, each compares a part.
template <class M>
[[gnu::cold]] Alarms check_alarms(const RootSet<M>& set, const Executor& executor = {}, const Ranks& ranks = {}) {
    std::vector<detail::RootView> roots;
    roots.reserve(set.roots.size());
    for (const auto& root : set.roots) roots.push_back(detail::view(root));
    Alarms y = detail::alarms_of(detail::find_partners(set.model.sizes, roots, executor, ranks),
                                 set.model.reflection_symmetric);
    y.poincare_hopf = detail::poincare_hopf(set.by_index(), set.model.sizes.coordinates == 0,
                                            set.degenerate() == 0 && set.paths.singular == 0);
    return y;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/alarms_definitions.hpp>
#endif
