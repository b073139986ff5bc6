/// \file
/// The cusps of a model in two of its parameters, x and y, against a third, z, as a continuation problem:
///
///     Y = (q, v, x, y)     [ F(q, p)          ]
///                          [ J(q, p) v        ] = 0
///                          [ (v . v - 1) / 2  ]
///                          [ V'''[v, v, v]    ]
///
/// with exact derivatives: duals through the power series of F along v.
/// Where it fails: next to a symmetric point (theta -> -theta) the system is nearly singular, for on the symmetric
/// branch every pitchfork solves it.
#pragma once

#include <type_traits>

#include <Eigen/Core>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/taylor.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/model/derivatives.hpp>

namespace equilibria {

/// The cusps of a model in its parameters number X and Y, against the parameter number Z: a continuation problem.
template <PotentialModel M, int X, int Y, int Z>
class CuspProblem {
public:
    static constexpr bool symmetric = false;  ///< an augmented system
    static constexpr int n = n_unknowns<M>;   ///< unknowns of the model
    static constexpr int size = 2 * n + 2;    ///< unknowns of this problem, entries of Y

    /// parameters: entries X, Y and Z are not read. x_scale, y_scale: changes that count as much as one of 1.
    CuspProblem(const Parameters<M>& parameters, double x_scale, double y_scale)
        : parameters_(parameters), x_scale_(x_scale), y_scale_(y_scale) {}

    /// A function of a continuation problem (continuation/problem.hpp).
    /// \{
    Eigen::VectorXd residual(const Eigen::VectorXd& at, double z) const {
        const auto r = system<double>(at, z);
        return Eigen::Map<const Eigen::VectorXd>(r.elements, size);
    }
    Eigen::MatrixXd tangent(const Eigen::VectorXd& at, double z) const {
        const auto r = system<Dual<double, size + 1>>(at, z);
        Eigen::MatrixXd k(size, size);
        for (int i = 0; i < size; ++i)
            for (int j = 0; j < size; ++j) k(i, j) = r[i].derivative[j];
        return k;
    }
    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& at, double z) const {
        const auto r = system<Dual<double, size + 1>>(at, z);
        Eigen::VectorXd d(size);
        for (int i = 0; i < size; ++i) d(i) = r[i].derivative[size];
        return d;
    }
    Eigen::VectorXd weights(const Eigen::VectorXd&) const {
        Eigen::VectorXd w = Eigen::VectorXd::Ones(size);
        w(size - 2) = 1 / (x_scale_ * x_scale_);
        w(size - 1) = 1 / (y_scale_ * y_scale_);
        return w;
    }
    /// \}

    /// Y from its parts.
    static Eigen::VectorXd packed(const Unknowns<M>& q, const Unknowns<M>& v, double x, double y) {
        Eigen::VectorXd at(size);
        for (int i = 0; i < n; ++i) at(i) = q[i], at(n + i) = v[i];
        at(size - 2) = x;
        at(size - 1) = y;
        return at;
    }
    /// q of Y.
    static Unknowns<M> unknowns(const Eigen::VectorXd& at) { return part(at, 0); }
    /// v of Y.
    static Unknowns<M> null_vector(const Eigen::VectorXd& at) { return part(at, n); }
    /// All parameters, x and y those of Y.
    Parameters<M> parameters(const Eigen::VectorXd& at, double z) const {
        return with_active<X, Y, Z>(parameters_, at(size - 2), at(size - 1), z);
    }

private:
    static Unknowns<M> part(const Eigen::VectorXd& at, int first) {
        Unknowns<M> y;
        for (int i = 0; i < n; ++i) y[i] = at(first + i);
        return y;
    }

    /// S: double, or a dual with a direction for each entry of Y and then one for z.
    template <class S>
    Array<S, size> system(const Eigen::VectorXd& at, double z) const {
        using Series = Taylor<S, 2>;
        Array<S, size + 1> u;
        for (int k = 0; k <= size; ++k) {
            u[k] = k < size ? at(k) : z;
            if constexpr (!std::is_same_v<S, double>) u[k].derivative[k] = 1;
        }
        // F along v: the coefficients 1 and 2 are J v and F''[v, v] / 2
        Unknowns<M, Series> along;
        Parameters<M, Series> p;
        for (int i = 0; i < n; ++i) along[i] = Series::variable(u[i], u[n + i]);
        for (int k = 0; k < p.size(); ++k) p[k] = parameters_[k];
        p[X] = u[size - 2];
        p[Y] = u[size - 1];
        p[Z] = u[size];
        const auto f = equations<M, Series>(along, p);
        Array<S, size> r;
        r[2 * n] = -0.5;
        r[2 * n + 1] = 0.0;
        for (int i = 0; i < n; ++i) {
            const S& v = u[n + i];
            r[i] = f[i].coefficient[0];
            r[n + i] = f[i].coefficient[1];
            r[2 * n] += 0.5 * v * v;
            r[2 * n + 1] += 2.0 * f[i].coefficient[2] * v;
        }
        return r;
    }

    Parameters<M> parameters_;
    double x_scale_, y_scale_;
};

}  // namespace equilibria
