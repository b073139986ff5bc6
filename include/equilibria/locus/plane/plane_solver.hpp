/// \file
/// All special points of a locus in a plane of two parameters: its points on lines, its cusps, and its points at which
/// a parameter is extremal, from all complex solutions of the critical system and of the symmetric branches' system.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

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

/// Solves for points of the locus of the model in the plane of its parameters number X and Y.
template <Model M, int X, int Y>
class PlaneSolver {
public:
    using System = CriticalSystem<M, X, Y>;
    using Numbers = typename System::Numbers;
    using Roots = ComplexRoots<>;
    using Points = std::vector<Singularity<M>>;
    static constexpr int n = n_unknowns<M>;

    /// scales: values of X and Y that count as large, positive: the size of the window. resort: for paths to cusps
    /// and extremal points that fail.
    PlaneSolver(const Parameters<M>& p, const RunOptions& run, const Array<double, 2>& scales = {1, 1},
                MoreDigits<> resort = nullptr)
        : p_(p), run_(run), scales_(scales), more_digits_(resort) {}

    /// The folds on lines on which the parameter number `fixed` (0 for X, 1 for Y) has the given value. One line is
    /// solved from its start system, at the value `generic`; the others follow by parameter homotopy, on as many paths
    /// as there are folds.
    class Lines {
    public:
        Lines(const PlaneSolver& solver, int fixed, double generic) : solver_(&solver), fixed_(fixed) {
            Roots set;
            solver.attempt(counts_, [&](std::uint64_t seed, Generator& generator) -> const auto& {
                numbers_ = solver.line(fixed, generic, generator);
                return set = solver.solve_line(numbers_, seed);
            });
            for (const auto& root : set.roots)
                if (root.status == PathStatus::finite && root.paths == 1) roots_.push_back(root);
        }
        const SolutionCounts& counts() const { return counts_; }

        /// `failed` is increased by the paths that failed. thorough: a line that leaves paths undecided is solved from
        /// its own start system.
        Points folds(double value, std::uint64_t& failed, bool thorough = true) const {
            Numbers there = numbers_;
            there.slice[2] = -System::unknown(fixed_, value, solver_->scales_[fixed_]);
            const auto from = System::system(numbers_), to = System::system(there);
            // gamma is a choice: where one leaves paths undecided, another may not
            Roots set;
            for (std::uint64_t k = 0; k < 4 && (k == 0 || set.paths.failed > 0); ++k)
                set = solve_from(roots_, from, to, solver_->run_.with_seed(solver_->run_.seed + k));
            Points points;
            const auto take = [&](const auto& roots) {
                for (const auto& root : roots)
                    if (const auto near = solver_->real_point(root)) {
                        auto at = *near;
                        (fixed_ == 0 ? at.x() : at.y()) = value;
                        constexpr auto fold = SingularityKind::fold;
                        solver_->keep(points, at,
                                      fixed_ == 0 ? refine_singularity<M, fold, Y>(at.q, at.p)
                                                  : refine_singularity<M, fold, X>(at.q, at.p));
                    }
            };
            take(set.roots);
            if (!thorough) {
                failed += set.paths.failed;
            } else if (set.paths.failed > 0) {
                SolutionCounts counts;
                solver_->attempt(counts, [&](std::uint64_t seed, Generator& generator) {
                    auto solved = solver_->solve_line(solver_->line(fixed_, value, generator), seed);
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
    };

    /// All cusps of the plane.
    Points cusps(SolutionCounts& counts) const
    requires PotentialModel<M>
    {
        return solve(
            counts, [](Numbers& numbers) { numbers.cusp = 1; },
            [](const Unknowns<M>& q, const Parameters<M>& p) {
                return refine_singularity<M, SingularityKind::cusp, X, Y>(q, p);
            });
    }
    /// All points of fold curves at which the parameter number `which` (0 for X, 1 for Y) is extremal.
    Points extremal_folds(int which, SolutionCounts& counts) const
    requires PotentialModel<M>
    {
        return solve(
            counts, [which](Numbers& numbers) { numbers.extremal[1 - which] = 1; },
            [which](const Unknowns<M>& q, const Parameters<M>& p) {
                constexpr auto extremal = SingularityKind::extremal_fold;
                return which == 0 ? refine_singularity<M, extremal, X, Y>(q, p)
                                  : refine_singularity<M, extremal, Y, X>(q, p);
            });
    }

    /// All pitchforks of symmetric branches at which that parameter is extremal on their curve.
    Points extremal_pitchforks(int which, SolutionCounts& counts) const
    requires PotentialModel<M>
    {
        return on_branches(counts, [which](auto& numbers) { numbers.extremal[1 - which] = 1; });
    }
    /// All pitchforks of symmetric branches that turn from super- to subcritical.
    Points degenerate_pitchforks(SolutionCounts& counts) const
    requires PotentialModel<M>
    {
        return on_branches(counts, [](auto& numbers) { numbers.fourth = 1; });
    }

private:
    static constexpr std::uint64_t most_attempts = 12;

    /// Of the line on which the parameter number `fixed` has the value; and its folds, from their own start system.
    Numbers line(int fixed, double value, Generator& generator) const {
        Numbers numbers = System::numbers(p_, scales_, generator);
        numbers.slice[fixed] = 1;
        numbers.slice[2] = -System::unknown(fixed, value, scales_[fixed]);
        return numbers;
    }
    Roots solve_line(const Numbers& numbers, std::uint64_t seed) const {
        return solve_multihomogeneous(System::system(numbers), System::grouping, run_.with_seed(seed));
    }

    /// Start systems until one leaves no path undecided; solve(seed, generator) returns what it found.
    void attempt(SolutionCounts& counts, const auto& solve) const {
        PathCounts paths;
        std::uint64_t attempts = 0, regular = 0;
        while (attempts < most_attempts && (attempts == 0 || paths.failed > 0)) {
            const std::uint64_t seed = seed_of_attempt(run_.seed, attempts++);
            Generator generator(seed);
            const auto& set = solve(seed, generator);
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
    std::optional<Singularity<M>> real_point(const auto& root) const {
        const double near = root.status == PathStatus::singular ? 1e-3 : 1e-5;
        auto at = singularity_at<M, X, Y>(SingularityKind::undecided, {}, p_);
        for (int i = 0; i < n; ++i) {
            if (!(std::abs(root.q[i].imag()) < near)) return std::nullopt;
            at.q[i] = root.q[i].real();
        }
        if (!real_parameters(&root.q[System::n_angles + System::first_active], near, at)) return std::nullopt;
        return at;
    }
    /// The two parameters from their unknowns; false where they are not real to within `near`.
    bool real_parameters(const std::complex<double>* unknowns, double near, Singularity<M>& at) const {
        for (int k = 0; k < 2; ++k) {
            const std::complex<double> x = unknowns[k];
            if (!(std::abs(x.imag()) < near * (1 + std::abs(x)))) return false;
            if (System::entry().power[k] == 2 && !(x.real() > -near)) return false;
            (k == 0 ? at.x() : at.y()) =
                System::parameter(k, System::entry().power[k] == 2 ? std::max(0.0, x.real()) : x.real(), scales_[k]);
        }
        return true;
    }

    bool same(const Singularity<M>& a, const Singularity<M>& b, double tolerance) const {
        if (!(std::abs(a.x() - b.x()) <= tolerance * scales_[0])) return false;
        if (!(std::abs(a.y() - b.y()) <= tolerance * scales_[1])) return false;
        return same_unknowns<M>(a.q, b.q, tolerance);
    }
    /// Keeps the refined point if Newton's method stayed near, and it is new.
    void keep(Points& points, const Singularity<M>& near, Singularity<M> at) const {
        at.active = near.active;
        if (!at.converged || !same(at, near, 1e-3)) return;
        for (const auto& other : points)
            if (same(other, at, 1e-8)) return;
        points.push_back(at);
    }

    /// weigh(numbers): sets the weights of the last equation.
    Points solve(SolutionCounts& counts, const auto& weigh, const auto& refine) const {
        Points points;
        attempt(counts, [&](std::uint64_t seed, Generator& generator) {
            Numbers numbers = System::numbers(p_, scales_, generator);
            weigh(numbers);
            auto set = solve_multihomogeneous(System::system(numbers), System::grouping, run_.with_seed(seed), {},
                                              more_digits_);
            for (const auto& root : set.roots)
                if (const auto at = real_point(root)) keep(points, *at, refine(at->q, at->p));
            return set;
        });
        return points;
    }

    Points on_branches(SolutionCounts& counts, const auto& weigh) const {
        Points points;
        if constexpr (Formulation<M>::reflection_symmetric) {
            using Branch = SymmetricSystem<M, X, Y>;
            for (const Unknowns<M>& branch : symmetric_branches<M>())
                attempt(counts, [&](std::uint64_t seed, Generator& generator) {
                    auto numbers = Branch::numbers(p_, scales_, branch, generator);
                    weigh(numbers);
                    auto set = solve_multihomogeneous(Branch::system(numbers), Branch::grouping, run_.with_seed(seed));
                    for (const auto& root : set.roots) {
                        auto at = singularity_at<M, X, Y>(SingularityKind::pitchfork, branch, p_);
                        if (!real_parameters(&root.q[Branch::first_active], 1e-6, at)) continue;
                        at.v = null_vector<M>(jacobian<M, double>(branch, at.p));
                        bool known = false;
                        for (const auto& other : points) known = known || same(other, at, 1e-8);
                        if (!known) points.push_back(at);
                    }
                    return set;
                });
        }
        return points;
    }

    Parameters<M> p_;
    RunOptions run_;
    Array<double, 2> scales_;
    MoreDigits<> more_digits_;
};

}  // namespace equilibria
