// Random problems with critical points planted on a branch: none may be missed, none invented, none lost in silence.

#include <Eigen/Core>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

struct Planted {
    double at;  ///< the path's coordinate y_0
    CriticalKind kind;
};

/// V = F(y_0) - p y_0 + sum slope_k (y_0 - at_k) y_k^2 / 2 + cubic_k y_k^3 / 3 + quartic_k y_k^4 / 4, F' = y^3 / 3 - y,
/// in coordinates y = Q q + (q^T B_i q)_i / 2 that hide it. On the branch y_k = 0 there are folds at y_0 = -1 and 1,
/// and a bifurcation at each at_k: trans-critical where cubic_k is not 0, else a pitchfork.
struct Hidden {
    static constexpr int n = 4;
    MatrixXd turn;
    MatrixXd bend[n];
    double slope[n]{}, at[n]{}, cubic[n]{}, quartic[n]{};

    VectorXd y(const VectorXd& q) const {
        VectorXd v = turn * q;
        for (int i = 0; i < n; ++i) v(i) += 0.5 * q.dot(bend[i] * q);
        return v;
    }
    MatrixXd jacobian(const VectorXd& q) const {
        MatrixXd j = turn;
        for (int i = 0; i < n; ++i) j.row(i) += (bend[i] * q).transpose();
        return j;
    }
    VectorXd gradient(const VectorXd& v, double p) const {
        VectorXd g = VectorXd::Zero(n);
        g(0) = v(0) * v(0) * v(0) / 3 - v(0) - p;
        for (int k = 1; k < n; ++k) {
            g(0) += 0.5 * slope[k] * v(k) * v(k);
            g(k) = slope[k] * (v(0) - at[k]) * v(k) + cubic[k] * v(k) * v(k) + quartic[k] * v(k) * v(k) * v(k);
        }
        return g;
    }
    VectorXd residual(const VectorXd& q, double p) const { return jacobian(q).transpose() * gradient(y(q), p); }
    MatrixXd tangent(const VectorXd& q, double p) const {
        const VectorXd v = y(q), g = gradient(v, p);
        MatrixXd h = MatrixXd::Zero(n, n);
        h(0, 0) = v(0) * v(0) - 1;
        for (int k = 1; k < n; ++k) {
            h(0, k) = h(k, 0) = slope[k] * v(k);
            h(k, k) = slope[k] * (v(0) - at[k]) + 2 * cubic[k] * v(k) + 3 * quartic[k] * v(k) * v(k);
        }
        const MatrixXd j = jacobian(q);
        MatrixXd out = j.transpose() * h * j;
        for (int i = 0; i < n; ++i) out += g(i) * bend[i];
        return out;
    }
    VectorXd parameter_derivative(const VectorXd& q, double) const { return -jacobian(q).row(0).transpose(); }

    std::vector<Planted> planted() const {
        std::vector<Planted> y{{-1, CriticalKind::fold}, {1, CriticalKind::fold}};
        for (int k = 1; k < n; ++k)
            y.push_back({at[k], cubic[k] != 0 ? CriticalKind::transcritical : CriticalKind::pitchfork});
        std::sort(y.begin(), y.end(), [](const Planted& a, const Planted& b) { return a.at < b.at; });
        return y;
    }
    /// The configuration on the branch at y_0, by Newton's method.
    VectorXd on_branch(double y_0) const {
        VectorXd q = VectorXd::Zero(n), target = VectorXd::Zero(n);
        target(0) = y_0;
        for (double share = 0.1; share < 1.05; share += 0.1)
            for (int k = 0; k < 10; ++k) q -= tests::solved(jacobian(q), y(q) - share * target);
        return q;
    }
};

Hidden hidden(std::uint64_t seed) {
    Generator generator(seed);
    const auto draw = [&](double low, double high) { return uniform(generator, low, high); };
    Hidden y;
    MatrixXd m(Hidden::n, Hidden::n);
    for (auto& entry : m.reshaped()) entry = draw(-1, 1);
    y.turn = tests::orthogonal_factor(m);
    for (auto& b : y.bend) {
        for (auto& entry : m.reshaped()) entry = draw(-.04, .04);
        b = m + m.transpose();
    }
    for (int k = 1; k < Hidden::n; ++k) {
        y.slope[k] = draw(.5, 2) * (draw(-1, 1) < 0 ? -1 : 1);
        // apart from the folds, and from each other but for the pair
        do y.at[k] = draw(-1.8, 1.8);
        while (std::abs(std::abs(y.at[k]) - 1) < .05 || (k > 1 && std::abs(y.at[k] - y.at[1]) < .05) ||
               (k > 2 && std::abs(y.at[k] - y.at[2]) < .05));
        y.cubic[k] = draw(-1, 1) < 0 ? draw(.5, 1.5) : 0;
        y.quartic[k] = draw(.5, 1.5) * (draw(-1, 1) < 0 ? -1 : 1);
    }
    if (seed % 2 == 0) y.at[2] = y.at[1] + .01 * std::max(std::abs(y.at[1]), .3);
    return y;
}

}  // namespace

TEST_CASE("200 random problems with planted folds, pitchforks, trans-critical points and pairs 1 % apart") {
    int planted_points = 0, missed = 0, invented = 0, unexplained = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        const Hidden problem = hidden(seed);
        const auto planted = problem.planted();
        const VectorXd start = problem.on_branch(-2);
        ContinuationOptions options;
        options.range.low = -3;
        options.range.high = 2.0 / 3;  // p at y_0 = 2
        options.most_steps = 200;
        const auto branch = continue_branch(problem, start, -2.0 / 3, 1, options);
        std::vector<double> found;
        for (const auto& event : branch.events) found.push_back(problem.y(event.point.q)(0));
        planted_points += static_cast<int>(planted.size());
        unexplained += static_cast<int>(branch.unexplained.size());
        for (const auto& expected : planted) {
            int hits = 0;
            for (std::size_t k = 0; k < found.size(); ++k)
                if (std::abs(found[k] - expected.at) < 1e-8) {
                    ++hits;
                    CHECK(branch.events[k].point.kind == expected.kind);
                    const double y_0 = expected.at;
                    CHECK(std::abs(branch.events[k].point.p - (y_0 * y_0 * y_0 / 3 - y_0)) < 1e-9);
                    CHECK(branch.events[k].point.nullity == 1);
                }
            missed += hits == 0;
            invented += std::max(hits - 1, 0);
        }
        for (const double y_0 : found)
            invented += std::none_of(planted.begin(), planted.end(),
                                     [&](const Planted& p) { return std::abs(p.at - y_0) < 1e-8; });
    }
    CHECK(planted_points == 1000);
    CHECK(missed == 0);
    CHECK(invented == 0);
    CHECK(unexplained == 0);
}

namespace {

/// V = y_0^3 / 6 - p y_0 and three modes along it, of which one stays weak: c_1 falls and c_2 rises through 0 within 1
/// %.
struct Opposite {
    static constexpr double falls = 1.5, rises = 1.51, weak = 1e-3;
    VectorXd modes(const VectorXd& y) const { return Eigen::Vector3d(falls - y(0), y(0) - rises, weak); }
    VectorXd residual(const VectorXd& y, double p) const {
        VectorXd g(4);
        g(0) = y(0) * y(0) / 2 - p - 0.5 * y(1) * y(1) + 0.5 * y(2) * y(2);
        g.tail(3) = modes(y).cwiseProduct(y.tail(3)) + Eigen::Vector3d(std::pow(y(1), 3), std::pow(y(2), 3), 0);
        return g;
    }
    MatrixXd tangent(const VectorXd& y, double) const {
        MatrixXd k = MatrixXd::Zero(4, 4);
        k(0, 0) = y(0);
        k(0, 1) = k(1, 0) = -y(1);
        k(0, 2) = k(2, 0) = y(2);
        k.diagonal().tail(3) = modes(y) + 3 * Eigen::Vector3d(y(1) * y(1), y(2) * y(2), 0);
        return k;
    }
    VectorXd parameter_derivative(const VectorXd&, double) const { return Eigen::Vector4d(-1, 0, 0, 0); }
};

}  // namespace

TEST_CASE("two eigenvalues that cross 0 in opposite directions in one step, hidden behind a third") {
    ContinuationOptions options;
    options.range.low = 0;
    options.range.high = 3;
    options.branch.largest_step = 0.5;
    const auto branch = continue_branch(Opposite{}, VectorXd(Eigen::Vector4d(1, 0, 0, 0)), 0.5, 1, options);
    CHECK(branch.end == BranchEnd::window);
    CHECK(branch.unexplained.empty());
    REQUIRE(branch.events.size() == 2);
    CHECK(branch.events[0].step == branch.events[1].step);
    CHECK(branch.events[0].point.p == Approx(Opposite::falls * Opposite::falls / 2).epsilon(1e-12));
    CHECK(branch.events[1].point.p == Approx(Opposite::rises * Opposite::rises / 2).epsilon(1e-12));
    for (const auto& event : branch.events) CHECK(event.point.kind == CriticalKind::pitchfork);
}

namespace {

/// y_0^2 / 2 = p and three modes along it, coupled one way, so that K is not symmetric: two fall through 0 at `first`
/// and `second`, and a weak one stays.
struct OneWay {
    static constexpr bool symmetric = false;
    double first, second, coupling;
    VectorXd residual(const VectorXd& y, double p) const {
        VectorXd g(4);
        g << y(0) * y(0) / 2 - p, (first - y(0)) * y(1) + coupling * y(2) + std::pow(y(1), 3),
            (second - y(0)) * y(2) + std::pow(y(2), 3) + y(1) * y(1) * y(2), 1e-3 * y(3);
        return g;
    }
    MatrixXd tangent(const VectorXd& y, double) const {
        MatrixXd k = MatrixXd::Zero(4, 4);
        k(0, 0) = y(0);
        k.block<3, 1>(1, 0) << -y(1), -y(2), 0;
        k(1, 1) = first - y(0) + 3 * y(1) * y(1);
        k(1, 2) = coupling;
        k(2, 1) = 2 * y(1) * y(2);
        k(2, 2) = second - y(0) + 3 * y(2) * y(2) + y(1) * y(1);
        k(3, 3) = 1e-3;
        return k;
    }
    VectorXd parameter_derivative(const VectorXd&, double) const { return Eigen::Vector4d(-1, 0, 0, 0); }
};

}  // namespace

TEST_CASE("two real eigenvalues of an unsymmetric K that cross 0 in one step, and at one point") {
    ContinuationOptions options;
    options.range = {0, 3};
    options.branch.largest_step = 0.5;
    const VectorXd start = Eigen::Vector4d(1, 0, 0, 0);
    const auto apart = continue_branch(OneWay{1.5, 1.51, 0.4}, start, 0.5, 1, options);
    CHECK(apart.unexplained.empty());
    REQUIRE(apart.events.size() == 2);
    CHECK(apart.events[0].step == apart.events[1].step);
    CHECK(apart.events[0].point.p == Approx(1.5 * 1.5 / 2).epsilon(1e-12));
    CHECK(apart.events[1].point.p == Approx(1.51 * 1.51 / 2).epsilon(1e-12));
    const auto at_once = continue_branch(OneWay{1.5, 1.5, 0}, start, 0.5, 1, options);
    REQUIRE(at_once.events.size() == 1);
    CHECK(at_once.events[0].point.nullity == 2);
    CHECK(at_once.events[0].point.p == Approx(1.5 * 1.5 / 2).epsilon(1e-9));
}
