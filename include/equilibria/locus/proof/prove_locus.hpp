/// \file
/// What certificates say of a locus: Krawczyk's test on the critical systems at the points of its curves, its cusps and
/// its extremal points, and proofs of the enumerations of its regions.
///
/// A point that passes is a degenerate equilibrium of the model at exactly these doubles: one, and only one, is within
/// the radius given, on the line through the point across its curve; of special points it is one of their kind, and
/// regular, so that a cusp has an unfolding and a fourth derivative that do not vanish. That no curve is missing is not
/// what is proved here (see Locus::argument).
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <ostream>
#include <vector>

#include <Eigen/Core>
#include <Eigen/QR>

#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/system/critical_system.hpp>
#include <equilibria/system/symmetric_system.hpp>

namespace equilibria {

/// How many of some points are proved.
struct ProvedShare {
    std::uint64_t proved = 0, of = 0;
    friend std::ostream& operator<<(std::ostream& out, const ProvedShare& s) {
        return out << s.proved << " of " << s.of;
    }
};

struct LocusProof {
    /// Points of curves that are not listed as special ones.
    ProvedShare folds, pitchforks;
    ProvedShare cusps, extremal, degenerate_pitchforks;
    ProvedShare regions;        ///< whose table is proved at their point
    double largest_radius = 0;  ///< of the parameters of a proved point, in parts of the window
    double seconds = 0;

    friend std::ostream& operator<<(std::ostream& out, const LocusProof& p) {
        return out << p.folds << " points of fold curves, " << p.pitchforks << " of pitchfork curves, " << p.cusps
                   << " cusps, " << p.extremal << " extremal points, " << p.degenerate_pitchforks
                   << " degenerate pitchforks and the equilibria of " << p.regions << " regions, by index";
    }
};

namespace detail {

template <PotentialModel M, int X, int Y>
class LocusProver {
public:
    static constexpr int n = n_unknowns<M>;

    LocusProver(const Locus<M>& locus, const RunOptions& run) : locus_(&locus), run_(run) {
        const Window& w = locus.window;
        scales_ = {std::max(std::abs(w.x.low), std::abs(w.x.high)), std::max(std::abs(w.y.low), std::abs(w.y.high))};
    }

    LocusProof run() {
        for (const auto& curve : locus_->curves)
            for (std::size_t k = 0; k < curve.points.size(); ++k)
                if (!special(curve.points[k]))
                    add(curve.kind, curve.points[k], across(curve, k),
                        curve.kind == SingularityKind::fold ? &proof_.folds : &proof_.pitchforks);
        for (const auto& at : locus_->points) {
            if (at.extremal >= 0)
                add(curve_of(at.kind), at, {.extremal = {at.extremal == Y ? 1.0 : 0.0, at.extremal == X ? 1.0 : 0.0}},
                    &proof_.extremal);
            else if (at.kind == SingularityKind::cusp)
                add(SingularityKind::fold, at, {.third = 1}, &proof_.cusps);
            else
                add(SingularityKind::pitchfork, at, {.third = 1}, &proof_.degenerate_pitchforks);
        }
        std::vector<double> radii(tasks_.size(), -1);
        run_.executor.for_blocks(tasks_.size(), 8, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) radii[k] = radius(tasks_[k]);
        });
        for (std::size_t k = 0; k < tasks_.size(); ++k) {
            ++tasks_[k].share->of;
            if (!(radii[k] >= 0)) continue;
            ++tasks_[k].share->proved;
            proof_.largest_radius = std::max(proof_.largest_radius, radii[k]);
        }
        for (const LocusRegion& region : locus_->regions) {
            const auto proof =
                prove(enumerate<M>(with_active<X, Y>(locus_->parameters, region.point.x, region.point.y), run_));
            ++proof_.regions.of;
            proof_.regions.proved += proof.complete && proof.by_index == region.by_index;
        }
        return proof_;
    }

private:
    /// The weights of the last equation of the systems; third: of the derivative whose vanishing makes the point
    /// degenerate.
    struct Last {
        Array<double, 2> slice{}, extremal{};
        double third = 0;
    };
    struct Task {
        SingularityKind kind;  ///< fold or pitchfork: whose system it is
        const Singularity<M>* at;
        Last last;
        ProvedShare* share;
    };
    using Folds = CriticalSystem<M, X, Y>;
    using Pitchforks = SymmetricSystem<M, X, Y>;

    void add(SingularityKind kind, const Singularity<M>& at, const Last& last, ProvedShare* share) {
        tasks_.push_back({kind, &at, last, share});
    }
    bool special(const Singularity<M>& at) const {
        return std::ranges::any_of(locus_->points, [&](const auto& other) { return other.p == at.p; });
    }
    Array<double, 2> unknowns(const Singularity<M>& at) const {
        return {Folds::unknown(0, at.x(), scales_[0]), Folds::unknown(1, at.y(), scales_[1])};
    }
    /// A slice normal to the curve at its point number k.
    Last across(const LocusCurve<M>& curve, std::size_t k) const {
        const auto a = unknowns(curve.points[k > 0 ? k - 1 : k]);
        const auto b = unknowns(curve.points[std::min(k + 1, curve.points.size() - 1)]);
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        return {.slice = {(b[0] - a[0]) / length, (b[1] - a[1]) / length}};
    }

    /// The radius within which the parameters are proved, in parts of the window; negative where nothing is.
    double radius(const Task& task) const {
        if (task.kind == SingularityKind::fold) return fold_radius(task);
        if constexpr (Formulation<M>::reflection_symmetric) return pitchfork_radius(task);
        return -1;
    }
    double fold_radius(const Task& task) const {
        const Unknowns<M>& q = task.at->q;
        Generator generator(1);
        auto numbers = Folds::numbers(task.at->p, scales_, generator);
        numbers.basis = basis(task);
        weigh(task, numbers);
        numbers.cusp = task.last.third;
        Array<std::complex<double>, n_unknowns<Folds>> place{};
        for (int u = 0; u < n; ++u) place[u] = q[u];
        Point<Folds, double> at = point_of<Folds>(place);
        if constexpr (Folds::off_symmetric_branches) {
            double sum = 0;
            for (int i = 0; i < n_angles<M>; ++i) {
                numbers.sine[i] = std::sin(q[i]);
                sum += std::sin(q[i]) * std::sin(q[i]);
            }
            at.x[Folds::reciprocal] = 1 / sum;
        }
        return proved_radius<Folds>(numbers, at, task);
    }
    double pitchfork_radius(const Task& task) const {
        Generator generator(1);
        auto numbers = Pitchforks::numbers(task.at->p, scales_, task.at->q, generator);
        numbers.plane.basis = basis(task);
        weigh(task, numbers);
        numbers.fourth = task.last.third;
        Point<Pitchforks, double> at;
        for (auto& x : at.x) x = 0.0;
        return proved_radius<Pitchforks>(numbers, at, task);
    }

    /// The basis that has v for its first vector: w = 0.
    static Array<Array<double, n>, n> basis(const Task& task) {
        const Eigen::Map<const Eigen::Matrix<double, n, 1>> v(&task.at->v[0]);
        const Eigen::Matrix<double, n, n> b = Eigen::HouseholderQR<Eigen::Matrix<double, n, 1>>(v).householderQ();
        Array<Array<double, n>, n> y;
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < n; ++k) y[i][k] = k == 0 ? v(i) : b(i, k);
        return y;
    }
    /// Sets the weights of the last equation.
    void weigh(const Task& task, auto& numbers) const {
        const auto x = unknowns(*task.at);
        for (int k = 0; k < 2; ++k) {
            numbers.slice[k] = task.last.slice[k];
            numbers.extremal[k] = task.last.extremal[k];
        }
        numbers.slice[2] = -(task.last.slice[0] * x[0] + task.last.slice[1] * x[1]);
    }

    /// Of the root next to `at`, whose parameters are those of the task.
    template <class System>
    double proved_radius(const typename System::Numbers& numbers, Point<System, double> at, const Task& task) const {
        const auto place = unknowns(*task.at);
        for (int k = 0; k < 2; ++k) at.x[System::first_active + k] = place[k];
        const BallSystem<double> system(ExactSystem<System>(System::template equations<ExactBall>(numbers)));
        const auto proof = krawczyk<System, double>(system, at, true);
        if (!proof.proved) return -1;
        double largest = 0;
        for (int k = 0; k < 2; ++k) {
            const double x = place[k], r = proof.radius[n_angles<System> + System::first_active + k];
            if (Folds::entry().power[k] == 2 && !(x > 2 * r)) return -1;  // the parameter itself might not be real
            const double size = k == 0 ? locus_->window.width() : locus_->window.height();
            for (const double end : {x - r, x + r})
                largest = std::max(
                    largest,
                    std::abs(Folds::parameter(k, end, scales_[k]) - Folds::parameter(k, x, scales_[k])) / size);
        }
        return largest;
    }
    const Locus<M>* locus_;
    RunOptions run_;
    Array<double, 2> scales_;
    LocusProof proof_;
    std::vector<Task> tasks_;
};

}  // namespace detail

/// Proves what can be proved of a locus of the plane of the parameters number X and Y. What is not proved is missing in
/// the shares, no more. Throws InvalidArgument for a run with a checkpoint or a cancel. Source: krawczyk.hpp.
template <PotentialModel M, int X, int Y>
LocusProof prove_locus(const Locus<M>& locus, const RunOptions& run = {}) {
    run.require_whole("a proof");
    const detail::Stopwatch begin;
    LocusProof proof = detail::LocusProver<M, X, Y>(locus, run).run();
    proof.seconds = begin.seconds();
    return proof;
}

}  // namespace equilibria
