// The start system is a means: the roots do not depend on it. Symmetries of the set of roots.
#include <equilibria/stability/inertia.hpp>

#include "support/enumeration.hpp"

using namespace equilibria;
using tests::Chain;

TEST_CASE("the reflected and the general start find the same roots") {
    Generator generator(7);
    for (int k = 0; k < 2 * tests::thoroughness; ++k) {
        const auto p = k == 0 ? tests::benchmark_chain<3>() : tests::random_chain<3>(generator);
        const auto reflected = enumerate<Chain<3>, Reflected<Chain<3>>>(p, {.seed = 3});
        const auto general = enumerate<Chain<3>, TotalDegree<Chain<3>>>(p, {.seed = 4});
        tests::check_generic_chain<3>(reflected);
        tests::check_generic_chain<3>(general);
        // roots of condition 1e8 would still agree to 1e-8; these do to 1e-9
        CHECK(tests::same_roots(reflected, general, 1e-9));
        CHECK(general.paths.tracked == 64);
        CHECK(reflected.paths.tracked == 28);
        CHECK(reflected.by_index() == general.by_index());
    }
}

namespace {

/// Odd equations of different degrees: 6, 4 and 8 start points.
struct UnevenDegrees {
    static constexpr int n_angles = 3, n_parameters = 3;
    constexpr auto potential(const auto& theta, const auto& p) const {
        return p[0] * cos(3 * theta[0]) + p[1] * cos(theta[1] - theta[0]) + p[2] * cos(4 * theta[2]) * cos(theta[1]);
    }
};

template <class M>
void check_numbering() {
    Generator generator(1);
    Parameters<M> p;
    for (double& x : p) x = uniform(generator, 0.5, 1.5);
    const Reflected<M> start(ModelSystem<M>(p), generator);
    const PathNumbering& numbering = start.numbering();
    std::uint64_t pairs = 0, resting = 0;
    for (std::uint64_t path = 0; path < static_cast<std::uint64_t>(total_degree<M>()); ++path) {
        const std::uint64_t image = numbering.mirror(path);
        CHECK(numbering.mirror(image) == path);
        if (image == path) CHECK(numbering.resting_path(resting++) == path);
        if (image > path) CHECK(numbering.tracked_path(pairs++) == path);
    }
    CHECK(numbering.total() == static_cast<std::uint64_t>(total_degree<M>()));
    CHECK(numbering.tracked() == pairs);
    CHECK(numbering.resting() == resting);
}

}  // namespace

TEST_CASE("starts are numbered without a list of them: those that rest, and one of each mirror pair") {
    check_numbering<Chain<1>>();
    check_numbering<Chain<2>>();
    check_numbering<Chain<5>>();
    check_numbering<UnevenDegrees>();
}

TEST_CASE("the roots come in conjugate pairs and in mirror pairs") {
    Generator generator(8);
    for (int k = 0; k < 2 * tests::thoroughness; ++k) {
        const auto r = enumerate<Chain<3>, TotalDegree<Chain<3>>>(tests::random_chain<3>(generator));
        CHECK(tests::distance(tests::conjugated(r.roots), r.roots) < 1e-9);
        CHECK(tests::distance(tests::mirrored(r.roots), r.roots) < 1e-9);
    }
}

TEST_CASE("the real roots are the equilibria, and stand apart from the others") {
    Generator generator(9);
    for (int k = 0; k < tests::thoroughness; ++k) {
        const auto r = enumerate<Chain<3>>(tests::random_chain<3>(generator));
        std::uint64_t real = 0;
        for (const auto& root : r.roots) {
            double imaginary = 0;
            for (const auto& q : root.q) imaginary = std::max(imaginary, std::abs(q.imag()));
            real += imaginary < 1e-9;
        }
        CHECK(real == r.real());
        CHECK(r.largest_real_imaginary < 1e-9);
        CHECK(r.smallest_nonreal_imaginary > 1e-9);
    }
}

TEST_CASE("equilibria are critical points: gradient, energy and index by finite differences of the energy") {
    const auto p = tests::benchmark_chain<3>();
    const auto r = enumerate<Chain<3>>(p);
    for (const auto& e : r.equilibria) {
        CHECK(e.energy == Approx(potential<Chain<3>>(e.q, p)).margin(1e-12));
        constexpr double h = 1e-3;
        Eigen::Matrix3d hessian;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const auto at = [&](double a, double b) {
                    auto q = e.q;
                    q[i] += a;
                    q[j] += b;
                    return potential<Chain<3>, double>(q, p);
                };
                hessian(i, j) = (at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4 * h * h);
                // central differences of a critical point's energy: h^2 / 6 times a third derivative below 100
                CHECK(std::abs(at(h, 0) - at(-h, 0)) / (2 * h) < 2e-5);
            }
        CHECK(inertia(hessian).negative == e.index);
        CHECK(e.margin > 1e-4);
        CHECK(e.stable() == (e.index == 0));
    }
}
