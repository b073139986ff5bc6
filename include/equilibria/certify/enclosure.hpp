/// \file
/// Regions of (cos, sin, x) space that hold one root each, and which of them are proved to be disjoint.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/core/compiled.hpp>

namespace equilibria {

namespace detail {

/// Whether the disc of this radius around z holds no real number.
template <class R>
auto without_real_points(const Complex<R>& z, const R& radius) {
    return lane_max(z.im, R(-z.im)) > radius;
}

}  // namespace detail

/// Whether the enclosure that a proof gives holds no real point, for each lane.
template <class R>
typename LaneTraits<R>::Mask excludes_real_points(const KrawczykResult<R>& proof) {
    auto some = R{} > R{} + 1.0;  // none
    const auto note = [&](const Complex<R>& z, const R& off) {
        some = mask_not(mask_and(mask_not(some), mask_not(detail::without_real_points(z, off))));
    };
    const int angles = proof.center.c.size();
    for (int i = 0; i < angles; ++i) note(proof.center.c[i], proof.off[i]), note(proof.center.s[i], proof.off[i]);
    for (int j = 0; j < proof.center.x.size(); ++j) note(proof.center.x[j], proof.off[angles + j]);
    return some;
}

/// All points with |cos - value_u| <= off_u and |sin - sine_u| <= off_u of each angle, |x - value_u| <= off_u of each
/// coordinate.
template <class S>
struct Enclosure {
    /// The discs of one unknown.
    struct Unknown {
        Complex<S> value;             ///< of the cosine of an angle, or of a coordinate
        Complex<S> sine{S(0), S(0)};  ///< 0 of a coordinate
        S off{};                      ///< their radius
    };
    SizedArray<Unknown, at_run_time> unknowns;  ///< the angles, then the coordinates

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
        bool y = false;
        for (const Unknown& at : unknowns)
            y |= detail::without_real_points(at.value, at.off) || detail::without_real_points(at.sine, at.off);
        return y;
    }
    /// Whether it is proved that no point is in both; of as many unknowns.
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

/// What a linear form takes an enclosure to: enclosures with disjoint intervals are disjoint. NaN: there is none.
struct EnclosureInterval {
    double low = std::numeric_limits<double>::quiet_NaN();  ///< lower end
    double high = low;                                      ///< upper end
};

/// A linear form of the coordinates of enclosures, the same each time for as many unknowns.
class EnclosureForm {
public:
    explicit EnclosureForm(int unknowns);  ///< for this number of unknowns

    /// The interval of one enclosure, with the rounding errors of the sum in it.
    EnclosureInterval operator()(const Enclosure<double>& e) const {
        Sum<double> sum;
        for (int u = 0; u < e.unknowns.size(); ++u) {
            add(sum, e.unknowns[u].value, e.unknowns[u].off, 4 * u, 1.0);
            add(sum, e.unknowns[u].sine, e.unknowns[u].off, 4 * u + 2, 1.0);
        }
        const double reach = sum.error(e.unknowns.size());
        return {sum.key - reach, sum.key + reach};
    }
    /// Of the enclosures that a proof gives, a lane each; mirrored: of their images under theta -> -theta.
    template <class R>
    void intervals(const KrawczykResult<R>& proof, bool mirrored, EnclosureInterval* to) const {
        Sum<R> sum;
        const int angles = proof.center.c.size();
        for (int i = 0; i < angles; ++i) {
            add(sum, proof.center.c[i], proof.off[i], 4 * i, 1.0);
            add(sum, proof.center.s[i], proof.off[i], 4 * i + 2, mirrored ? -1.0 : 1.0);
        }
        for (int j = 0; j < proof.center.x.size(); ++j)
            add(sum, proof.center.x[j], proof.off[angles + j], 4 * (angles + j), 1.0);
        const R reach = sum.error(proof.off.size()), low = sum.key - reach, high = sum.key + reach;
        for (int k = 0; k < LaneTraits<R>::width; ++k) to[k] = {lane(low, k), lane(high, k)};
    }

private:
    template <class R>
    struct Sum {
        R key{}, size{}, reach{};

        R error(int n) const {
            const double unit = rounding_unit<double>;
            return rounded_up<R>(reach * (1 + 4 * n * unit)) + rounded_up<R>(8 * n * unit * size);
        }
    };
    template <class R>
    void add(Sum<R>& sum, const Complex<R>& z, const R& radius, int w, double sign) const {
        sum.key = sum.key + sign * (weight_[w] * z.re + weight_[w + 1] * z.im);
        sum.size = sum.size + 3.0 * magnitude_bound(z);
        sum.reach = sum.reach + 3.0 * radius;  // the weights of the real and imaginary part together
    }

    SizedArray<double, at_run_time> weight_;
};

/// The numbers of the enclosures whose interval meets another one's, ascending.
std::vector<std::size_t> meeting(const std::vector<EnclosureInterval>& intervals);

/// Groups enclosures that could not be shown to be disjoint, directly or through others: two from different groups
/// share no point. Returns for each the number of the first of its group; one of no unknowns is a group by itself. No
/// all-pairs comparison: those whose intervals meet are compared.
std::vector<std::size_t> groups_of_enclosures(const std::vector<Enclosure<double>>& enclosures);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/certify/detail/enclosure_definitions.hpp>
#endif
