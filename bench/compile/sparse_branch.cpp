// A sparse problem of the user's, its branch followed through its fold: u'' + p exp(u) = 0, u(0) = u(1) = 0, by
// differences (G. Bratu, Sur les equations integrales non lineaires, Bull. Soc. Math. France 42, 1914). The fold is at
// p = 3.5138307.
#include <Eigen/SparseCore>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <equilibria/continuation/branch.hpp>
#include <vector>

struct Bratu {
    int n;

    Eigen::VectorXd residual(const Eigen::VectorXd& u, double p) const {
        Eigen::VectorXd r(n);
        for (int i = 0; i < n; ++i)
            r(i) = 2 * u(i) - (i > 0 ? u(i - 1) : 0) - (i < n - 1 ? u(i + 1) : 0) - p * width2() * std::exp(u(i));
        return r;
    }
    Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& u, double p) const {
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < n; ++i) {
            entries.emplace_back(i, i, 2 - p * width2() * std::exp(u(i)));
            if (i > 0) entries.emplace_back(i, i - 1, -1.0);
            if (i < n - 1) entries.emplace_back(i, i + 1, -1.0);
        }
        Eigen::SparseMatrix<double> k(n, n);
        k.setFromTriplets(entries.begin(), entries.end());
        return k;
    }
    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& u, double) const {
        return -width2() * u.array().exp().matrix();
    }

private:
    double width2() const { return 1.0 / ((n + 1.0) * (n + 1.0)); }
};

int main() {
    const Bratu bratu{1000};
    const auto branch = equilibria::continue_branch(bratu, Eigen::VectorXd::Zero(bratu.n), 0.0, 1, {.range = {-1, 5}});
    double fold = 0;
    for (const auto& [step, point] : branch.events) {
        std::printf("%s at p = %.8f\n", std::string(to_string(point.kind)).c_str(), point.p);
        fold = point.p;
    }
    return branch.events.size() == 1 && std::abs(fold - 3.5138307) < 1e-5 ? EXIT_SUCCESS : EXIT_FAILURE;
}
