// Paths in single precision: the same roots as in double, each path accounted for.
#include <equilibria/core/lanes.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/start/linear_product.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <map>
#include <string_view>

#include "support/catch.hpp"
#include "support/enumeration.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

constexpr TrackerOptions in_double{.single_precision = false};

/// The largest difference of two roots of the same path.
template <class M>
double difference(const RootSet<M>& a, const RootSet<M>& b) {
    std::map<std::uint64_t, const Root<M>*> of_path;
    for (const auto& root : b.roots) of_path[root.path] = &root;
    double largest = 0;
    for (const auto& root : a.roots) {
        const auto other = of_path.find(root.path);
        REQUIRE(other != of_path.end());
        for (int u = 0; u < root.q.size(); ++u) {
            const auto turn = std::exp(std::complex<double>(0, 1) * (root.q[u] - other->second->q[u]));
            largest = std::max(largest, std::abs(turn - 1.0));
        }
    }
    return largest;
}

/// The first paths of a start.
struct FirstPaths {
    const LinearProduct* start;
    std::uint64_t paths;

    static constexpr std::string_view name() { return "first paths"; }
    PathNumbering numbering() const { return PathNumbering::all(paths); }
    RuntimePoint<double> point(std::uint64_t k) const { return start->point(k); }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("Each path of a chain ends in single precision where it ends in double", "", ((int N), N), 4, 5,
                       6) {
    Generator generator(7);
    for (int k = 0; k < (N == 6 ? 1 : tests::thoroughness); ++k) {
        const auto p = k == 0 ? tests::benchmark_chain<N>() : tests::random_chain<N>(generator);
        RunOptions run;
        run.seed = static_cast<std::uint64_t>(k + 1);
        const auto single = enumerate<tests::Chain<N>>(p, run);
        const auto twofold = enumerate<tests::Chain<N>>(p, run, in_double);
        CAPTURE(N, k, single.paths.in_double);
        CHECK(single.paths.accounted_for());
        CHECK(single.paths.failed == 0);
        CHECK(single.paths.crossed == 0);
        CHECK(twofold.paths.in_double == 0);
        REQUIRE(single.roots.size() == twofold.roots.size());
        CHECK(difference(single, twofold) < 1e-9);
        CHECK(single.by_index() == twofold.by_index());
    }
}

TEST_CASE("Sizes of coefficients that floats do not have change nothing") {
    using M = tests::Chain<4>;
    const auto p = tests::benchmark_chain<4>();
    const auto set = enumerate<M>(p);
    for (const int power : {200, -200}) {
        auto scaled = p;
        for (int i = 0; i < 4; ++i) scaled[M::mass + i] = std::ldexp(p[M::mass + i], power);
        const auto other = enumerate<M>(scaled);
        CHECK(other.paths.steps == set.paths.steps);
        CHECK(other.paths.in_double == set.paths.in_double);
        REQUIRE(other.roots.size() == set.roots.size());
        for (std::size_t k = 0; k < set.roots.size(); ++k) CHECK(other.roots[k].q == set.roots[k].q);
    }
}

TEST_CASE("What single precision cannot carry goes on in double from where it is, for any number of threads") {
    const auto p = tests::benchmark_chain<7>();
    const auto set = enumerate<tests::Chain<7>>(p);
    CHECK(set.clean());
    CHECK(set.roots.size() == 16384);
    CHECK(set.paths.in_double > 0);
    CHECK(set.paths.retracked == 0);
    RunOptions run;
    run.executor = threads(3);
    const auto again = enumerate<tests::Chain<7>>(p, run);
    CHECK(again.paths.in_double == set.paths.in_double);
    CHECK(again.paths.steps == set.paths.steps);
    REQUIRE(again.roots.size() == set.roots.size());
    bool same = true;
    for (std::size_t k = 0; k < set.roots.size(); ++k) same = same && again.roots[k].q == set.roots[k].q;
    CHECK(same);
}

TEST_CASE("Paths that fill three packs of doubles are tracked in single precision, fewer are not") {
    using M = models::CoupledAngles<3>;  // most of its paths go to infinity, in double at last
    Generator generator(11);
    Parameters<M> p;
    for (double& x : p) x = uniform(generator, 0.3, 1.3);
    const auto system = sparse_system<M>(p);
    const LinearProduct start(system, Array<int, 3>{}, unit_complex(generator), generator);
    const PolynomialHomotopy homotopy(system, start);
    REQUIRE(start.solutions().size() == 64);
    const std::uint64_t least = 3 * native_lanes;
    const auto solved = [&](std::uint64_t paths, const TrackerOptions& options) {
        return complex_roots(homotopy, FirstPaths{&start, paths}, {}, options);
    };
    CHECK(solved(least, {}).paths.in_double > 0);
    const auto few = solved(least - 1, {}), twofold = solved(least - 1, in_double);
    CHECK(few.paths.in_double == 0);
    CHECK(few.paths.steps == twofold.paths.steps);
    CHECK(few.paths.at_infinity > 0);
}
