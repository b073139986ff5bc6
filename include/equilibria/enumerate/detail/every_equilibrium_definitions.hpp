/// \file
/// See enumerate/every_equilibrium.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <equilibria/algebra/exact_scalars.hpp>
#include <equilibria/core/sorted_order.hpp>
#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/enumerate/classify.hpp>
#include <equilibria/enumerate/every_equilibrium.hpp>

namespace equilibria::detail {

/// The real equations of a model in units: of a gradient by a congruence of the Hessian, of others by a similarity of
/// the Jacobian, so that neither indices nor signs of eigenvalues change.
class EquationsInUnits final : public RealEquations {
public:
    EquationsInUnits(const RealEquations& of, const std::vector<int>& powers)
        : RealEquations(of.sizes, of.has_potential), of_(&of), powers_(powers) {}

    void linearize(const double* q, double* f, double* jacobian) const override {
        const RuntimeArray<double> at = back(q);
        of_->linearize(at.begin(), f, jacobian);
        const int n = sizes.unknowns;
        for (int i = 0; i < n; ++i) {
            f[i] = std::ldexp(f[i], row(i));
            for (int j = 0; j < n; ++j) jacobian[i * n + j] = std::ldexp(jacobian[i * n + j], row(i) + power(j));
        }
    }
    double energy(const double* q) const override { return of_->energy(back(q).begin()); }

private:
    int power(int u) const { return powers_[static_cast<std::size_t>(u)]; }
    int row(int u) const { return has_potential ? power(u) : -power(u); }
    RuntimeArray<double> back(const double* q) const {
        RuntimeArray<double> y(sizes.unknowns);
        for (int u = 0; u < y.size(); ++u) y[u] = std::ldexp(q[u], power(u));
        return y;
    }

    const RealEquations* of_;
    const std::vector<int>& powers_;
};

/// The model's exact equations in units, as EquationsInUnits has them.
EQUILIBRIA_INLINE ExactTerms in_units(ExactTerms exact, const std::vector<int>& powers) {
    for (auto& t : exact.terms) {
        int power = powers[static_cast<std::size_t>(t.equation)];
        for (int k = t.first; k < t.last; ++k) {
            const auto& factor = exact.factors[static_cast<std::size_t>(k)];
            if (factor.unknown >= exact.sizes.angles)
                power += factor.code * powers[static_cast<std::size_t>(factor.unknown)];
        }
        t.coefficient = t.coefficient * ExactBall(std::ldexp(1.0, power));
    }
    return exact;
}

EQUILIBRIA_INLINE RootsVerdict verdict_of(const ProofOfRoots& proof) {
    RootsVerdict v;
    v.completeness = proof.complete ? Completeness::complete : Completeness::open;
    if (proof.bound) v.missing_at_most = proof.bound->value - std::min(proof.bound->value, proof.distinct);
    v.sentence = proof.reason;
    return v;
}

EQUILIBRIA_INLINE void say_stopped(RootsVerdict& verdict, const PathCounts& paths) {
    if (verdict.completeness == Completeness::complete) return;
    verdict.sentence +=
        "; " + std::to_string(paths.cancelled) + " paths were not followed to their ends, since the run was stopped";
}

EQUILIBRIA_INLINE std::optional<SparseSystem> system_of_exact(const ExactTerms& exact) {
    std::vector<SparseTerm> terms;
    for (const auto& t : exact.terms) {
        if (!may_differ_from_zero(t.coefficient)) continue;
        std::vector<int> codes(static_cast<std::size_t>(exact.sizes.unknowns));
        for (int k = t.first; k < t.last; ++k) {
            const auto& factor = exact.factors[static_cast<std::size_t>(k)];
            codes[static_cast<std::size_t>(factor.unknown)] = factor.code;
        }
        terms.push_back({t.equation, SparseMonomial(std::move(codes)), t.coefficient.mid().to<double>()});
    }
    return system_of_terms(exact.sizes, terms);
}

EQUILIBRIA_INLINE EveryEquilibrium equilibria_of(const SparseSystem& system, const ModelToSolve& problem,
                                                 const RunOptions& run, std::optional<StartKind> asked) {
    EveryRootOptions options;
    for (const auto& bound : {total_degree_bound(problem.exact), mixed_volume_bound(problem.exact)})
        if (bound) options.bounds.push_back(*bound);
    EveryRoot found = every_root(system, fewest_paths(start_bounds(system, {}, true, run), asked), run, options);
    const UnitScaling units = unit_scaling(system);
    const int n = system.sizes().unknowns;

    EveryEquilibrium y;
    RootSet<RuntimeUnknowns>& set = y.set;
    set.parameters = problem.p;
    set.seed = run.seed;
    set.paths = found.found.paths;
    set.model = problem.model;
    set.roots = std::move(found.found.roots);
    set.families = std::move(found.families);
    set.failures = std::move(found.found.failures);
    set.tracking_seconds = found.tracking_seconds;
    set.start = {std::string(to_string(found.start.kind)), found.start.why, found.start.bounds.mixed_volume};
    set.completeness = std::move(found.verdict);
    y.confirmed = std::move(found.confirmed);
    y.at_infinity = std::move(found.at_infinity);

    const auto scale = [&](auto& q, int sign) {
        for (int u = 0; u < n; ++u) {
            const int power = sign * units.unknown[static_cast<std::size_t>(u)];
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(q[0])>, double>)
                q[u] = std::ldexp(q[u], power);
            else
                q[u] = {std::ldexp(q[u].real(), power), std::ldexp(q[u].imag(), power)};
        }
    };
    for (auto& root : set.roots) scale(root.q, -1);
    y.proof = prove_set(set, in_units(problem.exact, units.unknown),
                        [&]() -> std::optional<ProvedBound> {
                            const auto at = std::ranges::min_element(options.bounds, {}, &ProvedBound::value);
                            return at == options.bounds.end() ? std::nullopt : std::optional(*at);
                        },
                        {.executor = run.executor, .ranks = run.ranks}, {});
    const double largest = std::ldexp(1.0, *std::ranges::max_element(units.unknown));
    for (const MovedRoot& refined : y.proof.moved) {
        std::copy(refined.q.begin(), refined.q.end(), set.roots[refined.root].q.begin());
        y.proof.certificates[refined.root].radius = refined.radius;
    }
    for (Certificate& c : y.proof.certificates) c.radius *= largest;

    y.proof.contradictions = 0;  // nothing was classified before
    const EquationsInUnits equations(*problem.equations, units.unknown);
    RootClassifier classifier(equations);
    std::vector<std::array<std::int64_t, 3>> keys;
    for (std::size_t k = 0; k < set.roots.size(); ++k) {
        const auto& root = set.roots[k];
        const Certificate& c = y.proof.certificates[k];
        const double imaginary = largest_imaginary(root);
        RuntimeArray<double> q(n);
        bool real = c.exists ? c.reality == Reality::real : classifier.is_real(view(root), {q.begin(), q.end()});
        if (c.exists && real)
            for (int u = 0; u < n; ++u) q[u] = root.q[u].real();
        if (!real) {
            set.smallest_nonreal_imaginary = std::min(set.smallest_nonreal_imaginary, imaginary);
            continue;
        }
        set.largest_real_imaginary = std::max(set.largest_real_imaginary, imaginary);
        for (int u = 0; u < system.sizes().angles; ++u) {
            q[u] = std::remainder(q[u], 2 * std::numbers::pi);
            if (q[u] <= -std::numbers::pi) q[u] = std::numbers::pi;
        }
        auto e = equilibrium_of(root, q, RootClassifier(equations).classify({q.begin(), q.end()}));
        y.proof.contradictions += c.index_proved && !e.degenerate() && e.index != c.index;
        if (c.index_proved) e.index = c.index, e.nullity = 0;
        keys.push_back({e.index, e.nullity, static_cast<std::int64_t>(e.path)});
        set.equilibria.push_back(std::move(e));
    }
    set.equilibria = in_order(sorted_order(keys), std::move(set.equilibria));
    set.alarms = check_alarms(set, run.executor, run.ranks);
    for (auto& root : set.roots) scale(root.q, 1);
    for (auto& e : set.equilibria) scale(e.q, 1);
    if (set.completeness.completeness == Completeness::complete && y.proof.distinct < found.proof.distinct) {
        set.completeness.completeness = Completeness::open;
        set.completeness.missing_at_most = found.proof.distinct - y.proof.distinct;
        set.completeness.sentence = "roots of the rounded equations could not be proved to be those of the model";
    }
    y.proof.complete = set.completeness.completeness == Completeness::complete;
    y.proof.reason = set.completeness.sentence;
    return y;
}

}  // namespace equilibria::detail
