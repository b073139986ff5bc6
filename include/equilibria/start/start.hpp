/// \file
/// What a start is: where paths begin, and what it adds to the target's terms on the way.
///
/// A homotopy is made of a target F and a start. The start says how the coefficients of F depend on the time t, and
/// which terms of its own it adds:
///     H(q, t) = t F(q) + (1 - t) G(q)           where it is not `moving`: total degree, reflected, linear product;
///     H(q, t) = sum_k a_k(t) m_k(q) + (1-t) G   where it is: each term of F has a law of its own, a_k(1) being F's
///                                               coefficient: a solved instance, (1-t) gamma b_k + t a_k.
/// G is evaluated in its own form (start_forms.hpp).
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include <equilibria/evaluation/point.hpp>
#include <equilibria/start/path_numbering.hpp>

namespace equilibria {

/// Where the paths begin that are tracked: point(k), on path number tracked_path(k) of the numbering. M: the unknowns.
template <class T, class M>
concept Start = requires(const T& start, std::uint64_t k) {
    { start.numbering() } -> std::convertible_to<PathNumbering>;
    { start.point(k) } -> std::same_as<Point<M, double>>;
};

/// The points of any start, of which no more is known: what those ask who track its paths.
class StartPoints {
public:
    using Point = RuntimePoint<double>;  ///< with its numbers of unknowns at run time

    /// The start has to outlive it.
    template <class T>
    explicit StartPoints(const T& start)
        : numbering(start.numbering()), name(start.name()),
          point([&start](std::uint64_t k) { return runtime_point(start.point(k)); }), of_system(of_start_system<T>()) {
        if constexpr (requires { start.resting_point(std::uint64_t{}); })
            resting_point = [&start](std::uint64_t k) { return runtime_point(start.resting_point(k)); };
    }

    PathNumbering numbering;                    ///< which paths are tracked
    std::string name;                           ///< what results call the start
    std::function<Point(std::uint64_t)> point;  ///< where the k-th tracked path begins
    /// The k-th solution that rests at every t; none where the numbering has none.
    std::function<Point(std::uint64_t)> resting_point;
    /// Whether they are roots of G by their numbers, so that the homotopy's coefficients say all of them.
    bool of_system;

private:
    template <class T>
    static constexpr bool of_start_system() {
        if constexpr (requires { T::moving; }) return !T::moving;
        return false;
    }
};

}  // namespace equilibria
