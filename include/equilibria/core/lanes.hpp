/// \file
/// SIMD lanes: W doubles, or W floats, that are added, multiplied and compared together, one path of a homotopy a lane.
///
/// They are the vector extension of GCC and Clang, so the compiler maps them onto whatever the target has, and the
/// numeric code is written once: it runs over `Lanes<8>`, over `FloatLanes<16>`, over `double` and over any
/// multiprecision float. The few operations in which those differ (choose by a mask, read or write one lane) are the
/// overloads below.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace equilibria {

namespace detail {
template <int W>
struct LanesOf {
    typedef double type __attribute__((vector_size(W * 8)));
    typedef std::int64_t mask __attribute__((vector_size(W * 8)));
};
}  // namespace detail

/// W doubles side by side; W is a power of two, at least 2.
template <int W>
using Lanes = typename detail::LanesOf<W>::type;

/// The width of the vector registers of the compilation's target, in doubles.
#if defined(__AVX512F__)
inline constexpr int native_lanes = 8;
#elif defined(__AVX__)
inline constexpr int native_lanes = 4;
#else
inline constexpr int native_lanes = 2;
#endif

/// W floats side by side; W is a power of two, at least 4. Numbers of doubles that take part are rounded to float,
/// which the bare vector extension refuses to do.
template <int W>
struct FloatLanes {
    typedef float Values __attribute__((vector_size(W * 4)));       ///< bare pack of the vector extension
    typedef std::int32_t Mask __attribute__((vector_size(W * 4)));  ///< 0 or -1 a lane, from comparisons
    Values values;                                                  ///< one a lane

    /// Lane by lane, with scalars rounded to float; comparisons give masks.
    /// \{
    friend constexpr FloatLanes operator+(const FloatLanes& a, const FloatLanes& b) { return {a.values + b.values}; }
    friend constexpr FloatLanes operator-(const FloatLanes& a, const FloatLanes& b) { return {a.values - b.values}; }
    friend constexpr FloatLanes operator*(const FloatLanes& a, const FloatLanes& b) { return {a.values * b.values}; }
    friend constexpr FloatLanes operator/(const FloatLanes& a, const FloatLanes& b) { return {a.values / b.values}; }
    friend constexpr FloatLanes operator-(const FloatLanes& a) { return {-a.values}; }
    friend constexpr Mask operator<(const FloatLanes& a, const FloatLanes& b) { return a.values < b.values; }
    friend constexpr Mask operator>(const FloatLanes& a, const FloatLanes& b) { return a.values > b.values; }
    friend constexpr Mask operator>=(const FloatLanes& a, const FloatLanes& b) { return a.values >= b.values; }

    template <std::floating_point A>
    friend constexpr FloatLanes operator+(const FloatLanes& a, A b) {
        return {a.values + static_cast<float>(b)};
    }
    template <std::floating_point A>
    friend constexpr FloatLanes operator+(A a, const FloatLanes& b) {
        return {static_cast<float>(a) + b.values};
    }
    template <std::floating_point A>
    friend constexpr FloatLanes operator-(const FloatLanes& a, A b) {
        return {a.values - static_cast<float>(b)};
    }
    template <std::floating_point A>
    friend constexpr FloatLanes operator-(A a, const FloatLanes& b) {
        return {static_cast<float>(a) - b.values};
    }
    template <std::floating_point A>
    friend constexpr FloatLanes operator*(const FloatLanes& a, A b) {
        return {a.values * static_cast<float>(b)};
    }
    template <std::floating_point A>
    friend constexpr FloatLanes operator*(A a, const FloatLanes& b) {
        return {static_cast<float>(a) * b.values};
    }
    template <std::floating_point A>
    friend constexpr FloatLanes operator/(A a, const FloatLanes& b) {
        return {static_cast<float>(a) / b.values};
    }
    /// \}
    /// a where the mask is set, b elsewhere.
    friend constexpr FloatLanes select(const Mask& mask, const FloatLanes& a, const FloatLanes& b) {
        return {mask ? a.values : b.values};
    }
};

/// What generic code must know about a real type that may be a pack of lanes.
template <class R>
struct LaneTraits {
    static constexpr int width = 1;  ///< number of lanes
    using Scalar = R;                ///< the type of one lane
    using Mask = bool;               ///< what a comparison gives
};
/// Of Lanes<W>.
template <class R>
requires(!std::is_arithmetic_v<R> && std::is_arithmetic_v<std::remove_reference_t<decltype(std::declval<R&>()[0])>> &&
         std::is_trivially_copyable_v<R> && requires(R a) { a < a ? a : a; })
struct LaneTraits<R> {
    static constexpr int width = static_cast<int>(sizeof(R) / sizeof(double));  ///< number of lanes, W
    using Scalar = double;                                                      ///< the type of one lane
    using Mask = decltype(R{} < R{});                                           ///< 0 or -1 a lane
};
/// Of FloatLanes<W>.
template <int W>
struct LaneTraits<FloatLanes<W>> {
    static constexpr int width = W;             ///< number of lanes
    using Scalar = float;                       ///< the type of one lane
    using Mask = typename FloatLanes<W>::Mask;  ///< 0 or -1 a lane
};

/// Whether R has more than one lane.
template <class R>
inline constexpr bool is_pack = LaneTraits<R>::width > 1;

/// Packs of floats, and float itself.
template <class R>
inline constexpr bool is_single = std::is_same_v<typename LaneTraits<R>::Scalar, float>;

/// The same value in every lane.
template <class R>
constexpr R broadcast(const typename LaneTraits<R>::Scalar& value) {
    if constexpr (is_pack<R>)
        return value - R{};  // value, of either sign: a broadcast alone, where R{} + value is an addition as well
    else
        return value;
}
/// A double, rounded to float.
template <class R>
requires is_single<R>
constexpr R broadcast(double value) {
    return broadcast<R>(static_cast<float>(value));
}

/// Lane k of a pack; a scalar has the one lane 0.
template <class R>
typename LaneTraits<R>::Scalar lane(const R& pack, int k) {
    if constexpr (is_pack<R> && is_single<R>)
        return pack.values[k];
    else if constexpr (is_pack<R>)
        return pack[k];
    else
        return pack;
}
/// Writes lane k; a scalar has the one lane 0.
template <class R>
void set_lane(R& pack, int k, const typename LaneTraits<R>::Scalar& value) {
    if constexpr (is_pack<R> && is_single<R>)
        pack.values[k] = value;
    else if constexpr (is_pack<R>)
        pack[k] = value;
    else
        pack = value;
}

/// a where the mask is set, b elsewhere.
template <class M, class R>
R select(const M& mask, const R& a, const R& b) {
    return mask ? a : b;
}

/// Masks: bool for scalars, else a pack of 0 and -1. Negation and conjunction lane by lane.
/// \{
template <class Mask>
Mask mask_not(const Mask& m) {
    if constexpr (std::is_same_v<Mask, bool>)
        return !m;
    else
        return ~m;
}
template <class Mask>
Mask mask_and(const Mask& a, const Mask& b) {
    if constexpr (std::is_same_v<Mask, bool>)
        return a && b;
    else
        return a & b;
}
/// \}
/// Whether lane k of the mask is set; of a scalar's, k is ignored.
template <class Mask>
bool mask_lane(const Mask& m, int k) {
    if constexpr (std::is_same_v<Mask, bool>)
        return m;
    else
        return m[k] != 0;
}
/// Whether the mask is set in every lane.
template <class Mask>
bool all_lanes(const Mask& m) {
    if constexpr (std::is_same_v<Mask, bool>) {
        return m;
    } else {
        for (int k = 0; k < static_cast<int>(sizeof(Mask) / sizeof(m[0])); ++k)
            if (m[k] == 0) return false;
        return true;
    }
}

/// Whether the mask is set in no lane.
template <class Mask>
bool no_lane(const Mask& m) {
    return all_lanes(mask_not(m));
}

/// The larger and the smaller one, lane by lane; b where either is a NaN.
/// \{
template <class R>
R lane_max(const R& a, const R& b) {
    return select(a > b, a, b);
}
template <class R>
R lane_min(const R& a, const R& b) {
    return select(a < b, a, b);
}
/// \}

/// The root of each lane, with std::sqrt, or with what the scalar's own library has.
template <class R>
R square_root(const R& a) {
    if constexpr (is_pack<R>) {
        R y;
        for (int k = 0; k < LaneTraits<R>::width; ++k) set_lane(y, k, std::sqrt(lane(a, k)));
        return y;
    } else {
        using std::sqrt;
        return sqrt(a);
    }
}

}  // namespace equilibria
