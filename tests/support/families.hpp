// Families of systems whose numbers of roots are known: polynomials of the literature, and equations of coupled angles.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/runtime_model.hpp>
#include <equilibria/system/runtime_formulation.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria::families {

/// A system of so many variables while it is written down; exponents by lists of variables, x^2 y as {x, x, y}.
class Writer {
public:
    explicit Writer(const std::string& letter, int n, int first = 1) {
        for (int k = first; k < first + n; ++k) system_.variables.push_back(letter + std::to_string(k));
    }
    Writer& equation() {
        sums_.emplace_back();
        return *this;
    }
    Writer& term(double coefficient, const std::vector<int>& variables = {}) {
        std::vector<int> exponents(system_.variables.size());
        for (const int v : variables) ++exponents[static_cast<std::size_t>(v)];
        sums_.back().add(exponents, coefficient);
        return *this;
    }
    PolynomialSystem<double> system() {
        system_.equations.clear();
        for (const auto& sum : sums_) system_.equations.push_back(sum.terms());
        return system_;
    }

private:
    PolynomialSystem<double> system_;
    std::vector<detail::PolynomialSum<double>> sums_;
};

/// Cyclic n-roots (Bjorck, Froberg, J. Symbolic Comput. 12, 1991): 70, 156, 924 for n = 5, 6, 7; not isolated where a
/// square divides n.
inline PolynomialSystem<double> cyclic(int n) {
    Writer w("x", n);
    for (int k = 1; k < n; ++k) {
        w.equation();
        for (int i = 0; i < n; ++i) {
            std::vector<int> product;
            for (int j = i; j < i + k; ++j) product.push_back(j % n);
            w.term(1, product);
        }
    }
    std::vector<int> all(static_cast<std::size_t>(n));
    std::iota(all.begin(), all.end(), 0);
    w.equation().term(1, all).term(-1);
    return w.system();
}

/// Katsura's equations in u0, .., un (Katsura, Spin glass problem by the method of integral equation of the effective
/// field, World Scientific, 1990): 2^n roots.
inline PolynomialSystem<double> katsura(int n) {
    Writer w("u", n + 1, 0);
    w.equation().term(1, {0}).term(-1);
    for (int l = 1; l <= n; ++l) w.term(2, {l});
    for (int m = 0; m < n; ++m) {
        w.equation().term(-1, {m});
        for (int l = -n; l <= n; ++l)
            if (std::abs(m - l) <= n) w.term(1, {std::abs(l), std::abs(m - l)});
    }
    return w.system();
}

/// Noonburg's neural network (SIAM J. Appl. Math. 49, 1989), coefficient 1.1: 3^n - 2 n roots.
inline PolynomialSystem<double> noon(int n) {
    Writer w("x", n);
    for (int i = 0; i < n; ++i) {
        w.equation().term(-1.1, {i}).term(1);
        for (int j = 0; j < n; ++j)
            if (j != i) w.term(1, {i, j, j});
    }
    return w.system();
}

/// The economics problem (Morgan, Solving Polynomial Systems Using Continuation, Prentice-Hall, 1987, p. 148), its
/// constants 1, .., n - 1: 2^(n-2) roots.
inline PolynomialSystem<double> eco(int n) {
    Writer w("x", n);
    for (int k = 1; k < n; ++k) {
        w.equation().term(1, {k - 1, n - 1}).term(-k);
        for (int i = 1; i + k < n; ++i) w.term(1, {i - 1, i + k - 1, n - 1});
    }
    w.equation().term(1);
    for (int i = 0; i < n - 1; ++i) w.term(1, {i});
    return w.system();
}

/// Reimer's system (PoSSo's list of test systems): sum_j 2 (-1)^(j+1) x_j^(i+1) = 1.
inline PolynomialSystem<double> reimer(int n) {
    Writer w("x", n);
    for (int i = 1; i <= n; ++i) {
        w.equation().term(-1);
        for (int j = 0; j < n; ++j) w.term(j % 2 == 0 ? 2 : -2, std::vector<int>(static_cast<std::size_t>(i + 1), j));
    }
    return w.system();
}

/// Chandrasekhar's H-equation, discretised (Gonzalez-Vega, Some examples of problem solving by using the symbolic
/// viewpoint, 1992), c = 0.51234: 2^(n-1) roots.
inline PolynomialSystem<double> chandra(int n) {
    constexpr double c = 0.51234;
    Writer w("h", n);
    for (int k = 1; k <= n; ++k) {
        w.equation().term(2.0 * n - c, {k - 1}).term(-2.0 * n);
        for (int i = 1; i < n; ++i) w.term(-c * k / (i + k), {k - 1, i - 1});
    }
    return w.system();
}

/// Two angles that see each other, by number.
struct Edge {
    int a, b;
};
using Edges = std::vector<Edge>;

/// Each with each.
inline Edges complete(int n) {
    Edges y;
    for (int a = 0; a < n; ++a)
        for (int b = a + 1; b < n; ++b) y.push_back({a, b});
    return y;
}
/// Each with the next.
inline Edges row(int n) {
    Edges y;
    for (int a = 0; a + 1 < n; ++a) y.push_back({a, a + 1});
    return y;
}
inline Edges cycle(int n) {
    Edges y = row(n);
    y.push_back({0, n - 1});
    return y;
}

/// Angles coupled by k cos(theta_a - theta_b), each loaded by g cos(theta) + h sin(theta): arms on springs, under dead
/// loads. Each with each: C(2n, n) roots; rows: 6, 16, 44, 120, 328 for n = 2, .., 6. Parameters: k of each edge, g, h.
struct LoadedAngles {
    int n;
    Edges edges;

    int angles() const { return n; }
    int parameters() const { return static_cast<int>(edges.size()) + 2 * n; }
    auto potential(const auto& theta, const auto& p) const {
        scalar_of<decltype(theta)> v{};
        int k = 0;
        for (const Edge& e : edges) v -= p[k++] * cos(theta[e.a] - theta[e.b]);
        for (int i = 0; i < n; ++i) {
            v -= p[k++] * cos(theta[i]);
            v -= p[k++] * sin(theta[i]);
        }
        return v;
    }
};

/// Kuramoto's oscillators at rest, the last of n + 1 at angle 0: w_a = sum_b k_ab sin(theta_a - theta_b). Of generic
/// couplings of each with each C(2n, n) roots, of cycles of N = n + 1 N C(N-1, floor((N-1)/2)), of equal couplings of
/// each with each 2^N - 2. Parameters: k of each edge, w of the n.
struct Oscillators {
    int n;
    Edges edges;  ///< of n + 1

    int angles() const { return n; }
    int parameters() const { return static_cast<int>(edges.size()) + n; }
    auto equations(const auto& theta, const auto& p) const {
        using S = std::remove_cvref_t<decltype(sin(theta[0]) * p[0])>;
        std::vector<S> f;
        const int m = static_cast<int>(edges.size());
        for (int i = 0; i < n; ++i) f.push_back(S() - p[m + i]);
        const auto pull = [&](int a, const auto& torque) {
            if (a < n) f[static_cast<std::size_t>(a)] = f[static_cast<std::size_t>(a)] + torque;
        };
        for (int k = 0; k < m; ++k) {
            const Edge& e = edges[static_cast<std::size_t>(k)];
            const S torque = p[k] * (e.b < n ? sin(theta[e.a] - theta[e.b]) : sin(theta[e.a]));
            pull(e.a, torque);
            pull(e.b, S() - torque);
        }
        return f;
    }
};

/// So many numbers between 0.5 and 1.5.
inline RuntimeArray<double> generic(int parameters, std::uint64_t seed) {
    Generator generator(seed);
    RuntimeArray<double> p(parameters);
    for (double& x : p) x = uniform(generator, 0.5, 1.5);
    return p;
}
/// Equal couplings of oscillators, and small generic frequencies.
inline RuntimeArray<double> equal_couplings(const Oscillators& model, std::uint64_t seed) {
    Generator generator(seed);
    RuntimeArray<double> p(model.parameters());
    const int m = static_cast<int>(model.edges.size());
    for (int k = 0; k < m; ++k) p[k] = 1;
    for (int i = 0; i < model.n; ++i) p[m + i] = uniform(generator, -0.3, 0.3);
    return p;
}

/// A model's equations at p as data.
template <RuntimeModel T>
SparseSystem system_of(const T& model, const RuntimeArray<double>& p) {
    std::vector<SparseTerm> terms;
    for (auto& t : RuntimeFormulation(model).terms(model, p))
        if (t.coefficient != 0) terms.push_back(std::move(t));
    return {sizes_of(model), std::move(terms)};
}

/// The system with a name as "cyclic-5": a family of polynomials; "loaded", "row" (LoadedAngles), "kuramoto",
/// "kuramoto-cycle", "kuramoto-equal" (Oscillators, number: how many) in (c, s). Throws InvalidArgument for another
/// name.
inline PolynomialSystem<double> by_name(const std::string& name) {
    const auto dash = name.rfind('-');
    const std::string family = name.substr(0, dash);
    const int n = dash == std::string::npos ? 0 : std::atoi(name.c_str() + dash + 1);
    require(n >= 2 && n <= 16, "system", name, "must end with -N, N from 2 to 16");
    const auto angles = [](const auto& model, const auto& p) { return polynomial_system(system_of(model, p)); };
    if (family == "cyclic") return cyclic(n);
    if (family == "katsura") return katsura(n);
    if (family == "noon") return noon(n);
    if (family == "eco") return eco(n);
    if (family == "reimer") return reimer(n);
    if (family == "chandra") return chandra(n);
    if (family == "loaded" || family == "row") {
        const LoadedAngles model{n, family == "row" ? row(n) : complete(n)};
        return angles(model, generic(model.parameters(), 1));
    }
    if (family.starts_with("kuramoto")) {
        const Oscillators model{n - 1, family == "kuramoto-cycle" ? cycle(n) : complete(n)};
        if (family == "kuramoto" || family == "kuramoto-cycle") return angles(model, generic(model.parameters(), 1));
        if (family == "kuramoto-equal") return angles(model, equal_couplings(model, 1));
    }
    throw InvalidArgument("system", name,
                          "must be of cyclic, katsura, noon, eco, reimer, chandra, loaded, row, kuramoto, "
                          "kuramoto-cycle, kuramoto-equal");
}

/// How many isolated roots the system of `by_name` has, where a formula or the literature says so; 0 elsewhere.
inline std::int64_t known_roots(const std::string& name) {
    const auto dash = name.rfind('-');
    const std::string family = name.substr(0, dash);
    const int n = dash == std::string::npos ? 0 : std::atoi(name.c_str() + dash + 1);
    const auto power = [](std::int64_t base, int k) {
        std::int64_t y = 1;
        for (int j = 0; j < k; ++j) y *= base;
        return y;
    };
    const auto choose = [](std::int64_t of, std::int64_t k) {
        std::int64_t y = 1;
        for (std::int64_t j = 1; j <= k; ++j) y = y * (of - k + j) / j;
        return y;
    };
    if (family == "cyclic") return n == 3 ? 6 : n == 5 ? 70 : n == 6 ? 156 : n == 7 ? 924 : 0;
    if (family == "katsura") return power(2, n);
    if (family == "noon") return power(3, n) - 2 * n;
    if (family == "eco") return power(2, n - 2);
    if (family == "chandra") return power(2, n - 1);
    if (family == "loaded") return choose(2 * n, n);
    if (family == "row") {  // r_n = 2 (r_(n-1) + r_(n-2))
        std::int64_t before = 2, y = 6;
        for (int k = 2; k < n; ++k) before = std::exchange(y, 2 * (y + before));
        return y;
    }
    if (family == "kuramoto") return choose(2 * n - 2, n - 1);
    if (family == "kuramoto-cycle") return n * choose(n - 1, (n - 1) / 2);
    if (family == "kuramoto-equal") return power(2, n) - 2;
    return 0;
}

}  // namespace equilibria::families
