/// \file
/// See enumerate/every_equilibrium.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <equilibria/algebra/exact_scalars.hpp>
#include <equilibria/core/sorted_order.hpp>
#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/enumerate/classify.hpp>
#include <equilibria/enumerate/every_equilibrium.hpp>

namespace equilibria::detail {

/// Exact equations in double, evaluated term by term, with the energy of a model in its own units.
class EquationsOfTerms final : public RealEquations {
public:
    EquationsOfTerms(const ExactTerms& terms, const RealEquations& of, const std::vector<int>& powers)
        : RealEquations(of.sizes, of.has_potential), terms_(terms), of_(&of), powers_(powers) {
        for (const auto& t : terms.terms) coefficients_.push_back(t.coefficient.mid().to<double>());
    }

    void linearize(const double* q, double* f, double* jacobian) const override {
        const int n = sizes.unknowns;
        std::fill(f, f + n, 0.0);
        std::fill(jacobian, jacobian + n * n, 0.0);
        for (std::size_t k = 0; k < coefficients_.size(); ++k) {
            const auto& t = terms_.terms[k];
            const auto product_without = [&](int left_out) {
                double y = coefficients_[k];
                for (int m = t.first; m < t.last; ++m)
                    if (m != left_out) y *= value(m, q);
                return y;
            };
            f[t.equation] += product_without(-1);
            for (int m = t.first; m < t.last; ++m)
                jacobian[t.equation * n + factor(m).unknown] += product_without(m) * slope(m, q);
        }
    }
    double energy(const double* q) const override {
        RuntimeArray<double> y(sizes.unknowns);
        for (int u = 0; u < y.size(); ++u) y[u] = std::ldexp(q[u], powers_[static_cast<std::size_t>(u)]);
        return of_->energy(y.begin());
    }

private:
    const ExactTerms::Factor& factor(int m) const { return terms_.factors[static_cast<std::size_t>(m)]; }
    double value(int m, const double* q) const {
        const auto [u, code] = factor(m);
        if (u >= sizes.angles) return std::pow(q[u], code);
        return code > 0 ? std::cos(code * q[u]) : std::sin(-code * q[u]);
    }
    double slope(int m, const double* q) const {
        const auto [u, code] = factor(m);
        if (u >= sizes.angles) return code * std::pow(q[u], code - 1);
        return code > 0 ? -code * std::sin(code * q[u]) : -code * std::cos(-code * q[u]);
    }

    const ExactTerms& terms_;
    const RealEquations* of_;
    const std::vector<int>& powers_;
    std::vector<double> coefficients_;
};

/// 2^power, exactly.
EQUILIBRIA_INLINE ExactBall power_of_two(int power) {
    ExactBall y(1.0);
    for (; power > 1000; power -= 1000) y = y * ExactBall(std::ldexp(1.0, 1000));
    for (; power < -1000; power += 1000) y = y * ExactBall(std::ldexp(1.0, -1000));
    return y * ExactBall(std::ldexp(1.0, power));
}

/// A model's exact equations in units: of a gradient by a congruence of the Hessian, of others by a similarity of the
/// Jacobian, and all of them by one power of two, so that neither indices nor signs of eigenvalues change.
EQUILIBRIA_INLINE ExactTerms in_units(ExactTerms exact, const std::vector<int>& powers) {
    std::vector<int> of_term;
    int largest = std::numeric_limits<int>::min();
    for (const auto& t : exact.terms) {
        const int own = powers[static_cast<std::size_t>(t.equation)];
        int power = exact.symmetric ? own : -own;
        for (int k = t.first; k < t.last; ++k) {
            const auto& factor = exact.factors[static_cast<std::size_t>(k)];
            if (factor.unknown >= exact.sizes.angles)
                power += factor.code * powers[static_cast<std::size_t>(factor.unknown)];
        }
        of_term.push_back(power);
        if (may_differ_from_zero(t.coefficient))
            largest = std::max(largest, power + std::ilogb(t.coefficient.mid().to<double>()));
    }
    for (std::size_t k = 0; k < of_term.size(); ++k)
        exact.terms[k].coefficient = exact.terms[k].coefficient * power_of_two(of_term[k] - largest);
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

EQUILIBRIA_INLINE void say_curves_not_searched(RootsVerdict& verdict, ProofOfRoots& proof,
                                               const std::optional<ProvedBound>& paths) {
    verdict.completeness = Completeness::open;
    verdict.sentence += "; curves of equilibria, which it does not count, were not looked for: " +
                        (paths ? std::to_string(paths->value) + " paths" : "more paths than can be counted") +
                        " would find them; where nothing changes when angles turn together, fix one of them";
    proof.complete = false;
    proof.reason = verdict.sentence;
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
        const auto coefficient = t.coefficient.mid().to<double>();
        require(std::isnormal(coefficient), "coefficient of equation " + std::to_string(t.equation + 1), coefficient,
                "must be a number of double precision, from 2.3e-308 to 1.7e308 in size, at these parameters: choose "
                "other units");
        terms.push_back({t.equation, SparseMonomial(std::move(codes)), coefficient});
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
    const ExactTerms exact = in_units(problem.exact, units.unknown);
    y.proof = prove_set(set, exact,
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
    const EquationsOfTerms equations(exact, *problem.equations, units.unknown);
    RootClassifier classifier(equations);
    std::vector<std::array<std::int64_t, 3>> keys;
    for (std::size_t k = 0; k < set.roots.size(); ++k) {
        const auto& root = set.roots[k];
        const Certificate& c = y.proof.certificates[k];
        const double imaginary = largest_imaginary(root);
        RuntimeArray<double> q(n);
        const bool real = c.exists ? c.reality == Reality::real
                                   : classifier.is_real(view(root), {q.begin(), q.end()}) &&
                                         !(root.status == PathStatus::singular &&
                                           conjugate_is_another(std::span<const Root<RuntimeUnknowns>>(set.roots), k,
                                                                system.sizes().angles));
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
