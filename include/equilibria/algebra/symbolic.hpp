/// \file
/// The scalars and angles that turn a model's function into its trigonometric polynomials.
///
/// They are handles to polynomials that a pool owns until the function has returned. Scalars that own their terms would
/// be simpler, but models return arrays of scalars, and in constant expressions g++ 12 destroys the elements of a
/// copied array too early. A handle is copied bit by bit, so that no copy can go wrong.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/algebra/trigonometric_polynomial.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/constant_math.hpp>
#include <equilibria/model/angle.hpp>

namespace equilibria {

/// The polynomials of one call of a model's function.
template <int Angles, int Coordinates, class C>
class PolynomialPool {
public:
    using Polynomial = TrigonometricPolynomial<Angles, Coordinates, C>;  ///< what it owns

    constexpr PolynomialPool() = default;
    constexpr PolynomialPool(const PolynomialPool&) = delete;
    constexpr PolynomialPool& operator=(const PolynomialPool&) = delete;
    constexpr ~PolynomialPool() {
        for (const Polynomial* chunk : chunks_) delete[] chunk;
    }

    /// Takes a polynomial; the pointer is valid as long as the pool lives.
    constexpr const Polynomial* keep(Polynomial&& p) {
        if (used_ == chunk_size) {
            chunks_.push_back(nullptr);
            chunks_.back() = new Polynomial[chunk_size];
            used_ = 0;
        }
        Polynomial* const kept = chunks_.back() + used_++;
        *kept = std::move(p);
        return kept;
    }

private:
    static constexpr int chunk_size = 16;
    std::vector<Polynomial*> chunks_;
    int used_ = chunk_size;  // of the last chunk
};

/// A constant, or a polynomial in the pool.
template <int Angles, int Coordinates, class C = double>
class SymbolicScalar {
public:
    using Pool = PolynomialPool<Angles, Coordinates, C>;  ///< owns the polynomials
    using Polynomial = typename Pool::Polynomial;         ///< with coefficients of type C

    constexpr SymbolicScalar() = default;
    /// A constant, which needs no pool.
    template <class A>
    requires(std::is_arithmetic_v<A> || std::is_same_v<A, C>)
    constexpr SymbolicScalar(const A& constant) : constant_(static_cast<C>(constant)) {}
    /// Put into the pool.
    constexpr SymbolicScalar(Pool* pool, Polynomial&& p) : pool_(pool), kept_(pool->keep(std::move(p))) {}

    /// Whether it is the constant 0; false of every polynomial.
    constexpr bool is_zero() const { return !kept_ && constant_ == C(0); }
    /// A copy; of a constant the polynomial of degree 0.
    constexpr Polynomial polynomial() const {
        if (kept_) return *kept_;
        return Polynomial(constant_);
    }

    /// Arithmetic of polynomials, in constants where both are; faults travel along, see NotPolynomial.
    /// \{
    friend constexpr SymbolicScalar operator+(const SymbolicScalar& a) { return a; }
    friend constexpr SymbolicScalar operator-(const SymbolicScalar& a) {
        return a.kept_ ? SymbolicScalar(a.pool_, -*a.kept_) : SymbolicScalar(C(-a.constant_));
    }
    friend constexpr SymbolicScalar operator+(const SymbolicScalar& a, const SymbolicScalar& b) {
        if (a.is_zero()) return b;
        if (b.is_zero()) return a;
        return combined(a, b, [](const auto& x, const auto& y) { return x + y; });
    }
    friend constexpr SymbolicScalar operator-(const SymbolicScalar& a, const SymbolicScalar& b) {
        return combined(a, b, [](const auto& x, const auto& y) { return x - y; });
    }
    friend constexpr SymbolicScalar operator*(const SymbolicScalar& a, const SymbolicScalar& b) {
        if (a.kept_ && !b.kept_) return {a.pool_, *a.kept_ * b.constant_};
        if (!a.kept_ && b.kept_) return {b.pool_, a.constant_ * *b.kept_};
        return combined(a, b, [](const auto& x, const auto& y) { return x * y; });
    }
    friend constexpr SymbolicScalar operator/(const SymbolicScalar& a, const SymbolicScalar& b) {
        return combined(a, b, [](const auto& x, const auto& y) { return x / y; });
    }
    constexpr SymbolicScalar& operator+=(const SymbolicScalar& b) { return *this = *this + b; }
    constexpr SymbolicScalar& operator-=(const SymbolicScalar& b) { return *this = *this - b; }
    constexpr SymbolicScalar& operator*=(const SymbolicScalar& b) { return *this = *this * b; }
    constexpr SymbolicScalar& operator/=(const SymbolicScalar& b) { return *this = *this / b; }
    /// \}

    /// Integer powers of polynomials; everything else of constants alone, and faulty of what is none, see
    /// NotPolynomial.
    /// \{
    template <class Power>
    requires std::is_arithmetic_v<Power>
    friend constexpr SymbolicScalar pow(const SymbolicScalar& a, Power power) {
        return a.transformed([power](const Polynomial& x) { return pow(x, power); });
    }
    friend constexpr SymbolicScalar sqrt(const SymbolicScalar& a) {
        return a.transformed([](const Polynomial& x) { return sqrt(x); });
    }
    friend constexpr SymbolicScalar exp(const SymbolicScalar& a) {
        return a.transformed([](const Polynomial& x) { return exp(x); });
    }
    friend constexpr SymbolicScalar log(const SymbolicScalar& a) {
        return a.transformed([](const Polynomial& x) { return log(x); });
    }
    friend constexpr SymbolicScalar sin(const SymbolicScalar& a) {
        return a.transformed([](const Polynomial& x) { return sin(x); });
    }
    friend constexpr SymbolicScalar cos(const SymbolicScalar& a) {
        return a.transformed([](const Polynomial& x) { return cos(x); });
    }
    /// \}

private:
    template <class F>
    static constexpr SymbolicScalar combined(const SymbolicScalar& a, const SymbolicScalar& b, F operation) {
        if (!a.kept_ && !b.kept_) return C(operation(a.constant_, b.constant_));
        Pool* pool = a.kept_ ? a.pool_ : b.pool_;
        if (!a.kept_) return {pool, operation(Polynomial(a.constant_), *b.kept_)};
        if (!b.kept_) return {pool, operation(*a.kept_, Polynomial(b.constant_))};
        return {pool, operation(*a.kept_, *b.kept_)};
    }
    template <class F>
    constexpr SymbolicScalar transformed(F function) const {
        if (kept_) return {pool_, function(*kept_)};
        return function(Polynomial(constant_)).constant();
    }

    Pool* pool_ = nullptr;
    const Polynomial* kept_ = nullptr;
    C constant_{};
};

/// An integer combination of the unknown angles plus a constant phase.
template <int Angles, int Coordinates, class C = double>
class SymbolicAngle : public AngleBase {
public:
    using Scalar = SymbolicScalar<Angles, Coordinates, C>;  ///< what its sine and cosine are
    using Pool = typename Scalar::Pool;                     ///< owns those polynomials
    using Polynomial = typename Scalar::Polynomial;         ///< with coefficients of type C

    constexpr SymbolicAngle() = default;
    /// Unknown number i.
    constexpr SymbolicAngle(Pool* pool, int i) : pool_(pool) { multiples_[i] = 1; }

    /// Sums with angles and with constant phases in radians, multiples by integers.
    /// \{
    friend constexpr SymbolicAngle operator+(const SymbolicAngle& a) { return a; }
    friend constexpr SymbolicAngle operator-(const SymbolicAngle& a) { return -1 * a; }
    friend constexpr SymbolicAngle operator+(SymbolicAngle a, const SymbolicAngle& b) {
        if (!a.pool_) a.pool_ = b.pool_;
        for (int i = 0; i < Angles; ++i) a.multiples_[i] += b.multiples_[i];
        a.phase_ += b.phase_;
        return a;
    }
    friend constexpr SymbolicAngle operator-(const SymbolicAngle& a, const SymbolicAngle& b) { return a + -1 * b; }
    template <detail::Integer I>
    friend constexpr SymbolicAngle operator*(I multiple, SymbolicAngle a) {
        for (int& m : a.multiples_) m *= static_cast<int>(multiple);
        a.phase_ *= Scalar(static_cast<double>(multiple));
        return a;
    }
    template <detail::Integer I>
    friend constexpr SymbolicAngle operator*(const SymbolicAngle& a, I multiple) {
        return multiple * a;
    }
    template <class P>
    requires(!AngleLike<P>)
    friend constexpr SymbolicAngle operator+(SymbolicAngle a, const P& by) {
        a.phase_ += Scalar(by);
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
        return a + -Scalar(by);
    }
    template <class P>
    requires(!AngleLike<P>)
    friend constexpr SymbolicAngle operator-(const P& by, const SymbolicAngle& a) {
        return -a + by;
    }
    template <class B>
    constexpr SymbolicAngle& operator+=(const B& b) {
        return *this = *this + b;
    }
    template <class B>
    constexpr SymbolicAngle& operator-=(const B& b) {
        return *this = *this - b;
    }
    /// \}

    /// Expanded by the addition formulas into a polynomial; faulty where a multiple is above Monomial::highest.
    /// \{
    friend constexpr Scalar cos(const SymbolicAngle& a) { return a.expanded(true); }
    friend constexpr Scalar sin(const SymbolicAngle& a) { return a.expanded(false); }
    /// \}

private:
    /// cos or sin by the addition formulas, one unknown after the other.
    constexpr Scalar expanded(bool cosine) const {
        using Basis = typename Polynomial::Basis;
        if (!pool_) return cosine ? cos(phase_) : sin(phase_);
        Polynomial c, s;
        bool begun = !phase_.is_zero();
        if (begun) c = cos(phase_).polynomial(), s = sin(phase_).polynomial();
        for (int i = 0; i < Angles; ++i) {
            const int m = multiples_[i], k = m < 0 ? -m : m;
            if (m == 0) continue;
            if (k > Basis::highest) return {pool_, Polynomial::faulty(NotPolynomial::degree_too_high)};
            Polynomial ci(Basis::single(i, k), C(1)), si(Basis::single(i, -k), C(m < 0 ? -1 : 1));
            if (!begun) {
                c = std::move(ci), s = std::move(si);
                begun = true;
                continue;
            }
            const Polynomial next = c * ci - s * si;
            s = s * ci + c * si;
            c = next;
        }
        if (!begun) c = Polynomial(C(1));
        if (cosine) return {pool_, std::move(c)};
        return {pool_, std::move(s)};
    }

    Pool* pool_ = nullptr;
    Array<int, Angles> multiples_{};
    Scalar phase_;
};

}  // namespace equilibria
