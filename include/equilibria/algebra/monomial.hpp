/// \file
/// Basis functions of the trigonometric polynomials: products with one factor an unknown. For an angle the factor is
/// 1, cos(k theta) or sin(k theta); for a plain coordinate it is x^k. These products are linearly independent, so two
/// expressions of the same function have the same coefficients, and derivatives map factors to single factors.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace equilibria {

/// A product of factors, one an unknown. Unknowns 0 .. Angles-1 are angles, the others plain coordinates.
///
/// The code of a factor: 0 for 1; for an angle +k for cos(k theta), -k for sin(k theta); for a coordinate k for x^k.
/// Codes are packed, two bytes each: constant expressions compare and multiply monomials by the ten thousand.
template <int Angles, int Coordinates>
class Monomial {
public:
    static constexpr int angles = Angles;                  ///< number of angles
    static constexpr int unknowns = Angles + Coordinates;  ///< number of all unknowns
    static constexpr int highest = 1000;  ///< the largest multiple of an angle and power of a coordinate

    /// The code of the factor in an unknown; 0 where it has none.
    constexpr int code(int unknown) const {
        return static_cast<std::int16_t>(words_[word(unknown)] >> shift(unknown) & 0xffff);
    }
    /// Replaces the factor in an unknown; |code| is at most `highest`.
    constexpr void set_code(int unknown, int code) {
        auto& w = words_[word(unknown)];
        w = (w & ~(std::uint64_t{0xffff} << shift(unknown))) |
            (static_cast<std::uint64_t>(static_cast<std::uint16_t>(code)) << shift(unknown));
    }
    /// The monomial of a single factor.
    static constexpr Monomial single(int unknown, int code) {
        Monomial m;
        m.set_code(unknown, code);
        return m;
    }
    static constexpr bool is_angle(int unknown) { return unknown < Angles; }  ///< whether the unknown is an angle

    constexpr bool is_one() const { return *this == Monomial{}; }  ///< whether no unknown has a factor

    /// Degree in the unknown: of the factor as a polynomial in (cos, sin), or in x.
    constexpr int degree(int unknown) const {
        const int c = code(unknown);
        return c < 0 ? -c : c;
    }
    /// Total degree in all (cos, sin) and x.
    constexpr int degree() const {
        int d = 0;
        for (int u = 0; u < unknowns; ++u) d += degree(u);
        return d;
    }

    /// Whether some unknown has a factor in both.
    friend constexpr bool overlap(const Monomial& a, const Monomial& b) {
        for (std::size_t w = 0; w < words; ++w)
            if (occupied(a.words_[w]) & occupied(b.words_[w])) return true;
        return false;
    }
    /// The first unknown, from u on, that has a factor in both; `unknowns` if there is none.
    friend constexpr int next_overlap(const Monomial& a, const Monomial& b, int u) {
        for (; u < unknowns; u = u / 4 * 4 + 4) {
            const std::uint64_t both =
                occupied(a.words_[word(u)]) & occupied(b.words_[word(u)]) & (~std::uint64_t{0} << shift(u));
            if (both) return u / 4 * 4 + std::countr_zero(both) / 16;
        }
        return unknowns;
    }
    /// Product of monomials that do not overlap.
    friend constexpr Monomial join(const Monomial& a, const Monomial& b) {
        Monomial m;
        for (std::size_t w = 0; w < words; ++w) m.words_[w] = a.words_[w] | b.words_[w];
        return m;
    }

    /// A total order of no meaning, the same in every program: products are sorted by it.
    /// \{
    friend constexpr bool operator==(const Monomial&, const Monomial&) = default;
    friend constexpr bool operator<(const Monomial& a, const Monomial& b) {
        for (std::size_t pair = 0; pair < words; pair += 2) {
            if (pair + 1 < words && a.words_[pair + 1] != b.words_[pair + 1])
                return a.words_[pair + 1] < b.words_[pair + 1];
            if (a.words_[pair] != b.words_[pair]) return a.words_[pair] < b.words_[pair];
        }
        return false;
    }
    /// \}

private:
    static constexpr std::size_t word(int unknown) { return static_cast<std::size_t>(unknown) / 4; }
    static constexpr int shift(int unknown) { return 16 * (unknown % 4); }
    static constexpr std::uint64_t occupied(std::uint64_t w) {  // the top bit of each code that is not 0
        constexpr std::uint64_t low = 0x7fff7fff7fff7fff;
        return (((w & low) + low) | w) & ~low;
    }

    static constexpr std::size_t words = static_cast<std::size_t>((unknowns + 3) / 4);
    std::uint64_t words_[words]{};
};

}  // namespace equilibria
