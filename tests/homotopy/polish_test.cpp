#include <array>
#include <cmath>
#include <complex>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/polish.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

/// x^2 = square, y = 1.
struct TwinRoots {
    static constexpr int n_angles = 0, n_coordinates = 2;
    enum Parameter { square, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        return std::array{x[0] * x[0] - p[square], x[1] - 1.0};
    }
};

/// A polisher of the model at p. The homotopy's start plays no part at t = 1.
template <class M>
struct Polished {
    using Polisher = detail::Polisher<PolynomialHomotopy>;
    PolynomialHomotopy h;
    Polisher polisher{h};
    Polisher::Workspace<double> with{h};

    explicit Polished(const Parameters<M>& p) : h(homotopy(p)) {}
    static PolynomialHomotopy homotopy(const Parameters<M>& p) {
        const ModelSystem<M> target(p);
        Generator generator(1);
        return model_homotopy(target, TotalDegree<M>(target, generator));
    }

    RuntimePoint<double> at(const Array<std::complex<double>, n_angles<M>>& theta) const {
        auto q = point_of_zeros<RuntimeUnknowns, double>(h.sizes());
        for (int i = 0; i < n_angles<M>; ++i) {
            set_lane(q.c[i], 0, std::cos(theta[i]));
            set_lane(q.s[i], 0, std::sin(theta[i]));
        }
        return q;
    }
};

using Angle = Array<std::complex<double>, 1>;

}  // namespace

TEST_CASE("polishing brings a point near a root onto it") {
    using M = models::Pendulum;
    Polished<M> pendulum({0.5});
    const double theta = std::asin(0.5);
    for (const double off : {0.0, 1e-15, 1e-9, 1e-6, 5e-5}) {
        auto q = pendulum.at(Angle{{theta + std::complex<double>(off, -off)}});
        PolishedEvidence evidence;
        pendulum.polisher.run(q, &evidence, pendulum.with);
        CHECK(std::abs(lane(q.s[0], 0) - 0.5) < 1e-15);
        CHECK(evidence.residual < 1e-15);
        CHECK(evidence.correction < 1e-14);
        // the derivative of sin theta - 0.5 is cos theta, beside the coefficient 1
        CHECK(evidence.condition == Approx(1 / std::cos(theta)));
    }
}

TEST_CASE("a point that is no root is left where it is, and the evidence says so") {
    using M = models::Pendulum;
    Polished<M> pendulum({0.5});
    auto q = pendulum.at(Angle{{std::asin(0.5) + 0.01}});
    PolishedEvidence evidence;
    pendulum.polisher.run(q, &evidence, pendulum.with);
    CHECK(std::abs(lane(q.s[0], 0) - std::sin(std::asin(0.5) + 0.01)) < 1e-15);
    CHECK(evidence.correction > 1e-3);
    CHECK(evidence.residual > 1e-3);
}

TEST_CASE("the condition number sees a fold, and a row of rounding errors") {
    using M = models::Pendulum;
    Polished<M> fold({1});
    auto q = fold.at(Angle{{std::numbers::pi / 2 + 1e-9}});
    PolishedEvidence evidence;
    fold.polisher.assess(q, &evidence, fold.with);
    CHECK(evidence.condition > 1e8);

    // equal links without gravity: at (pi/2, -pi/2) the second row of the Hessian vanishes
    using Chain = mechanisms::RotatingChain<2>;
    Polished<Chain> folded({1, 1, 1, 1, 1.7, 0});
    auto r = folded.at({std::numbers::pi / 2, -std::numbers::pi / 2 + 1e-12});
    folded.polisher.assess(r, &evidence, folded.with);
    CHECK(evidence.condition > regular_condition);
}

TEST_CASE("far from the real torus a regular root is well conditioned") {
    // sin theta = 1e6: theta = pi/2 + i arcosh 1e6, where F and F' are of the size 1e6
    using M = models::Pendulum;
    Polished<M> far({1e6});
    auto q = far.at(Angle{{std::complex<double>(std::numbers::pi / 2, std::acosh(1e6))}});
    PolishedEvidence evidence;
    far.polisher.run(q, &evidence, far.with);
    CHECK(evidence.condition == Approx(1).epsilon(1e-6));
    CHECK(evidence.residual < 1e-14);
}

TEST_CASE("lanes are polished each for itself") {
    using M = models::Pendulum;
    using R = Lanes<native_lanes>;
    Polished<M> pendulum({0.5});
    auto pack = point_of_zeros<RuntimeUnknowns, R>(pendulum.h.sizes());
    for (int k = 0; k < native_lanes; ++k)
        copy_lane(pendulum.at(Angle{{std::asin(0.5) + (k == 1 ? 0.01 : 1e-7 * k)}}), 0, pack, k);
    PolishedEvidence evidence[native_lanes];
    detail::Polisher<PolynomialHomotopy>::Workspace<R> with(pendulum.h);
    pendulum.polisher.run(pack, evidence, with);
    for (int k = 0; k < native_lanes; ++k) CHECK((evidence[k].residual < 1e-15) == (k != 1));
}

TEST_CASE("what the equations determine is corrected near a singular point, and the point between two roots is none") {
    const auto between = [](double square, double x) {
        Polished<TwinRoots> twins({square});
        auto q = point_of_zeros<RuntimeUnknowns, double>(twins.h.sizes());
        set_lane(q.x[0], 0, x);
        set_lane(q.x[1], 0, 1 + 1e-6);
        const double residual = twins.polisher.correct_determined(q, twins.with);
        CHECK(std::abs(lane(q.x[0], 0) - x) < 1e-6);
        CHECK(std::abs(lane(q.x[1], 0) - 1.0) < 1e-13);
        return residual;
    };
    CHECK(between(0, 1e-7) < 1e-13);
    CHECK(between(1e-8, 1e-7) == Approx(1e-8).epsilon(1e-5));
}
