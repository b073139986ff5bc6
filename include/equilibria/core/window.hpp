/// \file
/// Ranges of one, two and three parameters, each in its parameter's own unit (angles in radians).
#pragma once

#include <cmath>
#include <string>

#include <equilibria/core/error.hpp>

namespace equilibria {

/// From low to high, both included.
struct Interval {
    double low = 0;   ///< lower bound
    double high = 1;  ///< upper bound

    double width() const { return high - low; }  ///< negative where the interval is empty
    bool contains(double value) const { return value >= low && value <= high; }  ///< bounds included
    /// Throws InvalidArgument, which calls it `name`, unless it is finite and not empty.
    void validate(const std::string& name) const {
        require(std::isfinite(low) && std::isfinite(high) && low < high, name, to_text(low) + ":" + to_text(high),
                "must be finite and run from the smaller to the larger value");
    }
    friend constexpr bool operator==(const Interval&, const Interval&) = default;  ///< equal bounds
};

/// A rectangle of the plane of two parameters.
struct Window {
    Interval x;  ///< range of the first parameter
    Interval y;  ///< range of the second parameter

    double width() const { return x.width(); }   ///< of the first parameter's range
    double height() const { return y.width(); }  ///< of the second parameter's range
    bool contains(double at_x, double at_y) const { return x.contains(at_x) && y.contains(at_y); }  ///< edges included
    /// Throws InvalidArgument.
    void validate() const {
        x.validate("window x");
        y.validate("window y");
    }
    friend constexpr bool operator==(const Window&, const Window&) = default;  ///< equal ranges
};

/// A box of the space of three parameters.
struct Box {
    Interval x;  ///< range of the first parameter
    Interval y;  ///< range of the second parameter
    Interval z;  ///< range of the third parameter

    /// Whether the point is in the box; faces are included.
    bool contains(double at_x, double at_y, double at_z) const {
        return x.contains(at_x) && y.contains(at_y) && z.contains(at_z);
    }
    /// Throws InvalidArgument.
    void validate() const {
        x.validate("box x");
        y.validate("box y");
        z.validate("box z");
    }
};

}  // namespace equilibria
