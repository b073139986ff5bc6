// A start with a law of time of its own, quadratic in t: its paths lead to the same roots, and its Taylor coefficients
// are those of the law.
#include <algorithm>
#include <complex>

#include <equilibria/core/random.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/paths/own_homotopy.hpp>
#include <equilibria/start/solved_instance.hpp>
#include <equilibria/system/sparse_system.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

using M = models::TwoAngleMechanism;

/// A solved instance whose coefficients go along a parabola: (1-t) b + t a + t (1-t) c.
class Parabola {
public:
    static constexpr int law_order = 2;

    Parabola(const SparseSystem& from, const SparseSystem& to, std::complex<double> gamma,
             SolvedInstance::Points points, Generator& generator)
        : line_(from, to, gamma, std::move(points)) {
        for (std::size_t k = 0; k < line_.from().size(); ++k) bend_.push_back(0.3 * unit_complex(generator));
    }

    const std::vector<SparseTerm>& terms(const SparseSystem& target) const { return line_.terms(target); }
    const std::vector<std::complex<double>>& from() const { return line_.from(); }
    StartForms forms() const { return {}; }
    static std::string name() { return "a parabola"; }
    PathNumbering numbering() const { return line_.numbering(); }
    RuntimePoint<double> point(std::uint64_t k) const { return line_.point(k); }

    template <int Order, class R, class Time>
    Complex<R> law(int term, double target, const Time& t) const {
        const auto k = static_cast<std::size_t>(term);
        const auto b = broadcast_complex<R>(line_.from()[k]), c = broadcast_complex<R>(bend_[k]);
        const auto a = broadcast_complex<R>(std::complex<double>(target));
        if constexpr (Order == 0)
            return b + (a - b) * t + c * (t * (1.0 - t));
        else if constexpr (Order == 1)
            return a - b + c * (1.0 - 2.0 * t);
        else
            return -1.0 * c;
    }

private:
    SolvedInstance line_;
    std::vector<std::complex<double>> bend_;
};

}  // namespace

TEST_CASE("a start with a quadratic law of time leads to the roots that a line leads to") {
    Generator generator(5);
    const auto some = [&] {
        Parameters<M> p;
        for (double& value : p) value = uniform(generator, 0.5, 1.5);
        return p;
    };
    const auto from = sparse_system<M>(some()), to = sparse_system<M>(some());
    const std::vector<int> grouping{0, 1};
    const auto solved = solve_multihomogeneous(from, grouping);
    REQUIRE(solved.paths.failed == 0);
    const auto line = solve_from(solved.roots, from, to);
    SolvedInstance::Points points;
    for (const auto& root : solved.roots) points.push_back(root.q);
    const Parabola start(from, to, unit_complex(generator), std::move(points), generator);
    const auto found = complex_roots(SparseHomotopy<Parabola>(to, start), start);
    CHECK(found.paths.accounted_for());
    CHECK(found.paths.failed == 0);
    REQUIRE(found.roots.size() == line.roots.size());
    for (const auto& root : line.roots)
        CHECK(std::any_of(found.roots.begin(), found.roots.end(), [&](const auto& other) {
            double distance = 0;
            for (int u = 0; u < 2; ++u)
                distance += std::abs(std::exp(std::complex<double>(0, 1) * root.q[u]) -
                                     std::exp(std::complex<double>(0, 1) * other.q[u]));
            return distance < 1e-8;
        }));
}
