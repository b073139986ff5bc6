/// \file
/// From roots to equilibria: filtered to real ones, classified.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/sorted_order.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/model/equations.hpp>
#include <equilibria/run/executor.hpp>

namespace equilibria::detail {

/// A model's equations at real points, its numbers of unknowns known at run time.
class RealEquations {
public:
    virtual ~RealEquations() = default;
    RuntimeSizes sizes;
    bool has_potential;
    /// f: F(q); jacobian: J(q), row after row.
    virtual void linearize(const double* q, double* f, double* jacobian) const = 0;
    /// NaN without a potential.
    virtual double energy(const double* q) const = 0;

protected:
    RealEquations(const RuntimeSizes& numbers, bool potential) : sizes(numbers), has_potential(potential) {}
};

template <Model M>
class RealModelEquations final : public RealEquations {
public:
    explicit RealModelEquations(const Parameters<M>& p) : RealEquations(Sizes<M>(), PotentialModel<M>), p_(p) {}

    void linearize(const double* q, double* f, double* jacobian) const override {
        constexpr int n = n_unknowns<M>;
        const auto values = equations_and_slopes<M, double>(unknowns(q), p_);
        for (int r = 0; r < n; ++r) {
            f[r] = values[r].value;
            for (int c = 0; c < n; ++c) jacobian[r * n + c] = values[r].derivative[c];
        }
    }
    double energy(const double* q) const override {
        if constexpr (PotentialModel<M>)
            return potential<M, double>(unknowns(q), p_);
        else
            return std::numeric_limits<double>::quiet_NaN();
    }

private:
    static Unknowns<M> unknowns(const double* q) {
        Unknowns<M> y;
        std::copy(q, q + n_unknowns<M>, y.begin());
        return y;
    }
    Parameters<M> p_;
};

/// What an Equilibrium says of its Jacobian.
struct Classification {
    int index = 0, nullity = 0;
    double margin = 0, energy = 0;
};

/// Tells the real roots and classifies them; for one thread, whatever the number of roots.
class RootClassifier {
public:
    /// The equations have to outlive it.
    explicit RootClassifier(const RealEquations& equations);
    ~RootClassifier();

    /// Whether a root is real, by Newton's method in real arithmetic from its real part: a regular root whose imaginary
    /// part is rounding is reached again. On success q is the real root.
    bool is_real(const RootView& root, std::span<double> q);
    Classification classify(std::span<const double> q);

private:
    struct Workspace;
    const RealEquations* equations_;
    std::unique_ptr<Workspace> with_;
};

template <class M>
double largest_imaginary(const Root<M>& root) {
    double y = 0;
    for (const auto& q : root.q) y = std::max(y, std::abs(q.imag()));
    return y;
}
/// The equilibrium at q, the real root that a root is.
template <class M>
Equilibrium<M> equilibrium_of(const Root<M>& root, UnknownArray<M, double> q, const Classification& found) {
    Equilibrium<M> e;
    e.q = std::move(q);
    e.energy = found.energy;
    e.index = found.index;
    e.nullity = found.nullity;
    e.margin = found.margin;
    e.residual = root.residual;
    e.condition = root.condition;
    e.path = root.path;
    e.multiplicity = root.paths;
    if (root.status == PathStatus::singular && e.nullity == 0) e.nullity = 1;
    return e;
}

/// The real roots among roots, classified.
template <class M>
struct RealRoots {
    std::vector<Equilibrium<M>> equilibria;  ///< by index, then nullity, then path
    /// The largest imaginary part among the real roots, the smallest among the others (infinity where there are none).
    double largest_real_imaginary = 0, smallest_nonreal_imaginary = std::numeric_limits<double>::infinity();
};

template <class M>
[[gnu::cold]] RealRoots<M> classify(const std::vector<Root<M>>& roots, const RealEquations& equations,
                                    const Executor& executor) {
    std::vector<std::uint8_t> real(roots.size());
    std::vector<UnknownArray<M, double>> at(roots.size());
    executor.for_blocks(roots.size(), 4096, [&](std::size_t first, std::size_t last) {
        RootClassifier classifier(equations);
        UnknownArray<M, double> q{};
        if constexpr (std::is_same_v<M, RuntimeUnknowns>) q.resize(equations.sizes.unknowns);
        for (std::size_t k = first; k < last; ++k) {
            real[k] = classifier.is_real(view(roots[k]), {q.begin(), q.end()});
            if (real[k]) at[k] = q;
        }
    });
    RootClassifier classifier(equations);
    RealRoots<M> y;
    y.equilibria.reserve(static_cast<std::size_t>(std::count(real.begin(), real.end(), 1)));
    for (std::size_t k = 0; k < roots.size(); ++k) {
        const double imaginary = largest_imaginary(roots[k]);
        if (real[k]) {
            const Classification found = classifier.classify({at[k].begin(), at[k].end()});
            y.equilibria.push_back(equilibrium_of(roots[k], std::move(at[k]), found));
            y.largest_real_imaginary = std::max(y.largest_real_imaginary, imaginary);
        } else {
            y.smallest_nonreal_imaginary = std::min(y.smallest_nonreal_imaginary, imaginary);
        }
    }
    std::vector<std::array<std::int64_t, 3>> keys;
    keys.reserve(y.equilibria.size());
    for (const auto& e : y.equilibria) keys.push_back({e.index, e.nullity, static_cast<std::int64_t>(e.path)});
    y.equilibria = in_order(sorted_order(keys), std::move(y.equilibria));
    return y;
}

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/classify_definitions.hpp>
#endif
