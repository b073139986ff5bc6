/// \file
/// The circle around t = 1 that a path is followed on: a segment after the other, until it closes.
#pragma once

#include <algorithm>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

#include <equilibria/core/complex.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/detail/closed_loop.hpp>
#include <equilibria/homotopy/detail/segments.hpp>

namespace equilibria::detail {

/// A path around t = 1 at |1-t| = r, until it closes.
template <class R>
struct Circle : Segment<R> {
    using At = RuntimePoint<R>;
    using Loop = ClosedLoop<R>;
    static constexpr int samples = Loop::samples;

    /// Points as close as `closed` are the same.
    Circle(const At& first, double radius, std::int32_t steps_before, double noise_there, double closed)
        : points_{first}, radius_(radius), closed_(closed) {
        this->q = first;
        this->steps = steps_before;
        this->noise = noise_there;
        set_arc();
    }
    /// Without a winding number where the path was stuck, or did not close.
    const Loop& loop() const { return loop_; }

    bool advance() {
        ++arc_;
        if (arc_ == samples * Loop::most_turns) return false;
        set_arc();
        return true;
    }
    bool take(const At& at) {
        const double away = distance(points_.front(), at);
        excursion_ = std::max(excursion_, away);
        if (arc_ % samples == 0 && away < 1e-3 * excursion_ + closed_) {
            loop_ = Loop(points_, arc_ / samples);
            return false;
        }
        points_.push_back(at);
        return arc_ < samples * Loop::most_turns;
    }

private:
    Complex<R> time(int arc) const {
        const int m = arc % samples;
        const auto z = m == 0 ? std::complex<double>(radius_) : std::polar(radius_, 2 * std::numbers::pi * m / samples);
        return {1.0 - R(z.real()), -R(z.imag())};
    }
    void set_arc() {
        this->from = time(arc_);
        this->to = time(arc_ + 1);
    }

    std::vector<At> points_;
    double radius_, closed_, excursion_ = 0;
    int arc_ = 0;
    Loop loop_;
};

}  // namespace equilibria::detail
