/// \file
/// See core/jet.hpp.
#pragma once

#include <algorithm>

#include <equilibria/core/jet.hpp>

namespace equilibria {

template <class S>
Jet<S>::Jet(const Series& series, int order, bool moves) : Jet(order, moves) {
    for (int k = 0; k <= order; ++k) {
        value_[k] = series.coefficient[k].value;
        for (int d = 0; d < directions; ++d) slope_[k][d] = series.coefficient[k].derivative[d];
    }
}

template <class S>
typename Jet<S>::Series Jet<S>::series() const {
    Series y;
    for (int k = 0; k <= order_; ++k) y.coefficient[k] = coefficient(k);
    return y;
}

template <class S>
template <class Operation>
Jet<S> Jet<S>::entry_by_entry(const Jet& a, const Jet& b, const Operation& operation) {
    Jet y(std::max(a.order_, b.order_), a.moves_ || b.moves_);
    const int both = std::min(a.order_, b.order_);
    for (int k = 0; k <= both; ++k) y.value_[k] = operation(a.value_[k], b.value_[k]);
    for (int k = both + 1; k <= y.order_; ++k) y.value_[k] = operation(a.value(k), b.value(k));
    if (y.moves_)
        for (int k = 0; k <= y.order_; ++k)
            for (int d = 0; d < directions; ++d) y.slope_[k][d] = operation(a.slope(k, d), b.slope(k, d));
    return y;
}
template <class S>
Jet<S> Jet<S>::sum(const Jet& a, const Jet& b) {
    return entry_by_entry(a, b, [](const S& x, const S& y) { return x + y; });
}
template <class S>
Jet<S> Jet<S>::difference(const Jet& a, const Jet& b) {
    return entry_by_entry(a, b, [](const S& x, const S& y) { return x - y; });
}

template <class S>
Jet<S> Jet<S>::product(const Jet& a, const Jet& b) {
    Jet y(std::max(a.order_, b.order_), a.moves_ || b.moves_);
    for (int k = 0; k <= y.order_; ++k) {
        const int first = std::max(0, k - b.order_), last = std::min(k, a.order_);
        S value(0.0);
        for (int j = first; j <= last; ++j) value = value + a.value_[j] * b.value_[k - j];
        y.value_[k] = value;
        if (!y.moves_) continue;
        for (int d = 0; d < directions; ++d) {
            S slope(0.0);
            if (a.moves_)
                for (int j = first; j <= last; ++j) slope = slope + a.slope_[j][d] * b.value_[k - j];
            if (b.moves_)
                for (int j = first; j <= last; ++j) slope = slope + a.value_[j] * b.slope_[k - j][d];
            y.slope_[k][d] = slope;
        }
    }
    return y;
}

template <class S>
Jet<S> Jet<S>::quotient(const Jet& a, const Jet& b) {
    if (b.order_ > 0 || b.moves_)
        return Jet(a.series() / b.series(), std::max(a.order_, b.order_), a.moves_ || b.moves_);
    Jet y(a.order_, a.moves_);
    for (int k = 0; k <= y.order_; ++k) y.value_[k] = a.value_[k] / b.value_[0];
    if (y.moves_)
        for (int k = 0; k <= y.order_; ++k)
            for (int d = 0; d < directions; ++d) y.slope_[k][d] = a.slope_[k][d] / b.value_[0];
    return y;
}

template <class S>
Jet<S> Jet<S>::scaled(double by) const {
    Jet y(order_, moves_);
    for (int k = 0; k <= order_; ++k) y.value_[k] = by * value_[k];
    if (moves_)
        for (int k = 0; k <= order_; ++k)
            for (int d = 0; d < directions; ++d) y.slope_[k][d] = by * slope_[k][d];
    return y;
}

template <class S>
Jet<S> Jet<S>::of(Function function) const {
    const auto as = [&](const Series& series) { return Jet(series, order_, moves_); };
    switch (function) {
        case Function::sine: return as(sin(series()));
        case Function::cosine: return as(cos(series()));
        case Function::exponential: return as(exp(series()));
        case Function::logarithm: return as(log(series()));
        case Function::square_root: break;
    }
    return as(sqrt(series()));
}

template <class S>
Jet<S> Jet<S>::to_the(int power) const {
    if (power < 0) return quotient(Jet(1.0), to_the(-power));
    Jet y(1.0);
    for (int j = 0; j < power; ++j) y = product(y, *this);
    return y;
}
template <class S>
Jet<S> Jet<S>::to_the(double power) const {
    return Jet(pow(series(), power), order_, moves_);
}

}  // namespace equilibria
