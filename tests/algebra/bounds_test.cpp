#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <equilibria/algebra/bounds.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;
using mechanisms::RotatingChain;

namespace {

/// N angles that know nothing of each other.
template <int N>
struct Uncoupled {
    static constexpr int n_angles = N, n_parameters = 1;
    constexpr auto equations(const auto& theta, const auto& p) const {
        std::array<scalar_of<decltype(theta)>, N> f{};
        for (int i = 0; i < N; ++i) f[static_cast<std::size_t>(i)] = sin(theta[i]) - p[0];
        return f;
    }
};

template <class M>
std::int64_t each() {
    return multihomogeneous_number<M>(one_group_each<M>()).value;
}

/// 2^n times the permanent of the degrees of the equations in the angles: what the coefficient is for a group each.
template <class M>
std::int64_t by_permanent() {
    constexpr int n = n_angles<M>;
    Array<Array<int, n>, n> degree{};
    for (const auto& t : Formulation<M>::support)
        for (int u = 0; u < n; ++u) degree[t.equation][u] = std::max(degree[t.equation][u], t.monomial.degree(u));
    std::array<int, n> order{};
    std::iota(order.begin(), order.end(), 0);
    std::int64_t sum = 0;
    do {
        std::int64_t product = 1 << n;
        for (int i = 0; i < n; ++i) product *= degree[i][order[static_cast<std::size_t>(i)]];
        sum += product;
    } while (std::next_permutation(order.begin(), order.end()));
    return sum;
}

}  // namespace

TEST_CASE("total degree of the chain and of coupled angles") {
    STATIC_REQUIRE(total_degree<RotatingChain<2>>() == 16);
    STATIC_REQUIRE(total_degree<RotatingChain<3>>() == 64);
    CHECK(total_degree<RotatingChain<4>>() == 256);
    CHECK(total_degree<models::CoupledAngles<3>>() == 64);
    CHECK(total_degree<models::CoupledAngles<4>>() == 256);
    CHECK(total_degree<models::CoupledAngles<5>>() == 1024);
    CHECK(total_degree<models::TwoAngleMechanism>() == 16);
    CHECK(total_degree<models::ElasticPendulum>() == 4);
}

TEST_CASE("a group each unknown") {
    CHECK(each<RotatingChain<2>>() == 20);
    CHECK(each<RotatingChain<3>>() == 128);
    CHECK(each<RotatingChain<4>>() == 1040);
    CHECK(each<models::TwoAngleMechanism>() == 8);
    CHECK(each<models::ElasticPendulum>() == 4);
    CHECK(each<RotatingChain<5>>() == by_permanent<RotatingChain<5>>());
    CHECK(each<models::CoupledAngles<3>>() == by_permanent<models::CoupledAngles<3>>());
    CHECK(each<models::CoupledAngles<5>>() == by_permanent<models::CoupledAngles<5>>());
}

TEST_CASE("one group of all unknowns gives the total degree") {
    CHECK(multihomogeneous_number<RotatingChain<4>>({}).value == total_degree<RotatingChain<4>>());
    CHECK(multihomogeneous_number<models::CoupledAngles<4>>({}).value == total_degree<models::CoupledAngles<4>>());
    CHECK(multihomogeneous_number<models::ElasticPendulum>({}).value == total_degree<models::ElasticPendulum>());
    CHECK(multihomogeneous_number<models::Everything>({}).value == total_degree<models::Everything>());
}

TEST_CASE("the names of the groups do not matter") {
    using M = models::CoupledAngles<4>;
    CHECK(multihomogeneous_number<M>({{0, 0, 1, 2}}) == multihomogeneous_number<M>({{2, 2, 0, 1}}));
    CHECK(multihomogeneous_number<M>({{0, 0, 1, 1}}) == multihomogeneous_number<M>({{3, 3, 0, 0}}));
    CHECK_THROWS_AS(multihomogeneous_number<M>({{0, 0, 1, 4}}), InvalidArgument);
    CHECK_THROWS_AS(multihomogeneous_number<M>({{0, 0, -1, 1}}), InvalidArgument);
}

template <class M, class Count>
void compare_partitions_with_coefficients(std::size_t bell) {
    std::set<std::vector<int>> groupings;
    detail::GroupingSearch<Count> search({Formulation<M>::support, n_unknowns<M>});
    search.for_each([&](Count ways, const std::vector<int>& grouping, int groups) {
        groupings.insert(grouping);
        CHECK(groups == detail::n_groups(grouping));
        Grouping<M> g;
        std::ranges::copy(grouping, g.begin());
        PathCount number{ways};
        for (int i = 0; i < n_angles<M>; ++i) number = number * PathCount{2};
        CHECK(number == multihomogeneous_number<M>(g));
    });
    CHECK(groupings.size() == bell);
}

TEST_CASE("the partitions are all visited, each with its number") {
    compare_partitions_with_coefficients<models::CoupledAngles<2>, std::int64_t>(2);
    compare_partitions_with_coefficients<models::CoupledAngles<5>, std::int64_t>(52);
    compare_partitions_with_coefficients<models::Everything, PathCount>(5);
    compare_partitions_with_coefficients<RotatingChain<6>, PathCount>(203);
    compare_partitions_with_coefficients<Uncoupled<8>, std::int64_t>(4140);
    compare_partitions_with_coefficients<models::CoupledAngles<8>, std::int64_t>(4140);
}

TEST_CASE("the smallest multihomogeneous number") {
    SECTION("for the chain it is the total degree, 4^n, which is sharp") {
        constexpr auto smallest = smallest_multihomogeneous_number<RotatingChain<3>>();
        STATIC_REQUIRE(smallest.number.value == 64);
        STATIC_REQUIRE(smallest.grouping == Grouping<RotatingChain<3>>{});
        STATIC_REQUIRE(smallest.compared == ComparedGroupings::all);
        CHECK(smallest_multihomogeneous_number<RotatingChain<8>>().number.value == 65536);
    }
    SECTION("for coupled angles it lies between the number of solutions and the total degree") {
        CHECK(smallest_multihomogeneous_number<models::CoupledAngles<3>>().number.value == 48);
        CHECK(smallest_multihomogeneous_number<models::CoupledAngles<5>>().number.value == 1024);
        CHECK(smallest_multihomogeneous_number<models::TwoAngleMechanism>().number.value == 8);
    }
    SECTION("unknowns that do not meet are best kept apart") {
        CHECK(smallest_multihomogeneous_number<Uncoupled<4>>().number.value == 16);
    }
    SECTION("what was compared is said") {
        CHECK(smallest_multihomogeneous_number<Uncoupled<9>>().compared == ComparedGroupings::one_or_each);
        CHECK(smallest_multihomogeneous_number<Uncoupled<21>>().compared == ComparedGroupings::one);
    }
}

TEST_CASE("numbers of paths that do not fit are said to be too large") {
    const PathCount large{std::int64_t{1} << 40, false}, small{3, false};
    CHECK((large * large).saturated);
    CHECK((large * large + small).saturated);
    CHECK((large * large * PathCount{}) == PathCount{});
    CHECK_FALSE((large * small).saturated);
    CHECK(large < large * large);
    CHECK((PathCount{std::numeric_limits<std::int64_t>::max(), false} + small).saturated);

    CHECK(total_degree<Uncoupled<62>>() == std::int64_t{1} << 62);
    CHECK(total_degree_count<Uncoupled<63>>().saturated);
    CHECK_THROWS_AS(total_degree<Uncoupled<63>>(), std::overflow_error);
    CHECK_THROWS_AS(multihomogeneous_number<Uncoupled<63>>(one_group_each<Uncoupled<63>>()), InvalidArgument);
    std::ostringstream out;
    out << bounds<Uncoupled<63>>().total_degree;
    CHECK(out.str() == "more than 9223372036854775807");
}

TEST_CASE("the estimate for chains applies to chains") {
    const auto estimate = chain_estimate<RotatingChain<3>>();
    REQUIRE(estimate);
    CHECK(estimate->at_least.value == 8);
    CHECK(estimate->at_most.value == 64);
    CHECK(estimate->at_most.value == total_degree<RotatingChain<3>>());
    CHECK_FALSE(chain_estimate<models::TwoAngleMechanism>());  // not odd
    CHECK_FALSE(chain_estimate<models::ElasticPendulum>());    // a coordinate
    CHECK_FALSE(chain_estimate<models::Pendulum>());           // degree 1
}

TEST_CASE("bounds side by side") {
    auto b = bounds<mechanisms::TwoLinkChain>();
    CHECK(b.smallest().value == 16);
    std::ostringstream chain;
    chain << b;
    CHECK(chain.str() ==
          "2 angles\n"
          "  total degree            16\n"
          "  a group each unknown    20\n"
          "  multihomogeneous        16  {theta1 theta2}, least of all groupings\n"
          "  estimate for chains     4 to 16\n");

    std::ostringstream pendulum;
    pendulum << bounds<models::ElasticPendulum>();
    CHECK(pendulum.str() ==
          "1 angle, 1 coordinate\n"
          "  total degree            4\n"
          "  a group each unknown    4\n"
          "  multihomogeneous        4  {theta1 x1}, least of all groupings\n");

    auto coupled = bounds<models::CoupledAngles<3>>();
    CHECK(coupled.smallest().value == 48);
    coupled.mixed_volume = PathCount{40, false};
    coupled.laurent_mixed_volume = PathCount{20, false};
    CHECK(coupled.smallest().value == 20);
    std::ostringstream out;
    out << coupled;
    CHECK(out.str() ==
          "3 angles\n"
          "  total degree            64\n"
          "  a group each unknown    48\n"
          "  multihomogeneous        48  {theta1}{theta2}{theta3}, least of all groupings\n"
          "  mixed volume            40\n"
          "  Laurent mixed volume    20\n");
}
