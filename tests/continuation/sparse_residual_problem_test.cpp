#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/check_derivatives.hpp>
#include <equilibria/continuation/sparse_residual_problem.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Products, quotients and functions of unknowns at random places; the parameter enters nonlinearly.
class RandomEquations {
public:
    RandomEquations(int n, Generator& generator) {
        for (int i = 0; i < n; ++i) {
            terms_.emplace_back();
            for (int k = 0; k < 4; ++k) terms_.back().push_back(static_cast<int>(uniform(generator, 0, n)));
            weights_.push_back(uniform(generator, -2, 2));
        }
    }
    template <class T>
    Eigen::VectorX<T> residual(const Eigen::VectorX<T>& q, const T& p) const {
        using std::exp, std::sin, std::sqrt;
        Eigen::VectorX<T> g(q.size());
        for (Eigen::Index i = 0; i < q.size(); ++i) {
            const auto& at = terms_[static_cast<std::size_t>(i)];
            const double w = weights_[static_cast<std::size_t>(i)];
            const T product = q(at[0]) * sin(q(at[1]));
            g(i) = w * product + exp(p * q(at[2])) / (2 + q(at[3]) * q(at[3])) - p * p * w + pow(q(at[0]), 3);
            g(i) += sqrt(1 + q(at[1]) * q(at[1]));
        }
        return g;
    }

private:
    std::vector<std::vector<int>> terms_;
    std::vector<double> weights_;
};

/// A chain: -sum over neighbours up to `reach` away, and p e^q.
struct Band {
    static constexpr bool symmetric = true;
    Eigen::Index reach;
    template <class T>
    Eigen::VectorX<T> residual(const Eigen::VectorX<T>& q, const T& p) const {
        using std::exp;
        Eigen::VectorX<T> g(q.size());
        for (Eigen::Index i = 0; i < q.size(); ++i) {
            g(i) = 2.0 * static_cast<double>(reach) * q(i) - p * exp(q(i));
            for (Eigen::Index k = 1; k <= reach; ++k) {
                if (i >= k) g(i) -= q(i - k);
                if (i + k < q.size()) g(i) -= q(i + k);
            }
        }
        return g;
    }
    VectorXd weights(const VectorXd& q) const { return VectorXd::Constant(q.size(), 2); }
    int multipliers() const { return 0; }
};

/// Eigen's products of constants and vectors of any number; no equation depends on its own unknown, one on none.
struct Shifted {
    template <class T>
    Eigen::VectorX<T> residual(const Eigen::VectorX<T>& q, const T& p) const {
        MatrixXd m(2, 2);
        m << 1, 2, 3, 4;
        Eigen::VectorX<T> g(4);
        g.head(2) = m.cast<T>() * q.tail(2);
        g(2) = p * q.head(2).squaredNorm();
        g(3) = p;
        return g;
    }
};

struct TooLong {
    template <class T>
    Eigen::VectorX<T> residual(const Eigen::VectorX<T>& q, const T& p) const {
        Eigen::VectorX<T> g = Eigen::VectorX<T>::Constant(q.size() + 1, p);
        g.head(q.size()) += q;
        return g;
    }
};

VectorXd random_vector(Eigen::Index n, Generator& generator) {
    VectorXd v(n);
    for (double& x : v) x = uniform(generator, -1, 1);
    return v;
}
template <class A, class B>
void check_same(const A& a, const B& b, double tolerance) {
    REQUIRE(a.rows() == b.rows());
    REQUIRE(a.cols() == b.cols());
    CHECK((a - b).norm() <= tolerance * (1 + b.norm()));
}
template <class F>
std::string refusal(const F& f) {
    try {
        f();
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return "";
}

static_assert(ContinuationProblem<SparseResidualProblem<Band>> && symmetric_tangent<SparseResidualProblem<Band>>);
static_assert(!symmetric_tangent<SparseResidualProblem<Shifted>>);
static_assert(std::is_same_v<TangentMatrix<SparseResidualProblem<Band>>, Eigen::SparseMatrix<double>>);

template <int Directions>
void compare_with_dense() {
    Generator generator(Directions);
    for (int trial = 0; trial < 12; ++trial) {
        const int n = 1 + 3 * trial;
        const RandomEquations model(n, generator);
        const SparseResidualProblem<RandomEquations, Directions> sparse(model, n);
        const ResidualProblem dense(model);
        const VectorXd q = random_vector(n, generator), v = random_vector(n, generator);
        const double p = uniform(generator, -1, 1), rounding = 1e-14;
        check_same(sparse.residual(q, p), dense.residual(q, p), rounding);
        check_same(MatrixXd(sparse.tangent(q, p)), dense.tangent(q, p), rounding);
        check_same(MatrixXd(sparse.tangent_derivative(q, p, v)), dense.tangent_derivative(q, p, v), rounding);
        check_same(sparse.parameter_derivative(q, p), dense.parameter_derivative(q, p), rounding);
        check_same(sparse.parameter_derivative_along(q, p, v), dense.parameter_derivative_along(q, p, v), rounding);
        check_same(sparse.second_parameter_derivative(q, p), dense.second_parameter_derivative(q, p), rounding);
        // differences know nothing of either
        const double h = 1e-6;
        const VectorXd ahead = dense.residual(q + h * v, p), behind = dense.residual(q - h * v, p);
        check_same(VectorXd(sparse.tangent(q, p) * v), VectorXd((ahead - behind) / (2 * h)), 1e-8);
    }
}

}  // namespace

TEST_CASE("sparse residuals: every derivative is that of the dense problem, on random patterns") {
    compare_with_dense<1>();
    compare_with_dense<4>();
    compare_with_dense<7>();
}

TEST_CASE("sparse residuals: a band takes as many colours as it is wide") {
    for (const Eigen::Index reach : {1, 2, 4}) {
        const SparseResidualProblem problem(Band{reach}, 40);
        CHECK(problem.colours() == 2 * reach + 1);
        CHECK(problem.unknowns() == 40);
        CHECK(problem.pattern().nonZeros() == 40 * (2 * reach + 1) - reach * (reach + 1));
        CHECK(problem.tangent(VectorXd::Zero(40), 0.3).nonZeros() == problem.pattern().nonZeros());
    }
}

TEST_CASE("sparse residuals: the whole diagonal is stored, and no entry that is not in the equations") {
    const SparseResidualProblem problem(Shifted{}, 4);
    CHECK(problem.pattern().nonZeros() == 4 + 4 + 2);
    for (int i = 0; i < 4; ++i) {
        bool stored = false;
        for (Eigen::SparseMatrix<double>::InnerIterator entry(problem.pattern(), i); entry; ++entry)
            stored = stored || entry.row() == i;
        CHECK(stored);
    }
    const VectorXd q = Eigen::Vector4d(0.3, -0.2, 0.5, 0.7);
    check_same(MatrixXd(problem.tangent(q, 0.4)), ResidualProblem(Shifted{}).tangent(q, 0.4), 1e-15);
}

TEST_CASE("sparse residuals: the check of derivatives passes, weights and multipliers are passed on") {
    const SparseResidualProblem problem(Band{2}, 30);
    const DerivativeErrors errors = check_derivatives(problem, VectorXd(VectorXd::LinSpaced(30, -1, 1)), 0.4);
    CHECK(errors.tangent < 1e-8);
    CHECK(errors.symmetry < 1e-14);
    CHECK(errors.parameter_derivative < 1e-8);
    CHECK(errors.tangent_derivative < 1e-8);
    CHECK(errors.parameter_derivative_along < 1e-8);
    CHECK(errors.second_parameter_derivative < 1e-8);
    CHECK(weights(problem, VectorXd(VectorXd::Zero(30)), 30) == VectorXd::Constant(30, 2));
    CHECK(multipliers(problem) == 0);
}

TEST_CASE("sparse residuals: wrong sizes are refused by name") {
    CHECK(refusal([] { SparseResidualProblem(Band{1}, 0); }) == "unknowns = 0: must be at least 1");
    CHECK(refusal([] { SparseResidualProblem(TooLong{}, 5); }) ==
          "size of residual(q, p) = 6: must be the number of unknowns, 5");
    const SparseResidualProblem problem(Band{1}, 5);
    const VectorXd four = VectorXd::Zero(4), five = VectorXd::Zero(5);
    const std::string q_refused = "size of q = 4: must be the number of unknowns, 5";
    CHECK(refusal([&] { problem.residual(four, 0); }) == q_refused);
    CHECK(refusal([&] { problem.tangent(four, 0); }) == q_refused);
    CHECK(refusal([&] { problem.parameter_derivative(four, 0); }) == q_refused);
    CHECK(refusal([&] { problem.second_parameter_derivative(four, 0); }) == q_refused);
    CHECK(refusal([&] { problem.tangent_derivative(four, 0, five); }) == q_refused);
    const std::string v_refused = "size of v = 4: must be the number of unknowns, 5";
    CHECK(refusal([&] { problem.tangent_derivative(five, 0, four); }) == v_refused);
    CHECK(refusal([&] { problem.parameter_derivative_along(five, 0, four); }) == v_refused);
}

TEST_CASE("sparse residuals: the same branch and fold as by the dense problem") {
    const SparseResidualProblem sparse(Band{1}, 20);
    const ResidualProblem dense(Band{1});
    ContinuationOptions options;
    options.range = {0.002, 10};
    const VectorXd zero = VectorXd::Zero(20);
    const auto a = continue_branch(sparse, zero, 0.002, 1, options);
    const auto b = continue_branch(dense, zero, 0.002, 1, options);
    REQUIRE(a.events.size() == 1);
    REQUIRE(b.events.size() == 1);
    CHECK(a.unexplained.empty());
    CHECK(a.events[0].point.kind == CriticalKind::fold);
    CHECK(a.events[0].point.p == Approx(b.events[0].point.p).epsilon(1e-12));
}
