/// \file
/// What decides the kind of a singularity that Newton's method found, in double but for the derivatives along the null
/// vector: these derivatives, the nullity of J, and how far the parameters unfold the point.
///
/// A coefficient is 0 if it is below 1e-6 of the largest Taylor coefficient of the reduced potential and of J; a
/// singular value of J is 0 below 1e-8 of that. Where it fails: of two singularities closer than that the higher kind
/// is seen. Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 6 to 8; Golubitsky and
/// Schaeffer, Singularities and Groups in Bifurcation Theory I, chapter III (universal unfoldings).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/singular_values.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/reduced_series.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria::detail {

/// The derivatives that are collected are those to phi^(evidence_order + 1).
inline constexpr int evidence_order = 7;

/// J at q and p, both rounded to double.
template <Model M, class S>
UnknownMatrix<M> rounded_jacobian(const Unknowns<M, S>& q, const Parameters<M, S>& p) {
    return jacobian<M, double>(to_double(q), to_double(p));
}

/// The largest Taylor coefficient of the reduced potential or entry of J: what 0 is measured by.
template <Model M, class S>
double scale_of(const Singularity<M, S>& at) {
    double y = rounded_jacobian<M>(at.q, at.p).cwiseAbs().maxCoeff(), factorial = 2;
    for (int k = 3; k <= 8; ++k) {
        factorial *= k;
        y = std::max(y, std::abs(to_double(at.derivative(k))) / factorial);
    }
    return y;
}

/// Whether phi^(k) is no rounding of 0.
template <Model M, class S>
bool decides(const Singularity<M, S>& at, int k) {
    double factorial = 1;
    for (int j = 2; j <= k; ++j) factorial *= j;
    return std::abs(to_double(at.derivative(k))) > 1e-6 * factorial * scale_of(at);
}

/// Fills in v, which is about `near`, the derivatives along it and the nullity. Returns the reduced series along v, or
/// nothing at a second null vector.
template <Model M, class S>
std::optional<ReducedSeries<M, evidence_order, S>> fill_evidence(Singularity<M, S>& at, const Unknowns<M>& near) {
    const UnknownMatrix<M> j = rounded_jacobian<M>(at.q, at.p);
    const auto along = [&](const Unknowns<M, S>& v) {
        if constexpr (PotentialModel<M>)
            return reduced_series<M, evidence_order, S>(at.q, v, at.p);
        else
            return reduced_series<M, evidence_order, S>(at.q, v, in_digits_of<S>(left_null_vector<M>(j, to_double(v))),
                                                        at.p);
    };
    at.v = in_digits_of<S>(near);
    auto series = along(at.v);
    if (series.regular) {
        at.v = normalized(series.curve[1]);
        series = along(at.v);
        for (int k = 3; k <= 8; ++k) at.derivatives[k - 3] = series.derivative(k);
    }
    at.nullity = nullity<M>(j, scale_of(at));
    if (!series.regular) return std::nullopt;
    return series;
}

/// The unfolding's coefficients by the parameters: each column is that of one of the null vectors `right` or of one
/// parameter, its rows the part of F along `left` and the conditions of Newton's system, whose first Rows equations are
/// F and whose last columns are the parameters'. F is solved for q across the null vectors; columns are scaled.
template <int Rows, int Corank, int N, class S>
std::optional<SquareArray<double, Corank + N - Rows>> unfolding(const SquareArray<S, N>& jacobian,
                                                                const Array<Array<double, Rows>, Corank>& right,
                                                                const Array<Array<double, Rows>, Corank>& left) {
    constexpr int conditions = N - Rows;
    Array<Array<double, N>, N> a;
    for (int i = 0; i < N; ++i) a[i] = to_double(jacobian[i]);
    SquareArray<double, Rows + Corank> bordered;
    for (int i = 0; i < Rows; ++i) {
        for (int j = 0; j < Rows; ++j) bordered[i][j] = a[i][j];
        for (int c = 0; c < Corank; ++c) bordered[i][Rows + c] = -left[c][i], bordered[Rows + c][i] = right[c][i];
    }
    SquareArray<double, Corank + conditions> columns;
    const auto conditions_along = [&](const auto& z, auto& column) {
        for (int k = 0; k < conditions; ++k)
            for (int i = 0; i < Rows; ++i) column[Corank + k] += a[Rows + k][i] * z[i];
    };
    const auto scale = [](auto& column, double by) {
        if (by > 0)
            for (double& x : column) x /= by;
    };
    double largest_along_null = 0;
    for (int c = 0; c < Corank; ++c) {
        conditions_along(right[c], columns[c]);
        largest_along_null = std::max(largest_along_null, std::sqrt(dot(columns[c], columns[c])));
    }
    for (int c = 0; c < Corank; ++c) scale(columns[c], largest_along_null);
    const DenseFactorization<double, Rows + Corank> factors(bordered);
    if (!factors.regular()) return std::nullopt;
    for (int k = 0; k < conditions; ++k) {
        auto& column = columns[Corank + k];
        Array<double, Rows + Corank> b;
        double whole = 0;
        for (int i = 0; i < N; ++i) whole += a[i][Rows + k] * a[i][Rows + k];
        for (int i = 0; i < Rows; ++i) b[i] = -a[i][Rows + k];
        b = factors.solve(b);
        for (int c = 0; c < Corank; ++c) column[c] = b[Rows + c];
        conditions_along(b, column);
        for (int i = 0; i < conditions; ++i) column[Corank + i] += a[Rows + i][Rows + k];
        scale(column, std::sqrt(whole));
    }
    return columns;
}

/// `Singularity::versality`, of the last Jacobian of Newton's method; 0 where an entry is not finite.
template <int Rows, int Corank, int N, class S>
double versality(const SquareArray<S, N>& jacobian, const Array<Array<double, Rows>, Corank>& right,
                 const Array<Array<double, Rows>, Corank>& left) {
    constexpr int size = Corank + N - Rows;
    const auto columns = unfolding<Rows, Corank, N>(jacobian, right, left);
    if (!columns) return 0;
    SingularValues::Vector entries;
    for (const auto& column : *columns) entries.insert(entries.end(), column.begin(), column.end());
    for (const auto& x : entries)
        if (!std::isfinite(x.real())) return 0;
    return SingularValues(size, size, std::move(entries))[size - 1];
}

}  // namespace equilibria::detail
