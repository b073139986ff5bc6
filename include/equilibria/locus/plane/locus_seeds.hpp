/// \file
/// The points that the curves of a locus must pass: on lines, cusps, and points at which a parameter is extremal.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include <equilibria/core/dense_solvers.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/locus/plane/plane_problems.hpp>
#include <equilibria/locus/plane/plane_solver.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_newton.hpp>
#include <equilibria/system/symmetric_branches.hpp>

namespace equilibria {

namespace detail {

/// A point that some curve must pass: a fold or pitchfork on a line, on which the parameter number `fixed` has the
/// value `line`, or a special point of the plane.
template <Model M>
struct LocusSeed {
    Singularity<M> at;
    int fixed = -1;  ///< of points on lines; else -1
    double line = 0;
    bool traced = false;

    SingularityKind curve() const { return curve_of(at.kind); }
};

/// All such points of a window, and what they have to do with the curves that were traced.
template <Model M, int X, int Y>
class LocusSeeds {
public:
    static constexpr int n = n_unknowns<M>;
    static constexpr bool reflection_symmetric = Formulation<M>::reflection_symmetric;
    using Evidence = typename Locus<M>::Evidence;

    /// inner_lines: in each direction, beside the borders.
    LocusSeeds(const Parameters<M>& p, const Window& window, int inner_lines, const RunOptions& run,
               MoreDigits<> resort)
        : parameters_(p), window_(window), inner_lines_(inner_lines), seed_(run.seed),
          solver_(p, run,
                  {std::max(std::abs(window.x.low), std::abs(window.x.high)),
                   std::max(std::abs(window.y.low), std::abs(window.y.high))},
                  resort) {}

    void solve(Evidence& evidence) {
        solve_lines<X, Y>(evidence);
        solve_lines<Y, X>(evidence);
        solve_points(evidence);
        evidence.seeds = seeds_.size();
    }

    std::vector<LocusSeed<M>>& all() { return seeds_; }
    /// The values of the lines on which x (axis 0) or y (axis 1) is fixed.
    const std::vector<double>& lines(int axis) const { return lines_[static_cast<std::size_t>(axis)]; }

    /// The same event, or its mirror image; angles modulo 2 pi, null vectors up to sign.
    bool same(const Singularity<M>& a, const Singularity<M>& b) const {
        constexpr double tolerance = 1e-5;
        if (std::abs(a.x() - b.x()) > tolerance * window_.width()) return false;
        if (std::abs(a.y() - b.y()) > tolerance * window_.height()) return false;
        if (!(std::abs(std::abs(dot(a.v, b.v)) - 1) < 100 * tolerance)) return false;
        return same_unknowns<M>(a.q, b.q, 100 * tolerance) ||
               (reflection_symmetric && same_unknowns<M>(a.q, mirrored<M>(b.q), 100 * tolerance));
    }

    /// Every point solved for is on a curve, and every special point of a curve was solved for.
    void compare(Locus<M>& locus) {
        if constexpr (PotentialModel<M>) {
            for (const Singularity<M>& at : locus.points) {
                bool known = false;
                for (LocusSeed<M>& seed : seeds_)
                    if (seed.at.kind == at.kind && seed.at.extremal == at.extremal && same(seed.at, at))
                        known = seed.traced = true;
                locus.evidence.unsolved_points += !known;
            }
        }
    }

private:
    using Solver = PlaneSolver<M, X, Y>;
    using Problems = PlaneProblems<M, X, Y>;

    void add_seed(const LocusSeed<M>& seed) {
        if (!window_.contains(seed.at.x(), seed.at.y()) || is_family(seed.at)) return;
        for (const LocusSeed<M>& other : seeds_)  // the mirror image
            if (other.at.kind == seed.at.kind && other.at.extremal == seed.at.extremal && other.fixed == seed.fixed &&
                other.line == seed.line && same(other.at, seed.at))
                return;
        seeds_.push_back(seed);
    }
    /// Special points of the plane; extremal: the number of the parameter that turns back there, or -1.
    void add_points(std::vector<Singularity<M>> points, SingularityKind kind, int extremal = -1) {
        for (Singularity<M>& at : points) {
            at.kind = kind;
            at.extremal = extremal;
            add_seed({at});
        }
    }

    template <int Active, int Fixed>
    void solve_lines(Evidence& evidence) {
        const double low = Fixed == X ? window_.x.low : window_.y.low;
        const double size = Fixed == X ? window_.width() : window_.height();
        const double active_low = Active == X ? window_.x.low : window_.y.low;
        const double active_high = Active == X ? window_.x.high : window_.y.high;
        const int degree = Solver::System::entry().degree[Active == X ? 0 : 1];
        Generator generator(seed_);
        const typename Solver::Lines lines(solver_, Fixed == X ? 0 : 1, low + size * uniform(generator));
        evidence.solved[SingularityKind::fold].add(lines.counts());
        const auto add = [&](double line, const std::vector<Singularity<M>>& folds) {
            for (Singularity<M> at : folds) {
                at.kind = SingularityKind::fold;
                add_seed({at, Fixed, line});
            }
            Parameters<M> p = parameters_;
            p[Fixed] = line;
            for (const Unknowns<M>& branch : symmetric_branches<M>()) {
                const auto determinant = [&](double value) {
                    p[Active] = value;
                    return equilibria::detail::determinant(
                        Problems{p}(p[Y]).tangent(PlaneProblem<M, X, Y>::vector(branch), p[X]));
                };
                for (const double value : polynomial_roots(determinant, n * degree, active_low, active_high)) {
                    p[Active] = value;
                    const auto v = null_vector<M>(jacobian<M, double>(branch, p));
                    add_seed({singularity_at<M, X, Y>(SingularityKind::pitchfork, branch, p, v), Fixed, line});
                }
            }
            lines_[Fixed == X ? 0 : 1].push_back(line);
            ++evidence.lines;
        };
        // the borders, moved in: the model may degenerate on them, and near to them may leave paths undecided, most of
        // all near 0 of a parameter that enters by its square
        const bool squared = Solver::System::entry().power[Fixed == X ? 0 : 1] == 2;
        for (const bool upper : {false, true})
            for (const double inset : {1e-6, 1e-4, 1e-2}) {
                if (squared && !upper && low == 0 && inset < 1e-2) continue;
                const double line = low + size * (upper ? 1 - inset : inset);
                std::uint64_t failed = 0;
                const bool last = inset == 1e-2;
                const auto folds = lines.folds(line, failed, last);
                if (failed > 0 && !last) continue;
                evidence.failed_paths += failed;
                double& widest = evidence.inset[Fixed == X ? 0 : 1];
                widest = std::max(widest, inset);
                add(line, folds);
                break;
            }
        // off the centre of the cells, where special values (alpha = 1/2) would sit
        for (int k = 0; k < inner_lines_; ++k) {
            const double line = low + size * (k + 0.4713) / inner_lines_;
            add(line, lines.folds(line, evidence.failed_paths));
        }
    }

    void solve_points(Evidence& evidence) {
        if constexpr (PotentialModel<M>) {
            using Kind = SingularityKind;
            auto& solved = evidence.solved;
            add_points(solver_.cusps(solved[Kind::cusp]), Kind::cusp);
            for (const int which : {0, 1})
                add_points(solver_.extremal_folds(which, solved[Kind::extremal_fold]), Kind::extremal_fold,
                           which == 0 ? X : Y);
            if constexpr (reflection_symmetric) {
                for (const int which : {0, 1})
                    add_points(solver_.extremal_pitchforks(which, solved[Kind::extremal_pitchfork]),
                               Kind::extremal_pitchfork, which == 0 ? X : Y);
                add_points(solver_.degenerate_pitchforks(solved[Kind::tricritical_pitchfork]),
                           Kind::tricritical_pitchfork);
            }
        }
    }

    /// Where a parameter by which equations were divided is 0, one of them vanishes identically, as that of a massless
    /// link does: all its solutions are degenerate, and none is an event.
    bool is_family(const Singularity<M>& at) const {
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < 2; ++k)
                if (Solver::System::entry().content[i][k] > 0 &&
                    std::abs(k == 0 ? at.x() : at.y()) <= 1e-9 * (k == 0 ? window_.width() : window_.height()))
                    return true;
        return false;
    }

    Parameters<M> parameters_;
    Window window_;
    int inner_lines_;
    std::uint64_t seed_;
    Solver solver_;
    std::array<std::vector<double>, 2> lines_;  ///< values of x, and of y
    std::vector<LocusSeed<M>> seeds_;
};

}  // namespace detail

}  // namespace equilibria
