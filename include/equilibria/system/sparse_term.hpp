/// \file
/// A term of a system that is data.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

#include <equilibria/algebra/monomial.hpp>

namespace equilibria {

/// A product of factors, one an unknown, as Monomial: the code of a factor is 0 for 1; for an angle +k for cos(k
/// theta), -k for sin(k theta); for a coordinate k for x^k.
class SparseMonomial {
public:
    SparseMonomial() = default;
    /// A code for each unknown.
    explicit SparseMonomial(std::vector<int> codes) : codes_(std::move(codes)) {}

    int size() const { return static_cast<int>(codes_.size()); }                       ///< number of unknowns
    int code(int unknown) const { return codes_[static_cast<std::size_t>(unknown)]; }  ///< of the factor in the unknown
    /// In (cos, sin) of the unknown, or in x.
    int degree(int unknown) const { return std::abs(code(unknown)); }
    /// Total degree in all (cos, sin) and x.
    int degree() const {
        int d = 0;
        for (const int c : codes_) d += std::abs(c);
        return d;
    }

    /// The order of the codes, the first unknown's first.
    /// \{
    friend bool operator==(const SparseMonomial&, const SparseMonomial&) = default;
    friend auto operator<=>(const SparseMonomial&, const SparseMonomial&) = default;
    /// \}

private:
    std::vector<int> codes_;
};

/// The same product of factors.
template <int Angles, int Coordinates>
SparseMonomial sparse_monomial(const Monomial<Angles, Coordinates>& monomial) {
    std::vector<int> codes(Angles + Coordinates);
    for (int u = 0; u < Angles + Coordinates; ++u) codes[static_cast<std::size_t>(u)] = monomial.code(u);
    return SparseMonomial(std::move(codes));
}

/// One term of one equation.
struct SparseTerm {
    int equation;             ///< from 0
    SparseMonomial monomial;  ///< product of factors, one an unknown
    double coefficient;       ///< real

    /// The factor in unknown number `equation`: terms of an equation that share it are summed before it is multiplied.
    int own_code() const { return monomial.code(equation); }
    /// By equation, then by the factor in its unknown.
    friend bool before(const SparseTerm& a, const SparseTerm& b) {
        if (a.equation != b.equation) return a.equation < b.equation;
        if (a.own_code() != b.own_code()) return a.own_code() < b.own_code();
        return a.monomial < b.monomial;
    }
};

}  // namespace equilibria
