// Corrections by GMRES with the last factors: the same branch, with fewer factorisations.
#include <cmath>
#include <limits>
#include <memory>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>

#include "../programs/support/fields.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using namespace support;

namespace {

/// SparseLDLT that counts.
class CountedFactors final : public SymmetricFactors {
public:
    explicit CountedFactors(int multipliers) : factors_(multipliers) {}
    using SymmetricFactors::factor;
    bool factor(const Matrix& k, const RemovedUnknown& removed) override {
        ++count;
        return factors_.factor(k, removed);
    }
    Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const override { return factors_.solve(f); }
    int negative() const override { return factors_.negative(); }
    Eigen::Index fill() const override { return factors_.fill(); }
    double work() const override { return factors_.work(); }

    static inline int count = 0;

private:
    SparseLDLT factors_;
};

template <class Problem>
struct Counted : Problem {
    MakeSymmetricFactors symmetric_factors() const {
        return [](int multipliers) -> std::unique_ptr<SymmetricFactors> {
            return std::make_unique<CountedFactors>(multipliers);
        };
    }
};

}  // namespace

TEST_CASE("Corrections with the last factors lead to the same branch with fewer factorisations") {
    const auto problem = sparse(Bratu(2, 12));
    const Counted<std::remove_cvref_t<decltype(problem)>> counted{problem};
    ContinuationOptions options;
    options.branch.largest_step = 0.5;
    options.range = {1, 20};
    options.most_steps = 60;
    // those with a value of their own beside the gradient as well
    options.branch.constraint = GENERATE(StepConstraint::normal_plane, StepConstraint::sphere);
    const auto follow = [&](double iterate_from) {
        options.branch.iterate_from = iterate_from;
        CountedFactors::count = 0;
        return continue_branch(counted, Eigen::VectorXd(Eigen::VectorXd::Zero(problem.unknowns())), 1.0, 1, options);
    };
    const auto factored = follow(std::numeric_limits<double>::infinity());
    const int factorisations = CountedFactors::count;
    const auto iterated = follow(0);
    CHECK(3 * CountedFactors::count < 2 * factorisations);
    CAPTURE(factorisations, CountedFactors::count);

    REQUIRE(factored.events.size() == iterated.events.size());
    for (std::size_t k = 0; k < factored.events.size(); ++k) {
        CHECK(std::abs(factored.events[k].point.p - iterated.events[k].point.p) < 1e-9);
        CHECK(factored.events[k].point.kind == iterated.events[k].point.kind);
    }
    CHECK(iterated.unexplained.empty());
    for (const auto& point : iterated.points) {
        CHECK(point.residual < 1e-9);
        // the point's own inertia
        const Eigen::MatrixXd k = problem.tangent(point.q, point.p);
        const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues();
        CHECK(point.negative == (values.array() < 0).count());
    }
}
