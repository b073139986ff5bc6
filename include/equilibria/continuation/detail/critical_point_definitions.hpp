/// \file
/// See continuation/critical_point.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>

namespace equilibria {

namespace detail {

/// Newton's method on both systems.
template <class Matrix>
class CriticalPointNewton {
public:
    using Point = CriticalPoint<Erased>;

    /// fold: one is expected, whose load does some work, however little that is beside the bifurcation's coefficients.
    CriticalPointNewton(const AnyProblem<Matrix>& problem, const CriticalPointOptions& options,
                        BorderedSolver<Matrix>& solver, bool fold)
        : problem_(problem), options_(options), symmetric_(problem.properties().symmetric), fold_(fold),
          solver_(solver) {}

    /// limit_first: the limit point's system unless the bifurcation's leads to a point that is about as near.
    /// weak: nearly the null vector; empty where it is not known.
    std::optional<Point> solve(const AnyConfiguration& q, double p, Border border, const Eigen::VectorXd& weak,
                               bool limit_first) {
        weights_ = problem_.weights(q, problem_.residual(q, p).size());
        border_ = border;
        scale_p_ = 0;
        weak_ = weak;
        Point point;
        point.q = q;
        point.p = p;
        bool bifurcation = false;
        int switches = 0;
        for (int k = 0; k < options_.most_iterations; ++k) {
            if (!evaluate(point.q, point.p)) return std::nullopt;
            Step step = bifurcation ? bifurcation_step() : limit_step();
            // a limit point's system is singular at a bifurcation, a bifurcation's finds imperfect ones as well
            const bool is_linear = linear(point.history);
            if (!bifurcation && switches < 2 && (transversality() < options_.bifurcation_start || is_linear)) {
                const Step other = bifurcation_step();
                const bool longer = !is_linear && length(other.d) > 10 * length(step.d);
                order_matters_ = order_matters_ || longer;
                if (!limit_first || !longer) step = other, bifurcation = true, ++switches;
            }
            const auto& [d, gamma] = step;
            const double size = length(d);
            if (!(size <= options_.reach) || !std::isfinite(size)) return std::nullopt;
            const double before =
                point.history.empty() ? std::numeric_limits<double>::infinity() : point.history.back().step;
            point.history.push_back({size, r_.tau, residual_, bifurcation});
            point.q = problem_.retract(point.q, d.q);
            point.p += d.p;
            point.unfolding = bifurcation ? gamma : 0;
            const bool done = size <= options_.tolerance || (size < 1e-9 && size > 0.2 * before);
            if (!done) continue;
            if (!evaluate(point.q, point.p)) return std::nullopt;
            if (bifurcation && transversality() > options_.bifurcation && !load_vanishes()) return std::nullopt;
            if (!bifurcation && !fold_ && switches < 2 && (bifurcation_step(), load_vanishes())) {
                bifurcation = true;
                switches = 2;
                continue;
            }
            if (bifurcation && unfolds(point, gamma)) {
                // not on the branch: an imperfect bifurcation; its folds are limit points
                bifurcation = false;
                switches = 2;
                continue;
            }
            finish(point, bifurcation);
            return point;
        }
        return std::nullopt;
    }

    /// Whether a limit point's system was to be chosen before a bifurcation's, or not, in some step so far.
    bool order_matters() const { return order_matters_; }

private:
    double length(const Direction& d) const {
        return std::sqrt(d.q.dot(weights_.cwiseProduct(d.q))) + std::abs(d.p) / scale_p_;
    }
    /// Newton's method converges linearly, by 1/2, or wanders about near by: a limit point's system at a bifurcation.
    static bool linear(const std::vector<CriticalIteration>& history) {
        const std::size_t n = history.size();
        if (n < 4) return false;
        const auto ratio = [&](std::size_t k) { return history[k].step / history[k - 1].step; };
        const double most = history[n - 1].step < 1e-5 ? std::numeric_limits<double>::infinity() : 0.7;
        return ratio(n - 1) > 0.3 && ratio(n - 1) < most && ratio(n - 2) > 0.3 && ratio(n - 2) < most;
    }
    /// What rounding leaves of g, for unknowns of size 1.
    double rounding() const {
        return 1e3 * std::numeric_limits<double>::epsilon() * (solver_.largest_entry() + largest_entry(dr_));
    }
    /// Whether gamma is not 0: above what rounding may leave by the largest entries of K. Parts that are much stiffer
    /// than what bends make that too much: then a gamma that moves the transcritical point's folds apart, y^2 = a gamma
    /// / b^2, counts too, if Newton's method from next to the point has it again.
    bool unfolds(const Point& point, double gamma) {
        if (std::abs(gamma) > 1e3 * rounding()) return true;
        const double apart = std::sqrt(std::abs(a_ * gamma)) / std::abs(b_);
        const double load = std::abs(point.p) > 1e-9 * scale_p_ ? std::abs(point.p) : scale_p_;
        if (!(apart > 1e-7 * load)) return false;
        Direction d{generic_vector(g_.size()), 0};
        d.q.tail(problem_.multipliers()).setZero();
        d.q *= 1e-10 / std::sqrt(d.q.dot(weights_.cwiseProduct(d.q)));
        AnyConfiguration q = problem_.retract(point.q, d.q);
        double p = point.p, noise = 0;
        for (int k = 0; k < 3; ++k) {
            if (!evaluate(q, p)) {
                noise = std::numeric_limits<double>::infinity();
                break;
            }
            const Step step = bifurcation_step();
            if (k > 0) noise = std::max(noise, std::abs(step.gamma - gamma));
            q = problem_.retract(q, step.d.q);
            p += step.d.p;
        }
        return evaluate(point.q, point.p) && std::abs(gamma) > 30 * noise;
    }
    /// Whether K has another null vector, left in `second`: K without the border is singular to the digits of a Newton
    /// iteration, and, as stiff structures have soft modes, that eigenvalue too is 0 at a distance along the branch
    /// below 1e-5 of the load, at a fold of the unknowns' size.
    bool two_null_vectors(Eigen::VectorXd& second, bool bifurcation) {
        const Eigen::VectorXd f = generic_vector(g_.size());
        second = solver_.solve(f, 0).x;
        const double size = second.norm();
        if (!(size * solver_.largest_entry() > 1e9 * f.norm())) return false;
        second /= size;
        const double eigenvalue =
                         std::abs(second.dot(solver_.matrix() * second)) / second.dot(weights_.cwiseProduct(second)),
                     phi2 = r_.x.dot(weights_.cwiseProduct(r_.x));
        if (!bifurcation) return !(eigenvalue > 1e-5 * std::abs(this->second(r_.x)) / (phi2 * std::sqrt(phi2)));
        bifurcation_step();  // b here
        const double load = std::abs(p_) > 1e-9 * scale_p_ ? std::abs(p_) : scale_p_;
        return !(eigenvalue > 1e-5 * std::abs(b_) / phi2 * load);
    }

    bool evaluate(const AnyConfiguration& q, double p) {
        q_ = &q;
        p_ = p;
        Matrix().swap(dr_);  // its memory is needed
        Linearization<Matrix> here = problem_.linearization(q, p);
        g_ = std::move(here.residual);
        g_p_ = std::move(here.parameter_derivative);
        residual_ = g_.lpNorm<Eigen::Infinity>();
        if (!g_.allFinite()) return false;
        auto weak =
            factor_at_weakest(solver_, std::move(here.tangent), weights_, problem_.multipliers(), border_, weak_);
        if (!weak) return false;
        r_ = std::move(weak->r);
        weak_ = std::move(weak->direction);
        left_ = symmetric_ ? r_ : solver_.solve_transposed(Eigen::VectorXd::Zero(g_.size()), 1);
        Eigen::MatrixXd right(g_.size(), 2);
        right.col(0) = -g_p_;
        right.col(1) = -g_;
        const BorderedSolutions solutions = solver_.solve(right, Eigen::Vector2d::Zero());
        s_ = solutions[0];
        q0_ = solutions[1];
        // a change of p that moves the unknowns by 1; multipliers count as the others do, lest nothing depends on p
        const Eigen::Index own = g_.size() - problem_.multipliers();
        const double slope = std::sqrt(s_.x.head(own).dot(weights_.head(own).cwiseProduct(s_.x.head(own))) +
                                       weights_.head(own).maxCoeff() * s_.x.tail(g_.size() - own).squaredNorm());
        if (scale_p_ == 0) scale_p_ = slope > 0 ? 1 / slope : 1.0;
        problem_.tangent_derivative(q, p, r_.x).swap(dr_);
        gp_r_ = problem_.parameter_derivative_along(q, p, r_.x);
        return true;
    }
    double transversality() const {
        const Eigen::ArrayXd root = weights_.array().sqrt();
        const double phi = (left_.x.array() * root).matrix().norm(), load = (g_p_.array() / root).matrix().norm();
        return load > 0 ? std::abs(left_.x.dot(g_p_)) / (phi * load) : 0;  // 0: a load that does no work here
    }

    /// Whether dg/dp itself vanishes, so that `transversality` means nothing; after bifurcation_step.
    bool load_vanishes() const { return std::abs(left_.x.dot(g_p_)) <= 1e-9 * (std::abs(b_) + std::abs(c_)); }

    struct Step {
        Direction d;
        double gamma;
    };
    Step combined(double z, double dp) const {
        return {{q0_.x + z * r_.x + dp * s_.x, dp}, q0_.tau + z * r_.tau + dp * s_.tau};
    }
    /// A number by differences, and how far apart two of their orders have it.
    struct Estimate {
        double value, error;
    };
    /// psi^T g_qqq[v, v, v], by differences of dK along v where that is exact, else by second differences of K. other:
    /// what is added to it, to whose sum the error counts.
    Estimate third(const Eigen::VectorXd& v, double other) const {
        const auto at = [&](double by) { return problem_.retract(*q_, Eigen::VectorXd(by * v)); };
        if (problem_.properties().tangent_derivative) {
            const double h = difference_step(problem_.weights(*q_, v.size()), v);
            const auto along = [&](double by) { return left_.x.dot(problem_.tangent_derivative(at(by), p_, v) * v); };
            return {(along(h) - along(-h)) / (2 * h), 0};
        }
        const auto along = [&](double by) { return left_.x.dot(problem_.tangent(at(by), p_) * v); };
        const double middle = along(0);
        // of sixth order in h = eps^(1/8): K may have entries that are far larger than what is sought
        const double move = std::pow(std::numeric_limits<double>::epsilon(), 1. / 8);
        const double first = difference_step(problem_.weights(*q_, v.size()), v) * move / third_root_of_rounding;
        Estimate best{0, std::numeric_limits<double>::infinity()};
        for (const double share : {1.0, 0.25, 0.0625, 4.0}) {
            const double h = share * first;
            const auto around = [&](double by) { return along(by) + along(-by); };
            const double one = around(h), two = around(2 * h), three = around(3 * h);
            const double sixth = (270 * one - 27 * two + 2 * three - 490 * middle) / (180 * h * h);
            const double fourth = (16 * one - two - 30 * middle) / (12 * h * h);
            const double error = std::abs(sixth - fourth);
            if (error < best.error) best = {sixth, error};
            if (error <= 1e-3 * std::abs(sixth + other)) break;
        }
        return best;
    }

    /// psi^T g_qq[r, v].
    double second(const Eigen::VectorXd& v) const { return left_.x.dot(dr_ * v); }
    Step limit_step() const {
        const double a = r_.tau, b = s_.tau, e = -q0_.tau;
        const double c = second(r_.x), d = second(s_.x) + left_.x.dot(gp_r_), f = r_.tau - second(q0_.x);
        const double determinant = a * d - b * c;
        return combined((e * d - b * f) / determinant, (a * f - e * c) / determinant);
    }
    /// Of a symmetric K phi^T g_qq[s, v] = s^T (dK along phi) v: no further derivative is needed.
    Step bifurcation_step() {
        const Eigen::VectorXd gp_s = problem_.parameter_derivative_along(*q_, p_, s_.x),
                              gp_q0 = problem_.parameter_derivative_along(*q_, p_, q0_.x),
                              g_pp = problem_.second_parameter_derivative(*q_, p_);
        double ss, sq;
        if (symmetric_) {
            ss = s_.x.dot(dr_ * s_.x);
            sq = s_.x.dot(dr_ * q0_.x);
        } else {
            const Matrix ds = problem_.tangent_derivative(*q_, p_, s_.x);
            ss = left_.x.dot(ds * s_.x);
            sq = left_.x.dot(ds * q0_.x);
        }
        const Eigen::VectorXd& psi = left_.x;
        a_ = second(r_.x);
        b_ = second(s_.x) + psi.dot(gp_r_);
        c_ = ss + 2 * psi.dot(gp_s) + psi.dot(g_pp);
        const double mu = psi.dot(g_p_);
        const double e = r_.tau - second(q0_.x), f = -mu - sq - psi.dot(gp_q0);
        const double determinant = a_ * c_ - b_ * b_;
        return combined((e * c_ - b_ * f) / determinant, (a_ * f - e * b_) / determinant);
    }

    /// Nullity, coefficients, tangents and kind at the converged point.
    void finish(Point& point, bool bifurcation) {
        point.residual = residual_;
        point.sigma = r_.tau;
        point.null_vector = r_.x;
        point.left_null_vector = left_.x;
        point.transversality = transversality();
        const double phi = std::sqrt(r_.x.dot(weights_.cwiseProduct(r_.x)));
        Eigen::VectorXd second_null;
        if (two_null_vectors(second_null, bifurcation)) {
            point.nullity = 2;
            point.null_vectors.resize(g_.size(), 2);
            point.null_vectors << r_.x / phi, second_null;
            // a load that does work along a null vector makes a fold of it
            const double work = (point.null_vectors.transpose() * g_p_).norm();
            point.kind = work > 1e-6 * g_p_.norm() ? CriticalKind::hilltop : CriticalKind::multiple;
            return;
        }
        if (!bifurcation) {
            point.a = second(r_.x);
            point.kind = CriticalKind::fold;
            const double load = left_.x.dot(g_p_);
            point.curvature = -point.a / load;
            const double size_a = left_.x.norm() * (dr_ * r_.x).norm();
            if (std::abs(point.a) <= 1e-6 * size_a) point.kind = CriticalKind::cusp;
            Direction t{r_.x / phi, 0};
            point.tangents = {t};
            return;
        }
        point.slope = s_.x;
        bifurcation_step();  // a, b, c here
        point.a = a_, point.b = b_, point.c = c_;
        // in units in which phi and (w, 1) have length 1; w may be 0
        const double w = std::numbers::sqrt2 / scale_p_;
        const double a = a_ / (phi * phi), b = b_ / (phi * w), c = c_ / (w * w);
        const double size = std::max({std::abs(a), std::abs(b), std::abs(c)});
        const double noise = 1e-5;
        const double discriminant = b * b - a * c;
        if (std::abs(discriminant) <= noise * size * size) {
            point.kind = CriticalKind::hilltop;
            return;
        }
        if (discriminant < 0) {
            point.kind = CriticalKind::isola_center;
            return;
        }
        // roots x : y of a x^2 + 2 b x y + c y^2, in the stable form: (x, y) = (m, a) and (c, m), m = -(b + sign(b)
        // sqrt)
        const double m = -(b + (b < 0 ? -1.0 : 1.0) * std::sqrt(discriminant));
        const auto direction = [&](double x, double y) {
            if (std::abs(y) < noise * std::abs(x)) y = 0;  // along phi to rounding
            Direction d{x / phi * r_.x + y / w * s_.x, y / w};
            return d;
        };
        point.tangents = {direction(m, a), direction(c, m)};
        point.kind = std::abs(a) < noise * size ? CriticalKind::pitchfork : CriticalKind::transcritical;
        if (point.kind == CriticalKind::pitchfork) {
            // K z = -g_qq[phi, phi], z_i = 0; d = phi^T (g_qqq[phi, phi, phi] + 3 g_qq[phi, z])
            const Eigen::VectorXd z = solver_.solve(-(dr_ * r_.x), 0).x;
            const double bending = 3 * second(z);
            const Estimate cubic = third(r_.x, bending);
            point.curvature = -(cubic.value + bending) / (3 * point.b);
            point.curvature_error = std::abs(cubic.error / (3 * point.b));
        }
    }

    const AnyProblem<Matrix>& problem_;
    CriticalPointOptions options_;
    bool symmetric_, fold_, order_matters_ = false;
    BorderedSolver<Matrix>& solver_;
    Eigen::VectorXd weights_, g_, g_p_, gp_r_, weak_;
    Matrix dr_;
    BorderedSolution r_, left_, s_, q0_;
    const AnyConfiguration* q_ = nullptr;
    double p_ = 0, residual_ = 0, a_ = 0, b_ = 0, c_ = 0, scale_p_ = 0;
    Border border_;
};

}  // namespace detail

template <class Matrix>
std::optional<CriticalPoint<Erased>> critical_point_near(const AnyProblem<Matrix>& problem, const AnyConfiguration& q,
                                                         double p, const CriticalPointOptions& options, Border border,
                                                         BorderedSolver<Matrix>* solver, const Eigen::VectorXd& weak,
                                                         bool fold) {
    std::optional<BorderedSolver<Matrix>> own;
    if (!solver)
        solver = &own.emplace(problem.properties().symmetric, problem.multipliers(), problem.symmetric_factors());
    detail::CriticalPointNewton<Matrix> newton(problem, options, *solver, fold);
    auto point = newton.solve(q, p, border, weak, fold);
    // a fold whose load does little work looks like a bifurcation
    return point || !newton.order_matters() ? point : newton.solve(q, p, border, weak, !fold);
}

}  // namespace equilibria
