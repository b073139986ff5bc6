/// \file
/// How many unknowns a system has: angles, then plain coordinates. Numbers of a type, or of a system that is data.
#pragma once

#include <algorithm>
#include <type_traits>

#include <equilibria/core/array.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// The unknowns of a system that is data, as a type: how many there are is known at run time alone.
struct RuntimeUnknowns {};

/// The numbers of angles, coordinates and all unknowns: of a model, or of the unknowns of a system.
template <class M>
struct Sizes {
    static constexpr int angles = n_angles<M>;            ///< number of angles
    static constexpr int coordinates = n_coordinates<M>;  ///< number of plain coordinates
    static constexpr int unknowns = n_unknowns<M>;        ///< number of both together
    static constexpr int extent = unknowns;               ///< of vectors of unknowns
};
/// The same as numbers of an object.
template <>
struct Sizes<RuntimeUnknowns> {
    static constexpr int extent = at_run_time;  ///< of vectors of unknowns: known at run time
    int angles = 0;                             ///< number of angles
    int coordinates = 0;                        ///< number of plain coordinates
    int unknowns = 0;                           ///< number of both together

    constexpr Sizes() = default;
    /// So many of each; not checked.
    constexpr Sizes(int n_angles, int n_coordinates)
        : angles(n_angles), coordinates(n_coordinates), unknowns(n_angles + n_coordinates) {}
    /// Those of a type.
    template <class M>
    constexpr Sizes(const Sizes<M>&) : Sizes(Sizes<M>::angles, Sizes<M>::coordinates) {}
};
/// The numbers of a system that is data.
using RuntimeSizes = Sizes<RuntimeUnknowns>;

namespace detail {
template <class M, class T>
struct UnknownArrayOf {
    using type = Array<T, n_unknowns<M>>;
};
template <class T>
struct UnknownArrayOf<RuntimeUnknowns, T> {
    using type = SizedArray<T, at_run_time>;
};
}  // namespace detail

/// A number T of each unknown.
template <class M, class T>
using UnknownArray = typename detail::UnknownArrayOf<M, T>::type;

/// A number T of each parameter.
template <class M, class T>
using ParameterArray =
    std::conditional_t<std::is_same_v<M, RuntimeUnknowns>, RuntimeArray<T>, Array<T, n_parameters<M>>>;

/// One, value-initialised.
template <class M, class T>
UnknownArray<M, T> unknown_array(const Sizes<M>& sizes) {
    if constexpr (std::is_same_v<M, RuntimeUnknowns>)
        return UnknownArray<M, T>(sizes.unknowns);
    else
        return {};
}

/// The numbers in an array of the size of their type, and back.
/// \{
template <class T, int N>
RuntimeArray<T> runtime_array(const Array<T, N>& a) {
    RuntimeArray<T> y(N);
    std::copy(a.begin(), a.end(), y.begin());
    return y;
}
template <class M, class T>
Array<T, n_unknowns<M>> unknowns_from(const RuntimeArray<T>& a) {
    Array<T, n_unknowns<M>> y;
    std::copy(a.begin(), a.end(), y.begin());
    return y;
}
template <class M, class T>
Array<T, n_parameters<M>> parameters_from(const RuntimeArray<T>& a) {
    Array<T, n_parameters<M>> y;
    std::copy(a.begin(), a.end(), y.begin());
    return y;
}
/// \}

}  // namespace equilibria
