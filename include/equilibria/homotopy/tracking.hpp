/// \file
/// What a homotopy is tracked by: a predictor (predictor.hpp) and a step control (step_control.hpp).
#pragma once

#include <equilibria/homotopy/predictor.hpp>
#include <equilibria/homotopy/step_control.hpp>

namespace equilibria {

/// Pade approximants and control of the contraction: how paths are tracked where nothing else is asked for.
struct PadeTracking {
    /// Where the path goes.
    template <class R>
    using Predictor = PadePredictor<R>;
    /// How far a step may go.
    template <class R, int local_order>
    using StepControl = ContractionControl<R, local_order>;
};

/// A homotopy that is tracked by something else: T, with a Predictor and a StepControl as PadeTracking has them, and a
/// class derived from that may bring one of them alone.
template <class T, class H>
struct TrackedBy : H {
    using Tracking = T;                                     ///< with a Predictor and a StepControl
    explicit TrackedBy(const H& homotopy) : H(homotopy) {}  ///< the same homotopy
};

namespace detail {
template <class H>
struct TrackingOf {
    using type = PadeTracking;
};
template <class H>
requires requires { typename H::Tracking; }
struct TrackingOf<H> {
    using type = typename H::Tracking;
};
}  // namespace detail

}  // namespace equilibria
