// Folds, pitchforks and cusps of the two-link chain to 40 digits, and what an enumeration exactly there reports:
// winding numbers 2, 2 and 3, multiplicities that sum to 4^2.
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/singularity/refine_singularity.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;
using M = mechanisms::TwoLinkChain;
using F = Multiprecision<40>;
using Kind = SingularityKind;

namespace {

/// The degenerate equilibrium near these parameters, ratio 1.5.
Unknowns<M> degenerate_equilibrium(double alpha, double omega) {
    const auto r = enumerate<M>({alpha, 1.5, omega});
    for (const auto& e : r.equilibria)
        if (e.degenerate()) return e.q;
    FAIL("no degenerate equilibrium");
    return {};
}

void check(const Singularity<M, F>& at) {
    CHECK(at.converged);
    CHECK(at.kind != Kind::undecided);
    CHECK(at.steps <= 6);
    CHECK(at.residual < F(1e-37));
    CHECK(at.correction < F(1e-36));
}

/// Exactly there, in double: the sizes, whatever the seed.
void check_enumeration(const Singularity<M, F>& at, std::size_t points, int multiplicity, int winding) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        const Parameters<M> p{static_cast<double>(at.p[M::alpha]), 1.5, static_cast<double>(at.p[M::omega])};
        const auto r = enumerate<M>(p, {.seed = seed});
        CHECK(r.paths.failed == 0);
        CHECK(r.paths.at_infinity == 0);
        CHECK(r.families.empty());
        std::int32_t multiplicities = 0;
        std::size_t singular = 0;
        double nearest = 1;
        for (const auto& root : r.roots) {
            multiplicities += root.paths;
            if (root.status != PathStatus::singular) continue;
            ++singular;
            CHECK(root.paths == multiplicity);
            CHECK(root.winding_number == winding);
            double off = 0;
            for (int i = 0; i < 2; ++i) off = std::max(off, std::abs(root.q[i] - static_cast<double>(at.q[i])));
            nearest = std::min(nearest, off);
        }
        CHECK(multiplicities == 16);
        CHECK(singular == points);
        CHECK(nearest < 1e-4);
    }
}

}  // namespace

TEST_CASE("a fold, refined: two mirror images with winding number 2") {
    const double omegas[] = {2.3179684357649, 2.4293853881739, 7.4951235452437}, alphas[] = {.1, .4, .6};
    for (int k = 0; k < 3; ++k) {
        const F alpha = F(k == 0 ? 1 : k == 1 ? 4 : 6) / 10;
        const auto at = refine_singularity<M, Kind::fold, M::omega>(degenerate_equilibrium(alphas[k], omegas[k]),
                                                                    Parameters<M, F>{alpha, F(3) / 2, F(omegas[k])});
        check(at);
        CHECK(static_cast<double>(at.p[M::omega]) == Approx(omegas[k]).epsilon(1e-13));
        check_enumeration(at, 2, 2, 2);
    }
    // where the fold curve has a vertical tangent: alpha = 1/3 exactly at omega = 2
    const auto at = refine_singularity<M, Kind::fold, M::alpha>(degenerate_equilibrium(1.0 / 3, 2),
                                                                Parameters<M, F>{F(0.333), F(3) / 2, F(2)});
    check(at);
    CHECK(abs(at.p[M::alpha] - F(1) / 3) < F(1e-36));
    // which is the extremal point of the fold curve in the plane
    const auto extremal = refine_singularity<M, Kind::extremal_fold, M::alpha, M::omega>(
        degenerate_equilibrium(1.0 / 3, 2), Parameters<M, F>{F(0.333), F(3) / 2, F(2.01)});
    check(extremal);
    CHECK(extremal.kind == Kind::extremal_fold);
    CHECK(extremal.extremal == M::alpha);
    CHECK(abs(extremal.x() - F(1) / 3) < F(1e-36));
    CHECK(abs(extremal.y() - 2) < F(1e-36));
}

TEST_CASE("a pitchfork, refined: one point, the pair that leaves it with winding number 2") {
    const double omegas[] = {.76450069744675, 1.1257844089591, 1.0322526364616, .83377163246986};
    for (const double omega : omegas) {
        const auto at = refine_singularity<M, Kind::pitchfork, M::omega>(
            degenerate_equilibrium(.1, omega), Parameters<M, F>{F(1) / 10, F(3) / 2, F(omega)});
        check(at);
        CHECK(static_cast<double>(at.p[M::omega]) == Approx(omega).epsilon(1e-13));
        check_enumeration(at, 1, 3, 2);
    }
}

TEST_CASE("the cusp, refined: two mirror images with winding number 3") {
    const double alpha = 0.32989617641140, omega = 1.93791347451593;
    const auto at = refine_singularity<M, Kind::cusp, M::alpha, M::omega>(
        degenerate_equilibrium(alpha, omega), Parameters<M, F>{F(alpha), F(3) / 2, F(omega)});
    check(at);
    CHECK(static_cast<double>(at.p[M::alpha]) == Approx(alpha).epsilon(1e-13));
    CHECK(static_cast<double>(at.p[M::omega]) == Approx(omega).epsilon(1e-13));
    check_enumeration(at, 2, 3, 3);
    // a fold system is singular at a cusp: not converged, and not said to be
    Unknowns<M> near{};
    for (int i = 0; i < 2; ++i) near[i] = static_cast<double>(at.q[i]) + 1e-3;
    CHECK_FALSE(refine_singularity<M, Kind::fold, M::omega>(near, at.p).converged);
}

TEST_CASE("the same in double, and for a model without a potential") {
    const auto at =
        refine_singularity<M, Kind::fold, M::omega>(degenerate_equilibrium(.1, 2.3179684357649), {.1, 1.5, 2.318});
    CHECK(at.converged);
    CHECK(at.p[M::omega] == Approx(2.31796843576488097869815298163510244).epsilon(1e-14));
    CHECK(at.residual < 1e-14);
    // sin theta = torque: torque 1 at pi/2
    using P = models::Pendulum;
    const auto fold = refine_singularity<P, Kind::fold, P::torque>({1.5}, Parameters<P, F>{F(0.9)});
    CHECK(fold.converged);
    CHECK(fold.kind == Kind::fold);
    CHECK(abs(fold.p[P::torque] - 1) < F(1e-37));
    CHECK(abs(cos(fold.q[0])) < F(1e-36));
}
