// What is a model, what is not, and what follows from a model at compile time.
#include <array>
#include <type_traits>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/model.hpp>

#include "support/models.hpp"

namespace {

using namespace equilibria;
using mechanisms::RotatingChain;
using mechanisms::TwoLinkChain;

// Models, with a potential or with equations, with and without coordinates.
static_assert(Model<TwoLinkChain> && PotentialModel<TwoLinkChain> && !EquationsModel<TwoLinkChain>);
static_assert(Model<models::Pendulum> && EquationsModel<models::Pendulum> && !PotentialModel<models::Pendulum>);
static_assert(PotentialModel<models::ElasticPendulum> && EquationsModel<models::CoupledAngles<3>>);
static_assert(ModelSizes<RotatingChain<1>> && PotentialModel<RotatingChain<1>>);

struct NoAngles {
    static constexpr int n_angles = 0, n_coordinates = 1, n_parameters = 1;
    constexpr auto potential(const auto&, const auto& x, const auto& p) const { return x[0] * x[0] - p[0] * x[0]; }
};
static_assert(PotentialModel<NoAngles> && n_unknowns<NoAngles> == 1);
static_assert(Formulation<NoAngles>::degrees[0] == 1);

// A sum starts with the scalar of angles, or of coordinates, which have no cosine.
static_assert(std::is_same_v<scalar_of<const Array<CircleAngle<Complex<double>>, 1>&>, Complex<double>>);
static_assert(std::is_same_v<scalar_of<const Array<Complex<double>, 1>&>, Complex<double>>);
static_assert(std::is_same_v<scalar_of<const Array<double, 0>&>, double>);

// A model that has both gives its potential.
struct Both {
    static constexpr int n_angles = 1, n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) const { return cos(theta[0]); }
    constexpr auto equations(const auto& theta, const auto&) const { return std::array{-sin(theta[0])}; }
};
static_assert(PotentialModel<Both> && !EquationsModel<Both>);

// No models.
struct Empty {};
struct NoFunction {
    static constexpr int n_angles = 1, n_parameters = 0;
};
struct NoParameters {
    static constexpr int n_angles = 1;
    constexpr auto potential(const auto& theta, const auto&) const { return cos(theta[0]); }
};
struct NoNumberOfAngles {
    static constexpr int n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) const { return cos(theta[0]); }
};
struct NotConst {
    static constexpr int n_angles = 1, n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) { return cos(theta[0]); }
};
struct WrongArguments {
    static constexpr int n_angles = 1, n_parameters = 0;
    constexpr auto potential(const auto& theta) const { return cos(theta[0]); }
};
struct CoordinatesForgotten {
    static constexpr int n_angles = 1, n_coordinates = 1, n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) const { return cos(theta[0]); }
};
struct NoDefault : Both {
    explicit NoDefault(int) {}
};
static_assert(!Model<Empty> && !ModelSizes<Empty> && !Model<int>);
static_assert(ModelSizes<NoFunction> && !Model<NoFunction>);
static_assert(!Model<NoParameters> && !Model<NoNumberOfAngles> && NoNumberOfAngles::n_parameters == 0);
static_assert(!Model<NotConst> && !Model<WrongArguments> && !Model<CoordinatesForgotten> && !Model<NoDefault>);

// Sizes.
static_assert(n_angles<RotatingChain<4>> == 4 && n_coordinates<RotatingChain<4>> == 0);
static_assert(n_parameters<RotatingChain<4>> == 10 && n_parameters<TwoLinkChain> == 3);
static_assert(n_unknowns<models::Everything> == 3 && n_angles<models::Everything> == 2);

// Angles are no numbers.
template <class A, class B>
concept Comparable = requires(A a, B b) { a < b; };
static_assert(!Comparable<CircleAngle<double>, double>);
static_assert(!std::is_convertible_v<CircleAngle<double>, double>);
static_assert(!std::is_convertible_v<double, CircleAngle<double>>);
static_assert(AngleLike<CircleAngle<double>> && AngleLike<const SymbolicAngle<1, 0>&> && !AngleLike<double>);

// Supports: equation i of a chain has c_i s_j for every j, and s_i.
template <int N>
constexpr bool chain_is_as_written() {
    using F = Formulation<RotatingChain<N>>;
    using Basis = Monomial<N, 0>;
    if (F::terms != N * (N + 1)) return false;
    for (int i = 0; i < N; ++i) {
        if (F::degrees[i] != 2 || F::first[i] != i * (N + 1)) return false;
        for (int j = 0; j < N; ++j) {
            // c_i s_i is sin(2 theta_i) / 2
            const Basis product = i == j ? Basis::single(i, -2) : join(Basis::single(i, 1), Basis::single(j, -1));
            bool found = false, weight = false;
            for (int k = F::first[i]; k < F::first[i + 1]; ++k) {
                found = found || F::support[k].monomial == product;
                weight = weight || F::support[k].monomial == Basis::single(i, -1);
            }
            if (!found || !weight) return false;
        }
    }
    return F::reflection_symmetric && F::has_potential && F::degree_in(0) == 2;
}
static_assert(chain_is_as_written<2>() && chain_is_as_written<3>() && chain_is_as_written<5>());

constexpr long paths(auto degrees) {
    long product = 1;
    for (int d : degrees) product *= 2 * d;
    return product;
}
static_assert(paths(Formulation<TwoLinkChain>::degrees) == 16);
static_assert(paths(Formulation<RotatingChain<6>>::degrees) == 4096);

// sin(theta_i - theta_j) is two products, and two loads; not odd in theta.
static_assert(Formulation<models::CoupledAngles<3>>::terms == 3 * (2 + 2 * 2));
static_assert(!Formulation<models::CoupledAngles<3>>::reflection_symmetric);
static_assert(!Formulation<models::CoupledAngles<3>>::has_potential);

// sin(theta) - torque: a constant term.
static_assert(Formulation<models::Pendulum>::terms == 2 && Formulation<models::Pendulum>::degrees[0] == 1);
static_assert(!Formulation<models::Pendulum>::reflection_symmetric);

// Coordinates: g x sin(theta), and k (x - 1) - g cos(theta).
static_assert(Formulation<models::ElasticPendulum>::terms == 1 + 3);
static_assert(Formulation<models::ElasticPendulum>::degrees == Array<int, 2>{{2, 1}});
static_assert(!Formulation<models::ElasticPendulum>::reflection_symmetric);

// cos(2 theta_1 - 3 theta_2 + phase) has degree 5, sin(theta)^2 x harmonics up to 2, x^3 differentiates to x^2.
static_assert(Formulation<models::Everything>::degrees == Array<int, 3>{{5, 5, 2}});
static_assert(Formulation<models::Everything>::degree_in(0) == 2 && Formulation<models::Everything>::degree_in(1) == 3);
static_assert(Formulation<models::Everything>::degree_in(2) == 2);

// Cancellations leave no term: sin^2 + cos^2 is constant.
struct Identity {
    static constexpr int n_angles = 1, n_parameters = 1;
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto s = sin(theta[0]), c = cos(theta[0]);
        return p[0] * (s * s + c * c) * c + pow(s, 2) + pow(c, 2) + s / (c * c + s * s);
    }
};
static_assert(Formulation<Identity>::terms == 2 && Formulation<Identity>::degrees[0] == 1);

}  // namespace
