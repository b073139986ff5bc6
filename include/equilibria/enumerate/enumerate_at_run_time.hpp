/// \file
/// `enumerate` of models whose numbers of unknowns are known at run time alone: the same paths, the same account.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>

#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/model/runtime_model.hpp>
#include <equilibria/system/runtime_formulation.hpp>

namespace equilibria {

namespace detail {

template <RuntimeModel T>
class RealRuntimeEquations final : public RealEquations {
public:
    RealRuntimeEquations(const T& model, const RuntimeArray<double>& p)
        : RealEquations(sizes_of(model), RuntimePotentialModel<T>), model_(model), p_(p) {}

    void linearize(const double* q, double* f, double* jacobian) const override {
        const RuntimeModelPoint<double> at(q, sizes);
        equations_and_jacobian(model_, at.theta, at.x, p_, f, jacobian);
    }
    double energy(const double* q) const override {
        if constexpr (RuntimePotentialModel<T>) {
            const RuntimeModelPoint<double> at(q, sizes);
            return call_runtime_potential(model_, at.theta, at.x, p_);
        } else {
            return std::numeric_limits<double>::quiet_NaN();
        }
    }

private:
    T model_;
    RuntimeArray<double> p_;
};

}  // namespace detail

/// Every isolated equilibrium of a model at run time at the parameters p, from a total-degree start: the reflected one
/// where the equations are odd under theta -> -theta. As `enumerate` of a Model; a resort (more_digits of
/// more_digits.hpp) is for paths that fail in double.
///
/// Throws InvalidArgument for a model that is no trigonometric polynomial, for parameters that are not finite or not
/// as many as the model's, for more paths than can be numbered and for options out of range; CheckpointError for a
/// checkpoint that cannot be used.
template <RuntimeModel T>
RootSet<RuntimeUnknowns> enumerate(const T& model, const RuntimeArray<double>& p, const RunOptions& run = {},
                                   const TrackerOptions& options = {}, MoreDigits<> resort = nullptr) {
    const detail::Stopwatch begin;
    require_finite(p, "parameters");
    options.validate();
    const RuntimeFormulation formulation(model);
    const RuntimeSizes& sizes = formulation.sizes();
    PathCount paths{1, false};
    for (int i = 0; i < sizes.unknowns; ++i)
        paths =
            paths * PathCount{(i < sizes.angles ? 2 : 1) * formulation.degrees()[static_cast<std::size_t>(i)], false};
    require(!paths.saturated, "model", "a total degree above 2^62", "must have fewer paths than can be numbered");
    const RuntimeModelSystem target(formulation, model, p);
    Generator generator(run.seed);
    const TotalDegreeStart start(
        formulation.reflection_symmetric() ? TotalDegreeKind::reflected : TotalDegreeKind::general, sizes,
        formulation.degrees(), target.scale, generator);
    const PolynomialHomotopy homotopy = model_homotopy(model, target, start);
    detail::PathProblem problem{.start = StartPoints(start)};
    if (!run.checkpoint.empty())
        problem.model = detail::model_fields(detail::type_name<T>(), sizes, target.terms, {p.begin(), p.end()});
    auto set = detail::root_set_of(detail::track_paths(homotopy, std::move(problem), run, options, resort), p,
                                   {sizes, formulation.has_potential(), formulation.reflection_symmetric()}, homotopy,
                                   detail::RealRuntimeEquations<T>(model, p), run);
    set.seconds = begin.seconds();
    return set;
}

}  // namespace equilibria
