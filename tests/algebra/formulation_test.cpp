#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <limits>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/derivatives.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;
using mechanisms::RotatingChain;
using mechanisms::TwoLinkChain;

namespace {

/// Refused: which terms there are depends on the parameter's value.
struct Branches {
    static constexpr int n_angles = 1, n_parameters = 1;
    constexpr auto potential(const auto& theta, const auto& p) const {
        using Scalar = scalar_of<decltype(theta)>;
        return Scalar(p[0]) * cos(theta[0]) + extra(theta, p[0]);
    }
    template <class Theta, class P>
    static constexpr scalar_of<Theta> extra(const Theta& theta, const P& p) {
        if constexpr (requires { p.polynomial(); })
            if (p.polynomial().constant() > 1) return sin(2 * theta[0]);
        return {};
    }
};

/// A second difference of parameters stands before the highest harmonic.
struct SecondDifference {
    static constexpr int n_angles = 1, n_parameters = 3;
    constexpr auto potential(const auto& theta, const auto& p) const {
        return (p[0] - 2 * p[1] + p[2]) * cos(3 * theta[0]) + cos(theta[0]);
    }
};

struct SixParameters {
    static constexpr int n_parameters = 6;
};

/// Functions of the parameters that need not be real at the generic ones.
struct RootOfDifference {
    static constexpr int n_angles = 1, n_parameters = 2;
    constexpr auto potential(const auto& theta, const auto& p) const {
        return (sqrt(p[0] - p[1]) + log(p[1] - p[0] + 2 * p[1])) * cos(theta[0]) +
               sqrt(p[1] - p[0]) * sin(2 * theta[0]);
    }
};

template <class M>
std::complex<double> value_of_term(const SupportTerm<M>& t, const Unknowns<M, std::complex<double>>& q) {
    std::complex<double> product = 1;
    for (int u = 0; u < n_unknowns<M>; ++u) {
        const int k = t.monomial.code(u);
        if (u >= n_angles<M>)
            product *= std::pow(q[u], k);
        else if (k != 0)
            product *= k > 0 ? std::cos(double(k) * q[u]) : std::sin(double(-k) * q[u]);
    }
    return product;
}

/// The terms with their coefficients add up to the model's own equations, at complex unknowns.
template <class M>
double largest_difference(Generator& generator) {
    Parameters<M> p;
    for (double& value : p) value = uniform(generator, 0.3, 1.7);
    const auto c = coefficients<M>(p);
    double largest = 0;
    for (int trial = 0; trial < 10; ++trial) {
        Unknowns<M, std::complex<double>> q;
        for (auto& value : q) value = {uniform(generator, -3, 3), uniform(generator, -0.5, 0.5)};
        detail::AnglesOf<M, Complex<double>> theta;
        detail::CoordinatesOf<M, Complex<double>> x;
        const auto converted = [](std::complex<double> z) { return Complex<double>(z.real(), z.imag()); };
        for (int i = 0; i < theta.size(); ++i) theta[i] = {converted(std::cos(q[i])), converted(std::sin(q[i]))};
        for (int j = 0; j < x.size(); ++j) x[j] = converted(q[theta.size() + j]);
        const auto own = detail::equations_at<M, Complex<double>>(theta, x, p);
        for (int i = 0; i < n_unknowns<M>; ++i) {
            std::complex<double> sum = 0;
            for (int k = Formulation<M>::first[i]; k < Formulation<M>::first[i + 1]; ++k)
                sum += c[k] * value_of_term<M>(Formulation<M>::support[k], q);
            largest = std::max(largest, std::abs(sum - std::complex(own[i].re, own[i].im)) / (1 + std::abs(sum)));
        }
    }
    return largest;
}

}  // namespace

TEST_CASE("the terms add up to the model's equations") {
    Generator generator(1);
    CHECK(largest_difference<TwoLinkChain>(generator) < 1e-14);
    CHECK(largest_difference<RotatingChain<5>>(generator) < 1e-13);
    CHECK(largest_difference<models::Pendulum>(generator) < 1e-14);
    CHECK(largest_difference<models::ElasticPendulum>(generator) < 1e-14);
    CHECK(largest_difference<models::CoupledAngles<4>>(generator) < 1e-13);
    CHECK(largest_difference<models::TwoAngleMechanism>(generator) < 1e-14);
    CHECK(largest_difference<models::Everything>(generator) < 1e-13);
}

TEST_CASE("terms are sorted, and grouped by equation and own factor") {
    using F = Formulation<models::Everything>;
    for (int k = 1; k < F::terms; ++k) CHECK(F::support[k - 1] < F::support[k]);
    for (int i = 0; i < F::unknowns; ++i)
        for (int k = F::first[i]; k < F::first[i + 1]; ++k) {
            CHECK(F::support[k].equation == i);
            if (k > F::first[i]) CHECK(F::support[k - 1].own_code() <= F::support[k].own_code());
        }
    CHECK(F::first[F::unknowns] == F::terms);
}

TEST_CASE("generic parameters have no small relation") {
    constexpr auto p = detail::generic_parameters<SixParameters>();
    double least = 1;
    for (int code = 1; code < 15625; ++code) {  // all combinations with coefficients -2 .. 2
        double sum = 0;
        for (int k = 0, rest = code; k < 6; ++k, rest /= 5) sum += (rest % 5 - 2) * p[k];
        if (code != 15624 / 2) least = std::min(least, std::abs(sum));
    }
    CHECK(least > 1e-5);
    for (double value : p) CHECK((value >= 0.25 && value < 1));
}

TEST_CASE("parameters enter by any function") {
    STATIC_REQUIRE(Formulation<SecondDifference>::degrees[0] == 3);
    STATIC_REQUIRE(Formulation<RootOfDifference>::degrees[0] == 2);
    // At given parameters the root of a negative number is one.
    CHECK_THROWS_AS(coefficients<RootOfDifference>({{1.0, 2.0}}), InvalidArgument);
    CHECK_THROWS_AS(coefficients<RootOfDifference>({{2.0, 1.0}}), InvalidArgument);
    using Z = std::complex<double>;
    const auto c = coefficients<RootOfDifference, Z>({{Z(2, 0), Z(1, 0)}});
    bool seen = false;
    for (const Z& z : c) seen = seen || std::abs(z - 2.0 * std::sqrt(Z(-1, 0))) < 1e-15;
    CHECK(seen);
}

TEST_CASE("a term that only some parameters have is refused") {
    CHECK_NOTHROW(coefficients<Branches>({{0.9}}));
    CHECK_THROWS_WITH(coefficients<Branches>({{1.1}}),
                      "model = equation 1: must have the same terms for all parameters: do not branch on their values");
}

TEST_CASE("a coefficient that is not finite is refused") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (double bad : {nan, infinity}) {
        CHECK_THROWS_AS(coefficients<TwoLinkChain>({{0.3, bad, 2.0}}), InvalidArgument);
        CHECK_THROWS_AS(coefficients<models::Pendulum>({{bad}}), InvalidArgument);
    }
}

TEST_CASE("coefficients that vanish at some parameters are zero there") {
    const auto c = coefficients<TwoLinkChain>({{0.3, 1.5, 0.0}});  // no rotation: -sin theta_i alone
    int others = 0;
    for (double value : c) others += value != 0;
    CHECK(others == 2);
}
