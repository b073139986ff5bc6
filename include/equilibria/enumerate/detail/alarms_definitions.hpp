/// \file
/// See enumerate/alarms.hpp. Each root goes by three numbers: a key that conjugation and theta -> -theta leave as it
/// is, and two sums that change their signs with them. In the order of the keys a root's images and duplicates are next
/// to it, and the sums, which lie in one piece, leave hardly any other to be compared: n log n in all.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <equilibria/core/key_sort.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/alarms.hpp>

namespace equilibria::detail {

/// Whether a differs from b with these signs of its real and imaginary parts by at most `most`: angles modulo 2 pi,
/// coordinates against 1 + |x|.
EQUILIBRIA_INLINE bool close_roots(const RuntimeSizes& sizes, const RootView& a, const RootView& b, double real_sign,
                                   double imaginary_sign, double most) {
    for (int u = 0; u < sizes.unknowns; ++u) {
        const std::complex<double>&x = a.q[static_cast<std::size_t>(u)], &y = b.q[static_cast<std::size_t>(u)];
        double re = std::abs(x.real() - real_sign * y.real());
        const double im = x.imag() - imaginary_sign * y.imag();
        if (u < sizes.angles && re > std::numbers::pi) re = 2 * std::numbers::pi - re;
        const double size = u < sizes.angles ? 1 : 1 + std::abs(x);
        if (!(re * re + im * im <= most * most * size * size)) return false;
    }
    return true;
}

class PartnerFinder {
public:
    RootPartners found;

    PartnerFinder(const RuntimeSizes& sizes, const std::vector<RootView>& roots, const Executor& executor,
                  const Ranks& ranks)
        : sizes_(sizes), roots_(&roots), weight_(3 * sizes.unknowns), entries_(roots.size()) {
        Generator generator(0xa1a2);  // any numbers without relations
        for (double& w : weight_) w = uniform(generator, 0.5, 1);
        executor.for_blocks(roots.size(), 4096, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) {
                if (k + soon < roots.size()) fetch(roots[k + soon]);
                entries_[k] = entry(roots[k], k);
            }
        });
        sort_by_key(entries_);
        const auto share = [&](int rank) {
            return roots.size() * static_cast<std::size_t>(rank) / static_cast<std::size_t>(ranks.size());
        };
        const std::size_t begin = share(ranks.rank()), end = share(ranks.rank() + 1);
        std::vector<std::array<std::uint8_t, 3>> images(end - begin);
        executor.for_blocks(images.size(), 4096, [&](std::size_t first, std::size_t last) {
            for (std::size_t e = begin + first; e < begin + last; ++e) {
                if (e + 2 * soon < roots.size()) __builtin_prefetch(&roots[entries_[e + 2 * soon].root]);
                if (e + soon < roots.size()) fetch(roots[entries_[e + soon].root]);
                images[e - begin] = partners(e);
            }
        });
        std::array<std::uint64_t, 3> counts{};
        for (const auto& f : images) counts[0] += !f[0], counts[1] += !f[1], counts[2] += f[2];
        ranks.add_up(counts);
        found = {counts[0], counts[1], counts[2]};
    }

private:
    struct Entry {
        double key, re, im;  ///< conjugation changes the sign of im, theta -> -theta those of both sums
        float near, same;    ///< by how much they may differ from an image's, and from a duplicate's
        std::size_t root;
    };

    Entry entry(const RootView& root, std::size_t k) const {
        Entry e{0, 0, 0, 0, 0, k};
        double reach = 0;  // how much the numbers change at most for a change of 1 in the root
        const double* w = weight_.begin();
        for (int u = 0; u < sizes_.unknowns; ++u, w += 3) {
            const auto& z = root.q[static_cast<std::size_t>(u)];
            if (u < sizes_.angles) {
                const double re = std::abs(z.real());  // up to pi it has no jump on the circle
                e.key += w[0] * re + w[1] * std::abs(z.imag());
                e.re += w[2] * z.real() * (std::numbers::pi - re);
                reach += 4;
            } else {
                e.key += w[0] * z.real() + w[1] * std::abs(z.imag());
                e.re += w[2] * z.real();
                reach += 2 * (1 + std::abs(z));
            }
            e.im += w[0] * z.imag();
        }
        e.near = static_cast<float>(accuracy(root) * reach);
        e.same = static_cast<float>(duplicate_distance(root) * reach);
        return e;
    }

    /// Roots lie anywhere in memory: those that come soon are asked for early.
    static constexpr std::size_t soon = 8;
    static void fetch(const RootView& root) {
        constexpr std::size_t line = 64 / sizeof(root.q[0]);
        for (std::size_t u = 0; u < root.q.size(); u += line) __builtin_prefetch(&root.q[u]);
    }
    /// How far the computed root may be from the true one.
    static double accuracy(const RootView& root) { return root.singular ? 1e-4 : 1e-9 + 1e-13 * root.condition; }
    /// Two regular roots have a distance of the order of 1 / condition.
    static double duplicate_distance(const RootView& root) {
        return root.singular ? 0 : std::clamp(1e-3 / root.condition, 1e-10, 1e-6);
    }

    /// Whether entry e has a conjugate, a mirror image, a duplicate.
    std::array<std::uint8_t, 3> partners(std::size_t e) const {
        const Entry& own = entries_[e];
        const RootView& root = (*roots_)[own.root];
        std::array<std::uint8_t, 3> has{};
        const auto look = [&](std::size_t k) {
            const Entry& other = entries_[k];
            const double re = std::abs(own.re - other.re), re_turned = std::abs(own.re + other.re);
            const double im = std::abs(own.im - other.im), im_turned = std::abs(own.im + other.im);
            const auto close = [&](double real_sign, double imaginary_sign, double most) {
                return close_roots(sizes_, root, (*roots_)[other.root], real_sign, imaginary_sign, most);
            };
            if (!has[0] && re <= own.near && im_turned <= own.near) has[0] = close(1, -1, accuracy(root));
            if (!has[1] && re_turned <= own.near && im_turned <= own.near) has[1] = close(-1, -1, accuracy(root));
            if (!has[2] && k != e && re <= own.same && im <= own.same) has[2] = close(1, 1, duplicate_distance(root));
        };
        const double most = std::max(own.near, own.same);
        for (std::size_t k = e; k < entries_.size() && entries_[k].key - own.key <= most; ++k) look(k);
        for (std::size_t k = e; k-- > 0 && own.key - entries_[k].key <= most;) look(k);
        return has;
    }

    RuntimeSizes sizes_;
    const std::vector<RootView>* roots_;
    SizedArray<double, at_run_time> weight_;  // three an unknown
    std::vector<Entry> entries_;
};

EQUILIBRIA_INLINE RootPartners find_partners(const RuntimeSizes& sizes, const std::vector<RootView>& roots,
                                             const Executor& executor, const Ranks& ranks) {
    return PartnerFinder(sizes, roots, executor, ranks).found;
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
