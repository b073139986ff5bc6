/// \file
/// Regions of (cos, sin, x) space that hold one root each, and which of them are proved to be disjoint.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// All points with |cos - c_u| <= off_u and |sin - s_u| <= off_u of each angle, |x - x_u| <= off_u of each coordinate.
template <class S>
struct Enclosure {
    RuntimePoint<S> center;
    SizedArray<S, at_run_time> off;

    Enclosure() = default;
    /// Room for one.
    explicit Enclosure(const RuntimeSizes& sizes)
        : center(point_of_zeros<RuntimeUnknowns, S>(sizes)), off(sizes.unknowns) {}

    /// That of lane k of a proof.
    template <class R>
    static Enclosure of(const KrawczykResult<R>& proof, int k) {
        Enclosure y;
        copy_lane(proof.center, k, y.center, 0);
        y.off.resize(proof.off.size());
        for (int u = 0; u < y.off.size(); ++u) y.off[u] = lane(proof.off[u], k);
        return y;
    }
    /// The smallest one over T that contains this one.
    template <class T>
    Enclosure<T> to() const {
        Enclosure<T> y(sizes());
        const auto convert = [](const Complex<S>& a, Complex<T>& b) {
            b = Complex<T>(static_cast<T>(a.re), static_cast<T>(a.im));
            return rounded_up<T>(4 * rounding_unit<T> * magnitude_bound(b));
        };
        for (int u = 0; u < off.size(); ++u) {
            T moved(0);
            if (u < center.c.size())
                moved = std::max(convert(center.c[u], y.center.c[u]), convert(center.s[u], y.center.s[u]));
            else
                moved = convert(center.x[u - center.c.size()], y.center.x[u - center.c.size()]);
            y.off[u] = rounded_up<T>(static_cast<T>(off[u]) * (1 + 4 * rounding_unit<T>)+moved);
        }
        return y;
    }

    RuntimeSizes sizes() const { return {center.c.size(), center.x.size()}; }

    /// Whether no point in it is real.
    bool excludes_real_points() const {
        const auto outside = [](const Complex<S>& z, const S& rad) { return z.im > rad || -z.im > rad; };
        for (int u = 0; u < off.size(); ++u)
            if (u < center.c.size() ? outside(center.c[u], off[u]) || outside(center.s[u], off[u])
                                : outside(center.x[u - center.c.size()], off[u]))
                return true;
        return false;
    }
    friend bool disjoint(const Enclosure& a, const Enclosure& b) {
        for (int u = 0; u < a.off.size(); ++u) {
            const S reach = rounded_up<S>(a.off[u] + b.off[u]);
            const auto apart = [&](const Complex<S>& y, const Complex<S>& z) {
                const Complex<S> d =
                    y - z;  // the differences of floats close to each other are exact, others nearly so
                const S re = d.re < 0 ? S(-d.re) : d.re, im = d.im < 0 ? S(-d.im) : d.im;
                return std::max(re, im) * (1 - 2 * rounding_unit<S>) > reach;
            };
            if (u < a.center.c.size() ? apart(a.center.c[u], b.center.c[u]) || apart(a.center.s[u], b.center.s[u])
                                : apart(a.center.x[u - a.center.c.size()], b.center.x[u - a.center.c.size()]))
                return true;
        }
        return false;
    }
};

/// Groups enclosures that could not be shown to be disjoint, directly or through others: two from different groups
/// share no point. Returns for each the number of the first of its group. No all-pairs comparison: a linear form of
/// the coordinates maps each enclosure to an interval, and only those with intersecting intervals are compared.
std::vector<std::size_t> groups_of_enclosures(const std::vector<Enclosure<double>>& enclosures);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/certify/detail/enclosure_definitions.hpp>
#endif
