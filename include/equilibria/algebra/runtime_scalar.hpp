/// \file
/// The scalars and angles that a model's function gets at run time to become polynomials: those of symbolic.hpp for the
/// most unknowns that there may be, behind functions that are not inlined and that no program instantiates again for
/// the coefficients listed below.
#pragma once

#include <complex>
#include <concepts>
#include <memory>
#include <type_traits>

#include <equilibria/algebra/runtime_polynomial.hpp>
#include <equilibria/algebra/symbolic.hpp>
#include <equilibria/model/angle.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// The polynomials of one call of a model's function.
template <class C>
class RuntimePool {
public:
    using Pool = PolynomialPool<most_angles, most_coordinates, C>;  ///< the polynomials' own pool

    RuntimePool();
    ~RuntimePool();
    Pool* get() const { return pool_.get(); }  ///< valid as long as this lives

private:
    std::unique_ptr<Pool> pool_;
};

/// A constant, or a polynomial in a pool.
template <class C = double>
class RuntimeScalar {
public:
    using Symbolic = SymbolicScalar<most_angles, most_coordinates, C>;  ///< the scalar that does the work
    using Polynomial = RuntimePolynomial<C>;                            ///< of one type for all models

    RuntimeScalar() = default;
    /// A constant, or the handle of a polynomial in a pool.
    /// \{
    template <class A>
    requires(std::is_arithmetic_v<A> || std::is_same_v<A, C>)
    RuntimeScalar(const A& constant) : of_(constant) {}
    explicit RuntimeScalar(const Symbolic& of) : of_(of) {}
    /// \}
    /// `scale` times the coordinate number j.
    static RuntimeScalar coordinate(const RuntimePool<C>& pool, int j, const C& scale);

    Polynomial polynomial() const;  ///< a copy; of a constant the polynomial of degree 0
    /// The derivatives by the unknowns of a system of these sizes.
    RuntimePolynomials<C> gradient(const RuntimeSizes& sizes) const;

    /// Arithmetic of polynomials; a quotient by what is not constant is marked as faulty, see NotPolynomial.
    /// \{
    friend RuntimeScalar operator+(const RuntimeScalar& a) { return a; }
    friend RuntimeScalar operator-(const RuntimeScalar& a) { return negative(a); }
    friend RuntimeScalar operator+(const RuntimeScalar& a, const RuntimeScalar& b) { return sum(a, b); }
    friend RuntimeScalar operator-(const RuntimeScalar& a, const RuntimeScalar& b) { return difference(a, b); }
    friend RuntimeScalar operator*(const RuntimeScalar& a, const RuntimeScalar& b) { return product(a, b); }
    friend RuntimeScalar operator/(const RuntimeScalar& a, const RuntimeScalar& b) { return quotient(a, b); }
    RuntimeScalar& operator+=(const RuntimeScalar& b) { return *this = sum(*this, b); }
    RuntimeScalar& operator-=(const RuntimeScalar& b) { return *this = difference(*this, b); }
    RuntimeScalar& operator*=(const RuntimeScalar& b) { return *this = product(*this, b); }
    RuntimeScalar& operator/=(const RuntimeScalar& b) { return *this = quotient(*this, b); }
    /// \}

    /// Integer powers of polynomials; everything else of constants alone, and faulty of what is none, see
    /// NotPolynomial.
    /// \{
    template <std::integral Power>
    friend RuntimeScalar pow(const RuntimeScalar& a, Power power) {
        return integer_power(a, static_cast<int>(power));
    }
    template <std::floating_point Power>
    friend RuntimeScalar pow(const RuntimeScalar& a, Power power) {
        return real_power(a, static_cast<double>(power));
    }
    friend RuntimeScalar sqrt(const RuntimeScalar& a) { return root(a); }
    friend RuntimeScalar exp(const RuntimeScalar& a) { return exponential(a); }
    friend RuntimeScalar log(const RuntimeScalar& a) { return logarithm(a); }
    friend RuntimeScalar sin(const RuntimeScalar& a) { return sine(a); }
    friend RuntimeScalar cos(const RuntimeScalar& a) { return cosine(a); }
    /// \}

private:
    template <class>
    friend class RuntimeAngle;

    static RuntimeScalar negative(const RuntimeScalar& a);
    static RuntimeScalar sum(const RuntimeScalar& a, const RuntimeScalar& b);
    static RuntimeScalar difference(const RuntimeScalar& a, const RuntimeScalar& b);
    static RuntimeScalar product(const RuntimeScalar& a, const RuntimeScalar& b);
    static RuntimeScalar quotient(const RuntimeScalar& a, const RuntimeScalar& b);
    static RuntimeScalar integer_power(const RuntimeScalar& a, int power);
    static RuntimeScalar real_power(const RuntimeScalar& a, double power);
    static RuntimeScalar root(const RuntimeScalar& a);
    static RuntimeScalar exponential(const RuntimeScalar& a);
    static RuntimeScalar logarithm(const RuntimeScalar& a);
    static RuntimeScalar sine(const RuntimeScalar& a);
    static RuntimeScalar cosine(const RuntimeScalar& a);

    Symbolic of_;
};

/// An integer combination of the unknown angles plus a constant phase.
template <class C = double>
class RuntimeAngle : public AngleBase {
public:
    using Symbolic = SymbolicAngle<most_angles, most_coordinates, C>;  ///< the angle that does the work
    using Scalar = RuntimeScalar<C>;                                   ///< what its sine and cosine are

    RuntimeAngle() = default;
    /// Unknown number i.
    RuntimeAngle(const RuntimePool<C>& pool, int i) : of_(pool.get(), i) {}

    /// Sums with angles and with constant phases in radians, multiples by integers.
    /// \{
    friend RuntimeAngle operator+(const RuntimeAngle& a) { return a; }
    friend RuntimeAngle operator-(const RuntimeAngle& a) { return multiple(-1, a); }
    friend RuntimeAngle operator+(const RuntimeAngle& a, const RuntimeAngle& b) { return sum(a, b); }
    friend RuntimeAngle operator-(const RuntimeAngle& a, const RuntimeAngle& b) { return sum(a, multiple(-1, b)); }
    template <detail::Integer I>
    friend RuntimeAngle operator*(I times, const RuntimeAngle& a) {
        return multiple(static_cast<int>(times), a);
    }
    template <detail::Integer I>
    friend RuntimeAngle operator*(const RuntimeAngle& a, I times) {
        return multiple(static_cast<int>(times), a);
    }
    template <class P>
    requires(!AngleLike<P>)
    friend RuntimeAngle operator+(const RuntimeAngle& a, const P& by) {
        return shifted(a, Scalar(by));
    }
    template <class P>
    requires(!AngleLike<P>)
    friend RuntimeAngle operator+(const P& by, const RuntimeAngle& a) {
        return shifted(a, Scalar(by));
    }
    template <class P>
    requires(!AngleLike<P>)
    friend RuntimeAngle operator-(const RuntimeAngle& a, const P& by) {
        return shifted(a, -Scalar(by));
    }
    template <class P>
    requires(!AngleLike<P>)
    friend RuntimeAngle operator-(const P& by, const RuntimeAngle& a) {
        return shifted(multiple(-1, a), Scalar(by));
    }
    template <class B>
    RuntimeAngle& operator+=(const B& b) {
        return *this = *this + b;
    }
    template <class B>
    RuntimeAngle& operator-=(const B& b) {
        return *this = *this - b;
    }
    /// \}

    /// Expanded by the addition formulas into a polynomial.
    /// \{
    friend Scalar cos(const RuntimeAngle& a) { return cosine(a); }
    friend Scalar sin(const RuntimeAngle& a) { return sine(a); }
    /// \}

private:
    static RuntimeAngle sum(const RuntimeAngle& a, const RuntimeAngle& b);
    static RuntimeAngle multiple(int times, const RuntimeAngle& a);
    static RuntimeAngle shifted(const RuntimeAngle& a, const Scalar& by);
    static Scalar cosine(const RuntimeAngle& a);
    static Scalar sine(const RuntimeAngle& a);

    Symbolic of_;
};

}  // namespace equilibria

#include <equilibria/algebra/detail/runtime_scalar_definitions.hpp>

#ifdef EQUILIBRIA_COMPILED
namespace equilibria {
extern template class RuntimePool<double>;
extern template class RuntimeScalar<double>;
extern template class RuntimeAngle<double>;
}  // namespace equilibria
#endif
