/// \file
/// Short arrays of a size at run time that live as long as one call.
#pragma once

#include <algorithm>
#include <cstddef>

#include <boost/container/small_vector.hpp>

#include <equilibria/core/aligned_vector.hpp>

namespace equilibria {

/// n entries, value-initialised; as many as go into 4 KB, and at most 8, lie where it is declared, and more on the
/// heap: a model's function is called thousands of times a second with some ten of these.
template <class T>
class LocalArray {
public:
    explicit LocalArray(int n) : entries_(static_cast<std::size_t>(n)) {}  ///< of n entries
    // no moves: of entries that lie here they are copies, and g++ 12 warns of small_vector's
    /// Copies of all entries.
    /// \{
    LocalArray(const LocalArray&) = default;
    LocalArray& operator=(const LocalArray&) = default;
    /// \}

    int size() const { return static_cast<int>(entries_.size()); }  ///< number of entries
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

private:
    static constexpr std::size_t here = std::clamp<std::size_t>(4096 / sizeof(T), 1, 8);
    boost::container::small_vector<T, here, typename AlignedVector<T>::allocator_type> entries_;
};

}  // namespace equilibria
