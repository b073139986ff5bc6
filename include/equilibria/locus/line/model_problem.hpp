/// \file
/// A model as a continuation problem: its equilibria in one of its parameters, with exact derivatives.
#pragma once

#include <utility>

#include <Eigen/Core>

#include <equilibria/continuation/member_derivatives.hpp>
#include <equilibria/continuation/problem.hpp>
#include <equilibria/core/eigen_copies.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/model/model_functions.hpp>

namespace equilibria {

/// The equilibria of a model against one parameter, its numbers of unknowns and parameters known at run time; unknowns:
/// the angles (radians), then the coordinates.
class EquilibriumProblem {
public:
    using Vector = Eigen::VectorXd;  ///< residuals, unknowns and increments
    using Matrix = Eigen::MatrixXd;  ///< n x n, dense

    /// active: the number of the parameter, whose entry in `parameters` is not read.
    EquilibriumProblem(const ModelDerivatives<>& model, RuntimeArray<double> parameters, int active)
        : model_(&model), parameters_(std::move(parameters)), active_(active) {}

    /// A function of a continuation problem (continuation/problem.hpp), exact.
    /// \{
    Vector residual(const Vector& q, double p) const {
        return eigen_vector(equations(*model_, runtime_array(q), at(p)));
    }
    Matrix tangent(const Vector& q, double p) const { return eigen_matrix(jacobian(*model_, runtime_array(q), at(p))); }
    Vector parameter_derivative(const Vector& q, double p) const { return derivatives(active_, q, p).first; }
    Matrix tangent_derivative(const Vector& q, double p, const Vector& v) const {
        return eigen_matrix(jacobian_derivative(*model_, runtime_array(q), runtime_array(v), at(p)));
    }
    Vector parameter_derivative_along(const Vector& q, double p, const Vector& v) const {
        return derivatives(active_, q, p).second * v;
    }
    /// \}
    /// The derivatives of g and K by any of the model's parameters.
    std::pair<Vector, Matrix> derivatives(int parameter, const Vector& q, double p) const {
        const auto y = parameter_derivatives(*model_, runtime_array(q), at(p), parameter);
        return {eigen_vector(y.first), eigen_matrix(y.second)};
    }

private:
    RuntimeArray<double> at(double p) const {
        RuntimeArray<double> values = parameters_;
        values[active_] = p;
        return values;
    }

    const ModelDerivatives<>* model_;
    RuntimeArray<double> parameters_;
    int active_;
};

/// The same of the model M against its parameter number X. A model without a potential has an unsymmetric tangent.
template <Model M, int X>
class ModelProblem : public EquilibriumProblem {
public:
    static constexpr bool symmetric = PotentialModel<M>;  ///< K is a Hessian
    static constexpr int n = n_unknowns<M>;               ///< number of unknowns

    /// parameters: entry X is not read.
    explicit ModelProblem(const Parameters<M>& parameters)
        : EquilibriumProblem(derivatives_of<M>(), runtime_array(parameters), X) {}

    /// Of n numbers, with operator[].
    static Vector vector(const auto& q) {
        Vector v(n);
        for (int i = 0; i < n; ++i) v(i) = q[i];
        return v;
    }
    /// The unknowns from a vector of n numbers.
    static Unknowns<M> unknowns(const Vector& v) {
        Unknowns<M> q;
        for (int i = 0; i < n; ++i) q[i] = v(i);
        return q;
    }
};

/// The same for each value of the parameter number Y.
template <Model M, int X, int Y>
struct ModelProblems {
    Parameters<M> parameters;  ///< entries X and Y are not read
    /// The problem at y.
    ModelProblem<M, X> operator()(double y) const { return ModelProblem<M, X>(with_active<Y>(parameters, y)); }
    /// What changes with y: dg/dy, and (dK/dy) v.
    MemberDerivatives member_derivatives(const Eigen::VectorXd& q, double x, double y, const Eigen::VectorXd& v) const {
        const auto [residual, tangent] = (*this)(y).derivatives(Y, q, x);
        return {residual, tangent * v};
    }
};

}  // namespace equilibria
