/// \file
/// A model as a parametric continuation problem in a plane of two of its parameters, for the curves of a locus.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/system/critical_system.hpp>

namespace equilibria {

/// ModelProblem with each equation divided by the powers of the parameters X and Y that all its terms have (see
/// CriticalSystem): curves of critical points stay regular up to values at which an equation vanishes identically, as
/// that of a massless link does.
template <Model M, int X, int Y>
class PlaneProblem {
public:
    using Vector = Eigen::VectorXd;
    using Matrix = Eigen::MatrixXd;
    static constexpr bool symmetric = false;
    static constexpr int n = n_unknowns<M>;

    /// parameters: entry X is not read.
    explicit PlaneProblem(const Parameters<M>& parameters) : parameters_(parameters) {}

    Vector residual(const Vector& q, double p) const { return divided(equations<M, double>(unknowns(q), at(p)), p); }
    Matrix tangent(const Vector& q, double p) const {
        return scales(p).asDiagonal().inverse() * Matrix(jacobian<M, double>(unknowns(q), at(p)));
    }
    Vector parameter_derivative(const Vector& q, double p) const {
        Vector y = divided(equilibria::parameter_derivative<M, double>(unknowns(q), at(p), X), p);
        const Vector g = residual(q, p);
        for (int i = 0; i < n; ++i) y(i) -= exponent(i, 0) / p * g(i);
        return y;
    }
    Matrix tangent_derivative(const Vector& q, double p, const Vector& v) const {
        return scales(p).asDiagonal().inverse() *
               Matrix(jacobian_derivative<M, double>(unknowns(q), unknowns(v), at(p)));
    }
    Vector parameter_derivative_along(const Vector& q, double p, const Vector& v) const {
        return tangent_by_parameter<X>(q, p, v);
    }
    /// (dK/dp_Parameter) v, Parameter being X or Y.
    template <int Parameter>
    Vector tangent_by_parameter(const Vector& q, double p, const Vector& v) const {
        const Eigen::Matrix<double, n, 1> fixed = v;
        const Parameters<M> values = at(p);
        const Eigen::Matrix<double, n, 1> y =
            jacobian_parameter_derivative<M, double>(unknowns(q), values, Parameter) * fixed;
        Vector z = divided(y, p);
        const Vector kv = tangent(q, p) * v;
        for (int i = 0; i < n; ++i) z(i) -= exponent(i, Parameter == X ? 0 : 1) / values[Parameter] * kv(i);
        return z;
    }

    /// Of n numbers, with operator[].
    static Vector vector(const auto& q) { return ModelProblem<M, X>::vector(q); }
    static Unknowns<M> unknowns(const Vector& v) { return ModelProblem<M, X>::unknowns(v); }

private:
    using System = CriticalSystem<M, X, Y>;

    static double exponent(int i, int k) { return System::entry().content[i][k] * System::entry().power[k]; }
    Parameters<M> at(double p) const { return with_active<X>(parameters_, p); }
    Vector scales(double p) const {
        Vector y(n);
        for (int i = 0; i < n; ++i) y(i) = std::pow(p, exponent(i, 0)) * std::pow(parameters_[Y], exponent(i, 1));
        return y;
    }
    Vector divided(const auto& f, double p) const { return vector(f).cwiseQuotient(scales(p)); }

    Parameters<M> parameters_;
};

/// The same for each value of the parameter number Y.
template <Model M, int X, int Y>
struct PlaneProblems {
    Parameters<M> parameters;  ///< entries X and Y are not read
    PlaneProblem<M, X, Y> operator()(double y) const { return PlaneProblem<M, X, Y>(with_active<Y>(parameters, y)); }
};

}  // namespace equilibria
