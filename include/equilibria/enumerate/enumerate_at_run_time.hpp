/// \file
/// `enumerate` of models whose numbers of unknowns are known at run time alone: the same paths, the same account.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/model/runtime_model.hpp>
#include <equilibria/paths/solve_along.hpp>
#include <equilibria/system/runtime_formulation.hpp>
#include <equilibria/system/system_family.hpp>

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

/// A model at run time at p, and what tracking and counting its paths takes.
template <RuntimeModel T>
struct RuntimeProblem {
    /// Throws InvalidArgument for parameters that are not finite or not as many as the model's.
    RuntimeProblem(const T& model_, const RuntimeArray<double>& p_, const RunOptions& run_)
        : model((require_finite(p_, "parameters"), model_)), p(p_), run(run_), formulation(model),
          target(formulation, model, p),
          properties{formulation.sizes(), formulation.has_potential(), formulation.reflection_symmetric()},
          equations(model, p) {
        if (run.is_told_apart())
            fields = model_fields(type_name<T>(), formulation.sizes(), target.terms, {p.begin(), p.end()});
    }

    PathCount total_degree() const {
        PathCount y{1, false};
        const RuntimeSizes& sizes = formulation.sizes();
        for (int i = 0; i < sizes.unknowns; ++i)
            y = y * PathCount{(i < sizes.angles ? 2 : 1) * formulation.degrees()[static_cast<std::size_t>(i)], false};
        return y;
    }
    /// Reflected where the equations are odd. Throws InvalidArgument where its paths cannot be numbered.
    TotalDegreeStart total_degree_start() const {
        require(!total_degree().saturated, "model", "a total degree above 2^62",
                "must have fewer paths than can be numbered");
        Generator generator(run.seed);
        return {formulation.reflection_symmetric() ? TotalDegreeKind::reflected : TotalDegreeKind::general,
                formulation.sizes(), formulation.degrees(), target.scale, generator};
    }

    /// What endpoints are polished on.
    std::shared_ptr<const OwnEquations> own() const {
        return std::make_shared<OwnEquationsOf<RuntimeModelValues<T>>>(
            RuntimeModelValues<T>{model, formulation.sizes(), p});
    }

    T model;
    RuntimeArray<double> p;
    RunOptions run;
    RuntimeFormulation formulation;
    RuntimeModelSystem target;
    ModelProperties<RuntimeUnknowns> properties;
    RealRuntimeEquations<T> equations;
    CheckpointFields fields;
};

}  // namespace detail

/// Every isolated equilibrium of a model at run time at the parameters p, from the start of the least predicted cost: a
/// total-degree one, reflected where the equations are odd under theta -> -theta, or a polyhedral one; or from that
/// asked for, StartSystem TotalDegreeStart or Polyhedral. As `enumerate` of a Model; a resort (more_digits of
/// more_digits.hpp) is for paths that fail in double.
///
/// Throws InvalidArgument for a model that is no trigonometric polynomial, for parameters that are not finite or not
/// as many as the model's, for more paths than can be numbered and for options out of range; CheckpointError for a
/// checkpoint that cannot be used.
template <class StartSystem, RuntimeModel T>
RootSet<RuntimeUnknowns> enumerate_from(const T& model, const RuntimeArray<double>& p, const RunOptions& run = {},
                                        const TrackerOptions& options = {}, MoreDigits<> resort = nullptr) {
    const detail::Stopwatch begin;
    options.validate();
    const detail::RuntimeProblem<T> problem(model, p, run);
    const auto& formulation = problem.formulation;
    const auto& target = problem.target;
    const auto& properties = problem.properties;
    const auto& equations = problem.equations;
    const auto& fields = problem.fields;
    const RuntimeSizes& sizes = formulation.sizes();

    StartReport report{{}, "asked for", {}};
    if constexpr (!std::is_same_v<StartSystem, TotalDegreeStart>) {
        constexpr bool asked = std::is_same_v<StartSystem, Polyhedral>;
        const auto system = detail::system_of_terms(sizes, target.terms);
        PathCount tracked = problem.total_degree();
        if (formulation.reflection_symmetric()) tracked.value /= 2;
        require(!asked || system, "parameters", "an equation that vanishes",
                "must leave each equation a term for a polyhedral start");
        if (asked || detail::polyhedral_pays(system, tracked, formulation.reflection_symmetric(), report, run)) {
            auto set = detail::enumerate_polyhedral(*system, p, properties, problem.own(), equations, fields, run,
                                                    options, resort);
            set.seconds = begin.seconds();
            set.start.why = report.why;
            if (asked || (set.paths.singular == 0 && set.families.empty())) return set;
            report.why = "the roots are not all regular, and its paths lead to curves of solutions";
        }
    }
    const TotalDegreeStart start = problem.total_degree_start();
    const PolynomialHomotopy homotopy = model_homotopy(model, target, start);
    auto set = detail::root_set_of(
        detail::track_paths(homotopy, {.start = StartPoints(start), .model = fields}, run, options, resort), p,
        properties, homotopy, equations, run);
    set.start = {std::string(start.name()), std::move(report.why), report.mixed_volume};
    set.seconds = begin.seconds();
    return set;
}
/// From the start of the least predicted cost.
template <RuntimeModel T>
RootSet<RuntimeUnknowns> enumerate(const T& model, const RuntimeArray<double>& p, const RunOptions& run = {},
                                   const TrackerOptions& options = {}, MoreDigits<> resort = nullptr) {
    return enumerate_from<LeastCost>(model, p, run, options, resort);
}

/// The equilibria at p, from those of a solved instance of the same model: as many paths as `solved` has roots. As
/// `enumerate(solved, p)` of a Model, on a line in the space of coefficients or along an arc of the parameters.
///
/// Throws InvalidArgument as the other `enumerate`, and where `solved` has failed or singular paths, or other numbers
/// of unknowns or parameters.
template <RuntimeModel T>
RootSet<RuntimeUnknowns> enumerate(const T& model, const RootSet<RuntimeUnknowns>& solved,
                                   const RuntimeArray<double>& p, const RunOptions& run = {},
                                   const TrackerOptions& options = {}, MoreDigits<> resort = nullptr,
                                   MoreDigits<ArcHomotopy> arc_resort = nullptr) {
    const detail::Stopwatch begin;
    options.validate();
    detail::require_start_instance(solved.paths);
    const detail::RuntimeProblem<T> problem(model, p, run);
    const auto& formulation = problem.formulation;
    const auto& target = problem.target;
    const RuntimeSizes& sizes = formulation.sizes();
    KnownRoots::Points points;
    for (const auto& root : solved.roots) {
        require(root.q.size() == sizes.unknowns, "unknowns of solved", root.q.size(), "must be as many as the model's");
        points.push_back(root.q);
    }
    const RuntimeModelSystem solved_system(formulation, model, solved.parameters);
    Generator generator(run.seed);
    const auto gamma = unit_complex(generator);
    const auto own = problem.own();
    PolynomialHomotopy::Parts parts{.sizes = sizes,
                                    .terms = target.terms,
                                    .from = {},
                                    .forms = {},
                                    .scale = target.scale,
                                    .symmetric = formulation.has_potential(),
                                    .own = own};
    for (const auto& term : solved_system.terms) parts.from.push_back(gamma * term.coefficient);
    const PolynomialHomotopy line(std::move(parts));
    const SystemFamily family = system_family(model);
    const KnownRoots start(sizes, points);
    auto paths =
        detail::line_serves(points.size(), formulation.degrees(), family, solved.parameters, p)
            ? detail::track_paths(line, {.start = StartPoints(start), .model = problem.fields}, run, options, resort)
            : detail::track_along_arc(family, points, solved.parameters, p, own, problem.fields, run, options,
                                      arc_resort);
    auto set = detail::root_set_of(std::move(paths), p, problem.properties, line, problem.equations, run);
    set.seconds = begin.seconds();
    return set;
}

}  // namespace equilibria
