/// \file
/// All special points of a locus in a plane of two parameters: its points on lines, its cusps, and its points at which
/// a parameter is extremal, from all complex solutions of the critical system and of the symmetric branches' system.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <equilibria/locus/line/infinity_search.hpp>
#include <equilibria/locus/line/searched_model.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/paths/solution_counts.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/refine_singularity.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/system/critical_system.hpp>
#include <equilibria/system/symmetric_branches.hpp>
#include <equilibria/system/symmetric_system.hpp>

namespace equilibria {

/// Solves for points of the locus of a model in the plane of two of its parameters, x and y.
class PlaneSolver {
public:
    using Numbers = CriticalSystem::Numbers;           ///< of the polynomial system
    using Roots = ComplexRoots<>;                      ///< its complex solutions
    using Points = std::vector<RuntimeSingularity<>>;  ///< refined points of the locus

    /// The model and the plane's system have to outlive it. scales: values of x and y that count as large, positive:
    /// the size of the window. negative: whether negative values of x and y are looked for as well; of a parameter that
    /// enters by even powers alone they are the positive ones with the other sign.
    PlaneSolver(const SearchedModel& model, const CriticalSystem& system, const RuntimeArray<double>& p,
                const RunOptions& run, const std::array<double, 2>& scales = {1, 1},
                const std::array<bool, 2>& negative = {false, false})
        : model_(&model), system_(&system), p_(p), run_(run), scales_(scales), negative_(negative) {}

    /// The folds on lines on which x (`fixed` 0) or y (1) has the given value. One line is
    /// solved from its start system, at the value `generic`; the others follow by parameter homotopy, on as many paths
    /// as there are folds.
    class Lines {
    public:
        /// Solves the line at `generic` for all its complex folds; the solver must outlive it.
        Lines(const PlaneSolver& solver, int fixed, double generic) : solver_(&solver), fixed_(fixed) {
            Roots set;
            solver.attempt(counts_,
                           [&](std::uint64_t seed, Generator& generator, std::uint64_t attempts) -> const auto& {
                               numbers_ = solver.line(fixed, generic, generator);
                               return set = solver.solve_line(numbers_, seed, attempts);
                           });
            for (const auto& root : set.roots)
                if (root.status == PathStatus::finite && root.paths == 1)
                    roots_.push_back(root);
                else if (const auto near = solver.real_point(root))
                    degenerate_.push_back(*near);
        }
        /// Points of the line at `generic` that are more than folds, and about real: a line meets curves alone.
        const Points& degenerate() const { return degenerate_; }
        const SolutionCounts& counts() const { return counts_; }  ///< of the line at `generic`

        /// `failed` is increased by the paths that failed. thorough: a line that leaves paths undecided is solved from
        /// its own start system.
        Points folds(double value, std::uint64_t& failed, bool thorough = true) const {
            if (roots_.empty()) return {};
            Numbers there = numbers_;
            there.slice[2] = -solver_->unknown(fixed_, value);
            const auto from = solver_->system_->system(numbers_), to = solver_->system_->system(there);
            // gamma is a choice: where one leaves paths undecided, another may not
            Roots set;
            for (std::uint64_t k = 0; k < 4 && (k == 0 || set.paths.failed > 0); ++k)
                set = solve_from(roots_, from, to, solver_->run_.with_seed(solver_->run_.seed + k));
            Points points;
            const auto take = [&](const auto& roots) {
                for (const auto& root : roots)
                    if (const auto near = solver_->real_point(root))
                        for (auto at : solver_->with_signs(*near, fixed_)) {
                            (fixed_ == 0 ? at.x() : at.y()) = value;
                            const int moving = solver_->system_->active()[fixed_ == 0 ? 1 : 0];
                            solver_->keep(points, at,
                                          locate_singularity(*solver_->model_->functions, SingularityKind::fold,
                                                             {&moving, 1}, at.q, at.p));
                        }
            };
            take(set.roots);
            if (!thorough) {
                failed += set.paths.failed;
            } else if (set.paths.failed > 0) {
                SolutionCounts counts;
                solver_->attempt(counts, [&](std::uint64_t seed, Generator& generator, std::uint64_t attempts) {
                    auto solved = solver_->solve_line(solver_->line(fixed_, value, generator), seed, attempts);
                    take(solved.roots);
                    return solved;
                });
                failed += counts.paths.failed;
            }
            return points;
        }

    private:
        const PlaneSolver* solver_;
        int fixed_;
        SolutionCounts counts_;
        Numbers numbers_{};
        decltype(Roots::roots) roots_;
        Points degenerate_;
    };

    /// All cusps of the plane.
    Points cusps(SolutionCounts& counts) const {
        return solve(counts, [](Numbers& numbers) { numbers.cusp = 1; }, SingularityKind::cusp, 0);
    }
    /// All points of fold curves at which x (`which` 0) or y (1) is extremal.
    Points extremal_folds(int which, SolutionCounts& counts) const {
        return solve(
            counts, [which](Numbers& numbers) { numbers.extremal[which == 0 ? 1 : 0] = 1; },
            SingularityKind::extremal_fold, which);
    }

    /// All pitchforks of symmetric branches at which that parameter is extremal on their curve.
    Points extremal_pitchforks(int which, SolutionCounts& counts) const {
        return on_branches(counts,
                           [which](SymmetricSystem::Numbers& numbers) { numbers.extremal[which == 0 ? 1 : 0] = 1; });
    }
    /// All pitchforks of symmetric branches that turn from super- to subcritical.
    Points degenerate_pitchforks(SolutionCounts& counts) const {
        return on_branches(counts, [](SymmetricSystem::Numbers& numbers) { numbers.fourth = 1; });
    }

private:
    static constexpr std::uint64_t most_attempts = 12;

    static std::size_t at(int axis) { return static_cast<std::size_t>(axis); }
    std::vector<double> scales() const { return {scales_[0], scales_[1]}; }
    double unknown(int axis, double value) const { return system_->unknown(axis, value, scales_[at(axis)]); }

    /// Of the line on which x or y has the value; and its folds, from their own start system.
    Numbers line(int fixed, double value, Generator& generator) const {
        Numbers numbers = system_->numbers(p_, scales(), generator);
        numbers.slice[at(fixed)] = 1;
        numbers.slice[2] = -unknown(fixed, value);
        return numbers;
    }
    Roots solve_line(const Numbers& numbers, std::uint64_t seed, std::uint64_t attempts) const {
        return detail::solve_equations(system_->equations(numbers), system_->sizes(), system_->grouping(),
                                       run_.with_seed(seed), resort(attempts));
    }
    MoreDigits<> resort(std::uint64_t attempts) const {
        // another start takes seconds, and decides most paths that one leaves; hundreds of paths with more digits,
        // minutes
        return attempts > model_->systems_in_double ? model_->more_digits : nullptr;
    }

    /// Start systems until one leaves no path undecided; solve(seed, generator, number of the attempt from 1) returns
    /// what it found.
    void attempt(SolutionCounts& counts, const auto& solve) const {
        PathCounts paths;
        std::uint64_t attempts = 0, regular = 0;
        while (attempts < most_attempts && (attempts == 0 || paths.failed > 0)) {
            const std::uint64_t seed = seed_of_attempt(run_.seed, attempts++);
            Generator generator(seed);
            const auto& set = solve(seed, generator, attempts);
            paths = set.paths;
            regular = 0;
            for (const auto& root : set.roots) regular += root.status == PathStatus::finite;
        }
        counts.add(paths);
        counts.solutions += regular;
        counts.attempts += attempts;
        ++counts.searches;
    }

    /// The real parameters and unknowns next to a root, if it is about real.
    std::optional<RuntimeSingularity<>> real_point(const Root<RuntimeUnknowns>& root) const {
        const double near = root.status == PathStatus::singular ? 1e-3 : 1e-5;
        auto at = singularity_at<double>(SingularityKind::undecided, system_->active(),
                                         RuntimeArray<double>(model_->unknowns()), p_);
        for (int i = 0; i < at.q.size(); ++i) {
            if (!(std::abs(root.q[i].imag()) < near)) return std::nullopt;
            at.q[i] = root.q[i].real();
        }
        if (!real_parameters(&root.q[model_->sizes().angles + system_->first_active()], near, at)) return std::nullopt;
        return at;
    }
    /// The two parameters from their unknowns; false where they are not real to within `near`.
    bool real_parameters(const std::complex<double>* unknowns, double near, RuntimeSingularity<>& point) const {
        for (int k = 0; k < 2; ++k) {
            const std::complex<double> x = unknowns[k];
            const bool squared = system_->entry().power[at(k)] == 2;
            if (!(std::abs(x.imag()) < near * (1 + std::abs(x)))) return false;
            if (squared && !(x.real() > -near)) return false;
            (k == 0 ? point.x() : point.y()) =
                system_->parameter(k, squared ? std::max(0.0, x.real()) : x.real(), scales_[at(k)]);
        }
        return true;
    }

    /// The point, and those with the other sign of a parameter that enters by even powers alone and is not `fixed`.
    Points with_signs(const RuntimeSingularity<>& at, int fixed = -1) const {
        Points y{at};
        for (const int k : {0, 1}) {
            if (k == fixed || !negative_[static_cast<std::size_t>(k)] ||
                system_->entry().power[static_cast<std::size_t>(k)] != 2)
                continue;
            for (std::size_t m = y.size(); m-- > 0;) {
                auto other = y[m];
                double& value = k == 0 ? other.x() : other.y();
                if (value == 0) continue;
                value = -value;
                y.push_back(std::move(other));
            }
        }
        return y;
    }

    bool same(const RuntimeSingularity<>& a, const RuntimeSingularity<>& b, double tolerance) const {
        if (!(std::abs(a.x() - b.x()) <= tolerance * scales_[0])) return false;
        if (!(std::abs(a.y() - b.y()) <= tolerance * scales_[1])) return false;
        return same_unknowns(model_->sizes(), a.q, b.q, tolerance);
    }
    /// Keeps the refined point if Newton's method stayed near, and it is new.
    void keep(Points& points, const RuntimeSingularity<>& near, RuntimeSingularity<> at) const {
        at.active = near.active;
        if (!at.settled() || !same(at, near, 1e-3)) return;
        for (const auto& other : points)
            if (same(other, at, 1e-8)) return;
        points.push_back(at);
    }

    /// weigh(numbers): sets the weights of the last equation. first: which parameter, x or y, is the first active one
    /// of the kind.
    Points solve(SolutionCounts& counts, const auto& weigh, SingularityKind kind, int first) const {
        const int active[] = {system_->active()[at(first)], system_->active()[at(1 - first)]};
        Points points;
        attempt(counts, [&](std::uint64_t seed, Generator& generator, std::uint64_t attempts) {
            Numbers numbers = system_->numbers(p_, scales(), generator);
            weigh(numbers);
            auto set = detail::solve_equations(system_->equations(numbers), system_->sizes(), system_->grouping(),
                                               run_.with_seed(seed), resort(attempts));
            for (const auto& root : set.roots)
                if (const auto near = real_point(root))
                    for (const auto& one : with_signs(*near))
                        keep(points, one, refine_singularity(*model_->functions, kind, active, one.q, one.p));
            return set;
        });
        return points;
    }

    Points on_branches(SolutionCounts& counts, const auto& weigh) const {
        Points points;
        const SymmetricSystem system(*system_);
        for (const auto& branch : symmetric_branches(*model_->polynomials))
            attempt(counts, [&](std::uint64_t seed, Generator& generator, std::uint64_t) {
                auto numbers = system.numbers(p_, scales(), branch, generator);
                weigh(numbers);
                auto set = detail::solve_equations(system.equations(numbers), system.sizes(), system.grouping(),
                                                   run_.with_seed(seed));
                for (const auto& root : set.roots) {
                    auto found = singularity_at<double>(SingularityKind::pitchfork, system_->active(), branch, p_);
                    if (!real_parameters(&root.q[system.first_active()], 1e-6, found)) continue;
                    for (auto& one : with_signs(found)) {
                        one.v = null_vector(jacobian(*model_->functions, branch, one.p));
                        bool known = false;
                        for (const auto& other : points) known = known || same(other, one, 1e-8);
                        if (!known) points.push_back(one);
                    }
                }
                return set;
            });
        return points;
    }

    const SearchedModel* model_;
    const CriticalSystem* system_;
    RuntimeArray<double> p_;
    RunOptions run_;
    std::array<double, 2> scales_;
    std::array<bool, 2> negative_;
};

}  // namespace equilibria
