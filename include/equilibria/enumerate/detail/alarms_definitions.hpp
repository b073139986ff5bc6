/// \file
/// See enumerate/alarms.hpp. Partners are looked for by a key that conjugation and theta -> -theta leave as it is, so
/// that one pass over the roots in the order of their keys finds images and duplicates, n log n in all.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <equilibria/enumerate/alarms.hpp>

namespace equilibria::detail {

/// Whether a and image(b) differ by at most `most`: angles modulo 2 pi, coordinates against 1 + |x|.
EQUILIBRIA_INLINE bool close_roots(const RuntimeSizes& sizes, const RootView& a, const RootView& b, bool conjugated,
                                   bool reflected, double most) {
    for (int u = 0; u < sizes.unknowns; ++u) {
        const double sign = reflected ? -1 : 1;
        double re = std::abs(a.q[u].real() - sign * b.q[u].real());
        const double im = a.q[u].imag() - (conjugated ? -sign : sign) * b.q[u].imag();
        if (u < sizes.angles && re > std::numbers::pi) re = 2 * std::numbers::pi - re;
        const double size = u < sizes.angles ? 1 : 1 + std::abs(a.q[u]);
        if (!(re * re + im * im <= most * most * size * size)) return false;
    }
    return true;
}

class PartnerFinder {
public:
    RootPartners found;

    PartnerFinder(const RuntimeSizes& sizes, const std::vector<RootView>& roots, const Executor& executor)
        : sizes_(sizes), roots_(&roots), entries_(roots.size()) {
        executor.for_blocks(roots.size(), 4096, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) entries_[k] = entry(roots[k], k);
        });
        std::sort(entries_.begin(), entries_.end(),
                  [](const Entry& a, const Entry& b) { return std::pair(a.key, a.root) < std::pair(b.key, b.root); });
        std::vector<std::array<std::uint8_t, 3>> images(roots.size());
        executor.for_blocks(roots.size(), 4096, [&](std::size_t first, std::size_t last) {
            for (std::size_t e = first; e < last; ++e) images[e] = partners(e);
        });
        for (const auto& f : images)
            found.without_conjugate += !f[0], found.without_mirror_image += !f[1], found.doubled += f[2];
    }

private:
    struct Entry {
        double key, size;  ///< size: how much the key changes at most for a change of 1 in the root
        std::size_t root;
    };

    /// Conjugation and reflection change the signs of all imaginary parts, or of all parts.
    Entry entry(const RootView& root, std::size_t k) const {
        // fixed numbers without relations: 1/sqrt of primes
        static constexpr double weights[] = {0.70710678, 0.57735027, 0.44721360, 0.37796447,
                                             0.30151134, 0.27735010, 0.24253563, 0.22941573};
        Entry e{0, 2.0 * sizes_.unknowns, k};
        for (int u = 0; u < sizes_.unknowns; ++u) {
            const double w = weights[u % 8] / (1 + u / 8);
            if (u < sizes_.angles) {
                e.key += w * std::cos(root.q[u].real()) + (1 - w) * std::abs(root.q[u].imag());
            } else {
                e.key += w * root.q[u].real();
                e.size += 2 * std::abs(root.q[u]);
            }
        }
        return e;
    }

    /// How far the computed root may be from the true one.
    static double accuracy(const RootView& root) { return root.singular ? 1e-4 : 1e-9 + 1e-13 * root.condition; }
    /// Two regular roots have a distance of the order of 1 / condition.
    static double duplicate_distance(const RootView& root) {
        return root.singular ? 0 : std::clamp(1e-3 / root.condition, 1e-10, 1e-6);
    }

    /// Whether entry e has a conjugate, a mirror image, a duplicate.
    std::array<std::uint8_t, 3> partners(std::size_t e) const {
        const RootView& root = (*roots_)[entries_[e].root];
        const double near = accuracy(root), same = duplicate_distance(root);
        std::array<std::uint8_t, 3> has{};
        const auto look = [&](std::size_t other) {
            const RootView& partner = (*roots_)[entries_[other].root];
            if (!has[0]) has[0] = close_roots(sizes_, root, partner, true, false, near);
            if (!has[1]) has[1] = close_roots(sizes_, root, partner, false, true, near);
            if (!has[2]) has[2] = other != e && close_roots(sizes_, root, partner, false, false, same);
        };
        const double reach = std::max(near, same) * entries_[e].size;
        for (std::size_t k = e; k < entries_.size() && entries_[k].key - entries_[e].key <= reach; ++k) look(k);
        for (std::size_t k = e; k-- > 0 && entries_[e].key - entries_[k].key <= reach;) look(k);
        return has;
    }

    RuntimeSizes sizes_;
    const std::vector<RootView>* roots_;
    std::vector<Entry> entries_;
};

EQUILIBRIA_INLINE RootPartners find_partners(const RuntimeSizes& sizes, const std::vector<RootView>& roots,
                                             const Executor& executor) {
    return PartnerFinder(sizes, roots, executor).found;
}

EQUILIBRIA_INLINE std::string counted(const Alarm& a) { return std::to_string(static_cast<std::int64_t>(a.value)); }

/// The sum of (-1)^index over nondegenerate equilibria, given by their indices.
EQUILIBRIA_INLINE Alarm poincare_hopf(const std::vector<std::int64_t>& by_index, bool only_angles, bool regular) {
    Alarm y;
    if (!only_angles) {
        y.sentence = "Poincare-Hopf does not apply: the unknowns are not only angles";
    } else if (!regular) {
        y.sentence = "Poincare-Hopf does not apply: there are singular roots";
    } else {
        std::int64_t sum = 0;
        for (std::size_t k = 0; k < by_index.size(); ++k) sum += k % 2 == 0 ? by_index[k] : -by_index[k];
        y.applied = true;
        y.value = static_cast<double>(sum);
        y.sentence = "the sum of (-1)^index is " + counted(y) + ", on a torus it is 0";
    }
    return y;
}

EQUILIBRIA_INLINE Alarms alarms_of(const RootPartners& partners, bool symmetric) {
    Alarms y;
    y.conjugates = {true, static_cast<double>(partners.without_conjugate), 0, {}};
    y.conjugates.sentence = counted(y.conjugates) + " roots lack their complex conjugate";
    if (symmetric) {
        y.mirror = {true, static_cast<double>(partners.without_mirror_image), 0, {}};
        y.mirror.sentence = counted(y.mirror) + " roots lack their image under theta -> -theta";
    } else {
        y.mirror.sentence = "the model has no symmetry theta -> -theta";
    }
    y.duplicates = {true, static_cast<double>(partners.doubled), 0, {}};
    y.duplicates.sentence = counted(y.duplicates) + " roots are closer to another one than regular roots can be";
    y.trace.sentence = "the trace test was not done";
    return y;
}

}  // namespace equilibria::detail
