/// \file
/// Every isolated solution of a model from a multihomogeneous start, for models of far fewer solutions than their total
/// degree: systems with null vectors, multipliers or parameters among their unknowns.
///
/// What comes back are complex roots. They are not classified as equilibria are: the models are systems of equations, and
/// their users know what a real root means.
#pragma once

#include <cstdint>
#include <vector>

#include <equilibria/paths/collect.hpp>
#include <equilibria/paths/path_solver.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/system/linear_product.hpp>

namespace equilibria {

/// All complex solutions of a system, every path accounted for.
template <Model M>
struct ComplexRoots {
    using System = LinearProduct<M>;
    Parameters<System> parameters;
    PathCounts paths;
    std::vector<Root<System>> roots;  ///< distinct, by path number; their unknowns are those of M
    std::vector<FailedPath<System>> failures;
};

/// How paths that fail in double are tracked with more digits: careful_roots<M> (multiprecision.hpp), or not at all.
template <Model M>
using RootRescue = detail::Rescue<LinearProduct<M>, StartKind::parameter, double>;

namespace detail {

/// Start systems are a choice: where one leaves paths undecided, another may not. The first attempt has the seed itself.
inline std::uint64_t seed_of_attempt(std::uint64_t seed, std::uint64_t attempt) {
    return seed + 0x9e3779b97f4a7c15 * attempt;
}

/// Follows the solutions `start` (unknowns of M) of the system with the coefficients `from` to the roots at `to`.
template <Model M>
ComplexRoots<M> follow_roots(const auto& start, const auto& from, const Parameters<LinearProduct<M>>& to,
                             const EnumerateOptions& options, RootRescue<M> rescue) {
    using System = LinearProduct<M>;
    ComplexRoots<M> found;
    found.parameters = to;
    Generator generator(options.seed);
    const auto target = coefficients<System, double>(to);
    PathSolver<System, StartKind::parameter, double> solver(
        Homotopy<System, StartKind::parameter, double>::parameter(from, target, unit_complex(generator)), to,
        equation_scales<System, double>(target), options, rescue);
    auto ends = solver.memory(start.size());
    solver.run(
        ends, [&](std::uint64_t path) { return start_point<System>(start[path]); }, {}, false, found.paths);
    const auto same = [](std::uint64_t path) { return path; };
    collect<System>(found.paths, found.failures, ends, same, {}, same, false, same,
                    [&](const Root<System>& root) { found.roots.push_back(root); });
    sort_by_path(found.roots);
    return found;
}

}  // namespace detail

/// Every isolated solution of the model at the parameters p, by paths from a linear-product start system for the groups
/// M::grouping: as many paths as the multihomogeneous number of Bezout of the terms that M has at p. With a rescue paths that
/// fail in double are tracked with more digits before they count as failed; paths.more_digits says how many were.
///
/// Throws InvalidArgument for parameters that are not finite and for options out of range. Checkpoints are not kept.
template <Model M>
ComplexRoots<M> solve_multihomogeneous(const Parameters<M>& p, const EnumerateOptions& options = {},
                                       RootRescue<M> rescue = nullptr) {
    require_finite(p, "parameters");
    options.validate();
    Generator generator(options.seed);
    const LinearProductStart<M> start(p, generator);
    return detail::follow_roots<M>(start.solutions, start.coefficients, start.target, options, rescue);
}

/// The solutions at p from regular solutions at the parameters `from`, along a line in the space of coefficients: complete
/// if `roots` are as many as a generic system on that line has.
template <Model M>
ComplexRoots<M> solve_from(const std::vector<Root<LinearProduct<M>>>& roots,
                           const Parameters<LinearProduct<M>>& from, const Parameters<LinearProduct<M>>& p,
                           const EnumerateOptions& options = {}, RootRescue<M> rescue = nullptr) {
    std::vector<Array<std::complex<double>, n_unknowns<M>>> start;
    start.reserve(roots.size());
    for (const auto& root : roots) start.push_back(root.q);
    return detail::follow_roots<M>(start, coefficients<LinearProduct<M>, double>(from), p, options, rescue);
}

}  // namespace equilibria
