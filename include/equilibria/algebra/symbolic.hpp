/// \file
/// The scalars that turn a model's function into its trigonometric polynomial: an integer combination of the unknown
/// angles plus a constant phase, whose sin and cos are trigonometric polynomials.
#pragma once

#include <cstddef>
#include <type_traits>

#include <equilibria/algebra/trigonometric_polynomial.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/model/angle.hpp>

namespace equilibria {

template <int Angles, int Coordinates, class C = double>
struct SymbolicAngle : AngleBase {
    using Polynomial = TrigonometricPolynomial<Angles, Coordinates, C>;

    Array<int, Angles> multiples{};
    Polynomial phase;

    static constexpr SymbolicAngle unknown(int i) {
        SymbolicAngle a;
        a.multiples[i] = 1;
        return a;
    }

    friend constexpr SymbolicAngle operator+(const SymbolicAngle& a) { return a; }
    friend constexpr SymbolicAngle operator-(const SymbolicAngle& a) { return -1 * a; }
    friend constexpr SymbolicAngle operator+(SymbolicAngle a, const SymbolicAngle& b) {
        for (int i = 0; i < a.multiples.size(); ++i) a.multiples[i] += b.multiples[i];
        a.phase += b.phase;
        return a;
    }
    friend constexpr SymbolicAngle operator-(const SymbolicAngle& a, const SymbolicAngle& b) { return a + -1 * b; }
    template <class B>
    constexpr SymbolicAngle& operator+=(const B& b) {
        return *this = *this + b;
    }
    template <class B>
    constexpr SymbolicAngle& operator-=(const B& b) {
        return *this = *this - b;
    }
    template <detail::Integer I>
    friend constexpr SymbolicAngle operator*(I multiple, SymbolicAngle a) {
        for (int& m : a.multiples) m *= static_cast<int>(multiple);
        a.phase *= Polynomial(static_cast<double>(multiple));
        return a;
    }
    template <detail::Integer I>
    friend constexpr SymbolicAngle operator*(const SymbolicAngle& a, I multiple) {
        return multiple * a;
    }
    template <class P>
        requires(!AngleLike<P>)
    friend constexpr SymbolicAngle operator+(SymbolicAngle a, const P& by) {
        a.phase += Polynomial(by);
        return a;
    }
    template <class P>
        requires(!AngleLike<P>)
    friend constexpr SymbolicAngle operator+(const P& by, const SymbolicAngle& a) {
        return a + by;
    }
    template <class P>
        requires(!AngleLike<P>)
    friend constexpr SymbolicAngle operator-(const SymbolicAngle& a, const P& by) {
        return a + -Polynomial(by);
    }
    template <class P>
        requires(!AngleLike<P>)
    friend constexpr SymbolicAngle operator-(const P& by, const SymbolicAngle& a) {
        return -a + by;
    }

    friend constexpr Polynomial cos(const SymbolicAngle& a) {
        Polynomial c, s;
        a.expand(c, s);
        return c;
    }
    friend constexpr Polynomial sin(const SymbolicAngle& a) {
        Polynomial c, s;
        a.expand(c, s);
        return s;
    }

private:
    /// cos and sin by the addition formulas, one unknown after the other.
    constexpr void expand(Polynomial& c, Polynomial& s) const {
        using Basis = typename Polynomial::Basis;
        c = cos(phase);
        s = sin(phase);
        for (int i = 0; i < Angles; ++i) {
            const int m = multiples[i], k = m < 0 ? -m : m;
            if (m == 0) continue;
            if (k > Basis::highest) {
                c = s = Polynomial::faulty(NotPolynomial::degree_too_high);
                return;
            }
            const Polynomial ci(Basis::single(i, k), C(1)), si(Basis::single(i, -k), C(m < 0 ? -1 : 1));
            const Polynomial cosine = c * ci - s * si;
            s = s * ci + c * si;
            c = cosine;
        }
    }
};

}  // namespace equilibria
