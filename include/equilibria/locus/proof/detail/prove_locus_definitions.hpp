/// \file
/// See locus/proof/prove_locus.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/QR>

#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/core/eigen_copies.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/locus/proof/prove_locus.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/system/symmetric_system.hpp>

namespace equilibria::detail {

class LocusProver {
public:
    /// Everything has to outlive it. exact: see prove_locus.
    LocusProver(const Locus<RuntimeUnknowns>& locus, const CriticalSystem& folds, const ExactPolynomials& exact,
                const ProveTable& prove_table, const RunOptions& run)
        : locus_(&locus), folds_(&folds), pitchforks_(folds), prove_table_(&prove_table), run_(run) {
        const Window& w = locus.window;
        scales_ = {std::max(std::abs(w.x.low), std::abs(w.x.high)), std::max(std::abs(w.y.low), std::abs(w.y.high))};
        const double scales[] = {scales_[0], scales_[1]};
        exact_ = exact(scales, folds.first_active());
    }

    LocusProof run() {
        for (const auto& curve : locus_->curves)
            for (std::size_t k = 0; k < curve.points.size(); ++k)
                if (!special(curve.points[k]))
                    add(curve.kind, curve.points[k], across(curve, k),
                        curve.kind == SingularityKind::fold ? &proof_.folds : &proof_.pitchforks);
        for (const auto& at : locus_->points) {
            if (at.extremal >= 0)
                add(curve_of(at.kind), at,
                    {.extremal = {at.extremal == folds_->active()[1] ? 1.0 : 0.0,
                                  at.extremal == folds_->active()[0] ? 1.0 : 0.0}},
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
            ++proof_.regions.of;
            proof_.regions.proved += (*prove_table_)(region);
        }
        return proof_;
    }

private:
    /// The weights of the last equation of the systems; third: of the derivative whose vanishing makes the point
    /// degenerate.
    struct Last {
        std::array<double, 2> slice{}, extremal{};
        double third = 0;
    };
    struct Task {
        SingularityKind kind;  ///< fold or pitchfork: whose system it is
        const RuntimeSingularity<>* at;
        Last last;
        ProvedShare* share;
    };

    void add(SingularityKind kind, const RuntimeSingularity<>& at, const Last& last, ProvedShare* share) {
        tasks_.push_back({kind, &at, last, share});
    }
    bool special(const RuntimeSingularity<>& at) const {
        return std::ranges::any_of(locus_->points, [&](const auto& other) { return other.p == at.p; });
    }
    std::array<double, 2> unknowns(const RuntimeSingularity<>& at) const {
        return {folds_->unknown(0, at.x(), scales_[0]), folds_->unknown(1, at.y(), scales_[1])};
    }
    /// A slice normal to the curve at its point number k.
    Last across(const LocusCurve<RuntimeUnknowns>& curve, std::size_t k) const {
        const auto a = unknowns(curve.points[k > 0 ? k - 1 : k]);
        const auto b = unknowns(curve.points[std::min(k + 1, curve.points.size() - 1)]);
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        return {.slice = {(b[0] - a[0]) / length, (b[1] - a[1]) / length}};
    }

    /// The radius within which the parameters are proved, in parts of the window; negative where nothing is.
    double radius(const Task& task) const {
        if (task.kind == SingularityKind::fold) return fold_radius(task);
        if (folds_->model().reflection_symmetric()) return pitchfork_radius(task);
        return -1;
    }
    double fold_radius(const Task& task) const {
        const RuntimeArray<double>& q = task.at->q;
        Generator generator(1);
        auto numbers = folds_->numbers(task.at->p, {scales_[0], scales_[1]}, generator);
        numbers.basis = basis(task);
        weigh(task, numbers);
        numbers.cusp = task.last.third;
        RuntimeArray<std::complex<double>> place(folds_->sizes().unknowns);
        for (int u = 0; u < q.size(); ++u) place[u] = q[u];
        auto at = point_of<RuntimeUnknowns>(place, folds_->sizes());
        if (folds_->off_symmetric_branches()) {
            double sum = 0;
            for (int i = 0; i < folds_->sizes().angles; ++i) {
                numbers.sine[i] = std::sin(q[i]);
                sum += std::sin(q[i]) * std::sin(q[i]);
            }
            at.x[folds_->reciprocal()] = 1 / sum;
        }
        return proved_radius(*folds_, numbers, at, task);
    }
    double pitchfork_radius(const Task& task) const {
        Generator generator(1);
        auto numbers = pitchforks_.numbers(task.at->p, {scales_[0], scales_[1]}, task.at->q, generator);
        numbers.plane.basis = basis(task);
        weigh(task, numbers);
        numbers.fourth = task.last.third;
        return proved_radius(pitchforks_, numbers, point_of_zeros<RuntimeUnknowns, double>(pitchforks_.sizes()), task);
    }

    /// The basis that has v for its first vector: w = 0.
    static RuntimeMatrix<double> basis(const Task& task) {
        const Eigen::VectorXd v = eigen_vector(task.at->v);
        Eigen::MatrixXd b = Eigen::HouseholderQR<Eigen::VectorXd>(v).householderQ();
        b.col(0) = v;
        return runtime_matrix(b);
    }
    /// Sets the weights of the last equation.
    void weigh(const Task& task, auto& numbers) const {
        const auto x = unknowns(*task.at);
        for (std::size_t k = 0; k < 2; ++k) {
            numbers.slice[k] = task.last.slice[k];
            numbers.extremal[k] = task.last.extremal[k];
        }
        numbers.slice[2] = -(task.last.slice[0] * x[0] + task.last.slice[1] * x[1]);
    }

    /// Of the root next to `at`, whose parameters are those of the task.
    template <class System>
    double proved_radius(const System& of, const typename System::Numbers& numbers, RuntimePoint<double> at,
                         const Task& task) const {
        const auto place = unknowns(*task.at);
        for (int k = 0; k < 2; ++k) at.x[of.first_active() + k] = place[static_cast<std::size_t>(k)];
        const BallSystem<double> system(ExactTerms(of.template equations<ExactBall>(numbers, exact_), of.sizes()));
        const auto proof = krawczyk<RuntimeUnknowns, double>(system, at, true);
        if (!proof.proved) return -1;
        double largest = 0;
        for (int k = 0; k < 2; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            const double x = place[axis], r = proof.radius[of.sizes().angles + of.first_active() + k];
            if (folds_->entry().power[axis] == 2 && !(x > 2 * r)) return -1;  // the parameter itself might not be real
            const double size = k == 0 ? locus_->window.width() : locus_->window.height();
            for (const double end : {x - r, x + r})
                largest = std::max(
                    largest,
                    std::abs(folds_->parameter(k, end, scales_[axis]) - folds_->parameter(k, x, scales_[axis])) / size);
        }
        return largest;
    }

    const Locus<RuntimeUnknowns>* locus_;
    const CriticalSystem* folds_;
    SymmetricSystem pitchforks_;
    const ProveTable* prove_table_;
    RunOptions run_;
    std::array<double, 2> scales_;
    RuntimePolynomials<ExactBall> exact_;  ///< the model's
    LocusProof proof_;
    std::vector<Task> tasks_;
};

EQUILIBRIA_INLINE LocusProof prove_locus(const Locus<RuntimeUnknowns>& locus, const CriticalSystem& folds,
                                         const ExactPolynomials& exact, const ProveTable& prove_table,
                                         const RunOptions& run) {
    run.require_alone("a proof");
    const Stopwatch begin;
    LocusProof proof = LocusProver(locus, folds, exact, prove_table, run).run();
    proof.seconds = begin.seconds();
    return proof;
}

}  // namespace equilibria::detail
