/// \file
/// Vectors of a size that is known at compile time, or at run time alone: code that is written over their extent serves
/// both. Square matrices of a size at run time.
///
/// What has a size at compile time lies where it is declared and is not initialised, as a C array; what has not lies on
/// the heap, made once and used again.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/core/aligned_vector.hpp>

namespace equilibria {

/// The extent of what has its size at run time.
inline constexpr int at_run_time = -1;

/// A size: N, or a number where N is at_run_time.
template <int N>
struct Extent {
    constexpr Extent() = default;
    constexpr explicit Extent(int) {}             ///< its argument is ignored, so that code for both kinds can give one
    constexpr operator int() const { return N; }  ///< the size
};
/// A size known at run time alone.
template <>
struct Extent<at_run_time> {
    constexpr Extent() = default;
    constexpr explicit Extent(int n) : size(n) {}    ///< n, not negative
    constexpr operator int() const { return size; }  ///< the size
    int size = 0;                                    ///< 0 until it is given
};

/// n entries.
template <class T, int N>
class SizedArray {
public:
    SizedArray() = default;
    explicit SizedArray(int) {}  ///< uninitialised; the argument is ignored, so that code for both kinds can give one

    static constexpr int size() { return N; }  ///< number of entries
    /// Entry i, not checked.
    /// \{
    T& operator[](int i) { return entries_[i]; }
    const T& operator[](int i) const { return entries_[i]; }
    /// \}
    /// Iterators over the entries, which are contiguous.
    /// \{
    T* begin() { return entries_; }
    T* end() { return entries_ + N; }
    const T* begin() const { return entries_; }
    const T* end() const { return entries_ + N; }
    /// \}

private:
    T entries_[N];
};

/// As many entries as the constructor is told, on the heap.
template <class T>
class SizedArray<T, at_run_time> {
public:
    SizedArray() = default;
    /// n entries, value-initialised.
    explicit SizedArray(int n) : entries_(static_cast<std::size_t>(n)) {}
    /// Holds these entries.
    /// \{
    SizedArray(std::initializer_list<T> entries) : entries_(entries) {}
    explicit SizedArray(AlignedVector<T> entries) : entries_(std::move(entries)) {}
    explicit SizedArray(const std::vector<T>& entries)
    requires(!std::is_same_v<AlignedVector<T>, std::vector<T>>)
        : entries_(entries.begin(), entries.end()) {}
    /// \}

    int size() const { return static_cast<int>(entries_.size()); }  ///< number of entries
    /// Keeps the first n entries; new ones are value-initialised.
    void resize(int n) { entries_.resize(static_cast<std::size_t>(n)); }
    /// Entry i, not checked.
    /// \{
    T& operator[](int i) { return entries_[static_cast<std::size_t>(i)]; }
    const T& operator[](int i) const { return entries_[static_cast<std::size_t>(i)]; }
    /// \}
    /// Iterators over the entries, which are contiguous.
    /// \{
    T* begin() { return entries_.data(); }
    T* end() { return entries_.data() + entries_.size(); }
    const T* begin() const { return entries_.data(); }
    const T* end() const { return entries_.data() + entries_.size(); }
    /// \}

    friend bool operator==(const SizedArray&, const SizedArray&) = default;  ///< the same size and equal entries

private:
    AlignedVector<T> entries_;
};

/// n rows of n entries: m[row][column].
template <class T>
class RuntimeMatrix {
public:
    RuntimeMatrix() = default;
    /// n x n entries, value-initialised.
    explicit RuntimeMatrix(int n)
        : n_(static_cast<std::size_t>(n)), entries_(static_cast<std::size_t>(n) * static_cast<std::size_t>(n)) {}

    int size() const { return static_cast<int>(n_); }  ///< number of rows and of columns
    /// First entry of a row; the rows lie one after the other.
    /// \{
    T* operator[](int row) { return entries_.data() + static_cast<std::size_t>(row) * n_; }
    const T* operator[](int row) const { return entries_.data() + static_cast<std::size_t>(row) * n_; }
    /// \}

private:
    std::size_t n_ = 0;
    AlignedVector<T> entries_;
};

/// Of a size known at run time.
template <class T>
using RuntimeArray = SizedArray<T, at_run_time>;

}  // namespace equilibria
