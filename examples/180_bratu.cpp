// A differential equation in two dimensions: Bratu's, laplace(u) + lambda e^u = 0 on the unit square, u = 0 on its
// edges. The residual is written once, for any number; its sparse K and all further derivatives are exact. The branch
// from u = 0 turns back at a fold, at lambda = 6.808124423, which three grids tell to seven digits.
#include <cmath>
#include <cstdio>
#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/sparse_residual_problem.hpp>
#include <vector>

struct Bratu {
    static constexpr bool symmetric = true;
    Eigen::Index intervals;  // along an edge

    template <class T>
    Eigen::VectorX<T> residual(const Eigen::VectorX<T>& u, const T& lambda) const {
        using std::exp;
        const Eigen::Index n = intervals - 1;
        const double per_h2 = static_cast<double>(intervals * intervals);
        Eigen::VectorX<T> g(n * n);
        for (Eigen::Index i = 0; i < n * n; ++i) {
            T beside = 0.0;  // outside of the square u is 0
            if (i % n > 0) beside += u(i - 1);
            if (i % n < n - 1) beside += u(i + 1);
            if (i >= n) beside += u(i - n);
            if (i < n * (n - 1)) beside += u(i + n);
            g(i) = per_h2 * (4 * u(i) - beside) - lambda * exp(u(i));
        }
        return g;
    }
    // lengths are root mean squares, so that a step means the same on each grid
    Eigen::VectorXd weights(const Eigen::VectorXd& u) const {
        return Eigen::VectorXd::Constant(u.size(), 1 / static_cast<double>(u.size()));
    }
};

int main() {
    equilibria::ContinuationOptions options;
    options.branch.largest_step = 0.5;
    options.range = {1, 10};
    std::vector<double> folds;
    for (const Eigen::Index intervals : {16, 32, 64}) {
        const Eigen::Index unknowns = (intervals - 1) * (intervals - 1);
        const equilibria::SparseResidualProblem problem(Bratu{intervals}, unknowns);
        const Eigen::VectorXd zero = Eigen::VectorXd::Zero(unknowns);
        const auto branch = continue_branch(problem, zero, 1, 1, options);
        for (const auto& [step, point] : branch.events) {
            std::printf("%4td unknowns, K in %d colours: %s at lambda = %.8f, largest u %.5f\n", unknowns,
                        problem.colours(), to_string(point.kind), point.p, point.q.maxCoeff());
            folds.push_back(point.p);
        }
    }
    // the errors are a h^2 + b h^4 + ..
    for (double factor = 4; folds.size() > 1; factor *= 4) {
        for (std::size_t k = 0; k + 1 < folds.size(); ++k)
            folds[k] = folds[k + 1] + (folds[k + 1] - folds[k]) / (factor - 1);
        folds.pop_back();
    }
    std::printf("extrapolated: %.6f\n", folds[0]);
}

// clang-format off
/* Output:
 225 unknowns, K in 7 colours: fold at lambda = 6.80217410, largest u 1.38886
 961 unknowns, K in 7 colours: fold at lambda = 6.80665273, largest u 1.39096
3969 unknowns, K in 7 colours: fold at lambda = 6.80775749, largest u 1.39149
extrapolated: 6.808124
*/
