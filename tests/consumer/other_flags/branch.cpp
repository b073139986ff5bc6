// A branch followed through two folds: vectors and matrices are made on one side and freed on the other.
#include <cstdio>

#include <Eigen/Core>

#include <equilibria/continuation/branch.hpp>

/// x^3 - x = p, in seventeen uncoupled copies.
struct Cubics {
    static constexpr bool symmetric = true;
    Eigen::VectorXd residual(const Eigen::VectorXd& q, double p) const {
        return (q.array().cube() - q.array() - p).matrix();
    }
    Eigen::MatrixXd tangent(const Eigen::VectorXd& q, double) const {
        Eigen::MatrixXd k = (3 * q.array().square() - 1).matrix().asDiagonal();
        return k;
    }
    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& q, double) const {
        return -Eigen::VectorXd::Ones(q.size());
    }
};

int main() {
    equilibria::ContinuationOptions options;
    options.range = {-2, 2};
    const Cubics cubics;
    const Eigen::VectorXd start = Eigen::VectorXd::Constant(17, -1.5);
    const auto branch = equilibria::continue_branch(cubics, start, -1.875, 1, options);
    std::printf("%zu points, %zu critical points\n", branch.points.size(), branch.events.size());
    return branch.points.size() > 5 ? 0 : 1;
}
