/// \file
/// SIMD lanes: W doubles that are added, multiplied and compared together, one path of a homotopy a lane.
///
/// They are the vector extension of GCC and Clang, so the compiler maps them onto whatever the target has, and the
/// numeric code is written once: it runs over `Lanes<8>`, over `double` and over any multiprecision float. The few
/// operations in which those differ (choose by a mask, read or write one lane) are the overloads below.
#pragma once

#include <cmath>
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

/// What generic code must know about a real type that may be a pack of lanes.
template <class R>
struct LaneTraits {
    static constexpr int width = 1;
    using Scalar = R;  ///< the type of one lane
    using Mask = bool;
};
template <class R>
requires(!std::is_arithmetic_v<R> && std::is_arithmetic_v<std::remove_reference_t<decltype(std::declval<R&>()[0])>> &&
         std::is_trivially_copyable_v<R> && requires(R a) { a < a ? a : a; })
struct LaneTraits<R> {
    static constexpr int width = static_cast<int>(sizeof(R) / sizeof(double));
    using Scalar = double;
    using Mask = decltype(R{} < R{});
};

template <class R>
inline constexpr bool is_pack = LaneTraits<R>::width > 1;

/// The same value in every lane.
template <class R>
constexpr R broadcast(const typename LaneTraits<R>::Scalar& value) {
    if constexpr (is_pack<R>)
        return R{} + value;
    else
        return value;
}

/// Lane k of a pack; a scalar has the one lane 0.
template <class R>
typename LaneTraits<R>::Scalar lane(const R& pack, int k) {
    if constexpr (is_pack<R>)
        return pack[k];
    else
        return pack;
}
template <class R>
void set_lane(R& pack, int k, const typename LaneTraits<R>::Scalar& value) {
    if constexpr (is_pack<R>)
        pack[k] = value;
    else
        pack = value;
}

/// a where the mask is set, b elsewhere.
template <class M, class R>
R select(const M& mask, const R& a, const R& b) {
    return mask ? a : b;
}

/// Masks: bool for scalars, else a pack of 0 and -1.
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
template <class Mask>
bool mask_lane(const Mask& m, int k) {
    if constexpr (std::is_same_v<Mask, bool>)
        return m;
    else
        return m[k] != 0;
}
template <class Mask>
bool all_lanes(const Mask& m) {
    if constexpr (std::is_same_v<Mask, bool>) {
        return m;
    } else {
        for (int k = 0; k < static_cast<int>(sizeof(Mask) / sizeof(std::int64_t)); ++k)
            if (m[k] == 0) return false;
        return true;
    }
}

template <class R>
R lane_max(const R& a, const R& b) {
    return select(a > b, a, b);
}
template <class R>
R lane_min(const R& a, const R& b) {
    return select(a < b, a, b);
}

template <class R>
R square_root(const R& a) {
    if constexpr (is_pack<R>) {
        R y;
        for (int k = 0; k < LaneTraits<R>::width; ++k) y[k] = std::sqrt(a[k]);
        return y;
    } else {
        using std::sqrt;
        return sqrt(a);
    }
}

}  // namespace equilibria
