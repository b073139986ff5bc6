/// \file
/// Vectors of packs of lanes, which need more alignment than `new` gives.
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

    static constexpr std::size_t room = alignof(T) + sizeof(void*);  // for the shift, and for the block's own address

    T* allocate(std::size_t n) {
        if (n > (std::size_t(-1) - room) / sizeof(T)) throw std::bad_array_new_length();
        void* const block = ::operator new(n * sizeof(T) + room);
        void* first = static_cast<void**>(block) + 1;
        std::size_t left = n * sizeof(T) + alignof(T);
        std::align(alignof(T), n * sizeof(T), first, left);
        static_cast<void**>(first)[-1] = block;
        return static_cast<T*>(first);
    }
    void deallocate(T* first, std::size_t) { ::operator delete(reinterpret_cast<void**>(first)[-1]); }

    friend bool operator==(const OveralignedAllocator&, const OveralignedAllocator&) { return true; }
};

}  // namespace detail

/// std::vector<T>, whatever the alignment of T.
template <class T>
using AlignedVector = std::vector<T, std::conditional_t<(alignof(T) > __STDCPP_DEFAULT_NEW_ALIGNMENT__),
                                                        detail::OveralignedAllocator<T>, std::allocator<T>>>;

}  // namespace equilibria
