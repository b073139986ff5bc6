#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <equilibria/enumerate/classify.hpp>
#include <equilibria/enumerate/enumerate.hpp>

#include "support/catch.hpp"
#include "support/enumeration.hpp"
#include "support/models.hpp"

using namespace equilibria;
using std::numbers::pi;
using M = models::Pendulum;

namespace {

Root<M> root(std::complex<double> theta, double condition = 1) {
    Root<M> r;
    r.q[0] = theta;
    r.condition = condition;
    return r;
}

bool is_real(const Parameters<M>& p, const Root<M>& root, Unknowns<M>& q) {
    const detail::RealModelEquations<M> equations(p);
    return detail::RootClassifier(equations).is_real(detail::view(root), {q.begin(), q.end()});
}

}  // namespace

TEST_CASE("a root is real if its imaginary part is rounding, and only then") {
    Unknowns<M> q;
    const Parameters<M> p{0.5};
    const double theta = std::asin(0.5);
    CHECK(is_real(p, root({theta, 0}), q));
    CHECK(q[0] == Approx(theta).margin(1e-15));
    CHECK(is_real(p, root({theta + 1e-13, 1e-13}), q));
    CHECK(q[0] == Approx(theta).margin(1e-15));
    CHECK_FALSE(is_real(p, root({theta, 1e-7}), q));
    CHECK_FALSE(is_real(p, root({theta, 0.5}), q));
    // sin theta = 1 + 1e-12: no real root, but pi/2 + 1.4e-6 i, of condition 1e6
    const Parameters<M> beyond{1 + 1e-12};
    CHECK_FALSE(is_real(beyond, root({pi / 2, std::acosh(1 + 1e-12)}, 1e6), q));
    // sin theta = 1 - 1e-12: two real roots, the imaginary parts being rounding times the condition
    const Parameters<M> below{1 - 1e-12};
    CHECK(is_real(below, root({pi / 2 + std::acos(1 - 1e-12), 1e-11}, 1e6), q));
}

TEST_CASE("real angles are above -pi and at most pi") {
    Unknowns<M> q;
    for (const double start : {pi, -pi, pi + 1e-9, -pi - 1e-9}) {
        CHECK(is_real({0}, root({start, 0}), q));
        CHECK(q[0] > -pi);
        CHECK(q[0] <= pi);
        CHECK(std::abs(q[0]) == Approx(pi));
    }
}

TEST_CASE("of a model that is odd mirror images are classified together, and alike") {
    using Chain = tests::Chain<4>;
    const auto p = tests::benchmark_chain<4>();
    const auto set = enumerate<Chain>(p);
    std::vector<Root<RuntimeUnknowns>> roots;
    for (const auto& root : set.roots) {
        Root<RuntimeUnknowns> r;
        r.q = RuntimeArray<std::complex<double>>(AlignedVector<std::complex<double>>(root.q.begin(), root.q.end()));
        r.condition = root.condition;
        r.path = root.path;
        roots.push_back(r);
    }
    const detail::RealModelEquations<Chain> equations(p);
    const auto together = detail::classify(roots, equations, true, {}),
               alone = detail::classify(roots, equations, false, {});
    REQUIRE(together.equilibria.size() == alone.equilibria.size());
    CHECK(together.largest_real_imaginary == alone.largest_real_imaginary);
    CHECK(together.smallest_nonreal_imaginary == alone.smallest_nonreal_imaginary);
    for (std::size_t k = 0; k < alone.equilibria.size(); ++k) {
        const auto &a = together.equilibria[k], &b = alone.equilibria[k];
        CHECK(a.path == b.path);
        CHECK(a.index == b.index);
        CHECK(a.nullity == b.nullity);
        CHECK(a.energy == Approx(b.energy).epsilon(1e-14));
        CHECK(a.margin == Approx(b.margin).epsilon(1e-10));
        for (int u = 0; u < a.q.size(); ++u) CHECK(std::abs(std::remainder(a.q[u] - b.q[u], 2 * pi)) < 1e-14);
    }
}
