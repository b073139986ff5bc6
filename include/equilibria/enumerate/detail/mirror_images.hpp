/// \file
/// Roots that are each other's images under theta -> -theta, to the last bit: from a reflected start they are, since
/// two such roots were one path. What is computed or proved of one of them holds of the other.
#pragma once

#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace equilibria::detail {

/// image[k]: the number of the image of root k, which comes later, or `none`. A root that is its own image has none.
class MirrorImages {
public:
    static constexpr auto none = std::numeric_limits<std::uint32_t>::max();
    using Unknowns = std::span<const std::complex<double>>;
    std::vector<std::uint32_t> image;
    std::vector<std::uint8_t> is_image;

    MirrorImages() = default;
    /// Of `size` roots: unknowns(k), all angles in (-pi, pi], or none to leave root k out.
    MirrorImages(std::size_t size, const auto& unknowns) : image(size, none), is_image(size) {
        if (size >= none) return;
        std::vector<std::uint32_t> table(std::bit_ceil(2 * size + 1), none);  // open addressing
        for (std::uint32_t k = 0; k < size; ++k) {
            const Unknowns q = unknowns(k);
            if (q.empty()) continue;
            std::size_t at = hash(q) & (table.size() - 1);
            for (; table[at] != none; at = (at + 1) & (table.size() - 1)) {
                const std::uint32_t other = table[at];
                if (image[other] != none || !are_images(unknowns(other), q)) continue;
                image[other] = k;
                is_image[k] = 1;
                break;
            }
            if (!is_image[k]) table[at] = k;
        }
    }

    /// Of each other.
    static bool are_images(Unknowns a, Unknowns b) {
        for (std::size_t u = 0; u < a.size(); ++u) {
            const bool turned = a[u].real() == std::numbers::pi && b[u].real() == std::numbers::pi;
            if ((a[u].real() != -b[u].real() && !turned) || a[u].imag() != -b[u].imag()) return false;
        }
        return true;
    }

private:
    /// The same for both of a pair.
    static std::size_t hash(Unknowns q) {
        std::uint64_t y = 0;
        for (const auto& z : q)
            for (const double part : {z.real(), z.imag()}) {
                y = (y ^ std::bit_cast<std::uint64_t>(std::abs(part))) * 0x9e3779b97f4a7c15;
                y ^= y >> 32;
            }
        return static_cast<std::size_t>(y);
    }
};

}  // namespace equilibria::detail
