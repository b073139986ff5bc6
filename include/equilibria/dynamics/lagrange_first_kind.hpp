/// \file
/// Lagrange's equations of the first kind, with multipliers. Sources: Vesovic and Radulovic, "Modelling and stability
/// analysis of the nonlinear system", Theoretical and Applied Mechanics (2022), (1.7) and (1.8); index reduction and
/// projection as in Hairer and Wanner, Solving Ordinary Differential Equations II, section VII.2.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Core>

#include <equilibria/core/cholesky.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/dynamics/christoffel.hpp>
#include <equilibria/dynamics/motion_formulation.hpp>

namespace equilibria {

/// What keeps the constraints, of which the equations know the second derivative alone.
enum class Stabilisation {
    projection,  ///< after each step, the nearest state (in the metric of the masses) that obeys them
    none,        ///< they drift away: to see how fast
};

/// The motion of a model with holonomic constraints f(q) = 0, in q and v: M a + Gamma v v = Q + J^T lambda with J a =
/// -v^T f'' v, the constraints' second derivative in time (index 1).
template <DynamicModel M>
class LagrangeFirstKind : public detail::ModelMotion<M> {
    using Base = detail::ModelMotion<M>;
    using typename Base::Vector;
    static constexpr int m = n_constraints<M>;
    using Values = Eigen::Vector<double, m>;
    static_assert(m > 0, "equilibria: Lagrange's equations of the first kind need a model with constraints");

public:
    using typename Base::State;

    /// Throws InvalidArgument for a parameter that is not finite.
    explicit LagrangeFirstKind(const Parameters<M>& p, Stabilisation stabilisation = Stabilisation::projection)
        : Base(p), stabilisation_(stabilisation) {}

    /// Throws InvalidArgument where q or the velocity breaks the constraints by more than 1e-6 of their size; less is
    /// put right.
    State start(const MotionState<M>& at) const {
        this->validate(at);
        State given = Base::joined(at.q, at.velocity), y = given;
        require(projected(y) == MotionStatus::finished, "start.q", constraint_error(at.q),
                "must be near a place where the constraints hold and are independent; this is by how much they fail");
        const auto moved = [&](std::size_t from) {
            double most = 0, size = 1;
            for (std::size_t i = from; i < from + Base::n; ++i)
                most = std::max(most, std::abs(y[i] - given[i])), size = std::max(size, std::abs(given[i]));
            return most / size;
        };
        require(moved(0) <= 1e-6, "start.q", constraint_error(at.q),
                "must obey the constraints; this is by how much they fail");
        require(moved(Base::n) <= 1e-6, "start.velocity", velocity_error(at.q, at.velocity),
                "must obey the constraints' derivative; this is by how much it fails");
        return y;
    }

    /// A function of a formulation, see MotionFormulation; the state is q, then v.
    /// \{
    MotionRates<Base::n_states> rates(double t, const State& y) const {
        const auto q = Base::first_half(y), v = Base::second_half(y);
        const auto solved = solve(t, q, v);
        if (solved.status != MotionStatus::finished) return {solved.status};
        return {MotionStatus::finished, Base::joined(v, detail::unknowns_of<M>(solved.acceleration)),
                solved.forces.power, solved.forces.loss};
    }

    MotionPoint<M> point(double t, const State& y) const {
        const auto q = Base::first_half(y), v = Base::second_half(y);
        auto point = this->point_at(t, q, v);
        const auto solved = solve(t, q, v);
        for (int i = 0; i < m; ++i) point.multipliers[i] = solved.multipliers[i];
        point.constraint_forces =
            detail::unknowns_of<M>(constraint_jacobian<M>(q, this->p_).transpose() * solved.multipliers);
        point.drift = constraint_error(q);
        point.velocity_drift = velocity_error(q, v);
        return point;
    }

    MotionStatus project(State& y) const {
        return stabilisation_ == Stabilisation::projection ? projected(y) : MotionStatus::finished;
    }
    /// \}

private:
    struct Solved {
        MotionStatus status = MotionStatus::finished;
        Vector acceleration = Vector::Zero();
        Values multipliers = Values::Zero();
        detail::AppliedForces<M> forces;
    };
    /// The factors of M and of J M^-1 J^T.
    struct Metric {
        explicit Metric(const Unknowns<M>& q, const Parameters<M>& p)
            : jacobian(constraint_jacobian<M>(q, p)), mass(mass_matrix<M>(q, p)),
              spread(mass.template solve<m>(jacobian.transpose())), product(jacobian * spread), gram(product) {}

        MotionStatus status() const {
            if (!mass.positive()) return MotionStatus::singular_mass_matrix;
            return gram.positive() && gram.reciprocal_condition(product) > 1e-13 ? MotionStatus::finished
                                                                                 : MotionStatus::singular_constraints;
        }

        ConstraintJacobian<M> jacobian;
        detail::Cholesky<Base::n> mass;
        Eigen::Matrix<double, Base::n, m> spread;  // M^-1 J^T
        Eigen::Matrix<double, m, m> product;       // J M^-1 J^T
        detail::Cholesky<m> gram;
    };

    Solved solve(double t, const Unknowns<M>& q, const Unknowns<M>& v) const {
        Solved y;
        const Metric at(q, this->p_);
        y.status = at.status();
        if (y.status != MotionStatus::finished) return y;
        y.forces = detail::applied_forces<M>(t, q, v, this->p_);
        const Vector inertial = contracted<M>(christoffel_first_kind<M>(q, this->p_), detail::vector_of<M>(v));
        const Vector free = at.mass.solve(Vector(y.forces.total - inertial));
        const auto curvature = constraint_curvature<M>(q, v, this->p_);
        y.multipliers = at.gram.solve(Values(-values(curvature) - at.jacobian * free));
        y.acceleration = free + at.spread * y.multipliers;
        return y;
    }

    /// Newton's method for the nearest place that obeys the constraints, then the nearest velocity there.
    MotionStatus projected(State& y) const {
        auto q = detail::vector_of<M>(Base::first_half(y)), v = detail::vector_of<M>(Base::second_half(y));
        double before = std::numeric_limits<double>::infinity();
        for (int iteration = 0; iteration < 20; ++iteration) {
            const auto place = detail::unknowns_of<M>(q);
            const Metric at(place, this->p_);
            if (const auto status = at.status(); status != MotionStatus::finished) return status;
            const Vector step = at.spread * at.gram.solve(values(constraints<M>(place, this->p_)));
            q -= step;
            const double size = step.norm();
            if (!std::isfinite(size)) return MotionStatus::not_finite;
            if (size <= 1e-15 * (1 + q.norm()) || size >= before) {
                v -= at.spread * at.gram.solve(Values(at.jacobian * v));
                y = Base::joined(detail::unknowns_of<M>(q), detail::unknowns_of<M>(v));
                return size <= 1e-9 * (1 + q.norm()) ? MotionStatus::finished : MotionStatus::singular_constraints;
            }
            before = size;
        }
        return MotionStatus::singular_constraints;
    }

    static Values values(const ConstraintValues<M>& f) { return Eigen::Map<const Values>(f.begin()); }
    double constraint_error(const Unknowns<M>& q) const {
        return values(constraints<M>(q, this->p_)).cwiseAbs().maxCoeff();
    }
    double velocity_error(const Unknowns<M>& q, const Unknowns<M>& v) const {
        return (constraint_jacobian<M>(q, this->p_) * detail::vector_of<M>(v)).cwiseAbs().maxCoeff();
    }

    Stabilisation stabilisation_;
};

}  // namespace equilibria
