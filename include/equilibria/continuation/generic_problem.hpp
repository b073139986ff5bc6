/// \file
/// Problems whose functions are generic over the scalar: one function is written, and every derivative that a
/// continuation can use is exact, by nested dual numbers (core/dual.hpp). Either the energy,
///
///     struct Arch {
///         double l;
///         template <class T>
///         T energy(const Eigen::VectorX<T>& a, const T& p) const {
///             const T bend = a(0) - l, stretch = a(0) * a(0) + 4 * a(1) * a(1) - l * l;
///             return 0.5 * bend * bend + 8 * a(1) * a(1) + 0.25 * stretch * stretch + p * a(0);
///         }
///     };
///     const EnergyProblem problem(Arch{2.5});
///     const auto branch = continue_branch(problem, Eigen::VectorXd(Eigen::Vector2d(2.5, 0)), 0, 1);
///
/// or, where forces have no potential, the equations themselves:
///
///     struct Follower {
///         static constexpr bool symmetric = false;   // the default; true promises a symmetric K
///         template <class T>
///         Eigen::VectorX<T> residual(const Eigen::VectorX<T>& q, const T& p) const;
///     };
///     const ResidualProblem problem(Follower{});
///
/// T is double or a dual. Elementary functions are found by argument: `using std::sin;` and then sin(x). A T has no `<`
/// and enters no function of doubles; matrices of constants are cast, `k.cast<T>() * q`. The square root of a sum of
/// squares has no derivative where all of them are 0.
///
/// Problems are flat, for small n and dense K: the configuration is a vector, and duals cost an evaluation for every
/// entry that is asked for. Of an energy: n for g, n (n + 1) / 2 for K and for dK along a direction, with duals nested
/// one, two and three deep. Of a residual: 1, n and n, with duals none, one and two deep. One level doubles the numbers
/// and triples the products. Structures with sparse K write their derivatives by elements instead.
///
/// weights(q) and multipliers() are passed on where the model has them; see problem.hpp.
#pragma once

#include <concepts>
#include <utility>

#include <Eigen/Core>

#include <equilibria/continuation/problem.hpp>
#include <equilibria/core/dual.hpp>

namespace equilibria {

/// An energy E(q, p) that takes duals for numbers.
template <class M>
concept GenericEnergy = requires(const M& model, const Eigen::VectorX<Dual<double, 1>>& q, const Dual<double, 1>& p) {
    { model.energy(q, p) } -> std::convertible_to<Dual<double, 1>>;
};

/// Equations g(q, p) that take duals for numbers.
template <class M>
concept GenericResidual = requires(const M& model, const Eigen::VectorX<Dual<double, 1>>& q, const Dual<double, 1>& p) {
    { model.residual(q, p) } -> std::convertible_to<Eigen::VectorX<Dual<double, 1>>>;
};

namespace detail {

template <int Order>
struct NestedDual {
    using Lower = typename NestedDual<Order - 1>::type;
    using type = Dual<Lower, 1>;
};
template <>
struct NestedDual<0> {
    using type = double;
};
/// A number with its derivatives along `Order` directions, those of each product of different directions among them.
template <int Order>
using nested_dual = typename NestedDual<Order>::type;

/// x, which changes by by[k] along direction k.
template <int Order>
nested_dual<Order> lifted(double x, const double* by) {
    if constexpr (Order == 0) {
        return x;
    } else {
        nested_dual<Order> y(lifted<Order - 1>(x, by));
        y.derivative[0] = by[Order - 1];
        return y;
    }
}
/// The derivative along all the directions, once each.
template <int Order>
double highest_derivative(const nested_dual<Order>& y) {
    if constexpr (Order == 0)
        return y;
    else
        return highest_derivative<Order - 1>(y.derivative[0]);
}

/// A direction of (q, p) space: an unknown, a vector of increments of q, or the parameter.
class GenericDirection {
public:
    static GenericDirection unknown(Eigen::Index i) { return {nullptr, i, 0}; }
    static GenericDirection vector(const Eigen::VectorXd& v) { return {&v, -1, 0}; }
    static GenericDirection parameter() { return {nullptr, -1, 1}; }

    double q(Eigen::Index i) const { return v_ ? (*v_)(i) : (i == unknown_ ? 1.0 : 0.0); }
    double p() const { return p_; }

private:
    GenericDirection(const Eigen::VectorXd* v, Eigen::Index unknown, double p) : v_(v), unknown_(unknown), p_(p) {}

    const Eigen::VectorXd* v_;
    Eigen::Index unknown_;
    double p_;
};

/// f(q, p) in duals that carry its derivatives along the directions d.
template <class F, std::same_as<GenericDirection>... D>
auto with_derivatives(const F& f, const Eigen::VectorXd& q, double p, const D&... d) {
    constexpr int order = static_cast<int>(sizeof...(d));
    const double change_of_p[] = {d.p()..., 0};
    Eigen::VectorX<nested_dual<order>> x(q.size());
    for (Eigen::Index i = 0; i < q.size(); ++i) {
        const double change[] = {d.q(i)..., 0};
        x(i) = lifted<order>(q(i), change);
    }
    return f(x, lifted<order>(p, change_of_p));
}

/// What both adapters do with the model.
template <class M>
class GenericProblem {
public:
    const M& model() const { return model_; }

    Eigen::VectorXd weights(const Eigen::VectorXd& q) const
    requires requires(const M& m, const Eigen::VectorXd& at) { m.weights(at); }
    {
        return model_.weights(q);
    }
    int multipliers() const
    requires requires(const M& m) { m.multipliers(); }
    {
        return model_.multipliers();
    }

protected:
    explicit GenericProblem(M model) : model_(std::move(model)) {}

    M model_;
};

}  // namespace detail

/// The equilibria of an energy: g = dE/dq, n entries; K its Hessian, n x n.
template <class M>
class EnergyProblem : public detail::GenericProblem<M> {
public:
    static_assert(GenericEnergy<M>,
                  "An energy is a function of any number: template <class T> T energy(const Eigen::VectorX<T>& q, "
                  "const T& p) const.");
    static constexpr bool symmetric = true;  ///< K is a Hessian

    /// model: with a template `energy`, as above.
    explicit EnergyProblem(M model) : detail::GenericProblem<M>(std::move(model)) {}

    double energy(const Eigen::VectorXd& q, double p) const { return derivative(q, p); }  ///< E, the model's own
    /// A function of a continuation problem (problem.hpp), exact.
    /// \{
    Eigen::VectorXd residual(const Eigen::VectorXd& q, double p) const { return gradient(q, p); }
    Eigen::MatrixXd tangent(const Eigen::VectorXd& q, double p) const { return hessian(q, p); }
    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& q, double p) const {
        return gradient(q, p, Along::parameter());
    }
    Eigen::MatrixXd tangent_derivative(const Eigen::VectorXd& q, double p, const Eigen::VectorXd& v) const {
        return hessian(q, p, Along::vector(v));
    }
    Eigen::VectorXd parameter_derivative_along(const Eigen::VectorXd& q, double p, const Eigen::VectorXd& v) const {
        return gradient(q, p, Along::vector(v), Along::parameter());
    }
    Eigen::VectorXd second_parameter_derivative(const Eigen::VectorXd& q, double p) const {
        return gradient(q, p, Along::parameter(), Along::parameter());
    }
    /// \}

private:
    using Along = detail::GenericDirection;

    /// The derivative of E along the directions d.
    template <class... D>
    double derivative(const Eigen::VectorXd& q, double p, const D&... d) const {
        constexpr int order = static_cast<int>(sizeof...(d));
        const auto f = [this](const auto& x, const auto& y) -> detail::nested_dual<order> {
            return this->model_.energy(x, y);
        };
        return detail::highest_derivative<order>(detail::with_derivatives(f, q, p, d...));
    }
    template <class... D>
    Eigen::VectorXd gradient(const Eigen::VectorXd& q, double p, const D&... d) const {
        Eigen::VectorXd y(q.size());
        for (Eigen::Index i = 0; i < q.size(); ++i) y(i) = derivative(q, p, d..., Along::unknown(i));
        return y;
    }
    template <class... D>
    Eigen::MatrixXd hessian(const Eigen::VectorXd& q, double p, const D&... d) const {
        Eigen::MatrixXd y(q.size(), q.size());
        for (Eigen::Index c = 0; c < q.size(); ++c)
            for (Eigen::Index r = c; r < q.size(); ++r)
                y(r, c) = y(c, r) = derivative(q, p, d..., Along::unknown(c), Along::unknown(r));
        return y;
    }
};

/// The solutions of equations without a known potential: g, n entries; K = dg/dq, n x n.
template <class M>
class ResidualProblem : public detail::GenericProblem<M> {
public:
    static_assert(GenericResidual<M>,
                  "Equations are functions of any number: template <class T> Eigen::VectorX<T> residual(const "
                  "Eigen::VectorX<T>& q, const T& p) const.");
    /// As the model promises; false where it says nothing.
    static constexpr bool symmetric = [] {
        if constexpr (requires { M::symmetric; })
            return M::symmetric;
        else
            return false;
    }();

    /// model: with a template `residual`, as above.
    explicit ResidualProblem(M model) : detail::GenericProblem<M>(std::move(model)) {}

    /// A function of a continuation problem (problem.hpp), exact.
    /// \{
    Eigen::VectorXd residual(const Eigen::VectorXd& q, double p) const { return derivative(q, p); }
    Eigen::MatrixXd tangent(const Eigen::VectorXd& q, double p) const { return jacobian(q, p); }
    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& q, double p) const {
        return derivative(q, p, Along::parameter());
    }
    Eigen::MatrixXd tangent_derivative(const Eigen::VectorXd& q, double p, const Eigen::VectorXd& v) const {
        return jacobian(q, p, Along::vector(v));
    }
    Eigen::VectorXd parameter_derivative_along(const Eigen::VectorXd& q, double p, const Eigen::VectorXd& v) const {
        return derivative(q, p, Along::vector(v), Along::parameter());
    }
    Eigen::VectorXd second_parameter_derivative(const Eigen::VectorXd& q, double p) const {
        return derivative(q, p, Along::parameter(), Along::parameter());
    }
    /// \}

private:
    using Along = detail::GenericDirection;

    /// The derivative of g along the directions d.
    template <class... D>
    Eigen::VectorXd derivative(const Eigen::VectorXd& q, double p, const D&... d) const {
        constexpr int order = static_cast<int>(sizeof...(d));
        using T = detail::nested_dual<order>;
        const auto f = [this](const auto& x, const auto& y) -> Eigen::VectorX<T> {
            return this->model_.residual(x, y);
        };
        const Eigen::VectorX<T> g = detail::with_derivatives(f, q, p, d...);
        Eigen::VectorXd y(g.size());
        for (Eigen::Index i = 0; i < g.size(); ++i) y(i) = detail::highest_derivative<order>(g(i));
        return y;
    }
    template <class... D>
    Eigen::MatrixXd jacobian(const Eigen::VectorXd& q, double p, const D&... d) const {
        Eigen::MatrixXd y;
        for (Eigen::Index c = 0; c < q.size(); ++c) {
            const Eigen::VectorXd column = derivative(q, p, d..., Along::unknown(c));
            if (c == 0) y.resize(column.size(), q.size());
            y.col(c) = column;
        }
        return y;
    }
};

}  // namespace equilibria
