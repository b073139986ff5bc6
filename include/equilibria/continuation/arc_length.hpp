/// \file
/// Curves g(y) = 0, g: R^N -> R^(N-1), followed by pseudo-arclength: the stepper of one step. The driver, who owns the
/// loop, the window and the events, is the caller.
///
///     predictor  y + h t,    corrector  [ g(y)                ]
///                                       [ t . (y - (y0 + h t)) ] = 0,    t the unit tangent: g_y t = 0.
///
/// Folds in any unknown are ordinary points of the curve. The method fails where g_y loses rank: branch points.
/// Sources: Keller 1977; Allgower and Georg, Numerical Continuation Methods.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/continuation/step_control.hpp>

namespace equilibria {

/// A curve: N unknowns, N - 1 equations and their Jacobian.
template <class S>
concept CurveSystem = requires(const S& system, const Eigen::Matrix<double, S::unknowns, 1>& y) {
    { system.residual(y) } -> std::convertible_to<Eigen::Matrix<double, S::unknowns - 1, 1>>;
    { system.jacobian(y) } -> std::convertible_to<Eigen::Matrix<double, S::unknowns - 1, S::unknowns>>;
};

struct ArcLengthOptions {
    double first_step = 1e-3;     ///< in scaled arc length (each unknown over its scale)
    double smallest_step = 1e-10; ///< a curve that needs a smaller one ends there
    double largest_step = 0.02;   ///< also the resolution of the result
    double largest_angle = 0.15;  ///< between the tangents of neighbouring points, radians
    int most_corrections = 6;     ///< Newton steps of one corrector
    double tolerance = 1e-12;     ///< of the last Newton step, scaled

    void validate() const { detail::require_step_control(*this, 1); }
};

template <CurveSystem S>
class ArcLengthStepper {
public:
    static constexpr int N = S::unknowns;
    using Vector = Eigen::Matrix<double, N, 1>;

    /// A point of the curve. The tangent has length 1 in scaled unknowns.
    struct State {
        Vector y;
        Vector tangent;
        double step;  ///< the step that the control proposes next
    };

    /// scale: the typical size of each unknown, all positive.
    ArcLengthStepper(const S& system, const Vector& scale, const ArcLengthOptions& options)
        : system_(&system), scale_(scale), options_(options) {}

    /// The point of the curve nearest to y0 in the tangent's normal plane, with the tangent in direction +1 or -1; none
    /// where Newton's method does not converge.
    std::optional<State> start(const Vector& y0, int direction) const {
        Vector y = y0;
        Vector t;  // the first guess has no tangent before it: a generic normal will do, then its own
        for (int k = 0; k < N; ++k) t(k) = std::cos(1 + k * k);
        t = tangent(y, t);
        if (!correct(y, t)) return std::nullopt;
        return State{y, direction * tangent(y, t), options_.first_step};
    }

    /// The next point; none where the step would be smaller than the smallest. The step control: by the number of
    /// corrections and by the angle of the tangents.
    std::optional<State> advance(const State& from) const {
        for (double h = std::min(from.step, options_.largest_step); h >= options_.smallest_step; h /= 2) {
            const std::optional<Vector> y = at(from, h);
            if (!y) continue;
            const Vector t = tangent(*y, from.tangent);
            const double angle = std::acos(std::min(1.0, t.dot(from.tangent)));
            if (!(angle <= options_.largest_angle)) continue;
            return State{*y, t, h * std::clamp(0.5 * options_.largest_angle / (angle + 1e-9), 0.5, 2.0)};
        }
        return std::nullopt;
    }

    /// The point of the curve in the hyperplane at arc length h along the tangent of `from`; none where Newton's
    /// method does not converge.
    std::optional<Vector> at(const State& from, double h) const {
        Vector y = from.y + h * scale_.cwiseProduct(from.tangent);
        if (!correct(y, from.tangent)) return std::nullopt;
        return y;
    }

    /// The point of the curve near y at which the unknown number k has the value `value`.
    std::optional<Vector> where(Vector y, int k, double value) const {
        Vector normal = Vector::Zero();
        normal(k) = 1;
        y(k) = value;
        if (!correct(y, normal)) return std::nullopt;
        return y;
    }

    /// The unit tangent at y, scaled unknowns, on the side of `before`; NaN where it is orthogonal to that.
    Vector tangent(const Vector& y, const Vector& before) const {
        Vector right = Vector::Zero();
        right(N - 1) = 1;
        return bordered(y, before, nullptr).partialPivLu().solve(right).normalized();
    }

private:
    using Square = Eigen::Matrix<double, N, N>;

    /// [g_y; normal], columns scaled by the unknowns' sizes, rows of g_y to length 1 and with them those of `right`.
    Square bordered(const Vector& y, const Vector& normal, Vector* right) const {
        Square m;
        m.template topRows<N - 1>() = system_->jacobian(y) * scale_.asDiagonal();
        for (int r = 0; r < N - 1; ++r) {
            const double norm = m.row(r).norm();  // of a vanishing row: the solution will be refused as not finite
            m.row(r) /= norm;
            if (right) (*right)(r) /= norm;
        }
        m.row(N - 1) = normal.transpose();
        return m;
    }

    /// Newton's method in the hyperplane through y with the given normal.
    bool correct(Vector& y, const Vector& normal) const {
        double before = 1e300;
        for (int k = 0; k < options_.most_corrections; ++k) {
            Vector right = Vector::Zero();
            right.template head<N - 1>() = system_->residual(y);
            const Square m = bordered(y, normal, &right);
            const Vector step = m.partialPivLu().solve(right);
            const double size = step.norm();
            if (!(size < 0.3) || (k > 0 && size > 0.5 * before && size > options_.tolerance)) return false;
            y -= scale_.cwiseProduct(step);
            if (size <= options_.tolerance) return true;
            before = size;
        }
        return before < 1e3 * options_.tolerance;
    }

    const S* system_;
    Vector scale_;
    ArcLengthOptions options_;
};

}  // namespace equilibria
