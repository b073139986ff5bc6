/// \file
/// Regions of (cos, sin, x) space that hold one root each, and which of them are proved to be disjoint.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// All points with |cos - value_u| <= off_u and |sin - sine_u| <= off_u of each angle, |x - value_u| <= off_u of each
/// coordinate.
template <class S>
struct Enclosure {
    struct Unknown {
        Complex<S> value;             ///< of the cosine of an angle, or of a coordinate
        Complex<S> sine{S(0), S(0)};  ///< 0 of a coordinate
        S off{};
    };
    SizedArray<Unknown, at_run_time> unknowns;

    Enclosure() = default;
    /// Room for one of n unknowns.
    explicit Enclosure(int n) : unknowns(n) {}

    /// That of lane k of a proof.
    template <class R>
    static Enclosure of(const KrawczykResult<R>& proof, int k) {
        const auto at = [k](const Complex<R>& z) { return Complex<S>(lane(z.re, k), lane(z.im, k)); };
        const auto& center = proof.center;
        Enclosure y(proof.off.size());
        for (int u = 0; u < y.unknowns.size(); ++u) {
            Unknown& to = y.unknowns[u];
            to.off = lane(proof.off[u], k);
            if (u < center.c.size())
                to.value = at(center.c[u]), to.sine = at(center.s[u]);
            else
                to.value = at(center.x[u - center.c.size()]);
        }
        return y;
    }
    /// The smallest one over T that contains this one.
    template <class T>
    Enclosure<T> to() const {
        Enclosure<T> y(unknowns.size());
        const auto convert = [](const Complex<S>& a, Complex<T>& b) {
            b = Complex<T>(static_cast<T>(a.re), static_cast<T>(a.im));
            return rounded_up<T>(4 * rounding_unit<T> * magnitude_bound(b));
        };
        for (int u = 0; u < unknowns.size(); ++u) {
            const Unknown& from = unknowns[u];
            auto& to = y.unknowns[u];
            const T moved = convert(from.value, to.value), sine_moved = convert(from.sine, to.sine);
            to.off = rounded_up<T>(static_cast<T>(from.off) * (1 + 4 * rounding_unit<T>)+std::max(moved, sine_moved));
        }
        return y;
    }

    /// Whether no point in it is real.
    bool excludes_real_points() const {
        const auto outside = [](const Complex<S>& z, const S& rad) { return z.im > rad || -z.im > rad; };
        for (const Unknown& at : unknowns)
            if (outside(at.value, at.off) || outside(at.sine, at.off)) return true;
        return false;
    }
    friend bool disjoint(const Enclosure& a, const Enclosure& b) {
        for (int u = 0; u < a.unknowns.size(); ++u) {
            const Unknown &at = a.unknowns[u], &other = b.unknowns[u];
            const S reach = rounded_up<S>(at.off + other.off);
            const auto apart = [&](const Complex<S>& y, const Complex<S>& z) {
                const Complex<S> d =
                    y - z;  // the differences of floats close to each other are exact, others nearly so
                const S re = d.re < 0 ? S(-d.re) : d.re, im = d.im < 0 ? S(-d.im) : d.im;
                return std::max(re, im) * (1 - 2 * rounding_unit<S>) > reach;
            };
            if (apart(at.value, other.value) || apart(at.sine, other.sine)) return true;
        }
        return false;
    }
};

/// Groups enclosures that could not be shown to be disjoint, directly or through others: two from different groups
/// share no point. Returns for each the number of the first of its group; one of no unknowns is a group by itself. No
/// all-pairs comparison: a linear form of the coordinates maps each enclosure to an interval, and only those with
/// intersecting intervals are compared.
std::vector<std::size_t> groups_of_enclosures(const std::vector<Enclosure<double>>& enclosures);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/certify/detail/enclosure_definitions.hpp>
#endif
