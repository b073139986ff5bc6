/// \file
/// Arrays of a fixed size that any integer indexes.
#pragma once

#include <concepts>
#include <cstddef>

namespace equilibria {

/// N entries, value-initialised, that any integer indexes: std::array asks for std::size_t, and every `theta[k]` of a
/// user's model with an int would be a sign conversion.
template <class T, int N>
struct Array {
    T elements[static_cast<std::size_t>(N)]{};  ///< in order; public, so that the array is an aggregate

    static constexpr int size() { return N; }  ///< number of entries
    /// Entry i, not checked; a constant expression out of range does not compile.
    /// \{
    template <std::convertible_to<int> I>
    constexpr T& operator[](I i) {
        return elements[static_cast<std::size_t>(i)];
    }
    template <std::convertible_to<int> I>
    constexpr const T& operator[](I i) const {
        return elements[static_cast<std::size_t>(i)];
    }
    /// \}
    /// Iterators over the entries, in order.
    /// \{
    constexpr T* begin() { return elements; }
    constexpr T* end() { return elements + N; }
    constexpr const T* begin() const { return elements; }
    constexpr const T* end() const { return elements + N; }
    /// \}

    /// Not defaulted: clang refuses that where T compares at run time only.
    friend constexpr bool operator==(const Array& a, const Array& b) {
        for (int k = 0; k < N; ++k)
            if (!(a[k] == b[k])) return false;
        return true;
    }
};

/// Without entries, for models that lack angles, coordinates or parameters.
template <class T>
struct Array<T, 0> {
    static constexpr int size() { return 0; }  ///< number of entries
    /// Always throws: there is none.
    template <std::convertible_to<int> I>
    constexpr T& operator[](I) const {
        throw "equilibria: an empty array has no elements";
    }
    /// An empty range.
    /// \{
    constexpr T* begin() const { return nullptr; }
    constexpr T* end() const { return nullptr; }
    /// \}

    friend constexpr bool operator==(const Array&, const Array&) = default;  ///< always true
};

}  // namespace equilibria
