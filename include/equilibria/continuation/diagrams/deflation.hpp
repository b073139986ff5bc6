/// \file
/// Deflated Newton: an equilibrium at a fixed parameter other than those that are known, from the same guesses. g is
/// multiplied by prod_k (1 / |q - q_k|^power + shift), which keeps its other zeros and removes q_k. With the step d of
/// Newton's method on g, that on the deflated system is d / (1 - d . grad log m), m the factor.
/// Source: Farrell, Birkisson and Funke, Deflation techniques for finding distinct solutions of nonlinear partial
/// differential equations, SIAM J. Sci. Comput. 37 (2015).
#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/continuation/any_problem.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

/// How deflated Newton searches.
struct DeflationOptions {
    double power = 2;           ///< of the distance to a known equilibrium
    double shift = 1;           ///< what each factor is far away from its equilibrium
    int most_iterations = 100;  ///< of Newton's method from one guess
    double tolerance = 1e-11;   ///< of the last step, over the size of the unknowns
    /// Of Newton's method, by the problem's weights.
    double longest_step = std::numeric_limits<double>::infinity();

    /// Throws InvalidArgument for an option out of range.
    void validate() const {
        require(power >= 1, "power", power, "must be at least 1");
        require(shift >= 0, "shift", shift, "must be 0 or positive");
        require(most_iterations >= 1, "most_iterations", most_iterations, "must be at least 1");
        require(tolerance > 0, "tolerance", tolerance, "must be positive");
        require(longest_step > 0, "longest_step", longest_step, "must be positive");
    }
};

/// Of problems of any type; see below.
/// \{
template <class Matrix>
std::optional<AnyConfiguration> deflated_newton(const AnyProblem<Matrix>& problem, double p, AnyConfiguration guess,
                                                const std::vector<AnyConfiguration>& known,
                                                const DeflationOptions& options);
template <class Matrix>
std::vector<AnyConfiguration> deflated_search(const AnyProblem<Matrix>& problem, double p,
                                              const std::vector<AnyConfiguration>& guesses,
                                              std::vector<AnyConfiguration> known, const DeflationOptions& options);
/// \}

/// An equilibrium at the parameter p other than `known`; nothing where Newton's method does not converge from the
/// guess, which happens where there is none as well. Distances are by the problem's weights.
template <ContinuationProblem P>
std::optional<Configuration<P>> deflated_newton(const P& problem, double p, Configuration<P> guess,
                                                const std::vector<Configuration<P>>& known,
                                                const DeflationOptions& options = {}) {
    const auto found = deflated_newton(AnyProblemOf<P>(problem), p, AnyConfiguration::of(std::move(guess)),
                                       erased_configurations(known), options);
    if (!found) return std::nullopt;
    return found->template as<Configuration<P>>();
}

/// All equilibria at the parameter p that deflated Newton finds from the guesses besides `known`: each new one joins
/// those that are deflated, and the guesses are tried again.
template <ContinuationProblem P>
std::vector<Configuration<P>> deflated_search(const P& problem, double p, const std::vector<Configuration<P>>& guesses,
                                              std::vector<Configuration<P>> known,
                                              const DeflationOptions& options = {}) {
    std::vector<Configuration<P>> y;
    for (const auto& found : deflated_search(AnyProblemOf<P>(problem), p, erased_configurations(guesses),
                                             erased_configurations(known), options))
        y.push_back(found.template as<Configuration<P>>());
    return y;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/diagrams/detail/deflation_definitions.hpp>
#endif
