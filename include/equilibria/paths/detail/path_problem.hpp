/// \file
/// What a run tracks, beside its homotopy.
#pragma once

#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/homotopy/tracker_options.hpp>
#include <equilibria/start/start.hpp>
#include <equilibria/storage/checkpoint_fields.hpp>

namespace equilibria {

namespace detail {
template <class H>
class Polisher;
}

/// Ends a path that failed in double with more digits (see enumerate/more_digits.hpp): straight on from where it
/// stands, where no start is given, else by all means. A pointer, so that only those who want it compile it.
template <class H = PolynomialHomotopy>
using MoreDigits = void (*)(const H&, const detail::Polisher<H>&, const TrackerOptions&,
                            const RuntimePoint<double>* start, Endpoint& end);

namespace detail {

struct PathProblem {
    StartPoints start;
    CheckpointFields model = {};  ///< what a checkpoint says of the model; empty: there can be none
    bool streamed = false;        ///< a checkpoint alone keeps the endpoints
};

}  // namespace detail

}  // namespace equilibria
