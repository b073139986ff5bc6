/// \file
/// Basins of attraction: which stable equilibrium a damped motion comes to, from many starts.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/dynamics/lagrange_second_kind.hpp>
#include <equilibria/dynamics/motion.hpp>
#include <equilibria/model/model.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/run/threads.hpp>

namespace equilibria {

/// How motions are followed to the equilibria where they settle.
struct BasinOptions {
    MotionOptions motion{1e-9, 1e-9, 0, 10'000'000};  ///< tolerances, and steps of one motion
    double longest_time = 1000;                       ///< in the model's unit of time
    /// A motion has settled when the energy that it has left above an equilibrium is below this share of the barrier:
    /// the height of the lowest unstable equilibrium above it.
    double settled_share = 1e-8;
    Executor executor{};  ///< serial, or threads(n); does not change the result
};

/// Where a motion ended.
template <DynamicModel M>
struct Settled {
    std::optional<std::size_t> equilibrium;  ///< its place in the given list; nothing where the motion did not settle
    MotionStatus status = MotionStatus::finished;  ///< why the integration ended
    double time = 0;                               ///< when it had settled, or how far it came
    /// Since when its energy is below the barrier around that equilibrium. From then on it could not leave, whatever
    /// the integration's errors below the barrier: energy falls, and below the barrier the well has no way out.
    double trapped_time = std::numeric_limits<double>::quiet_NaN();
    double energy_rise = 0;  ///< the most that the energy rose in a step, over what it lost in all: 0 but for errors
    MotionPoint<M> last;     ///< the last point of the motion
};

/// Follows the motion from each start until it has settled at one of the equilibria. `equilibria`: all of them, as of
/// RootSet, or other objects with q, energy and stable(). The energy must fall: forces beside the potential and damping
/// would break the argument, and `energy_rise` shows it. Throws InvalidArgument where an option or a start is none, or
/// no equilibrium is stable.
template <DynamicModel M, class Equilibria>
std::vector<Settled<M>> find_basins(const Parameters<M>& p, const Equilibria& equilibria,
                                    const std::vector<MotionState<M>>& starts, const BasinOptions& options = {}) {
    require(options.longest_time > 0 && std::isfinite(options.longest_time), "longest_time", options.longest_time,
            "must be positive");
    require(options.settled_share > 0 && options.settled_share < 1, "settled_share", options.settled_share,
            "must be between 0 and 1");
    options.motion.validate();
    struct Well {
        std::size_t equilibrium;
        Unknowns<M> q;
        double energy, barrier;
    };
    std::vector<Well> wells;
    for (std::size_t k = 0; k < equilibria.size(); ++k)
        if (equilibria[k].stable()) {
            double barrier = std::numeric_limits<double>::infinity();
            for (const auto& other : equilibria)
                if (!other.stable() && other.energy > equilibria[k].energy) barrier = std::min(barrier, other.energy);
            wells.push_back({k, equilibria[k].q, equilibria[k].energy, barrier});
        }
    require(!wells.empty(), "equilibria", equilibria.size(), "of these one at least must be stable");

    const LagrangeSecondKind<M> formulation(p);
    const auto follow = [&](const MotionState<M>& start) {
        Settled<M> y;
        MotionStepper<LagrangeSecondKind<M>> stepper(formulation, start, 0, options.motion);
        y.last = stepper.at(0);
        const double first = y.last.kinetic + y.last.potential;
        double energy = first, lowest = first;
        std::vector<double> below(wells.size(), std::numeric_limits<double>::quiet_NaN());
        do {
            y.last = stepper.at(stepper.time());
            energy = y.last.kinetic + y.last.potential;
            y.energy_rise = std::max(y.energy_rise, energy - lowest);
            lowest = std::min(lowest, energy);
            std::size_t nearest = 0;
            for (std::size_t k = 0; k < wells.size(); ++k) {
                if (energy < wells[k].barrier && std::isnan(below[k])) below[k] = y.last.time;
                if (distance<M>(y.last.q, wells[k].q) < distance<M>(y.last.q, wells[nearest].q)) nearest = k;
            }
            const auto& well = wells[nearest];
            const double height = std::min(well.barrier, std::max(first, well.energy)) - well.energy;
            if (std::abs(energy - well.energy) <= options.settled_share * height) {
                y.equilibrium = well.equilibrium;
                y.trapped_time = below[nearest];
            }
        } while (!y.equilibrium && stepper.time() < options.longest_time && stepper.step());
        y.status = stepper.status();
        y.time = stepper.time();
        if (first > lowest) y.energy_rise /= first - lowest;
        return y;
    };

    std::vector<Settled<M>> y(starts.size());
    options.executor.for_blocks(starts.size(), 1, [&](std::size_t from, std::size_t to) {
        for (std::size_t k = from; k < to; ++k) y[k] = follow(starts[k]);
    });
    return y;
}

}  // namespace equilibria
