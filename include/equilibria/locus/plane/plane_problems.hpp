/// \file
/// A model as a parametric continuation problem in a plane of two of its parameters, for the curves of a locus.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Core>

#include <equilibria/continuation/member_derivatives.hpp>
#include <equilibria/core/eigen_copies.hpp>
#include <equilibria/model/model_functions.hpp>
#include <equilibria/system/critical_system.hpp>

namespace equilibria {

/// ModelProblem with each equation divided by the powers of the parameters X and Y that all its terms have (see
/// CriticalSystem): curves of critical points stay regular up to values at which an equation vanishes identically, as
/// that of a massless link does.
class PlaneProblem {
public:
    using Vector = Eigen::VectorXd;           ///< residuals, unknowns and increments
    using Matrix = Eigen::MatrixXd;           ///< n x n, dense
    static constexpr bool symmetric = false;  ///< the division of its rows leaves K unsymmetric

    /// parameters: the entry of x is not read. system: of the plane, has to outlive it. sizes: of the unknowns, in
    /// lengths; empty: 1.
    PlaneProblem(const ModelDerivatives<>& model, const CriticalSystem& system, RuntimeArray<double> parameters,
                 Vector sizes = {})
        : model_(&model), system_(&system), parameters_(std::move(parameters)), sizes_(std::move(sizes)) {}

    /// A function of a continuation problem (continuation/problem.hpp), exact.
    /// \{
    Vector residual(const Vector& q, double x) const { return divided(equations(*model_, array(q), at(x)), x); }
    Matrix tangent(const Vector& q, double x) const {
        return scales(x).asDiagonal().inverse() * eigen_matrix(jacobian(*model_, array(q), at(x)));
    }
    Vector parameter_derivative(const Vector& q, double x) const { return residual_by_parameter(0, q, x); }
    Matrix tangent_derivative(const Vector& q, double x, const Vector& v) const {
        return scales(x).asDiagonal().inverse() * eigen_matrix(jacobian_derivative(*model_, array(q), array(v), at(x)));
    }
    Vector parameter_derivative_along(const Vector& q, double x, const Vector& v) const {
        return tangent_by_parameter(0, q, x, v);
    }
    Vector weights(const Vector& q) const {
        return sizes_.size() == 0 ? Vector::Ones(q.size()) : Vector(sizes_.cwiseAbs2().cwiseInverse());
    }
    /// \}
    /// dg/dx (axis 0) or dg/dy (axis 1).
    Vector residual_by_parameter(int axis, const Vector& q, double x) const {
        const RuntimeArray<double> values = at(x);
        Vector y = divided(parameter_derivatives(*model_, array(q), values, parameter(axis)).first, x);
        const Vector g = residual(q, x);
        for (int i = 0; i < y.size(); ++i)
            if (exponent(i, axis) != 0) y(i) -= exponent(i, axis) / values[parameter(axis)] * g(i);
        return y;
    }
    /// (dK/dx) v (axis 0) or (dK/dy) v (axis 1).
    Vector tangent_by_parameter(int axis, const Vector& q, double x, const Vector& v) const {
        const RuntimeArray<double> values = at(x);
        const Vector y = eigen_matrix(parameter_derivatives(*model_, array(q), values, parameter(axis)).second) * v;
        Vector z = y.cwiseQuotient(scales(x));
        const Vector kv = tangent(q, x) * v;
        for (int i = 0; i < z.size(); ++i)
            if (exponent(i, axis) != 0) z(i) -= exponent(i, axis) / values[parameter(axis)] * kv(i);
        return z;
    }

private:
    static RuntimeArray<double> array(const Vector& v) { return runtime_array(v); }
    int parameter(int axis) const { return system_->active()[static_cast<std::size_t>(axis)]; }
    double exponent(int i, int axis) const {
        const auto k = static_cast<std::size_t>(axis);
        return system_->entry().content[static_cast<std::size_t>(i)][k] * system_->entry().power[k];
    }
    RuntimeArray<double> at(double x) const {
        RuntimeArray<double> p = parameters_;
        p[parameter(0)] = x;
        return p;
    }
    Vector scales(double x) const {
        Vector y(model_->unknowns());
        for (int i = 0; i < y.size(); ++i)
            y(i) = std::pow(x, exponent(i, 0)) * std::pow(parameters_[parameter(1)], exponent(i, 1));
        return y;
    }
    Vector divided(const RuntimeArray<double>& f, double x) const { return eigen_vector(f).cwiseQuotient(scales(x)); }

    const ModelDerivatives<>* model_;
    const CriticalSystem* system_;
    RuntimeArray<double> parameters_;
    Vector sizes_;
};

/// The same for each value of y.
struct PlaneProblems {
    const ModelDerivatives<>* model;  ///< with its derivatives
    const CriticalSystem* system;     ///< of the plane; knows the powers that are divided by
    RuntimeArray<double> parameters;  ///< the entries of x and y are not read
    Eigen::VectorXd sizes{};          ///< of the unknowns, in lengths; empty: 1
    /// The problem in x at this y.
    PlaneProblem operator()(double y) const {
        RuntimeArray<double> p = parameters;
        p[system->active()[1]] = y;
        return PlaneProblem(*model, *system, std::move(p), sizes);
    }
    /// What changes with y: dg/dy, and (dK/dy) v.
    MemberDerivatives member_derivatives(const Eigen::VectorXd& q, double x, double y, const Eigen::VectorXd& v) const {
        const PlaneProblem member = (*this)(y);
        return {member.residual_by_parameter(1, q, x), member.tangent_by_parameter(1, q, x, v)};
    }
};

}  // namespace equilibria
