/// \file
/// What a start is: where paths begin, and what it adds to the target's terms on the way.
///
/// A homotopy is made of a target F and a start. The start says how the coefficients of F depend on the time t, and
/// which terms of its own it adds:
///     H(q, t) = t F(q) + (1 - t) G(q)           where it is not `moving`: total degree, reflected, linear product;
///     H(q, t) = sum_k a_k(t) m_k(q) + (1-t) G   where it is: each term of F has a law of its own, a_k(1) being F's
///                                               coefficient: a solved instance, (1-t) gamma b_k + t a_k.
/// G in the total-degree starts has a term or two an unknown, which join the terms of F (`has_term`); in others it is
/// evaluated in its own form (`Form`).
#pragma once

#include <concepts>
#include <cstdint>

#include <equilibria/evaluation/point.hpp>
#include <equilibria/start/path_numbering.hpp>

namespace equilibria {

/// Where the paths begin that are tracked: point(k), on path number tracked_path(k) of the numbering.
template <class T, class S>
concept Start = requires(const T& start, std::uint64_t k) {
    { T::moving } -> std::convertible_to<bool>;
    { start.numbering() } -> std::convertible_to<PathNumbering>;
    { start.point(k) } -> std::same_as<Point<S, double>>;
};

}  // namespace equilibria
