/// \file
/// Finds the endpoints that coincide, without comparing all pairs: each gets a key, a random combination of its
/// coordinates; endpoints that are close have close keys, so only neighbours in the order of the keys are compared.
/// Keys that do not fit into memory are sorted by ranges, in files.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <random>
#include <unordered_map>
#include <utility>
#include <vector>

#include <equilibria/core/key_sort.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/storage/key_files.hpp>

namespace equilibria::detail {

class CoincidenceFinder {
public:
    /// reflected: a point and its mirror image theta -> -theta count as the same.
    explicit CoincidenceFinder(bool reflected, const RuntimeSizes& sizes, KeyLimits limits = {})
        : reflected_(reflected), limits_(std::move(limits)) {
        std::minstd_rand generator(0x9e3779b9);  // any numbers without relations; seeding a larger one takes longer
        const auto draw = [&](std::vector<double>& weights, int n) {
            for (int k = 0; k < n; ++k)
                weights.push_back(0.5 + static_cast<double>(generator()) / static_cast<double>(generator.max()));
        };
        draw(cosine_, sizes.angles), draw(sine_, sizes.angles), draw(coordinate_, sizes.coordinates);
    }

    /// Groups of two or more numbers k < size whose points are within `tolerance` of each other, relative to their
    /// size; point(k) gives a PointView, valid until the next call but one, an empty one to leave k out. Each group
    /// is sorted, and so are the groups.
    template <class PointOf>
    std::vector<std::vector<std::size_t>> groups(std::size_t size, PointOf&& point, double tolerance) const {
        Joined joined;
        const auto compare = [&](std::vector<Entry>& entries) {
            sort_by_key(entries);
            for (std::size_t i = 0; i < entries.size(); ++i)
                for (std::size_t j = i + 1; j < entries.size() && entries[j].key <= reach(entries[i], tolerance); ++j)
                    if (same(point(entries[i].k), point(entries[j].k), tolerance))
                        joined.join(entries[i].k, entries[j].k);
        };
        const auto each = [&](auto&& take) {
            for (std::size_t k = 0; k < size; ++k)
                if (const auto entry = entry_of(k, point(k))) take(*entry);
        };
        if (limits_.beside.empty() || size <= limits_.memory / sizeof(Entry)) {
            std::vector<Entry> entries;
            each([&](const Entry& entry) { entries.push_back(entry); });
            compare(entries);
            return joined.groups();
        }
        // ranges of keys, each with those of the range below whose neighbours may be in it
        KeyFiles files(limits_.beside, boundaries(size, point));
        each([&](const Entry& entry) { files.put(entry); });
        std::vector<Entry> entries;
        for (std::size_t range = 0; range < files.ranges(); ++range) {
            files.get(range, entries);
            compare(entries);
            std::erase_if(entries, [&](const Entry& e) { return !(reach(e, tolerance) >= files.end_of(range)); });
        }
        return joined.groups();
    }

    bool same(const PointView& a, const PointView& b, double tolerance) const {
        return close(a, b, 1, tolerance) || (reflected_ && close(a, b, -1, tolerance));
    }

private:
    /// A combination of the cosines and coordinates, and of the sines: squared, where the mirror image is the same.
    std::pair<double, double> key_of(const PointView& q) const {
        Complex<double> even{0, 0}, odd{0, 0};
        double size = 1;
        for (std::size_t i = 0; i < q.c.size(); ++i) {
            even += cosine_[i] * q.c[i];
            odd += sine_[i] * q.s[i];
            size += 2 * std::sqrt(norm2(q.c[i]) + norm2(q.s[i]));
        }
        for (std::size_t j = 0; j < q.x.size(); ++j) {
            even += coordinate_[j] * q.x[j];
            size += 2 * std::sqrt(norm2(q.x[j]));
        }
        if (!reflected_) return {even.re + 0.7 * even.im + 1.3 * odd.re + 0.6 * odd.im, size};
        const Complex<double> square = odd * odd;
        return {even.re + 0.7 * even.im + square.re + 0.6 * square.im, size * size};
    }
    static bool close(const PointView& a, const PointView& b, double sign, double tolerance) {
        const double most = tolerance * tolerance;
        for (std::size_t i = 0; i < a.c.size(); ++i)
            if (!(norm2(a.c[i] - b.c[i]) + norm2(a.s[i] - sign * b.s[i]) <= most * (norm2(a.c[i]) + norm2(a.s[i]))))
                return false;
        for (std::size_t j = 0; j < a.x.size(); ++j)
            if (!(norm2(a.x[j] - b.x[j]) <= most * (1 + norm2(a.x[j])))) return false;
        return true;
    }

    using Entry = KeyEntry;

    /// The largest key of a point that may coincide with this one.
    static double reach(const Entry& e, double tolerance) { return e.key + 8 * tolerance * e.size; }
    std::optional<Entry> entry_of(std::size_t k, const PointView& q) const {
        if (q.empty()) return {};
        const auto [key, magnitude] = key_of(q);
        return Entry{key, magnitude, k};
    }
    /// Keys between which about as many keys lie as the memory holds, by a sample.
    template <class PointOf>
    std::vector<double> boundaries(std::size_t size, PointOf&& point) const {
        // half of it: ranges are not all alike, and there are those of the range below
        const std::size_t held = std::max<std::size_t>(1, limits_.memory / (2 * sizeof(Entry)));
        const std::size_t ranges = std::min(KeyFiles::most, (size + held - 1) / held);
        const std::size_t step = std::max<std::size_t>(1, size / 65536);
        std::vector<Entry> sample;
        for (std::size_t k = 0; k < size; k += step)
            if (const auto entry = entry_of(k, point(k))) sample.push_back(*entry);
        sort_by_key(sample);
        std::vector<double> y;
        for (std::size_t range = 1; range < ranges && !sample.empty(); ++range)
            y.push_back(sample[range * sample.size() / ranges].key);
        return y;
    }

    /// Numbers that were joined, of which there are few.
    class Joined {
    public:
        void join(std::size_t a, std::size_t b) {
            const std::size_t i = least(a), j = least(b);
            if (i != j) parent_[std::max(i, j)] = std::min(i, j);
        }
        std::vector<std::vector<std::size_t>> groups() {
            std::vector<std::pair<std::size_t, std::size_t>> members;  // the least number of the group, the number
            for (const auto& [k, _] : parent_) members.emplace_back(k, k);
            for (auto& [group, k] : members) group = least(k);
            std::sort(members.begin(), members.end());
            std::vector<std::vector<std::size_t>> found;
            for (std::size_t m = 0; m < members.size(); ++m) {
                if (m == 0 || members[m].first != members[m - 1].first) found.emplace_back();
                found.back().push_back(members[m].second);
            }
            return found;
        }

    private:
        std::size_t least(std::size_t k) {
            std::size_t& parent = parent_.try_emplace(k, k).first->second;
            if (parent == k) return k;
            std::size_t top = parent;
            for (std::size_t above; (above = parent_.at(top)) != top;) top = above;
            return parent = top;
        }
        std::unordered_map<std::size_t, std::size_t> parent_;
    };

    bool reflected_;
    KeyLimits limits_;
    std::vector<double> cosine_, sine_, coordinate_;
};

}  // namespace equilibria::detail
