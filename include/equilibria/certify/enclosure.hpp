/// \file
/// Regions of (cos, sin, x) space that hold one root each, and which of them are proved to be disjoint.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <boost/pending/disjoint_sets.hpp>

#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/core/random.hpp>

namespace equilibria {

/// All points with |cos - c_u| <= off_u and |sin - s_u| <= off_u of each angle, |x - x_u| <= off_u of each coordinate.
template <class M, class S>
struct Enclosure {
    Point<M, S> center;
    Array<S, n_unknowns<M>> off;

    /// That of lane k of a proof.
    template <class R>
    static Enclosure of(const KrawczykResult<M, R>& proof, int k) {
        Enclosure y;
        copy_lane(proof.center, k, y.center, 0);
        for (int u = 0; u < n_unknowns<M>; ++u) y.off[u] = lane(proof.off[u], k);
        return y;
    }
    /// The smallest one over T that contains this one.
    template <class T>
    Enclosure<M, T> to() const {
        Enclosure<M, T> y;
        const auto convert = [](const Complex<S>& a, Complex<T>& b) {
            b = Complex<T>(static_cast<T>(a.re), static_cast<T>(a.im));
            return rounded_up<T>(4 * rounding_unit<T> * magnitude_bound(b));
        };
        for (int u = 0; u < n_unknowns<M>; ++u) {
            T moved(0);
            if (u < n_angles<M>)
                moved = std::max(convert(center.c[u], y.center.c[u]), convert(center.s[u], y.center.s[u]));
            else
                moved = convert(center.x[u - n_angles<M>], y.center.x[u - n_angles<M>]);
            y.off[u] = rounded_up<T>(static_cast<T>(off[u]) * (1 + 4 * rounding_unit<T>)+moved);
        }
        return y;
    }

    /// Whether no point in it is real.
    bool excludes_real_points() const {
        const auto outside = [](const Complex<S>& z, const S& rad) { return z.im > rad || -z.im > rad; };
        for (int u = 0; u < n_unknowns<M>; ++u)
            if (u < n_angles<M> ? outside(center.c[u], off[u]) || outside(center.s[u], off[u])
                                : outside(center.x[u - n_angles<M>], off[u]))
                return true;
        return false;
    }
    friend bool disjoint(const Enclosure& a, const Enclosure& b) {
        for (int u = 0; u < n_unknowns<M>; ++u) {
            const S reach = rounded_up<S>(a.off[u] + b.off[u]);
            const auto apart = [&](const Complex<S>& y, const Complex<S>& z) {
                const Complex<S> d =
                    y - z;  // the differences of floats close to each other are exact, others nearly so
                const S re = d.re < 0 ? S(-d.re) : d.re, im = d.im < 0 ? S(-d.im) : d.im;
                return std::max(re, im) * (1 - 2 * rounding_unit<S>) > reach;
            };
            if (u < n_angles<M> ? apart(a.center.c[u], b.center.c[u]) || apart(a.center.s[u], b.center.s[u])
                                : apart(a.center.x[u - n_angles<M>], b.center.x[u - n_angles<M>]))
                return true;
        }
        return false;
    }
};

/// Groups enclosures that could not be shown to be disjoint, directly or through others: two from different groups
/// share no point. Returns for each the number of the first of its group. No all-pairs comparison: a linear form of
/// the coordinates maps each enclosure to an interval, and only those with intersecting intervals are compared.
template <class M>
std::vector<std::size_t> groups_of_enclosures(const std::vector<Enclosure<M, double>>& enclosures) {
    Generator generator(0x5eed);
    Array<double, 4 * n_unknowns<M>> weight;
    for (double& w : weight) w = uniform(generator, 0.5, 1.5);
    struct Entry {
        double low, high;
        std::size_t k;
    };
    std::vector<Entry> entries(enclosures.size());
    for (std::size_t k = 0; k < enclosures.size(); ++k) {
        const auto& e = enclosures[k];
        double key = 0, size = 0, reach = 0;
        const auto add = [&](const Complex<double>& z, double rad, int w) {
            key += weight[w] * z.re + weight[w + 1] * z.im;
            size += magnitude_bound(z) * 3;
            reach += 3 * rad;  // the weights of the real and imaginary part together
        };
        for (int u = 0; u < n_unknowns<M>; ++u) {
            if (u < n_angles<M>) {
                add(e.center.c[u], e.off[u], 4 * u);
                add(e.center.s[u], e.off[u], 4 * u + 2);
            } else {
                add(e.center.x[u - n_angles<M>], e.off[u], 4 * u);
            }
        }
        reach = rounded_up(reach * (1 + 4 * n_unknowns<M> * rounding_unit<double>)) +
                rounded_up(8 * n_unknowns<M> * rounding_unit<double> * size);
        entries[k] = {key - reach, key + reach, k};
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
