/// \file
/// Which solutions on families belong together: connected by walks on the families, and led to real points where there
/// are any.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/detail/family_probe.hpp>

namespace equilibria::detail {

/// Which of the solutions on families belong together, for any system.
class FamilyFinder {
public:
    using Vector = FamilyProbe::Vector;
    struct Group {
        int dimension;
        std::vector<std::size_t> members;  ///< numbers of points
        std::optional<Vector> real_point;
        std::vector<Vector> landmarks;  ///< points of it that others walk to
    };

    /// angles: how many of the n unknowns are defined modulo 2 pi.
    FamilyFinder(const FamilyProbe& probe, int n, int angles)
        : probe_(&probe), n_(n), angles_(static_cast<std::size_t>(angles)), walks_left_(2000 + 1000000 / (n * n * n)) {}

    [[gnu::cold]] std::vector<Group> groups(const std::vector<Vector>& points,
                                            const std::vector<FamilyProbe::Finding>& found) {
        std::vector<Group> y;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const int d = found[k].dimension;
            // where families cross no walk begins or ends: one from a neighbour does
            const Vector& at = found[k].rank_drops || found[k].nullity > d ? found[k].neighbour : points[k];
            const Vector q = probe_->projected(at, n_ - d, 1e-3).value_or(at);
            Group group{d, {k}, std::nullopt, {q}};
            const std::size_t home = connected_group(q, group, y, y.size());
            if (home == y.size()) {
                find_real_point(group);
                y.push_back(std::move(group));
            } else {
                join(y[home], std::move(group));
                if (!y[home].real_point) find_real_point(y[home]);
            }
        }
        // steepest descent may be caught on its way: again, from where a random detour leads
        for (int round = 0; round < 10 && y.size() > 1; ++round)
            for (std::size_t k = y.size(); k-- > 1;) {
                const std::size_t home = connected_group(detour(y[k]), y[k], y, k);
                if (home == k) continue;
                join(y[home], std::move(y[k]));
                y.erase(y.begin() + static_cast<std::ptrdiff_t>(k));
            }
        for (Group& g : y) std::sort(g.members.begin(), g.members.end());
        return y;
    }

private:
    static constexpr std::size_t most_landmarks = 8;

    static void join(Group& home, Group&& guest) {
        home.members.insert(home.members.end(), guest.members.begin(), guest.members.end());
        if (!home.real_point) home.real_point = guest.real_point;
        for (Vector& q : guest.landmarks)
            if (home.landmarks.size() < most_landmarks) home.landmarks.push_back(std::move(q));
    }

    /// The way from one point to another.
    Vector way(const Vector& from, const Vector& to) const {
        Vector y = to;
        for (std::size_t i = 0; i < y.size(); ++i) {
            y[i] -= from[i];
            if (i < angles_) y[i].real(std::remainder(y[i].real(), 2 * std::numbers::pi));
        }
        return y;
    }

    /// A group among y[0 .. last) to one of whose landmarks, the nearest ones first, a walk from q leads, a point of
    /// `from`; `last` if there is none.
    [[gnu::cold]] std::size_t connected_group(const Vector& q, const Group& from, const std::vector<Group>& y,
                                              std::size_t last) {
        if (walks_left_ <= 0) return last;
        struct Mark {
            double distance;
            std::size_t group;
            const Vector* at;
        };
        std::vector<Mark> marks;
        for (std::size_t g = 0; g < last; ++g)
            if (y[g].dimension == from.dimension)
                for (const Vector& at : y[g].landmarks) marks.push_back({FamilyProbe::largest(way(q, at)), g, &at});
        std::stable_sort(marks.begin(), marks.end(),
                         [](const Mark& a, const Mark& b) { return a.distance < b.distance; });
        for (std::size_t k = 0; k < std::min<std::size_t>(marks.size(), 12) && walks_left_-- > 0; ++k) {
            const auto direction = [&](const Vector& at) -> std::optional<Vector> {
                Vector wanted = way(at, *marks[k].at);
                if (FamilyProbe::largest(wanted) < 1e-6) return std::nullopt;
                return wanted;
            };
            if (probe_->walk(q, from.dimension, direction, 80).arrived) return marks[k].group;
        }
        return last;
    }

    /// Some way off from one of the group's landmarks.
    [[gnu::cold]] Vector detour(const Group& group) {
        if (walks_left_-- <= 0) return group.landmarks.front();
        const Vector& begin = group.landmarks[static_cast<std::size_t>(generator_() % group.landmarks.size())];
        Vector target = begin;
        for (auto& x : target) x += std::polar(uniform(generator_, 1, 4), 2 * std::numbers::pi * uniform(generator_));
        const auto direction = [&](const Vector& at) -> std::optional<Vector> {
            Vector way = target;
            for (std::size_t i = 0; i < way.size(); ++i) way[i] -= at[i];
            return way;
        };
        return probe_->walk(begin, group.dimension, direction, 30).at;
    }

    /// A real point of the family with real neighbours, by a walk that lets the imaginary parts vanish.
    [[gnu::cold]] void find_real_point(Group& group) {
        if (real_walks_left_-- <= 0) return;
        const auto direction = [](const Vector& at) -> std::optional<Vector> {
            Vector way(at.size());
            for (std::size_t i = 0; i < at.size(); ++i) way[i] = {0, -at[i].imag()};
            if (FamilyProbe::largest(way) < 1e-7) return std::nullopt;
            return way;
        };
        const auto arrived = probe_->walk(group.landmarks.back(), group.dimension, direction, 120);
        if (!arrived.arrived) return;
        Vector real = arrived.at;
        for (auto& x : real) x = x.real();
        const auto landed = probe_->projected(real, n_ - group.dimension, 1e-5);
        if (!landed || probe_->at(*landed, true).dimension != group.dimension) return;
        group.real_point = landed;
        group.landmarks.push_back(*landed);
    }

    const FamilyProbe* probe_;
    int n_;
    std::size_t angles_;
    int walks_left_;  // seconds' worth: what they leave unconnected stays apart
    int real_walks_left_ = 5000;
    Generator generator_{0x6a09e667f3bcc909};
};

}  // namespace equilibria::detail
