/// \file
/// One step along a branch of g(q, p) = 0: predictor, corrector with a constraint on the step, and what the converged
/// point tells of the branch: tangent, inertia, and the test functions sigma and mu of bordered.hpp.
///
/// Lengths are those of |(v, e)|^2 = sum w_i v_i^2 + theta^2 e^2, w the problem's weights and theta the parameter's.
/// Sources: Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems (1977); Crisfield, A fast
/// incremental/iterative solution procedure that handles snap-through, Comput. Struct. 13 (1981) (sphere, cylinder);
/// Seydel, Practical Bifurcation and Stability Analysis.
#pragma once

#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include <equilibria/continuation/any_problem.hpp>
#include <equilibria/continuation/branch_options.hpp>
#include <equilibria/continuation/branch_point.hpp>
#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

namespace detail {
struct BorderedPair;
template <class Matrix>
class LastFactors;
}  // namespace detail

/// Along branches of a problem of any type; its functions are those of BranchStepper, below.
template <class Matrix>
class AnyBranchStepper {
public:
    using Point = BranchPoint<Erased>;  ///< of a branch

    /// Throws InvalidArgument for options out of range.
    AnyBranchStepper(AnyProblem<Matrix> problem, const BranchOptions& options);

    /// As in BranchStepper.
    /// \{
    const AnyProblem<Matrix>& problem() const { return problem_; }
    const BranchOptions& options() const { return options_; }
    double parameter_weight() const { return theta_; }
    const Eigen::VectorXd& metric() const { return weights_; }

    std::optional<Point> start(AnyConfiguration q, double p, int direction);
    std::optional<Point> advance(const Point& from, const Point* before = nullptr);
    std::optional<Point> step(const Point& from, double h, const Point* before = nullptr);
    Direction predict(const Point& from, double h, const Point* before) const;
    /// \}
    /// The cubic curve with both points' tangents from one point through the other, where it is h away along the
    /// tangent: Hermite's interpolation.
    Direction through(const Point& from, const Point& other, double h) const;
    /// The point of the branch between two of its points, a share of the step from a to b away from a, from 0 to 1;
    /// nothing where the corrector does not converge.
    std::optional<Point> between(const Point& a, const Point& b, double share);
    /// As in BranchStepper.
    /// \{
    std::optional<Point> onto(const AnyConfiguration& q, double p, const Direction& increment, const Direction& normal,
                              const Direction& along);
    std::optional<Point> assess(const AnyConfiguration& q, double p, const std::optional<Direction>& along);
    Eigen::MatrixXd weak_directions(const AnyConfiguration& q, double p, int count);

    Direction difference(const Point& from, const AnyConfiguration& q, double p) const {
        return {problem_.difference(from.q, q), p - from.p};
    }
    double dot(const Direction& a, const Direction& b) const {
        return a.q.dot(weights_.cwiseProduct(b.q)) + theta_ * theta_ * a.p * b.p;
    }
    double length(const Direction& a) const { return std::sqrt(dot(a, a)); }

    static void flip(Direction& d) { scale(d, -1); }
    static void scale(Direction& d, double by) {
        d.q *= by;
        d.p *= by;
    }
    /// \}

    /// Where a direction is largest: a border for a K that is weak in it.
    Border border_of(const Eigen::VectorXd& direction) const {
        const Eigen::Index k = largest(direction);
        return {k, k};
    }

    /// What a step factors with; its factors are not kept from one step to the next.
    BorderedSolver<Matrix>& solver() { return solver_; }

private:
    struct Constraint {
        StepConstraint kind = StepConstraint::normal_plane;
        Direction normal;     ///< of planes
        double distance = 0;  ///< of sphere and cylinder
        double target = 0;    ///< of a scalar
    };

    /// The largest entry by the weights, multipliers apart.
    Eigen::Index largest(const Eigen::VectorXd& v) const;
    /// Factors K with the last border, or with another one where that is singular.
    bool factor(Matrix&& k);
    /// How many directions are watched beside the weakest one, where the eigenvalues are not known.
    int watched() const { return BorderedSolver<Matrix>::sparse && problem_.properties().symmetric ? 2 : 0; }
    /// The converged point (q, p), by the factors of the last correction, the r and s that it solved for, and, unless K
    /// is the `same` but for a correction of next to nothing, a refinement of these. `from`: the last point of the
    /// branch.
    std::optional<Point> assess_from(const AnyConfiguration& q, double p, detail::BorderedPair pair, bool same,
                                     const Point& from, const Direction& along);
    /// Whether the unknowns have moved elsewhere than predicted: behind a fold and another one, where p's share of the
    /// lengths hides both.
    bool jumped(const Point& from, const Point& next, const Direction& predicted) const;
    /// The point (q, p) with this residual and weakest direction; s: [s; -mu] of bordered.hpp.
    std::optional<Point> point_of(const AnyConfiguration& q, double p, const Eigen::VectorXd& g,
                                  const WeakDirection& weak, const BorderedSolution& s,
                                  const std::optional<Direction>& along);
    /// Chooses theta at a point with the weakest direction `weak` and dq/dp = `slope`.
    void choose_parameter_weight(const AnyConfiguration& q, double p, const WeakDirection& weak,
                                 const Eigen::VectorXd& slope);
    /// Whether the last factors are worth more than another factorisation.
    bool iterates() const;
    /// What the solver has factored last, where that is worth more than another factorisation.
    std::optional<detail::LastFactors<Matrix>> last_factors() const;
    Constraint normal_of(const Point& from, const Direction& predicted, double h) const;
    /// The gradient of the constraint, in weighted coordinates, and its value at (q, p), the increment `moved` away
    /// from the last point; planes have the value 0 at every iterate.
    std::pair<Direction, double> constraint_at(const Constraint& c, const Direction& moved, const AnyConfiguration& q,
                                               double p) const;
    /// Newton's method from q (+) moved; `from.tangent` decides the side of the tangent.
    std::optional<Point> correct_from(const Point& from, const Direction& moved, const Constraint& constraint,
                                      double h);
    /// The same by the last factors and those made meanwhile, or, with none, with a factorisation for each correction.
    std::optional<Point> correct_from(const Point& from, Direction moved, const Constraint& constraint, double h,
                                      std::optional<detail::LastFactors<Matrix>> last);
    double tolerance(const Direction& moved) const { return options_.tolerance * (1 + length(moved)); }

    AnyProblem<Matrix> problem_;
    BranchOptions options_;
    BorderedSolver<Matrix> solver_;
    double theta_;
    Eigen::VectorXd weights_;
    Border border_;
};

/// Makes the steps along branches of a problem, one at a time.
template <ContinuationProblem P>
class BranchStepper {
public:
    using Matrix = TangentMatrix<P>;  ///< of K, dense or sparse
    using Point = BranchPoint<P>;     ///< of a branch

    /// The problem must outlive the stepper. Throws InvalidArgument for options out of range.
    BranchStepper(const P& problem, const BranchOptions& options)
        : problem_(&problem), any_(AnyProblem<Matrix>(problem), options) {}
    BranchStepper(P&&, const BranchOptions&) = delete;

    const P& problem() const { return *problem_; }                   ///< the problem whose branches it follows
    const BranchOptions& options() const { return any_.options(); }  ///< as they were given
    /// Theta; 0 until the first point where it is to be chosen.
    double parameter_weight() const { return any_.parameter_weight(); }

    /// The equilibrium near q at the parameter p, with the tangent along which the parameter grows (direction 1) or
    /// falls (-1). Nothing where Newton's method at fixed p does not converge.
    std::optional<Point> start(Configuration<P> q, double p, int direction) {
        return typed<P>(any_.start(AnyConfiguration::of(std::move(q)), p, direction));
    }

    /// The next point of the branch; nothing where the step would be smaller than the smallest. `before`: the point
    /// before `from`, for predictors that need it.
    std::optional<Point> advance(const Point& from, const Point* before = nullptr) {
        const auto last = erased_or_none(before);
        return typed<P>(any_.advance(erased(from), last ? &*last : nullptr));
    }

    /// The point of the branch a step of length h from `from`, which may be negative: back; nothing where the corrector
    /// does not converge.
    std::optional<Point> step(const Point& from, double h, const Point* before = nullptr) {
        const auto last = erased_or_none(before);
        return typed<P>(any_.step(erased(from), h, last ? &*last : nullptr));
    }

    /// Where the predictor puts the next point, from `from`.
    Direction predict(const Point& from, double h, const Point* before) const {
        const auto last = erased_or_none(before);
        return any_.predict(erased(from), h, last ? &*last : nullptr);
    }

    /// The point of the branch in the plane through (q (+) increment) normal to `normal`, whose tangent points to the
    /// side of `along`.
    std::optional<Point> onto(const Configuration<P>& q, double p, const Direction& increment, const Direction& normal,
                              const Direction& along) {
        return typed<P>(any_.onto(AnyConfiguration::of(q), p, increment, normal, along));
    }

    /// What is known of a point of the branch; `along`: the tangent's side. Nothing where the tangent is not
    /// determined: nullity 2 or more.
    std::optional<Point> assess(const Configuration<P>& q, double p, const std::optional<Direction>& along) {
        return typed<P>(any_.assess(AnyConfiguration::of(q), p, along));
    }

    /// `count` orthonormal directions (by the weights) in which K is weakest at a regular point, the columns of the
    /// result, by subspace iteration. Empty where K is singular to rounding.
    Eigen::MatrixXd weak_directions(const Configuration<P>& q, double p, int count) {
        return any_.weak_directions(AnyConfiguration::of(q), p, count);
    }

    /// The increment from a point to a configuration near it.
    Direction difference(const Point& from, const Configuration<P>& q, double p) const {
        return {equilibria::difference(*problem_, from.q, q), p - from.p};
    }
    /// The scalar product of lengths: sum w_i a_i b_i + theta^2 a_p b_p.
    double dot(const Direction& a, const Direction& b) const { return any_.dot(a, b); }
    double length(const Direction& a) const { return any_.length(a); }  ///< of a direction, by this product
    const Eigen::VectorXd& metric() const { return any_.metric(); }     ///< w, the weights of the unknowns

    static void flip(Direction& d) { AnyBranchStepper<Matrix>::flip(d); }  ///< turns a direction round
    /// Multiplies a direction by a number.
    static void scale(Direction& d, double by) { AnyBranchStepper<Matrix>::scale(d, by); }

    /// What it does all of it with.
    AnyBranchStepper<Matrix>& any() { return any_; }

private:
    static std::optional<BranchPoint<Erased>> erased_or_none(const Point* point) {
        if (!point) return std::nullopt;
        return erased(*point);
    }

    const P* problem_;
    AnyBranchStepper<Matrix> any_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/detail/branch_stepper_definitions.hpp>
#include <equilibria/continuation/detail/step_correction_definitions.hpp>
#endif
