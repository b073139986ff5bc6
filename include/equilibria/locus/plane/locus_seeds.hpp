/// \file
/// The points that the curves of a locus must pass: on lines, cusps, and points at which a parameter is extremal.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <equilibria/core/dense_solvers.hpp>
#include <equilibria/core/eigen_copies.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/locus/plane/plane_problems.hpp>
#include <equilibria/locus/plane/plane_solver.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/reduced_coefficients.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_newton.hpp>
#include <equilibria/system/symmetric_branches.hpp>

namespace equilibria {

namespace detail {

/// A point that some curve must pass: a fold or pitchfork on a line, on which the parameter number `fixed` has the
/// value `line`, or a special point of the plane.
struct LocusSeed {
    RuntimeSingularity<> at;
    int fixed = -1;  ///< of points on lines; else -1
    double line = 0;
    bool traced = false;

    SingularityKind curve() const { return curve_of(at.kind); }
};

/// All such points of a window, and what they have to do with the curves that were traced.
class LocusSeeds {
public:
    /// The model and the plane's system have to outlive it. inner_lines: in each direction, beside the borders.
    LocusSeeds(const SearchedModel& model, const CriticalSystem& system, const RuntimeArray<double>& p,
               const Window& window, int inner_lines, const RunOptions& run)
        : model_(&model), system_(&system), parameters_(p), window_(window), inner_lines_(inner_lines), seed_(run.seed),
          solver_(model, system, p, run,
                  {std::max(std::abs(window.x.low), std::abs(window.x.high)),
                   std::max(std::abs(window.y.low), std::abs(window.y.high))},
                  {window.x.low < 0, window.y.low < 0}) {}

    void solve(LocusEvidence& evidence) {
        solve_lines(1, evidence);
        solve_lines(0, evidence);
        solve_points(evidence);
        evidence.seeds = seeds_.size();
    }

    std::vector<LocusSeed>& all() { return seeds_; }
    /// The values of the lines on which x (axis 0) or y (axis 1) is fixed.
    const std::vector<double>& lines(int axis) const { return lines_[static_cast<std::size_t>(axis)]; }

    /// The same event, or its mirror image; angles modulo 2 pi, null vectors up to sign.
    bool same(const RuntimeSingularity<>& a, const RuntimeSingularity<>& b) const {
        constexpr double tolerance = 1e-5;
        if (std::abs(a.x() - b.x()) > tolerance * window_.width()) return false;
        if (std::abs(a.y() - b.y()) > tolerance * window_.height()) return false;
        if (!(std::abs(std::abs(dot(a.v, b.v)) - 1) < 100 * tolerance)) return false;
        const RuntimeSizes& sizes = model_->sizes();
        return same_unknowns(sizes, a.q, b.q, 100 * tolerance) ||
               (model_->reflection_symmetric() && same_unknowns(sizes, a.q, mirrored(sizes, b.q), 100 * tolerance));
    }

    /// Where a parameter by which equations were divided is 0, one of them vanishes identically, as that of a massless
    /// link does: all its solutions are degenerate, and none is an event.
    bool is_family(double x, double y) const {
        for (const auto& content : system_->entry().content)
            for (std::size_t k = 0; k < 2; ++k)
                if (content[k] > 0 && std::abs(k == 0 ? x : y) <= 1e-9 * (k == 0 ? window_.width() : window_.height()))
                    return true;
        return false;
    }

    /// Every point solved for is on a curve, and every special point of a curve was solved for.
    void compare(Locus<RuntimeUnknowns>& locus) {
        if (!model_->has_potential()) return;
        for (const auto& at : locus.points) {
            bool known = false;
            for (LocusSeed& seed : seeds_)
                if (seed.at.kind == at.kind && seed.at.extremal == at.extremal && same(seed.at, at))
                    known = seed.traced = true;
            if (!known) locus.evidence.add(LocusFaultKind::unsolved_point, {at.x(), at.y()});
        }
    }

private:
    /// True of a point of the window, or one that only rounding puts beyond its border.
    bool is_inside(double x, double y) const {
        const auto inside = [](const Interval& range, double value) {
            const double rounding = 1e-14 * range.width();
            return value >= range.low - rounding && value <= range.high + rounding;
        };
        return inside(window_.x, x) && inside(window_.y, y);
    }
    void add_seed(const LocusSeed& seed) {
        if (!is_inside(seed.at.x(), seed.at.y()) || is_family(seed.at.x(), seed.at.y())) return;
        if (seed.fixed < 0 && is_continuum(seed.at)) return;
        for (const LocusSeed& other : seeds_)  // the mirror image
            if (other.at.kind == seed.at.kind && other.at.extremal == seed.at.extremal && other.fixed == seed.fixed &&
                other.line == seed.line && same(other.at, seed.at))
                return;
        seeds_.push_back(seed);
    }
    /// Special points of the plane; extremal: the number of the parameter that turns back there, or -1.
    void add_points(std::vector<RuntimeSingularity<>> points, SingularityKind kind, int extremal = -1) {
        for (auto& at : points) {
            at.kind = kind;
            at.extremal = extremal;
            add_seed({at});
        }
    }

    /// Lines on which x (axis 0) or y (axis 1) is fixed.
    void solve_lines(int axis, LocusEvidence& evidence) {
        const Interval &range = axis == 0 ? window_.x : window_.y, &moving = axis == 0 ? window_.y : window_.x;
        const double low = range.low, size = range.high - range.low;
        const std::size_t own = static_cast<std::size_t>(axis), other = 1 - own;
        const int fixed = system_->active()[own], degree = system_->entry().degree[other];
        Generator generator(seed_);
        const PlaneSolver::Lines lines(solver_, axis, low + size * uniform(generator));
        evidence.solved[SingularityKind::fold].add(lines.counts());
        // pitchforks of symmetric branches are solved for by themselves
        const auto branches = symmetric_branches(*model_->polynomials);
        for (auto at : lines.degenerate()) {
            if (!is_inside(at.x(), at.y()) || is_family(at.x(), at.y())) continue;
            if (std::any_of(branches.begin(), branches.end(),
                            [&](const auto& branch) { return same_unknowns(model_->sizes(), branch, at.q, 1e-2); }))
                continue;
            at.v = null_vector(jacobian(*model_->functions, at.q, at.p));
            if (!is_continuum(at)) evidence.add(LocusFaultKind::degenerate_line, {at.x(), at.y()});
        }
        const auto add = [&](double line, const std::vector<RuntimeSingularity<>>& folds) {
            for (auto at : folds) {
                at.kind = SingularityKind::fold;
                add_seed({at, fixed, line});
            }
            for (const auto& at : pitchforks(axis, line, degree, moving)) add_seed({at, fixed, line});
            lines_[own].push_back(line);
            ++evidence.lines;
        };
        // the borders, moved in: the model may degenerate on them, and near to them may leave paths undecided, most of
        // all near 0 of a parameter that enters by its square
        const bool squared = system_->entry().power[own] == 2;
        for (const bool upper : {false, true})
            for (const double inset : {1e-6, 1e-4, 1e-2}) {
                if (squared && !upper && low == 0 && inset < 1e-2) continue;
                const double line = low + size * (upper ? 1 - inset : inset);
                std::uint64_t failed = 0;
                const bool last = inset == 1e-2;
                const auto folds = lines.folds(line, failed, last);
                if (failed > 0 && !last) continue;
                evidence.failed_paths += failed;
                double& widest = evidence.inset[own];
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

    /// The pitchforks of symmetric branches on such a line.
    std::vector<RuntimeSingularity<>> pitchforks(int axis, double line, int degree, const Interval& moving) const {
        std::vector<RuntimeSingularity<>> found;
        const int fixed = system_->active()[static_cast<std::size_t>(axis)];
        const int active = system_->active()[static_cast<std::size_t>(1 - axis)];
        const int x = system_->active()[0], y = system_->active()[1];
        RuntimeArray<double> p = parameters_;
        p[fixed] = line;
        for (const auto& branch : symmetric_branches(*model_->polynomials)) {
            const auto determinant = [&](double value) {
                p[active] = value;
                const PlaneProblems problems{model_->functions, system_, p};
                return equilibria::detail::determinant(problems(p[y]).tangent(eigen_vector(branch), p[x]));
            };
            for (const double value :
                 polynomial_roots(determinant, model_->unknowns() * degree, moving.low, moving.high)) {
                p[active] = value;
                const auto v = null_vector(jacobian(*model_->functions, branch, p));
                found.push_back(singularity_at<double>(SingularityKind::pitchfork, system_->active(), branch, p, v));
            }
        }
        return found;
    }

    /// Crossings of curves with the line on which a parameter is 0 that enters by even powers alone: the other
    /// parameter turns back there, since the curve is its own mirror image.
    void solve_mirror_lines(LocusEvidence& evidence) {
        for (const int axis : {0, 1}) {
            const auto own = static_cast<std::size_t>(axis), other = 1 - own;
            const Interval &range = axis == 0 ? window_.x : window_.y, &moving = axis == 0 ? window_.y : window_.x;
            if (system_->entry().power[own] != 2 || !(range.low < 0 && range.high > 0)) continue;
            Generator generator(seed_);
            const PlaneSolver::Lines lines(solver_, axis, range.high * uniform(generator));
            std::uint64_t failed = 0;
            const int turning = system_->active()[other];
            add_points(lines.folds(0, failed), SingularityKind::extremal_fold, turning);
            evidence.failed_paths += failed;
            if (model_->reflection_symmetric())
                add_points(pitchforks(axis, 0, system_->entry().degree[other], moving),
                           SingularityKind::extremal_pitchfork, turning);
        }
    }

    void solve_points(LocusEvidence& evidence) {
        if (!model_->has_potential()) return;
        using Kind = SingularityKind;
        auto& solved = evidence.solved;
        const auto parameter = [&](int which) { return system_->active()[static_cast<std::size_t>(which)]; };
        add_points(solver_.cusps(solved[Kind::cusp]), Kind::cusp);
        for (const int which : {0, 1})
            add_points(solver_.extremal_folds(which, solved[Kind::extremal_fold]), Kind::extremal_fold,
                       parameter(which));
        solve_mirror_lines(evidence);
        if (!model_->reflection_symmetric()) return;
        for (const int which : {0, 1})
            add_points(solver_.extremal_pitchforks(which, solved[Kind::extremal_pitchfork]), Kind::extremal_pitchfork,
                       parameter(which));
        add_points(solver_.degenerate_pitchforks(solved[Kind::tricritical_pitchfork]), Kind::tricritical_pitchfork);
    }

    /// Whether the reduced potential vanishes to fourth order, by what it is elsewhere in the window: a curve of
    /// equilibria at one point of the plane. No curve of the locus is traced from it.
    bool is_continuum(const RuntimeSingularity<>& at) const {
        double size = 0;
        for (const double part : {0.21, 0.74}) {
            RuntimeArray<double> p = at.p;
            p[system_->active()[0]] = window_.x.low + part * window_.width();
            p[system_->active()[1]] = window_.y.low + (1 - 0.6 * part) * window_.height();
            size = std::max(size, eigen_matrix(jacobian(*model_->functions, at.q, p)).cwiseAbs().maxCoeff());
        }
        const auto reduced = reduced_coefficients(*model_->functions, at.q, at.v, at.p);
        return std::abs(reduced.third) < 1e-9 * size && !(std::abs(reduced.fourth) > 1e-9 * size);
    }

    const SearchedModel* model_;
    const CriticalSystem* system_;
    RuntimeArray<double> parameters_;
    Window window_;
    int inner_lines_;
    std::uint64_t seed_;
    PlaneSolver solver_;
    std::array<std::vector<double>, 2> lines_;  ///< values of x, and of y
    std::vector<LocusSeed> seeds_;
};

}  // namespace detail

}  // namespace equilibria
