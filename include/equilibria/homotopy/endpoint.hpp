/// \file
/// Where a path ended, with the evidence.
#pragma once

#include <cstdint>

#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/path_status.hpp>

namespace equilibria {

/// Where the tracker left a path.
enum class Arrival : std::uint8_t {
    end,      ///< t = 1
    endgame,  ///< close to t = 1, which no regular step reaches, or far away
    stuck     ///< the step control gave up, or the steps ran out
};

/// The numbers that a path was tracked with at last.
enum class Precision : std::uint8_t {
    as_begun,    ///< those of the whole run
    in_double,   ///< single precision could not carry it to its end: it went on in double from where it was
    more_digits  ///< more than double has, from its start or for its end
};

/// What became of a path, with the evidence.
struct Endpoint {
    RuntimePoint<double> q;                      ///< the endpoint, angles by cosine and sine
    double t = 0;                                ///< where the lane tracker left it
    std::int32_t steps = 0;                      ///< predictor-corrector steps, refused ones included
    Arrival arrival = Arrival::stuck;            ///< where the tracker left it
    PathStatus status = PathStatus::failed;      ///< what the endpoint is
    FailureReason reason = FailureReason::none;  ///< why it failed, where it did
    Precision precision = Precision::as_begun;   ///< of the numbers at last
    std::int16_t winding_number = 1;             ///< of the path at t = 1; more than 1 only at a singular endpoint
    PolishedEvidence evidence;                   ///< of the last correction
};

/// An endpoint without its point.
struct EndpointRecord {
    /// As of Endpoint.
    /// \{
    double t = 0;
    PolishedEvidence evidence;
    std::int32_t steps = 0;
    std::int16_t winding_number = 1;
    Arrival arrival = Arrival::stuck;
    PathStatus status = PathStatus::failed;
    FailureReason reason = FailureReason::none;
    Precision precision = Precision::as_begun;
    /// \}

    EndpointRecord() = default;
    /// All but the point.
    EndpointRecord(const Endpoint& end) {
        const auto& [q, t_, steps_, arrival_, status_, reason_, precision_, winding_, evidence_] = end;
        t = t_, evidence = evidence_, steps = steps_, winding_number = winding_;
        arrival = arrival_, status = status_, reason = reason_, precision = precision_;
    }
};

/// The largest condition number (see PolishedEvidence) of an endpoint that counts as regular.
inline constexpr double regular_condition = 1e8;

/// The square of the size beyond which a path is left to the endgame, which asks whether it goes to infinity.
inline constexpr double far_away2 = 1e16;

namespace detail {
/// The same of a homotopy, which may say otherwise.
template <class H>
double far_limit2(const H& homotopy) {
    if constexpr (requires { homotopy.far_away2(); })
        return homotopy.far_away2();
    else
        return far_away2;
}
}  // namespace detail

}  // namespace equilibria
