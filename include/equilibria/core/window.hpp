/// \file
/// Ranges of one, two and three parameters, each in its parameter's own unit (angles in radians).
#pragma once

#include <cmath>
#include <string>

#include <equilibria/core/error.hpp>

namespace equilibria {

/// From low to high, both included.
struct Interval {
    double low = 0, high = 1;

    double width() const { return high - low; }
    bool contains(double value) const { return value >= low && value <= high; }
    /// Throws InvalidArgument, which calls it `name`, unless it is finite and not empty.
    void validate(const std::string& name) const {
        require(std::isfinite(low) && std::isfinite(high) && low < high, name, to_text(low) + ":" + to_text(high),
                "must be finite and run from the smaller to the larger value");
    }
    friend constexpr bool operator==(const Interval&, const Interval&) = default;
};

/// A rectangle of the plane of two parameters.
struct Window {
    Interval x, y;

    double width() const { return x.width(); }
    double height() const { return y.width(); }
    bool contains(double at_x, double at_y) const { return x.contains(at_x) && y.contains(at_y); }
    /// Throws InvalidArgument.
    void validate() const {
        x.validate("window x");
        y.validate("window y");
    }
    friend constexpr bool operator==(const Window&, const Window&) = default;
};

/// A box of the space of three parameters.
struct Box {
    Interval x, y, z;

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
