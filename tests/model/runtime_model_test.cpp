// Models whose numbers of unknowns are known at run time alone: their equations and Jacobians are those of the same
// model as a type, over any scalar.
#include <cmath>
#include <complex>
#include <vector>

#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/equations.hpp>
#include <equilibria/model/runtime_model.hpp>
#include <equilibria/model/runtime_model_functions.hpp>

#include "support/catch.hpp"
#include "support/random_parameters.hpp"

using namespace equilibria;

namespace {

/// x_j' = ..: equations in plain coordinates and an angle, any number of them, not constexpr.
struct Forced {
    std::vector<double> weights;  // a coordinate each

    int angles() const { return 1; }
    int coordinates() const { return static_cast<int>(weights.size()); }
    int parameters() const { return 1; }
    auto equations(const auto& theta, const auto& x, const auto& p) const {
        using S = std::remove_cvref_t<decltype(x[0] * p[0])>;
        std::vector<S> f{sin(theta[0]) - p[0]};
        for (int j = 0; j < x.size(); ++j)
            f.push_back(weights[static_cast<std::size_t>(j)] * x[j] * x[j] - p[0] * x[j] + cos(theta[0]));
        return f;
    }
};
struct TooFew : Forced {
    auto equations(const auto&, const auto& x, const auto& p) const {
        return std::vector<std::remove_cvref_t<decltype(x[0] * p[0])>>(1);
    }
};
struct NoUnknowns {
    int angles() const { return 0; }
    int parameters() const { return 0; }
    auto potential(const auto&, const auto&) const { return 0.0; }
};

static_assert(RuntimePotentialModel<mechanisms::RuntimeRotatingChain>);
static_assert(RuntimeEquationsModel<Forced> && !RuntimePotentialModel<Forced>);
static_assert(!RuntimeModel<mechanisms::TwoLinkChain>);

template <int N>
void check_chain() {
    using M = mechanisms::RotatingChain<N>;
    const mechanisms::RuntimeRotatingChain model{N};
    Generator generator(N);
    const auto p = tests::random_parameters<M>(generator);
    Unknowns<M> q;
    for (double& angle : q) angle = uniform(generator, -3, 3);
    const auto own = equations<M>(q, p);
    const auto slopes = detail::equations_and_slopes<M, double>(q, p);
    const RuntimeModelFunctions functions(model);
    RuntimeArray<double> f;
    RuntimeMatrix<double> j;
    functions.linearize(runtime_array(q), runtime_array(p), f, j);
    REQUIRE(f.size() == N);
    for (int r = 0; r < N; ++r) {
        CHECK(std::abs(f[r] - own[r]) < 1e-13 * (1 + std::abs(own[r])));
        for (int c = 0; c < N; ++c)
            CHECK(std::abs(j[r][c] - slopes[r].derivative[c]) < 1e-13 * (1 + std::abs(j[r][c])));
    }
    // along a line of unknowns and parameters, by both kinds of functions
    Unknowns<M> v;
    Parameters<M> w;
    for (double& x : v) x = uniform(generator, -1, 1);
    for (double& x : w) x = uniform(generator, -1, 1);
    const auto derivatives = [&](const ModelDerivatives<>& of) {
        RuntimeArray<double> df;
        RuntimeMatrix<double> dj;
        of.derivatives_along(runtime_array(q), runtime_array(v), runtime_array(p), runtime_array(w), df, dj);
        return std::pair{df, dj};
    };
    const auto [df, dj] = derivatives(functions);
    const auto [typed_df, typed_dj] = derivatives(functions_of<M>());
    for (int r = 0; r < N; ++r) {
        CHECK(std::abs(df[r] - typed_df[r]) < 1e-12 * (1 + std::abs(df[r])));
        for (int c = 0; c < N; ++c) CHECK(std::abs(dj[r][c] - typed_dj[r][c]) < 1e-12 * (1 + std::abs(dj[r][c])));
    }
    for (int order = 1; order <= 4; ++order) {
        const auto a = directional_derivative(functions, order, runtime_array(q), runtime_array(v), runtime_array(p));
        const auto b =
            directional_derivative(functions_of<M>(), order, runtime_array(q), runtime_array(v), runtime_array(p));
        for (int r = 0; r < N; ++r) CHECK(std::abs(a[r] - b[r]) < 1e-11 * (1 + std::abs(b[r])));
    }
}

}  // namespace

TEST_CASE("a chain at run time has the equations, slopes and derivatives of the chain as a type") {
    check_chain<1>();
    check_chain<3>();
    check_chain<4>();  // as many as there are directions
    check_chain<5>();
    check_chain<9>();
}

TEST_CASE("equations in angles and coordinates: the Jacobian is the derivative") {
    const Forced model{{1, 2, -3, 0.5, 4}};
    const RuntimeModelFunctions functions(model);
    RuntimeArray<double> q{0.3, 1, -2, 0.7, 0.1, 0.9}, p{0.4}, f;
    RuntimeMatrix<double> j;
    functions.linearize(q, p, f, j);
    CHECK(f[0] == Approx(std::sin(0.3) - 0.4));
    for (int c = 0; c < 6; ++c) {
        const auto at = [&](double by) {
            RuntimeArray<double> moved = q;
            moved[c] += by;
            return equations(functions, moved, p);
        };
        const auto up = at(1e-5), down = at(-1e-5);
        for (int r = 0; r < 6; ++r) CHECK(std::abs((up[r] - down[r]) / 2e-5 - j[r][c]) < 1e-8);
    }
}

TEST_CASE("what is no model at run time is refused in a sentence") {
    CHECK_THROWS_WITH(sizes_of(NoUnknowns{}), "model = no unknowns: needs at least one unknown angle or coordinate");
    const RuntimeModelFunctions functions(TooFew{{{1, 2}}});
    RuntimeArray<double> f;
    RuntimeMatrix<double> j;
    CHECK_THROWS_WITH(functions.linearize({0, 0, 0}, {1}, f, j),
                      "model.equations(..).size() = 1: must be one for each unknown angle and coordinate");
    CHECK_THROWS_WITH(sizes_of(mechanisms::RuntimeRotatingChain{-1}), "model.angles() = -1: must not be negative");
}
