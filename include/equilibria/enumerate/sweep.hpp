/// \file
/// A model at many points of its parameter space: how many equilibria of each index it has at each, from the roots of
/// one generic instance, so that a point costs as many paths as the mixed volume. Points are done in any order, over
/// threads and ranks, and handed on in theirs.
///
/// A point where paths fail, where two of them end at one regular root or an alarm is raised is done again from another
/// generic instance, up to two more (Bates, Brake, Niemerg, "Paramotopy: parameter homotopies in parallel", ICMS 2018,
/// do that). What remains is told.
///
/// With a checkpoint the points that are finished are kept in the file; the same call goes on from there, and hands all
/// points on once more, from the first: who writes them somewhere writes the same again.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/parameter_points.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/run/run_options.hpp>

namespace equilibria {

/// What is known of one point.
struct SweptPoint {
    std::uint64_t number = 0;         ///< of the point, from 0
    RuntimeArray<double> parameters;  ///< all of the model's
    /// An equation vanishes there, whatever the unknowns: nothing was tracked.
    bool vanishing_equation = false;
    std::uint32_t paths = 0;             ///< that were tracked
    std::uint32_t finite = 0;            ///< ended at a regular root
    std::uint32_t at_infinity = 0;       ///< ended at infinity
    std::uint32_t singular = 0;          ///< ended at a singular root
    std::uint32_t failed = 0;            ///< were not finished
    std::uint32_t distinct = 0;          ///< regular or multiple roots, of any kind
    std::uint32_t real = 0;              ///< equilibria
    std::uint32_t degenerate = 0;        ///< of them
    std::vector<std::int64_t> by_index;  ///< nondegenerate equilibria of each index 0 .. n
    bool clean = false;                  ///< as of RootSet
    bool alarm = false;                  ///< one is raised
    std::uint8_t instances = 1;          ///< generic instances that it was followed from
    std::uint32_t proved = 0;            ///< of the roots, where asked for
    std::uint32_t proved_real = 0;       ///< with their index, if there is one
};

/// What is done at each point.
struct SweepOptions {
    bool prove = false;             ///< each root, by Krawczyk's test (prove.hpp)
    TrackerOptions tracker{};       ///< how paths are followed
    MoreDigits<> resort = nullptr;  ///< for paths that fail in double: more_digits of more_digits.hpp
};

/// What is known of all.
struct SweepCounts {
    std::uint64_t points = 0;                         ///< that there are
    std::uint64_t done = 0;                           ///< finished; less where the run was cancelled
    std::uint64_t paths = 0;                          ///< of all points
    std::uint64_t failed = 0;                         ///< paths that were not finished
    std::uint64_t singular_points = 0;                ///< points with multiple roots
    std::uint64_t alarms = 0;                         ///< points with an alarm
    std::uint64_t unclean = 0;                        ///< points that are not clean
    std::uint64_t again = 0;                          ///< points that were done from another instance too
    std::uint64_t vanishing = 0;                      ///< points at which an equation vanishes: none of the others
    std::uint64_t proved = 0;                         ///< points all of whose roots are proved
    std::map<std::uint64_t, std::uint64_t> by_real;   ///< points by how many equilibria they have
    std::uint64_t mixed_volume = 0;                   ///< paths a point
    double seconds = 0;                               ///< of the whole sweep
    bool cancelled() const { return done < points; }  ///< before all points were finished
};
/// The counts in words.
std::ostream& operator<<(std::ostream& out, const SweepCounts& counts);

namespace detail {

/// A model at one point, its type forgotten.
struct ModelMember {
    std::optional<SparseSystem> system;  ///< none where an equation vanishes
    std::shared_ptr<const OwnEquations> own;
    std::unique_ptr<RealEquations> equations;
};
struct SweptModel {
    ModelProperties<RuntimeUnknowns> properties;
    CheckpointFields fields;  ///< of a checkpoint's header, parameters left out
    std::function<ModelMember(const RuntimeArray<double>& p)> member;
    std::function<ExactTerms(const RuntimeArray<double>& p)> exact;
};
using SweptPointTaker = std::function<void(const SweptPoint&)>;
SweepCounts sweep_points(const SweptModel& model, const ParameterPoints& points, const SweptPointTaker& take,
                         const RunOptions& run, const SweepOptions& options);

}  // namespace detail

/// Hands each point's result to take(point), in their order, one call at a time, at rank 0. Every rank gets the
/// counts.
///
/// Throws InvalidArgument for options out of range and for points that do not fit the model, CheckpointError for a
/// checkpoint that cannot be used, and what `take` throws.
template <RuntimeModel T>
SweepCounts sweep(const T& model, const ParameterPoints& points, const detail::SweptPointTaker& take,
                  const RunOptions& run = {}, const SweepOptions& options = {}) {
    const auto formulation = std::make_shared<const RuntimeFormulation>(model);
    const RuntimeSizes sizes = formulation->sizes();
    detail::SweptModel swept{.properties = {sizes, formulation->has_potential(), formulation->reflection_symmetric()},
                             .fields = {},
                             .member =
                                 [&, formulation](const RuntimeArray<double>& p) {
                                     const RuntimeModelSystem target(*formulation, model, p);
                                     return detail::ModelMember{
                                         detail::system_of_terms(sizes, target.terms),
                                         std::make_shared<detail::OwnEquationsOf<detail::RuntimeModelValues<T>>>(
                                             detail::RuntimeModelValues<T>{model, sizes, p}),
                                         std::make_unique<detail::RealRuntimeEquations<T>>(model, p)};
                                 },
                             .exact = [&](const RuntimeArray<double>& p) { return exact_terms(model, p); }};
    if (run.is_told_apart())
        swept.fields = {{"model", detail::type_name<T>()}, {"model's build", detail::build_name()}};
    return detail::sweep_points(swept, points, take, run, options);
}

/// The same of a model whose sizes are known at compile time.
template <Model M>
SweepCounts sweep(const ParameterPoints& points, const detail::SweptPointTaker& take, const RunOptions& run = {},
                  const SweepOptions& options = {}) {
    detail::SweptModel swept{
        .properties = {Sizes<M>(), PotentialModel<M>, Formulation<M>::reflection_symmetric},
        .fields = {},
        .member =
            [](const RuntimeArray<double>& at) {
                const auto p = parameters_from<M>(at);
                return detail::ModelMember{
                    detail::system_of(ModelSystem<M>(p)),
                    std::make_shared<detail::OwnEquationsOf<detail::ModelValues<M>>>(detail::ModelValues<M>{p}),
                    std::make_unique<detail::RealModelEquations<M>>(p)};
            },
        .exact = [](const RuntimeArray<double>& p) { return ExactTerms(ExactSystem<M>::at(parameters_from<M>(p))); }};
    if (run.is_told_apart())
        swept.fields = {{"model", detail::type_name<M>()}, {"model's build", detail::build_name()}};
    return detail::sweep_points(swept, points, take, run, options);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/sweep_definitions.hpp>
#endif
