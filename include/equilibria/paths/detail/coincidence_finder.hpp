/// \file
/// Finds the endpoints that coincide, without comparing all pairs: each gets a key, a random combination of its
/// coordinates; endpoints that are close have close keys, so only neighbours in the order of the keys are compared.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <boost/pending/disjoint_sets.hpp>

#include <equilibria/core/key_sort.hpp>
#include <equilibria/evaluation/point.hpp>

namespace equilibria::detail {

class CoincidenceFinder {
public:
    /// reflected: a point and its mirror image theta -> -theta count as the same.
    explicit CoincidenceFinder(bool reflected, const RuntimeSizes& sizes) : reflected_(reflected) {
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
        struct Entry {
            double key, size;
            std::size_t k;
        };
        std::vector<Entry> entries;
        for (std::size_t k = 0; k < size; ++k)
            if (const PointView q = point(k); !q.empty()) {
                const auto [key, magnitude] = key_of(q);
                entries.push_back({key, magnitude, k});
            }
        sort_by_key(entries);
        boost::disjoint_sets_with_storage<> groups(entries.size());
        std::vector<std::uint8_t> joined(entries.size());
        for (std::size_t i = 0; i < entries.size(); ++i)
            for (std::size_t j = i + 1;
                 j < entries.size() && entries[j].key - entries[i].key <= 8 * tolerance * entries[i].size; ++j)
                if (same(point(entries[i].k), point(entries[j].k), tolerance)) {
                    groups.union_set(i, j);
                    joined[i] = joined[j] = 1;
                }
        std::vector<std::size_t> least(entries.size(), size);  // of the numbers in a group
        for (std::size_t i = 0; i < entries.size(); ++i)
            if (joined[i]) least[groups.find_set(i)] = std::min(least[groups.find_set(i)], entries[i].k);
        std::vector<std::pair<std::size_t, std::size_t>> members;  // of groups: the least number, the number
        for (std::size_t i = 0; i < entries.size(); ++i)
            if (joined[i]) members.push_back({least[groups.find_set(i)], entries[i].k});
        std::sort(members.begin(), members.end());
        std::vector<std::vector<std::size_t>> found;
        for (std::size_t m = 0; m < members.size(); ++m) {
            if (m == 0 || members[m].first != members[m - 1].first) found.emplace_back();
            found.back().push_back(members[m].second);
        }
        return found;
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

    bool reflected_;
    std::vector<double> cosine_, sine_, coordinate_;
};

}  // namespace equilibria::detail
