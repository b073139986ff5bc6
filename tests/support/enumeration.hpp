// Laws that every enumeration obeys, and the chains that the tests enumerate.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/torus.hpp>

#include "support/catch.hpp"

namespace tests {

using namespace equilibria;

/// Sanitizers make everything ten times slower: the loops over random cases shrink.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr int thoroughness = 1;
#else
inline constexpr int thoroughness = 10;
#endif

template <int N>
using Chain = mechanisms::RotatingChain<N>;

/// l_i = 1 + i/10, m_i = 1 + i^2/20, g = 1: the chain of the speed tables.
template <int N>
Parameters<Chain<N>> benchmark_chain(double omega = 1.7) {
    Parameters<Chain<N>> p;
    for (int i = 0; i < N; ++i) {
        p[Chain<N>::length + i] = 1 + (i + 1) / 10.0;
        p[Chain<N>::mass + i] = 1 + (i + 1) * (i + 1) / 20.0;
    }
    p[Chain<N>::omega] = omega;
    p[Chain<N>::gravity] = 1;
    return p;
}

template <int N>
Parameters<Chain<N>> random_chain(Generator& generator) {
    Parameters<Chain<N>> p;
    for (int i = 0; i < N; ++i) {
        p[Chain<N>::length + i] = uniform(generator, 0.4, 2.5);
        p[Chain<N>::mass + i] = uniform(generator, 0.1, 2);
    }
    p[Chain<N>::omega] = uniform(generator, 0.2, 4);
    p[Chain<N>::gravity] = 1;
    return p;
}

/// Lengths, masses, omega, and g = 1.
template <int N>
Parameters<Chain<N>> chain(const double (&lengths)[N], const double (&masses)[N], double omega, double gravity = 1) {
    Parameters<Chain<N>> p;
    for (int i = 0; i < N; ++i) p[Chain<N>::length + i] = lengths[i], p[Chain<N>::mass + i] = masses[i];
    p[Chain<N>::omega] = omega;
    p[Chain<N>::gravity] = gravity;
    return p;
}

/// The largest difference of two roots: of angles modulo 2 pi, complex.
template <class M>
double distance(const Root<M>& a, const Root<M>& b) {
    double largest = 0;
    for (int u = 0; u < n_unknowns<M>; ++u) {
        std::complex<double> d = a.q[u] - b.q[u];
        if (u < n_angles<M>) d.real(wrap(d.real()));
        largest = std::max(largest, std::abs(d));
    }
    return largest;
}

/// The largest distance from a root of `a` to the nearest one of `b`.
template <class M>
double distance(const std::vector<Root<M>>& a, const std::vector<Root<M>>& b) {
    double largest = 0;
    for (const auto& r : a) {
        double nearest = 1e300;
        for (const auto& s : b) nearest = std::min(nearest, distance(r, s));
        largest = std::max(largest, nearest);
    }
    return largest;
}

/// The same roots, each within the tolerance of its own partner.
template <class M>
bool same_roots(const RootSet<M>& a, const RootSet<M>& b, double tolerance) {
    return a.distinct() == b.distinct() && distance(a.roots, b.roots) <= tolerance &&
           distance(b.roots, a.roots) <= tolerance;
}

/// The complex conjugates of the roots.
template <class M>
std::vector<Root<M>> conjugated(std::vector<Root<M>> roots) {
    for (auto& r : roots)
        for (auto& q : r.q) q = std::conj(q);
    return roots;
}
/// The mirror images theta -> -theta.
template <class M>
std::vector<Root<M>> mirrored(std::vector<Root<M>> roots) {
    for (auto& r : roots)
        for (auto& q : r.q) q = -q;
    return roots;
}

/// Everything but the times, bit by bit.
template <class M>
bool identical(const RootSet<M>& a, const RootSet<M>& b) {
    const auto& x = a.paths;
    const auto& y = b.paths;
    if (x.total != y.total || x.finite != y.finite || x.at_infinity != y.at_infinity || x.singular != y.singular ||
        x.failed != y.failed || x.cancelled != y.cancelled || x.retracked != y.retracked || x.crossed != y.crossed ||
        x.steps != y.steps || a.roots.size() != b.roots.size() || a.equilibria.size() != b.equilibria.size() ||
        a.families.size() != b.families.size())
        return false;
    for (std::size_t k = 0; k < a.families.size(); ++k) {
        const auto &f = a.families[k], &g = b.families[k];
        if (f.dimension != g.dimension || !(f.real_point == g.real_point) || f.points.size() != g.points.size())
            return false;
        for (std::size_t m = 0; m < f.points.size(); ++m)
            if (!(f.points[m].q == g.points[m].q) || !(f.points[m].neighbour == g.points[m].neighbour)) return false;
    }
    for (std::size_t k = 0; k < a.roots.size(); ++k) {
        const auto &r = a.roots[k], &s = b.roots[k];
        if (!(r.q == s.q) || r.residual != s.residual || r.condition != s.condition || r.path != s.path ||
            r.paths != s.paths)
            return false;
    }
    for (std::size_t k = 0; k < a.equilibria.size(); ++k) {
        const auto &e = a.equilibria[k], &f = b.equilibria[k];
        if (!(e.q == f.q) || e.index != f.index || e.margin != f.margin || e.path != f.path) return false;
    }
    return true;
}

/// The residual of the user's own equations at a real point, relative to the largest coefficient of each.
template <class M>
double residual(const Unknowns<M>& q, const Parameters<M>& p) {
    const auto f = equations<M, double>(q, p);
    const auto scale = equation_scales<M>(coefficients<M, double>(p));
    double largest = 0;
    for (int u = 0; u < n_unknowns<M>; ++u) largest = std::max(largest, std::abs(f[u]) / scale[u]);
    return largest;
}

/// The sentence with which `action` refuses its arguments.
template <class Action>
std::string refusal(Action&& action) {
    try {
        action();
    } catch (const InvalidArgument& error) {
        return error.what();
    } catch (const CheckpointError& error) {
        return error.what();
    }
    return "nothing was refused";
}

/// What holds of every result, clean or not.
template <class M>
void check_accounts(const RootSet<M>& r) {
    CAPTURE(r.seed, r.paths.total, r.paths.finite, r.paths.at_infinity, r.paths.singular, r.paths.failed);
    CHECK(r.paths.accounted_for());
    CHECK(r.failures.size() == r.paths.failed);
    CHECK(r.distinct() <= r.paths.finite + r.paths.singular);
    CHECK(r.real() <= r.distinct());
    std::uint64_t ends = 0;
    for (const auto& root : r.roots) ends += static_cast<std::uint64_t>(root.paths);
    for (const auto& family : r.families) ends += family.paths();
    CHECK(ends == r.paths.finite + r.paths.singular);
    std::int64_t by_index = 0;
    for (const auto count : r.by_index()) by_index += count;
    CHECK(by_index + static_cast<std::int64_t>(r.degenerate()) == static_cast<std::int64_t>(r.real()));
    double largest = 0;
    bool in_range = true;
    for (const auto& e : r.equilibria) {
        if (!e.degenerate()) largest = std::max(largest, residual<M>(e.q, r.parameters));
        for (int i = 0; i < n_angles<M>; ++i)
            in_range = in_range && e.q[i] > -std::numbers::pi && e.q[i] <= std::numbers::pi;
    }
    CHECK(largest < 1e-12);
    CHECK(in_range);
}

/// What holds of the chain at parameters that are not on its bifurcation locus.
template <int N>
void check_generic_chain(const RootSet<Chain<N>>& r) {
    check_accounts(r);
    const std::uint64_t all = std::uint64_t{1} << (2 * N);
    CHECK(r.paths.total == all);
    CHECK(r.paths.finite == all);
    CHECK(r.paths.failed == 0);
    CHECK(r.distinct() == all);
    CHECK(r.clean());
    CHECK(r.morse());
    CHECK(r.real() >= std::uint64_t{1} << N);
    CHECK(r.real() <= all);
    CHECK(r.real() % 2 == 0);
    // the 2^n points with every sine 0 are among them
    const auto straight = std::count_if(r.equilibria.begin(), r.equilibria.end(), [](const auto& e) {
        return std::all_of(e.q.begin(), e.q.end(), [](double a) { return std::abs(std::sin(a)) < 1e-12; });
    });
    CHECK(straight == 1 << N);
}

}  // namespace tests
