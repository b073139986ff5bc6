/// \file
/// Bytes, and numbers among them.
#pragma once

#include <cstdint>
#include <vector>

#include <boost/endian/conversion.hpp>

namespace equilibria::detail {

using Bytes = std::vector<std::uint8_t>;

/// The lowest `bytes` bytes of a number, little-endian.
template <int bytes = 8>
void put_number(std::uint8_t* to, std::uint64_t value) {
    using namespace boost::endian;
    endian_store<std::uint64_t, bytes, order::little>(to, value);
}
template <int bytes = 8>
std::uint64_t get_number(const std::uint8_t* from) {
    using namespace boost::endian;
    return endian_load<std::uint64_t, bytes, order::little>(from);
}

}  // namespace equilibria::detail
