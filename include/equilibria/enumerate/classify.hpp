/// \file
/// From roots to equilibria: filtered to real ones, classified.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <equilibria/core/compiled.hpp>
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
    /// Of the root that is_real has found last, q.
    Classification classify(std::span<const double> q);

private:
    struct Workspace;
    const RealEquations* equations_;
    std::unique_ptr<Workspace> with_;
    bool linearized_ = false;  // the Jacobian in the workspace is that of the root that was found last
};

double largest_imaginary(const Root<RuntimeUnknowns>& root);
/// The equilibrium at q, the real root that a root is.
Equilibrium<RuntimeUnknowns> equilibrium_of(const Root<RuntimeUnknowns>& root, RuntimeArray<double> q,
                                            const Classification& found);

/// The real roots among roots.
struct RealRoots {
    std::vector<Equilibrium<RuntimeUnknowns>> equilibria;  ///< by index, then nullity, then path
    /// The largest imaginary part among the real roots, the smallest among the others (infinity where there are none).
    double largest_real_imaginary = 0, smallest_nonreal_imaginary = std::numeric_limits<double>::infinity();
};
/// The mirror image of a real point, angles in (-pi, pi].
RuntimeArray<double> mirrored(RuntimeArray<double> angles);
/// The real roots among these, classified. odd: F(-q) = -F(q), so that what one root is its mirror image is as well.
RealRoots classify(const std::vector<Root<RuntimeUnknowns>>& roots, const RealEquations& equations, bool odd,
                   const Executor& executor);

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/classify_definitions.hpp>
#endif
