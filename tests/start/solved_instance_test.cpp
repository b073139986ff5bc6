// The law of a parameter homotopy's coefficients: gamma b at t = 0, a at t = 1, linear between; terms of either system.
#include <complex>

#include <equilibria/core/random.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/start/solved_instance.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Z = std::complex<double>;

namespace {

using System = SparseSystem;
using Polynomial = TrigonometricPolynomial<0, 2>;
using Polynomials = std::vector<Polynomial>;

Polynomial power(int unknown, int k, double by) { return Polynomial(Polynomial::Basis::single(unknown, k), by); }

}  // namespace

TEST_CASE("coefficients go from gamma times the solved system's to the target's, 0 where one has no such term") {
    const System from(Polynomials{power(0, 2, 3) - Polynomial(1), power(1, 1, 2) - power(0, 1, 5)});
    const System to(Polynomials{power(0, 2, 7) + power(1, 1, 4), power(1, 1, -1) - Polynomial(6)});
    const Z gamma = std::polar(1.0, 0.7);
    const SolvedInstance start(from, to, gamma, {{Z(1), Z(2.5)}, {Z(-1), Z(-2.5)}});
    const PolynomialHomotopy homotopy(to, start);
    const auto coefficient = [](const System& system, const System::Term& like) {
        for (const auto& t : system.terms())
            if (!before(t, like) && !before(like, t)) return t.coefficient;
        return 0.0;
    };
    const auto& terms = start.terms(to);
    CHECK(terms.size() == 6);
    for (std::size_t k = 0; k < terms.size(); ++k) {
        const auto& t = terms[k];
        const int term = static_cast<int>(k);
        CHECK(t.coefficient == coefficient(to, t));
        const auto law = [&](double time) {
            const Complex<double> a = homotopy.law<0, double>(term, time);
            return Z(a.re, a.im);
        };
        const Z b = gamma * coefficient(from, t);
        CHECK(std::abs(law(0) - b) < 1e-15 * 7);
        CHECK(std::abs(law(1) - t.coefficient) == 0);
        CHECK(std::abs(law(0.25) - (0.75 * b + 0.25 * t.coefficient)) < 1e-15 * 7);
        CHECK(std::abs(homotopy.law<1, double>(term, 0.25) - (t.coefficient - b)) < 1e-15 * 7);
    }
    for (std::size_t k = 1; k < terms.size(); ++k) CHECK(before(terms[k - 1], terms[k]));
    CHECK(start.numbering().total() == 2);
    CHECK(start.numbering().resting() == 0);
    CHECK(start.point(1).x[1].re == -2.5);
}
