// The predictor and the step control of a homotopy, exchanged: other steps, the same roots.
#include <cmath>
#include <complex>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/homotopy/tracking.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/paths/own_homotopy.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using M = mechanisms::TwoLinkChain;
using H = PolynomialHomotopy;

/// Along the tangent.
template <class R>
struct Euler {
    static constexpr int order = 1;
    static constexpr int local_order = 2;
    static Complex<R> change(const auto& taylor, int u, const R& h) { return h * taylor[0][u]; }
    static R pole(const auto&, int) { return broadcast<R>(1.0); }
};
struct EulerTracking : PadeTracking {
    template <class R>
    using Predictor = Euler<R>;
};

/// Steps of half the length that the control of contractions proposes.
template <class R, int local_order>
struct HalfSteps : ContractionControl<R, local_order> {
    using ContractionControl<R, local_order>::ContractionControl;
    R longest(const R& pole) const { return 0.5 * ContractionControl<R, local_order>::longest(pole); }
    Verdict<R> judge(const Trial<R>& trial) const {
        Verdict<R> y = ContractionControl<R, local_order>::judge(trial);
        y.next_step = 0.5 * y.next_step;
        return y;
    }
};
struct HalfTracking : PadeTracking {
    template <class R, int local_order>
    using StepControl = HalfSteps<R, local_order>;
};

struct Chain {
    Generator generator{1};
    ModelSystem<M> target{Parameters<M>{.3, 1.5, 2}};
    TotalDegree<M> start{target, generator};
    H h = model_homotopy(target, start);
};

}  // namespace

TEST_CASE("a homotopy that names another predictor or step control is tracked by it, to the same roots") {
    const Chain chain;
    const auto pade = complex_roots(chain.h, chain.start);
    const auto check = [&](const auto& others) {
        CHECK(others.paths.finite == pade.paths.finite);
        CHECK(others.paths.failed == 0);
        REQUIRE(others.roots.size() == pade.roots.size());
        for (std::size_t k = 0; k < pade.roots.size(); ++k)
            for (int u = 0; u < 2; ++u) {
                const std::complex<double> d = others.roots[k].q[u] - pade.roots[k].q[u];
                CHECK(std::abs(std::complex<double>(wrap(d.real()), d.imag())) < 1e-10);
            }
    };
    const auto euler = complex_roots(TrackedBy<EulerTracking, H>(chain.h), chain.start);
    check(euler);
    CHECK(euler.paths.steps > 2 * pade.paths.steps);  // of lower order
    const auto half = complex_roots(TrackedBy<HalfTracking, H>(chain.h), chain.start);
    check(half);
    CHECK(half.paths.steps > pade.paths.steps);
}
