/// \file
/// What decides the kind of a singularity that Newton's method found, in double but for the derivatives along the null
/// vector: these derivatives, the nullity of J, and how far the parameters unfold the point.
///
/// A coefficient is 0 if it is below 1e-6 of the largest Taylor coefficient of the reduced potential and of J; a
/// singular value of J is 0 below 1e-8 of that. Where it fails: of two singularities closer than that the higher kind
/// is seen. Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 6 to 8; Golubitsky and
/// Schaeffer, Singularities and Groups in Bifurcation Theory I, chapter III (universal unfoldings).
#pragma once

#include <optional>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/model_functions.hpp>
#include <equilibria/singularity/reduced_series.hpp>
#include <equilibria/singularity/singularity.hpp>

namespace equilibria::detail {

/// The derivatives that are collected are those to phi^(evidence_order + 1).
inline constexpr int evidence_order = 7;

/// J at q and p, rounded to double.
template <class S>
RuntimeMatrix<double> rounded_jacobian(const ModelFunctions<S>& functions, const RuntimeArray<S>& q,
                                       const RuntimeArray<S>& p) {
    const auto j = jacobian(functions, q, p);
    RuntimeMatrix<double> y(j.size());
    for (int r = 0; r < j.size(); ++r)
        for (int c = 0; c < j.size(); ++c) y[r][c] = static_cast<double>(j[r][c]);
    return y;
}

/// The largest Taylor coefficient of the reduced potential or entry of J: what 0 is measured by.
template <class S>
double scale_of(const ModelFunctions<S>& functions, const RuntimeSingularity<S>& at);

/// Whether phi^(k) is no rounding of 0, measured by `scale`.
template <class S>
bool decides(const RuntimeSingularity<S>& at, int k, double scale);

/// Fills in v, which is about `near`, the derivatives along it and the nullity. Returns the reduced series along v, or
/// nothing at a second null vector.
template <class S>
std::optional<ReducedSeries<S>> fill_evidence(const ModelFunctions<S>& functions, RuntimeSingularity<S>& at,
                                              const RuntimeArray<double>& near);

/// `Singularity::versality`, of the last Jacobian of Newton's method, whose first `rows` equations are F and whose last
/// columns are the parameters'; 0 where an entry is not finite. right, left: the null vectors of J.
double versality(const RuntimeMatrix<double>& jacobian, int rows, const std::vector<RuntimeArray<double>>& right,
                 const std::vector<RuntimeArray<double>>& left);

}  // namespace equilibria::detail

#include <equilibria/singularity/detail/singularity_evidence_definitions.hpp>
#ifndef EQUILIBRIA_COMPILED
#include <equilibria/singularity/detail/versality_definitions.hpp>
#endif
