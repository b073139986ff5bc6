#include <cmath>
#include <complex>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/polyhedral_homotopy.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/homotopy/tracker.hpp>
#include <equilibria/system/laurent_terms.hpp>

#include "support/catch.hpp"
#include "support/families.hpp"

using namespace equilibria;
using Z = Complex<double>;

namespace {

SparseSystem coupled(int n) {
    const families::LoadedAngles model{n, families::complete(n)};
    return families::system_of(model, families::generic(model.parameters(), 1));
}
PolyhedralStart start_of(const SparseSystem& system) {
    const auto supports = laurent_supports(system);
    Generator generator(4);
    std::vector<std::complex<double>> coefficients;
    for (int k = 0; k < supports.columns(); ++k) coefficients.push_back(unit_complex(generator));
    return PolyhedralStart(supports, coefficients, generator);
}
double size(const RuntimeArray<Z>& f) {
    double y = 0;
    for (const Z& z : f) y = std::max(y, std::sqrt(norm2(z)));
    return y;
}

}  // namespace

TEST_CASE("at t = 0 the start points fulfil the polyhedral homotopy to the size of the terms that are left out") {
    const PolyhedralStart start = start_of(coupled(3));
    const PolyhedralHomotopy homotopy(start);
    PolyhedralHomotopy::Evaluation<double, double> evaluation(homotopy);
    RuntimeArray<Z> f(3);
    for (std::uint64_t path = 0; path < start.numbering().total(); ++path) {
        evaluation.enter(0, path);
        evaluation.value(start.point(path), 0.0, f);
        CHECK(size(f) < 1e-5);
        evaluation.value(start.point(path), 1.0, f);
        CHECK(size(f) > 1e-3);
        RuntimeArray<Z> target(3);
        evaluation.target_value(start.point(path), target);
        for (int i = 0; i < 3; ++i) CHECK(norm2(target[i] - f[i]) < 1e-24);
    }
}

TEST_CASE(
    "the Jacobian of a polyhedral homotopy is that of its values, and its Taylor coefficients leave an error of order "
    "4") {
    const PolyhedralStart start = start_of(coupled(3));
    const PolyhedralHomotopy homotopy(start);
    PolyhedralHomotopy::Evaluation<double, double> evaluation(homotopy);
    const TrackerOptions options;
    RuntimeArray<Z> f(3), above(3), below(3);
    RuntimeMatrix<Z> j(3);
    for (const std::uint64_t path : {0, 7, 19}) {
        evaluation.enter(0, path);
        auto q = start.point(path);
        const double t = 0.6;
        evaluation.jacobian(q, t, f, j);
        for (int u = 0; u < 3; ++u) {
            RuntimeArray<Z> d(3);
            const double h = 1e-5;
            d[u] = Z(h, 0);
            evaluation.value(moved(q, d), t, above);
            d[u] = Z(-h, 0);
            evaluation.value(moved(q, d), t, below);
            for (int i = 0; i < 3; ++i)
                CHECK(norm2((above[i] - below[i]) / (2 * h) - j[i][u]) < 1e-12 * (1 + norm2(j[i][u])));
        }
        // along the path: from its start by steps of the tracker, then by the Taylor polynomial
        detail::Stepper<PolyhedralHomotopy, double> stepper(homotopy, options);
        stepper.enter(0, path);
        double at = 0, step = 0;
        for (int k = 0; k < 200 && at < 0.5; ++k) {
            stepper.expand(q, at);
            const auto& outcome = stepper.step(q, at, k == 0 ? stepper.first_step() : std::min(step, 1 - at));
            if (outcome.accepted) at += outcome.step, q = outcome.q;
            step = outcome.next_step;
        }
        REQUIRE(at >= 0.5);
        stepper.expand(q, at);
        stepper.expand(q, at);
        const auto error = [&](double h) {
            RuntimeArray<Z> d(3);
            for (int u = 0; u < 3; ++u)
                d[u] = h * stepper.coefficient(1, u) + h * h * stepper.coefficient(2, u) +
                       h * h * h * stepper.coefficient(3, u);
            evaluation.value(moved(q, d), at + h, f);
            return size(f);
        };
        const double h = 2e-3;
        CHECK(error(h) / error(h / 2) == Approx(16).epsilon(0.15));
    }
}

TEST_CASE(
    "a homotopy in exponentials has the values of that in cosines and sines, and keeps them far off the real axis") {
    const SparseSystem system = coupled(2);
    // the same line of coefficients, (1 - t) 2 F + t F, in both forms
    PolynomialHomotopy::Parts parts{
        .sizes = system.sizes(), .terms = system.terms(), .from = {}, .forms = {}, .scale = system.scale()};
    for (const auto& t : system.terms()) parts.from.push_back(2 * t.coefficient);
    const PolynomialHomotopy waves(parts);
    parts.terms.clear(), parts.from.clear();
    int equation = 0;
    const auto laurent = laurent_terms(system);
    for (const auto& terms : laurent) {
        for (const auto& t : terms) parts.terms.push_back({equation, SparseMonomial(t.exponents), 0});
        ++equation;
    }
    std::ranges::sort(parts.terms, [](const auto& a, const auto& b) { return before(a, b); });
    for (const auto& t : parts.terms)
        for (const auto& term : laurent[static_cast<std::size_t>(t.equation)])
            if (SparseMonomial(term.exponents) == t.monomial)
                parts.laurent.push_back(term.coefficient), parts.from.push_back(2.0 * term.coefficient);
    const PolynomialHomotopy exponentials(parts);
    PolynomialHomotopy::Evaluation<double, double> a(waves), b(exponentials);
    RuntimeArray<Z> f(2), g(2);
    RuntimeMatrix<Z> j(2), k(2);
    Generator generator(6);
    for (int draw = 0; draw < 20; ++draw) {
        UnknownArray<RuntimeUnknowns, std::complex<double>> theta(2);
        for (auto& angle : theta) angle = {uniform(generator, -3, 3), uniform(generator, -2, 2)};
        const auto q = point_of<RuntimeUnknowns>(theta, system.sizes());
        const double t = uniform(generator);
        a.jacobian(q, t, f, j);
        b.jacobian(q, t, g, k);
        for (int i = 0; i < 2; ++i) {
            CHECK(norm2(f[i] - g[i]) < 1e-24 * (1 + norm2(f[i])));
            for (int u = 0; u < 2; ++u) CHECK(norm2(j[i][u] - k[i][u]) < 1e-24 * (1 + norm2(j[i][u])));
        }
        for (int order = 1; order <= 3; ++order) {
            a.taylor_right_side(order, f);
            b.taylor_right_side(order, g);
            for (int i = 0; i < 2; ++i) CHECK(norm2(f[i] - g[i]) < 1e-22 * (1 + norm2(f[i])));
            if (order < 3) a.set_coefficient(order, f), b.set_coefficient(order, f);
        }
    }
    // sin(theta_1 - theta_2) where both angles are at 20 i: products of cosines and sines of 1e17 cancel
    UnknownArray<RuntimeUnknowns, std::complex<double>> far(2);
    far[0] = {0.3, 20}, far[1] = {-0.4, 20};
    const auto q = point_of<RuntimeUnknowns>(far, system.sizes());
    const auto [z, reciprocal] = detail::exponentials(q.c[0], q.s[0]);
    CHECK(std::sqrt(norm2(z * reciprocal - 1.0)) < 1e-15);
    CHECK(std::sqrt(norm2(z)) == Approx(std::exp(-20)).epsilon(1e-14));
}
