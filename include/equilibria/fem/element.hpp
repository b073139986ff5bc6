/// \file
/// What an element is. A struct of yours becomes one by naming its nodes and what it uses of them, and one function:
///
///     struct Spring {                                          // between two nodes
///         static constexpr int n_nodes = 2;
///         static constexpr auto components = fem::positions;   // or spatial, planar, planar_positions, or your own
///         double stiffness, length;
///         template <class T>                                   // double or a dual
///         T energy(const std::array<fem::Frame<T>, 2>& at, const T& p) const {
///             using std::sqrt;
///             const Vector3<T> d = at[1].x - at[0].x;
///             const T stretch = sqrt(d.dot(d)) - length;
///             return 0.5 * stiffness * stretch * stretch;
///         }
///     };
///     model.add(Spring{3, 1}, {a, b});
///
/// The function is one of
///     T energy(at, p)                                  forces and stiffness follow by dual numbers, exactly
///     Eigen::Matrix<T, m, 1> constraints(at, p)        with `static constexpr int n_constraints = m`: m equations = 0,
///                                                      held by multipliers with the augmented Lagrangian (12)-(15)
///     Eigen::Matrix<T, n, 1> residual(at, p)           n = nodes times components: minus the forces (spatial) and
///                                                      moments (material), where they have no energy
///     void evaluate(at, p, Need, ElementValues&)       all by hand, where speed matters; `static constexpr bool
///                                                      conservative = false` where the tangent is not symmetric
///     void evaluate(at, multipliers, p, ConstraintScale, Need, ElementValues&)
///                                                      the same, with `static constexpr int n_multipliers`
/// An element may also say what it carries: `static constexpr std::array force_names{"N"}` of const char*, and
///     std::vector<InternalForce> forces(at, const ElementQuery&)
/// where it has no constraints; those say force_names alone, of minus their multipliers' forces.
/// p is the load parameter; an element that does not change with it may say so by `static constexpr bool
/// depends_on_parameter = false`: it is not asked for derivatives by p then. Derivatives are those by increments of the
/// nodes at increment 0: x + dx, R exp(dPsi). Numbers in brackets: equations of Cardona and Huespe, Evaluation of
/// simple bifurcation points and post-critical path in large finite rotation problems, Comput. Methods Appl. Mech.
/// Engrg. 175 (1999).
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/dual.hpp>
#include <equilibria/fem/frame.hpp>

namespace equilibria::fem {

/// Loads and prescribed motions of size p (the load parameter), or constant ones.
enum class LoadKind { proportional, constant };

/// What is asked of an element.
enum class Need { residual, tangent, parameter_derivative };

/// What it answers: its unknowns are the components of its first node, of the next one and so on, then its multipliers.
struct ElementValues {
    Eigen::VectorXd residual;              ///< of the energy, its gradient
    Eigen::MatrixXd tangent;               ///< derivative of the residual
    Eigen::VectorXd parameter_derivative;  ///< of the residual by p
};

/// The augmented Lagrangian's numbers, one of each for a structure: k lambda Phi + rho |Phi|^2 / 2 (12).
struct ConstraintScale {
    double multiplier = 1;  ///< k: unknowns are lambda, forces k lambda
    double penalty = 1;     ///< rho
};

/// What is asked of an element at the frames of its nodes.
struct ElementQuery {
    const double* multipliers;  ///< its own, lambda
    double p;                   ///< the load parameter
    ConstraintScale scale;      ///< of the augmented Lagrangian
    Need need;                  ///< which of its values are computed
};

/// What an element carries at one of its points.
struct InternalForce {
    Eigen::Vector3d place;       ///< in fixed axes, of the deformed element
    std::vector<double> values;  ///< forces and moments, in the order of their names
};

namespace detail {

template <class E, class T>
using Frames = std::array<Frame<T>, static_cast<std::size_t>(E::n_nodes)>;

template <class E>
concept NamesItsNodes = requires {
    { E::n_nodes } -> std::convertible_to<int>;
    { E::components[0] } -> std::convertible_to<Component>;
};
template <class E>
concept WithEnergy = NamesItsNodes<E> && requires(const E& e, const Frames<E, double>& at, double p) {
    { e.energy(at, p) } -> std::convertible_to<double>;
};
template <class E>
concept WithConstraints = NamesItsNodes<E> && requires(const E& e, const Frames<E, double>& at, double p) {
    { E::n_constraints } -> std::convertible_to<int>;
    { e.constraints(at, p) } -> std::convertible_to<Eigen::VectorXd>;
};
template <class E>
concept WithResidual = NamesItsNodes<E> && requires(const E& e, const Frames<E, double>& at, double p) {
    { e.residual(at, p) } -> std::convertible_to<Eigen::VectorXd>;
};
template <class E>
concept WithValues = NamesItsNodes<E> && requires(const E& e, const Frames<E, double>& at, double p,
                                                  ElementValues& out) { e.evaluate(at, p, Need::residual, out); };
template <class E>
concept WithMultipliers =
    NamesItsNodes<E> && requires(const E& e, const Frames<E, double>& at, double p, ElementValues& out) {
        { E::n_multipliers } -> std::convertible_to<int>;
        e.evaluate(at, &p, p, ConstraintScale{}, Need::residual, out);
    };

template <class E>
concept WithForces = requires {
    { E::force_names[0] } -> std::convertible_to<std::string>;
};

}  // namespace detail

/// An element; see the file.
template <class E>
concept Element = detail::WithEnergy<E> || detail::WithConstraints<E> || detail::WithResidual<E> ||
                  detail::WithValues<E> || detail::WithMultipliers<E>;

/// How many multipliers an element brings.
template <Element E>
inline constexpr int multipliers_of = [] {
    if constexpr (detail::WithConstraints<E>)
        return E::n_constraints;
    else if constexpr (detail::WithMultipliers<E>)
        return E::n_multipliers;
    else
        return 0;
}();

/// How many unknowns of nodes an element has.
template <Element E>
inline constexpr int node_unknowns_of = E::n_nodes * static_cast<int>(E::components.size());

/// Whether its residual changes with p: so unless it says `depends_on_parameter = false`.
template <Element E>
inline constexpr bool depends_on_parameter = [] {
    if constexpr (requires { E::depends_on_parameter; })
        return static_cast<bool>(E::depends_on_parameter);
    else
        return true;
}();

/// Whether its tangent is symmetric: so unless it has a residual alone, or says `conservative = false`.
template <Element E>
inline constexpr bool is_conservative = [] {
    if constexpr (requires { E::conservative; })
        return static_cast<bool>(E::conservative);
    else
        return !detail::WithResidual<E>;
}();

namespace detail {

/// The frames moved by increments u, by components; exact to second order, which is all that derivatives at 0 ask for.
template <class E, class T>
Frames<E, T> moved(const Frames<E, double>& at, const Eigen::VectorX<T>& u) {
    Frames<E, T> y;
    Eigen::Index next = 0;
    for (std::size_t k = 0; k < y.size(); ++k) {
        Vector3<T> x, half = Vector3<T>::Constant(T(0.0));
        for (int c = 0; c < 3; ++c) x(c) = T(at[k].x(c));
        bool turned = false;
        for (const Component c : E::components) {
            if (c < rx)
                x(c) = x(c) + u(next++);
            else
                half(c - rx) = 0.5 * u(next++), turned = true;
        }
        y[k].x = x;
        const auto& q = at[k].q;
        y[k].q = Eigen::Quaternion<T>(T(q.w()), T(q.x()), T(q.y()), T(q.z()));
        if (turned) y[k].q = y[k].q * Eigen::Quaternion<T>(T(1.0) - 0.5 * half.dot(half), half(0), half(1), half(2));
    }
    return y;
}

/// A number with derivatives along two directions.
using Hyper = Dual<Dual<double, 1>, 1>;

/// The frames with unknowns i and j as the two directions; number own is p.
template <class E>
std::pair<Frames<E, Hyper>, Hyper> along(const Frames<E, double>& at, double p, int i, int j) {
    constexpr int own = node_unknowns_of<E>;
    Eigen::VectorX<Hyper> u = Eigen::VectorX<Hyper>::Constant(own + 1, Hyper(0.0));
    u(own) = Hyper(p);
    u(i).derivative[0].value += 1;
    u(j).value.derivative[0] += 1;
    const Hyper parameter = u(own);
    return {moved<E, Hyper>(at, u), parameter};
}

/// Of an energy: its gradient, its Hessian, or its gradient's derivative by p.
template <class E>
void evaluate_energy(const E& element, const Frames<E, double>& at, double p, Need need, ElementValues& out) {
    constexpr int own = node_unknowns_of<E>;
    for (int i = 0; i < own; ++i)
        for (int j = need == Need::tangent ? i : own; j <= (need == Need::tangent ? own - 1 : own); ++j) {
            const auto [frames, parameter] = along<E>(at, p, i, j);
            const Hyper f = element.energy(frames, parameter);
            if (need == Need::residual) out.residual(i) = f.derivative[0].value;
            if (need == Need::parameter_derivative) out.parameter_derivative(i) = f.derivative[0].derivative[0];
            if (need == Need::tangent) out.tangent(i, j) = out.tangent(j, i) = f.derivative[0].derivative[0];
        }
}

/// Of constraints: the same of k lambda Phi + rho |Phi|^2 / 2, by nodes' unknowns and multipliers.
template <class E>
void evaluate_constraints(const E& element, const Frames<E, double>& at, const ElementQuery& query,
                          ElementValues& out) {
    const auto& [multipliers, p, scale, need] = query;
    constexpr int own = node_unknowns_of<E>, m = E::n_constraints;
    if (need == Need::tangent) out.tangent.template bottomRightCorner<m, m>().setZero();
    for (int i = 0; i < own; ++i)
        for (int j = need == Need::tangent ? i : own; j <= (need == Need::tangent ? own - 1 : own); ++j) {
            const auto [frames, parameter] = along<E>(at, p, i, j);
            const Eigen::Matrix<Hyper, m, 1> phi = element.constraints(frames, parameter);
            double force = 0, second = 0;
            for (int k = 0; k < m; ++k) {
                const double value = phi(k).value.value, by_i = phi(k).derivative[0].value,
                             by_j = phi(k).value.derivative[0], by_ij = phi(k).derivative[0].derivative[0];
                const double total = scale.multiplier * multipliers[k] + scale.penalty * value;
                force += total * by_i;
                second += total * by_ij + scale.penalty * by_i * by_j;
                if (need == Need::residual) out.residual(own + k) = scale.multiplier * value;
                if (need == Need::parameter_derivative) out.parameter_derivative(own + k) = scale.multiplier * by_j;
                if (need == Need::tangent) out.tangent(own + k, i) = out.tangent(i, own + k) = scale.multiplier * by_i;
            }
            if (need == Need::residual) out.residual(i) = force;
            if (need == Need::parameter_derivative) out.parameter_derivative(i) = second;
            if (need == Need::tangent) out.tangent(i, j) = out.tangent(j, i) = second;
        }
}

/// The moments m of a residual are by the spin of their nodes, the unknowns increments Psi: their derivative has the
/// part D(T^T m) d = d x m / 2 at Psi = 0.
template <class E>
void add_chart_term(const auto& residual, Eigen::MatrixXd& tangent) {
    constexpr int each = static_cast<int>(E::components.size());
    for (int k = 0; k < E::n_nodes; ++k) {
        Vector3<double> moment = Vector3<double>::Zero();
        for (int c = 0; c < each; ++c)
            if (E::components[c] >= rx)
                moment(E::components[c] - rx) = equilibria::detail::without_derivatives(residual(each * k + c));
        const Matrix3<double> s = skew(moment);
        for (int r = 0; r < each; ++r)
            for (int c = 0; c < each; ++c)
                if (E::components[r] >= rx && E::components[c] >= rx)
                    tangent(each * k + r, each * k + c) -= 0.5 * s(E::components[r] - rx, E::components[c] - rx);
    }
}

/// Residual, tangent or parameter derivative of an element, whichever functions it has.
template <Element E>
void evaluate(const E& element, const Frames<E, double>& at, const ElementQuery& query, ElementValues& out) {
    [[maybe_unused]] const auto& [multipliers, p, scale, need] = query;
    [[maybe_unused]] constexpr int own = node_unknowns_of<E>;
    if constexpr (WithValues<E>) {
        element.evaluate(at, p, need, out);
    } else if constexpr (WithMultipliers<E>) {
        element.evaluate(at, multipliers, p, scale, need, out);
    } else if constexpr (WithResidual<E>) {
        if (need == Need::residual) {
            out.residual = element.residual(at, p);
            return;
        }
        using T = Dual<double, 1>;
        for (int k = need == Need::tangent ? 0 : own; k <= (need == Need::tangent ? own - 1 : own); ++k) {
            Eigen::VectorX<T> u = Eigen::VectorX<T>::Constant(own + 1, T(0.0));
            u(own) = T(p);
            u(k).derivative[0] = 1;
            const Eigen::VectorX<T> r = element.residual(moved<E, T>(at, u), T(u(own)));
            for (int i = 0; i < own; ++i)
                (need == Need::tangent ? out.tangent(i, k) : out.parameter_derivative(i)) = r(i).derivative[0];
            if (need == Need::tangent && k == own - 1) add_chart_term<E>(r, out.tangent);
        }
    } else if constexpr (WithConstraints<E>) {
        evaluate_constraints(element, at, query, out);
    } else {
        evaluate_energy(element, at, p, need, out);
    }
}

}  // namespace detail

/// Elements of one kind, with their nodes: what a structure sees of them.
class ElementGroup {
public:
    explicit ElementGroup(LoadKind kind) : kind_(kind) {}  ///< a group without elements
    virtual ~ElementGroup() = default;
    /// A constant group is evaluated at p = 1, whatever the load parameter.
    LoadKind kind() const { return kind_; }
    virtual std::unique_ptr<ElementGroup> clone() const = 0;  ///< a copy
    virtual std::size_t size() const = 0;                     ///< how many elements
    /// The nodes of element e.
    virtual const int* nodes(std::size_t e) const = 0;
    virtual int n_nodes() const = 0;                  ///< of each element
    virtual int n_components() const = 0;             ///< of each node that the elements use
    virtual const Component* components() const = 0;  ///< n_components() of them, in the order of the unknowns
    virtual int multipliers() const = 0;              ///< of each element
    virtual bool conservative() const = 0;            ///< every tangent is symmetric
    virtual bool depends_on_parameter() const = 0;    ///< a residual may change with p
    /// Of element e, whose nodes are taken from `frames`, all of the structure's.
    virtual void evaluate(std::size_t e, const Frame<double>* frames, const ElementQuery& query,
                          ElementValues& out) const = 0;
    /// Names of what the elements carry; none where they do not say.
    virtual std::vector<std::string> force_names() const { return {}; }
    /// What element e carries, at each of its points.
    virtual std::vector<InternalForce> forces(std::size_t, const Frame<double>*, const ElementQuery&) const {
        return {};
    }
    int unknowns() const { return n_nodes() * n_components() + multipliers(); }  ///< of each element

private:
    LoadKind kind_;
};

/// The elements of type E of a model.
template <Element E>
class ElementGroupOf final : public ElementGroup {
public:
    static constexpr std::size_t count = static_cast<std::size_t>(E::n_nodes);  ///< nodes of an element

    /// A group without elements.
    explicit ElementGroupOf(LoadKind kind = LoadKind::proportional) : ElementGroup(kind) {}
    /// Adds an element with its nodes.
    void add(E element, const std::array<int, count>& nodes) {
        elements_.push_back(std::move(element));
        nodes_.push_back(nodes);
    }
    const E& operator[](std::size_t e) const { return elements_[e]; }  ///< the e-th of them

    std::unique_ptr<ElementGroup> clone() const override { return std::make_unique<ElementGroupOf>(*this); }
    std::size_t size() const override { return elements_.size(); }
    const int* nodes(std::size_t e) const override { return nodes_[e].data(); }
    int n_nodes() const override { return E::n_nodes; }
    int n_components() const override { return static_cast<int>(E::components.size()); }
    const Component* components() const override { return E::components.data(); }
    int multipliers() const override { return multipliers_of<E>; }
    bool conservative() const override { return is_conservative<E>; }
    bool depends_on_parameter() const override { return fem::depends_on_parameter<E>; }
    void evaluate(std::size_t e, const Frame<double>* frames, const ElementQuery& query,
                  ElementValues& out) const override {
        detail::Frames<E, double> at;
        for (std::size_t k = 0; k < count; ++k) at[k] = frames[nodes_[e][k]];
        detail::evaluate(elements_[e], at, query, out);
    }
    std::vector<std::string> force_names() const override {
        if constexpr (detail::WithForces<E>) return {E::force_names.begin(), E::force_names.end()};
        return {};
    }
    std::vector<InternalForce> forces(std::size_t e, const Frame<double>* frames,
                                      const ElementQuery& query) const override {
        detail::Frames<E, double> at;
        for (std::size_t k = 0; k < count; ++k) at[k] = frames[nodes_[e][k]];
        if constexpr (detail::WithForces<E> && detail::WithConstraints<E>) {
            const auto phi = elements_[e].constraints(at, query.p);
            InternalForce y{at[0].x, {}};
            for (int k = 0; k < E::n_constraints; ++k)
                y.values.push_back(-query.scale.multiplier * query.multipliers[k] - query.scale.penalty * phi(k));
            return {y};
        } else if constexpr (detail::WithForces<E>) {
            return elements_[e].forces(at, query);
        }
        return {};
    }

private:
    std::vector<E> elements_;
    std::vector<std::array<int, count>> nodes_;
};

}  // namespace equilibria::fem
