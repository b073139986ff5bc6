/// \file
/// Vectors of packs of lanes, which need more alignment than `new` gives, and of numbers, which begin where a register
/// does as well: compilers may peel off the first turns of a loop up to there, with another rounding than the rest, and
/// results would depend on the address that `new` happened to give.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

namespace equilibria {

namespace detail {

/// Takes a block a little larger than asked for and begins where the alignment is right. The aligned `new` of glibc
/// splits blocks and merges them again: an enumeration of a few paths, whose workspaces are some twenty such vectors,
/// spent a tenth of its time there.
template <class T>
struct OveralignedAllocator {
    using value_type = T;

    OveralignedAllocator() = default;
    template <class Other>
    OveralignedAllocator(const OveralignedAllocator<Other>&) {}

    static constexpr std::size_t alignment = alignof(T) > 64 ? alignof(T) : 64;
    static constexpr std::size_t room = alignment + sizeof(void*);  // for the shift, and for the block's own address

    T* allocate(std::size_t n) {
        if (n > (std::size_t(-1) / 2 - room) / sizeof(T)) throw std::bad_array_new_length();
        void* const block = ::operator new(n * sizeof(T) + room);
        void* first = static_cast<void**>(block) + 1;
        std::size_t left = n * sizeof(T) + alignment;
        std::align(alignment, n * sizeof(T), first, left);
        static_cast<void**>(first)[-1] = block;
        return static_cast<T*>(first);
    }
    void deallocate(T* first, std::size_t) { ::operator delete(reinterpret_cast<void**>(first)[-1]); }

    friend bool operator==(const OveralignedAllocator&, const OveralignedAllocator&) { return true; }
};

}  // namespace detail

/// std::vector<T>, whatever the alignment of T; of numbers and packs, from a multiple of 64 bytes on.
template <class T>
using AlignedVector = std::vector<
    T, std::conditional_t<std::is_trivially_copyable_v<T>, detail::OveralignedAllocator<T>, std::allocator<T>>>;

}  // namespace equilibria
