/// \file
/// See algebra/runtime_scalar.hpp.
#pragma once

#include <memory>

#include <equilibria/algebra/runtime_scalar.hpp>

namespace equilibria {

template <class C>
RuntimePool<C>::RuntimePool() : pool_(std::make_unique<Pool>()) {}
template <class C>
RuntimePool<C>::~RuntimePool() = default;

template <class C>
RuntimeScalar<C> RuntimeScalar<C>::coordinate(const RuntimePool<C>& pool, int j, const C& scale) {
    return RuntimeScalar(Symbolic(pool.get(), coordinate_polynomial<C>(j) * scale));
}

template <class C>
RuntimePolynomial<C> RuntimeScalar<C>::polynomial() const {
    return of_.polynomial();
}
template <class C>
RuntimePolynomials<C> RuntimeScalar<C>::gradient(const RuntimeSizes& sizes) const {
    const Polynomial v = of_.polynomial();
    RuntimePolynomials<C> f;
    for (int i = 0; i < sizes.angles; ++i) f.push_back(derivative(v, i));
    for (int j = 0; j < sizes.coordinates; ++j) f.push_back(derivative(v, most_angles + j));
    return f;
}

template <class C>
RuntimeScalar<C> RuntimeScalar<C>::negative(const RuntimeScalar& a) {
    return RuntimeScalar(-a.of_);
}
template <class C>
RuntimeScalar<C> RuntimeScalar<C>::sum(const RuntimeScalar& a, const RuntimeScalar& b) {
    return RuntimeScalar(a.of_ + b.of_);
}
template <class C>
RuntimeScalar<C> RuntimeScalar<C>::difference(const RuntimeScalar& a, const RuntimeScalar& b) {
    return RuntimeScalar(a.of_ - b.of_);
}
template <class C>
RuntimeScalar<C> RuntimeScalar<C>::product(const RuntimeScalar& a, const RuntimeScalar& b) {
    return RuntimeScalar(a.of_ * b.of_);
}
template <class C>
RuntimeScalar<C> RuntimeScalar<C>::quotient(const RuntimeScalar& a, const RuntimeScalar& b) {
    return RuntimeScalar(a.of_ / b.of_);
}
template <class C>
RuntimeScalar<C> RuntimeScalar<C>::integer_power(const RuntimeScalar& a, int power) {
    return RuntimeScalar(pow(a.of_, power));
}
template <class C>
RuntimeScalar<C> RuntimeScalar<C>::real_power(const RuntimeScalar& a, double power) {
    return RuntimeScalar(pow(a.of_, power));
}
template <class C>
RuntimeScalar<C> RuntimeScalar<C>::root(const RuntimeScalar& a) {
    return RuntimeScalar(sqrt(a.of_));
}
template <class C>
RuntimeScalar<C> RuntimeScalar<C>::exponential(const RuntimeScalar& a) {
    return RuntimeScalar(exp(a.of_));
}
template <class C>
RuntimeScalar<C> RuntimeScalar<C>::logarithm(const RuntimeScalar& a) {
    return RuntimeScalar(log(a.of_));
}
template <class C>
RuntimeScalar<C> RuntimeScalar<C>::sine(const RuntimeScalar& a) {
    return RuntimeScalar(sin(a.of_));
}
template <class C>
RuntimeScalar<C> RuntimeScalar<C>::cosine(const RuntimeScalar& a) {
    return RuntimeScalar(cos(a.of_));
}

template <class C>
RuntimeAngle<C> RuntimeAngle<C>::sum(const RuntimeAngle& a, const RuntimeAngle& b) {
    RuntimeAngle y;
    y.of_ = a.of_ + b.of_;
    return y;
}
template <class C>
RuntimeAngle<C> RuntimeAngle<C>::multiple(int times, const RuntimeAngle& a) {
    RuntimeAngle y;
    y.of_ = times * a.of_;
    return y;
}
template <class C>
RuntimeAngle<C> RuntimeAngle<C>::shifted(const RuntimeAngle& a, const Scalar& by) {
    RuntimeAngle y;
    y.of_ = a.of_ + by.of_;
    return y;
}
template <class C>
RuntimeScalar<C> RuntimeAngle<C>::cosine(const RuntimeAngle& a) {
    return RuntimeScalar<C>(cos(a.of_));
}
template <class C>
RuntimeScalar<C> RuntimeAngle<C>::sine(const RuntimeAngle& a) {
    return RuntimeScalar<C>(sin(a.of_));
}

}  // namespace equilibria
