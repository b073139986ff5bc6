/// \file
/// A problem whose type is not known. What follows branches and finds what happens on them is compiled once, for dense
/// and for sparse tangents, and reaches a problem's functions (problem.hpp) through this; the functions and classes
/// that take a problem of a type of its own are thin fronts, which put configurations into AnyConfiguration and back.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/problem.hpp>

namespace equilibria {

/// A configuration of whatever type; copies share it.
class AnyConfiguration {
public:
    AnyConfiguration() = default;
    /// Made of a configuration of the type Q.
    template <class Q>
    static AnyConfiguration of(Q q) {
        AnyConfiguration y;
        y.value_ = std::make_shared<const Q>(std::move(q));
        return y;
    }
    /// Q: the type that it was made of.
    template <class Q>
    const Q& as() const {
        return *static_cast<const Q*>(value_.get());
    }

private:
    std::shared_ptr<const void> value_;
};

/// Each of them as a configuration of any type.
template <class Q>
std::vector<AnyConfiguration> erased_configurations(const std::vector<Q>& all) {
    std::vector<AnyConfiguration> y;
    for (const Q& q : all) y.push_back(AnyConfiguration::of(q));
    return y;
}

/// What a problem promises, and which of the optional functions it has.
struct ProblemProperties {
    bool symmetric = true;                     ///< K is symmetric
    bool control = false;                      ///< it has control(q, p)
    bool transport = false;                    ///< transport(q, increment, v)
    bool multipliers = false;                  ///< multipliers()
    bool tangent_derivative = false;           ///< tangent_derivative(q, p, v)
    bool parameter_derivative_along = false;   ///< parameter_derivative_along(q, p, v)
    bool second_parameter_derivative = false;  ///< second_parameter_derivative(q, p)
};

namespace detail {

/// The functions of a problem, defaults in place of those that it has not.
template <class Matrix>
class ProblemFunctions {
public:
    using Vector = Eigen::VectorXd;
    using Q = AnyConfiguration;

    virtual ~ProblemFunctions() = default;
    virtual Vector residual(const Q& q, double p) const = 0;
    virtual Matrix tangent(const Q& q, double p) const = 0;
    virtual Vector parameter_derivative(const Q& q, double p) const = 0;
    virtual Linearization<Matrix> linearization(const Q& q, double p) const = 0;
    virtual Q retract(const Q& q, const Vector& increment) const = 0;
    virtual Vector transport(const Q& q, const Vector& increment, const Vector& v) const = 0;
    virtual Vector difference(const Q& q, const Q& near) const = 0;
    virtual Q rebase(const Q& q, double p) const = 0;
    virtual Vector weights(const Q& q, Eigen::Index size) const = 0;
    virtual Matrix tangent_derivative(const Q& q, double p, const Vector& v) const = 0;
    virtual Vector parameter_derivative_along(const Q& q, double p, const Vector& v) const = 0;
    virtual Vector second_parameter_derivative(const Q& q, double p) const = 0;
    virtual double control(const Q& q, double p) const = 0;
    virtual Direction control_gradient(const Q& q, double p, Eigen::Index size) const = 0;
    virtual std::vector<Q> images(const Q& q) const = 0;
    virtual Q image(const Q& q, std::size_t k) const = 0;
};

/// Of a problem of type P, which must outlive it.
template <ContinuationProblem P>
class ProblemFunctionsOf final : public ProblemFunctions<TangentMatrix<P>> {
public:
    using Vector = Eigen::VectorXd;
    using Matrix = TangentMatrix<P>;
    using Q = AnyConfiguration;

    explicit ProblemFunctionsOf(const P& problem) : problem_(&problem) {}

    Vector residual(const Q& q, double p) const override { return problem_->residual(of(q), p); }
    Matrix tangent(const Q& q, double p) const override { return problem_->tangent(of(q), p); }
    Vector parameter_derivative(const Q& q, double p) const override {
        return problem_->parameter_derivative(of(q), p);
    }
    Linearization<Matrix> linearization(const Q& q, double p) const override {
        return equilibria::linearization(*problem_, of(q), p);
    }
    Q retract(const Q& q, const Vector& increment) const override {
        return Q::of(equilibria::retract(*problem_, of(q), increment));
    }
    Vector transport(const Q& q, const Vector& increment, const Vector& v) const override {
        return equilibria::transport(*problem_, of(q), increment, v);
    }
    Vector difference(const Q& q, const Q& near) const override {
        return equilibria::difference(*problem_, of(q), of(near));
    }
    Q rebase(const Q& q, double p) const override {
        if constexpr (requires { problem_->rebase(of(q), p); })
            return Q::of(equilibria::rebase(*problem_, of(q), p));
        else
            return q;
    }
    Vector weights(const Q& q, Eigen::Index size) const override { return equilibria::weights(*problem_, of(q), size); }
    Matrix tangent_derivative(const Q& q, double p, const Vector& v) const override {
        return equilibria::tangent_derivative(*problem_, of(q), p, v);
    }
    Vector parameter_derivative_along(const Q& q, double p, const Vector& v) const override {
        return equilibria::parameter_derivative_along(*problem_, of(q), p, v);
    }
    Vector second_parameter_derivative(const Q& q, double p) const override {
        return equilibria::second_parameter_derivative(*problem_, of(q), p);
    }
    double control([[maybe_unused]] const Q& q, [[maybe_unused]] double p) const override {
        if constexpr (Controlled<P>)
            return problem_->control(of(q), p);
        else
            return 0;
    }
    Direction control_gradient([[maybe_unused]] const Q& q, [[maybe_unused]] double p,
                               Eigen::Index size) const override {
        if constexpr (Controlled<P>)
            return equilibria::control_gradient(*problem_, of(q), p, size);
        else
            return {Vector::Zero(size), 0};
    }
    std::vector<Q> images([[maybe_unused]] const Q& q) const override {
        if constexpr (requires { problem_->images(of(q)); })
            return erased_configurations<Configuration<P>>(problem_->images(of(q)));
        else
            return {};
    }

    Q image(const Q& q, std::size_t k) const override {
        if constexpr (requires { problem_->image(of(q), k); })
            return Q::of(problem_->image(of(q), k));
        else
            return images(q).at(k);
    }

private:
    static const Configuration<P>& of(const Q& q) { return q.as<Configuration<P>>(); }

    const P* problem_;
};

template <ContinuationProblem P>
ProblemProperties properties_of() {
    using Q = Configuration<P>;
    ProblemProperties y;
    y.symmetric = symmetric_tangent<P>;
    y.control = Controlled<P>;
    y.transport = requires(const P& f, const Q& q, const Eigen::VectorXd& v) { f.transport(q, v, v); };
    y.multipliers = requires(const P& f) { f.multipliers(); };
    y.tangent_derivative =
        requires(const P& f, const Q& q, const Eigen::VectorXd& v) { f.tangent_derivative(q, 0.0, v); };
    y.parameter_derivative_along =
        requires(const P& f, const Q& q, const Eigen::VectorXd& v) { f.parameter_derivative_along(q, 0.0, v); };
    y.second_parameter_derivative = requires(const P& f, const Q& q) { f.second_parameter_derivative(q, 0.0); };
    return y;
}

}  // namespace detail

/// A problem of any type whose tangent is a Matrix, Eigen::MatrixXd or Eigen::SparseMatrix<double>; copies share it.
template <class Matrix>
class AnyProblem {
public:
    using Vector = Eigen::VectorXd;  ///< residuals and increments, n entries
    using Q = AnyConfiguration;      ///< a configuration

    /// The problem must outlive it.
    template <ContinuationProblem P>
    requires(std::is_same_v<TangentMatrix<P>, Matrix>)
    explicit AnyProblem(const P& problem)
        : functions_(std::make_shared<const detail::ProblemFunctionsOf<P>>(problem)),
          properties_(detail::properties_of<P>()), multipliers_(equilibria::multipliers(problem)),
          symmetric_factors_(equilibria::symmetric_factors(problem)) {}

    const ProblemProperties& properties() const { return properties_; }  ///< what the problem's type promises
    int multipliers() const { return multipliers_; }  ///< how many of the last unknowns are Lagrange multipliers
    /// What factors a sparse symmetric K; null: SparseLDLT.
    MakeSymmetricFactors symmetric_factors() const { return symmetric_factors_; }

    /// A function of the problem, see problem.hpp: its own, or the default where it has none.
    /// \{
    Vector residual(const Q& q, double p) const { return functions_->residual(q, p); }
    Matrix tangent(const Q& q, double p) const { return functions_->tangent(q, p); }
    Vector parameter_derivative(const Q& q, double p) const { return functions_->parameter_derivative(q, p); }
    Linearization<Matrix> linearization(const Q& q, double p) const { return functions_->linearization(q, p); }
    Q retract(const Q& q, const Vector& increment) const { return functions_->retract(q, increment); }
    Vector transport(const Q& q, const Vector& increment, const Vector& v) const {
        return functions_->transport(q, increment, v);
    }
    Vector difference(const Q& q, const Q& near) const { return functions_->difference(q, near); }
    Q rebase(const Q& q, double p) const { return functions_->rebase(q, p); }
    Vector weights(const Q& q, Eigen::Index size) const { return functions_->weights(q, size); }
    Matrix tangent_derivative(const Q& q, double p, const Vector& v) const {
        return functions_->tangent_derivative(q, p, v);
    }
    Vector parameter_derivative_along(const Q& q, double p, const Vector& v) const {
        return functions_->parameter_derivative_along(q, p, v);
    }
    Vector second_parameter_derivative(const Q& q, double p) const {
        return functions_->second_parameter_derivative(q, p);
    }
    double control(const Q& q, double p) const { return functions_->control(q, p); }
    Direction control_gradient(const Q& q, double p, Eigen::Index size) const {
        return functions_->control_gradient(q, p, size);
    }
    /// \}
    /// None where the problem declares no symmetry.
    std::vector<Q> images(const Q& q) const { return functions_->images(q); }
    /// Number k of them.
    Q image(const Q& q, std::size_t k) const { return functions_->image(q, k); }

private:
    std::shared_ptr<const detail::ProblemFunctions<Matrix>> functions_;
    ProblemProperties properties_;
    int multipliers_;
    MakeSymmetricFactors symmetric_factors_;
};

/// What a problem of the type P becomes.
template <ContinuationProblem P>
using AnyProblemOf = AnyProblem<TangentMatrix<P>>;

/// In place of a problem's type: BranchPoint<Erased> is a point of a branch of a problem of any type.
struct Erased {
    using Configuration = AnyConfiguration;  ///< what configurations are
};

}  // namespace equilibria
