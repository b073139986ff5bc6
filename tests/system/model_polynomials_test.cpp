// A model's polynomials in some of its parameters, made at run time, against its own function; and what they refuse.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/equations.hpp>
#include <equilibria/system/model_polynomials.hpp>

#include "support/catch.hpp"
#include "support/enumeration.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

/// The value at angles and coordinates, as many coordinates as there are numbers behind the angles.
double value(const RuntimePolynomial<>& f, const RuntimeSizes& sizes, const std::vector<double>& q) {
    double sum = 0;
    for (const auto& t : f.terms()) {
        double term = t.coefficient;
        const auto codes = codes_of(t.monomial, sizes);
        for (std::size_t u = 0; u < codes.size(); ++u) {
            const int code = codes[u];
            if (static_cast<int>(u) >= sizes.angles)
                term *= std::pow(q[u], code);
            else if (code != 0)
                term *= code > 0 ? std::cos(code * q[u]) : std::sin(-code * q[u]);
        }
        sum += term;
    }
    return sum;
}

/// The equations at random points, the parameter number `active` being a coordinate.
template <class M>
void check_polynomials(int active) {
    Generator generator(1);
    constexpr int n = n_unknowns<M>, first = n_coordinates<M>;
    const RuntimeSizes sizes(n_angles<M>, first + 1);
    for (int trial = 0; trial < 10; ++trial) {
        Unknowns<M> q;
        Parameters<M> p;
        for (double& x : q) x = uniform(generator, -2, 2);
        for (double& x : p) x = uniform(generator, 0.5, 1.5);
        const double scale = uniform(generator, 0.5, 2);
        const auto polynomials = polynomials_of<M>().equations(runtime_array(p), {&active, 1}, {&scale, 1}, first);
        REQUIRE(polynomials.size() == static_cast<std::size_t>(n));
        std::vector<double> at(q.begin(), q.end());
        at.push_back(p[active] / scale);
        const auto f = equations<M>(q, p);
        for (int i = 0; i < n; ++i)
            CHECK(value(polynomials[static_cast<std::size_t>(i)], sizes, at) == Approx(f[i]).margin(1e-12));
    }
}

/// The load enters by its root.
struct RootLoad {
    static constexpr int n_angles = 1;
    enum Parameter { load, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const { return sqrt(p[load]) * cos(theta[0]); }
};
struct ManyAngles {
    static constexpr int n_angles = 17, n_parameters = 1;
    constexpr auto potential(const auto& theta, const auto& p) const {
        scalar_of<decltype(theta)> v{};
        for (int i = 0; i < 17; ++i) v += p[0] * cos(theta[i]);
        return v;
    }
};

}  // namespace

TEST_CASE("a model's polynomials are its equations, with and without a potential and with coordinates") {
    using Chain = mechanisms::RotatingChain<3>;
    check_polynomials<Chain>(Chain::omega);
    check_polynomials<models::TorquePendulum>(models::TorquePendulum::stiffness);
    check_polynomials<models::ElasticPendulum>(models::ElasticPendulum::gravity);
    CHECK(polynomials_of<Chain>().reflection_symmetric());
    CHECK_FALSE(polynomials_of<models::ElasticPendulum>().reflection_symmetric());
    CHECK(polynomials_of<models::ElasticPendulum>().has_potential());
    CHECK_FALSE(polynomials_of<models::TorquePendulum>().has_potential());
}

TEST_CASE("polynomials as a system are the model's at its parameters") {
    using M = models::ElasticPendulum;
    const Parameters<M> p{2, 9.5};
    const auto system = sparse_system(polynomials_of<M>().equations(runtime_array(p), {}, {}, 1), Sizes<M>());
    const auto same = sparse_system<M>(p);
    REQUIRE(system.terms().size() == same.terms().size());
    for (std::size_t k = 0; k < same.terms().size(); ++k) {
        CHECK(system.terms()[k].equation == same.terms()[k].equation);
        CHECK(system.terms()[k].monomial == same.terms()[k].monomial);
        CHECK(system.terms()[k].coefficient == same.terms()[k].coefficient);
    }
}

TEST_CASE("a parameter that is not polynomial cannot be active, and unknowns have an end") {
    const int active = 0;
    const double scale = 1;
    const RuntimeArray<double> one{1};
    CHECK(tests::refusal([&] { polynomials_of<RootLoad>().equations(one, {&active, 1}, {&scale, 1}, 0); }) ==
          "active parameters = 1: must enter the model's equations as polynomials");
    CHECK(tests::refusal([&] { polynomials_of<ManyAngles>().equations(one, {&active, 1}, {&scale, 1}, 0); }) ==
          "angles of the model = 17: must be at most 16");
}
