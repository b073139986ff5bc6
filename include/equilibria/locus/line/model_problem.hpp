/// \file
/// A model as a continuation problem: its equilibria in one of its parameters, with exact derivatives.
#pragma once

#include <Eigen/Core>

#include <equilibria/continuation/problem.hpp>
#include <equilibria/model/derivatives.hpp>

namespace equilibria {

/// The equilibria of a model against its parameter number X; unknowns: the angles (radians), then the coordinates.
template <Model M, int X>
class ModelProblem {
public:
    using Vector = Eigen::VectorXd;
    using Matrix = Eigen::MatrixXd;
    static constexpr bool symmetric = PotentialModel<M>;
    static constexpr int n = n_unknowns<M>;

    /// parameters: entry X is not read.
    explicit ModelProblem(const Parameters<M>& parameters) : parameters_(parameters) {}

    Vector residual(const Vector& q, double p) const { return vector(equations<M, double>(unknowns(q), at(p))); }
    Matrix tangent(const Vector& q, double p) const { return jacobian<M, double>(unknowns(q), at(p)); }
    Vector parameter_derivative(const Vector& q, double p) const {
        return vector(equilibria::parameter_derivative<M, double>(unknowns(q), at(p), X));
    }
    Matrix tangent_derivative(const Vector& q, double p, const Vector& v) const {
        return jacobian_derivative<M, double>(unknowns(q), unknowns(v), at(p));
    }
    Vector parameter_derivative_along(const Vector& q, double p, const Vector& v) const {
        const Eigen::Matrix<double, n, 1> fixed = v;
        const Eigen::Matrix<double, n, 1> y = jacobian_parameter_derivative<M, double>(unknowns(q), at(p), X) * fixed;
        return vector(y);
    }

    /// Of n numbers, with operator[].
    static Vector vector(const auto& q) {
        Vector v(n);
        for (int i = 0; i < n; ++i) v(i) = q[i];
        return v;
    }
    static Unknowns<M> unknowns(const Vector& v) {
        Unknowns<M> q;
        for (int i = 0; i < n; ++i) q[i] = v(i);
        return q;
    }

private:
    Parameters<M> at(double p) const {
        Parameters<M> values = parameters_;
        values[X] = p;
        return values;
    }

    Parameters<M> parameters_;
};

/// The same for each value of the parameter number Y.
template <Model M, int X, int Y>
struct ModelProblems {
    Parameters<M> parameters;  ///< entries X and Y are not read
    ModelProblem<M, X> operator()(double y) const {
        Parameters<M> values = parameters;
        values[Y] = y;
        return ModelProblem<M, X>(values);
    }
};

}  // namespace equilibria
