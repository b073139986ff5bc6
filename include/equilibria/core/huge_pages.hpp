/// \file
/// Large arrays in large pages. A system gives each page of 4 KB when it is first written, which takes a microsecond or
/// two: an enumeration of a tenth of a second that writes 40 MB once spends a tenth of its time there.
#pragma once

#include <cstddef>

#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// Asks the system to back this memory, allocated and not yet written, with large pages. Advice: nothing depends on
/// it, and elsewhere than on Linux, or below 4 MB, nothing happens.
void prefer_huge_pages(const void* first, std::size_t bytes) noexcept;

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/core/detail/huge_pages_definitions.hpp>
#endif
