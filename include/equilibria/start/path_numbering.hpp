/// \file
/// Which path is which: the number of a path in its start system, and the path that the symmetry theta -> -theta makes
/// of it, which need not be tracked.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace equilibria {

/// The paths of a run. All are tracked; or, with a reflected start, one of each mirror pair is, and those that are
/// their own mirror images rest where they are. Every number is found by arithmetic: nothing is stored a path.
class PathNumbering {
public:
    /// Paths 0 .. count-1, each tracked.
    static PathNumbering all(std::uint64_t count) {
        PathNumbering y;
        y.total_ = count;
        return y;
    }
    /// Of a reflected total-degree start: path numbers in mixed radix, radices even and at least 2; digits 0 and 1 of
    /// an unknown rest, 2k and 2k+1 are each other's mirror images.
    static PathNumbering mirrored(std::vector<std::uint64_t> radices) {
        PathNumbering y;
        y.total_ = 1;
        for (const std::uint64_t radix : radices) y.total_ *= radix;
        y.radices_ = std::move(radices);
        return y;
    }

    bool symmetric() const { return !radices_.empty(); }  ///< whether mirror images stand for each other
    std::uint64_t total() const { return total_; }        ///< number of all paths
    /// Number of the paths that rest.
    std::uint64_t resting() const { return symmetric() ? std::uint64_t{1} << radices_.size() : 0; }
    /// Number of the paths that are tracked.
    std::uint64_t tracked() const { return symmetric() ? (total_ - resting()) / 2 : total_; }
    std::uint64_t weight() const { return symmetric() ? 2 : 1; }  ///< how many paths each tracked one stands for

    /// The number of the k-th tracked path: with a symmetry the k-th of those that are less than their mirror image,
    /// whose highest digit that is not 0 or 1 is even.
    std::uint64_t tracked_path(std::uint64_t k) const {
        if (!symmetric()) return k;
        std::uint64_t weight = total_, rest = resting(), path = 0;
        for (std::size_t i = radices_.size(); i-- > 0;) {
            weight /= radices_[i];
            rest /= 2;
            const std::uint64_t below = (weight - rest) / 2;  // pairs of the lower digits alone
            if (k >= 2 * below) {                             // this digit decides, the lower ones are free
                k -= 2 * below;
                return path + (2 + 2 * (k / weight)) * weight + k % weight;
            }
            path += k / below * weight;
            k %= below;
        }
        return path;
    }
    /// The number of the k-th path that rests: the digits of k in base 2.
    std::uint64_t resting_path(std::uint64_t k) const {
        std::uint64_t path = 0, weight = 1;
        for (const std::uint64_t radix : radices_) {
            path += weight * (k & 1);
            weight *= radix;
            k >>= 1;
        }
        return path;
    }
    /// The number of the mirror image; without a symmetry the path itself.
    std::uint64_t mirror(std::uint64_t path) const {
        if (!symmetric()) return path;
        std::uint64_t image = 0, weight = 1;
        for (const std::uint64_t radix : radices_) {
            const std::uint64_t digit = path % radix;
            path /= radix;
            image += weight * (digit < 2 ? digit : digit ^ 1);
            weight *= radix;
        }
        return image;
    }

private:
    std::uint64_t total_ = 0;
    std::vector<std::uint64_t> radices_;
};

}  // namespace equilibria
