/// \file
/// The trace test along a line of torques: an alarm for models whose number of solutions no bound gives.
///
/// F(theta, p) + s tau = 0, with constant torques tau, has as many solutions as F = 0 has (the constant term lies
/// inside the Newton polytopes, so that nothing comes from infinity), and over all of them the sums of z_i = exp(i
/// theta_i) and of 1/z_i are affine-linear in s. Over a part of them they are not, nor where one is counted twice. So
/// the roots are followed to s = 1 and s = -1, and the second difference of the sums is looked at: 1e-15 of their size
/// if the set is complete. It costs two parameter homotopies, of as many paths as there are roots. Along a line of
/// loads (coefficients of sines and cosines) the sums are not linear. Sources: Sommese, Verschelde, Wampler, Symmetric
/// functions applied to decomposing solution sets (the trace test); Leykin, Rodriguez, Sottile, Trace test.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/paths/path_solver.hpp>

namespace equilibria {

/// The equations of M, an angles-only model, plus a constant torque each. Parameters: those of M, then the torques.
template <Model M>
requires(n_coordinates<M> == 0) struct WithTorques {
    static constexpr int n_angles = equilibria::n_angles<M>;
    static constexpr int first_torque = equilibria::n_parameters<M>;
    static constexpr int n_parameters = first_torque + n_angles;

    constexpr auto equations(const auto& theta, const auto& p) const {
        using S = scalar_of<decltype(theta)>;
        detail::AnglesOf<M, S> angle;
        for (int i = 0; i < n_angles; ++i) angle[i] = {cos(theta[i]), sin(theta[i])};
        Array<std::remove_cvref_t<decltype(p[0])>, first_torque> own;
        for (int k = 0; k < first_torque; ++k) own[k] = p[k];
        Unknowns<M, S> f = detail::equations_at<M, S>(angle, {}, own);
        for (int i = 0; i < n_angles; ++i) f[i] = f[i] + p[first_torque + i];
        return f;
    }

    /// The same as polynomials, from those of M.
    template <class C>
    static constexpr auto polynomials(const Array<C, n_parameters>& p) {
        Parameters<M, C> own;
        for (int k = 0; k < first_torque; ++k) own[k] = p[k];
        auto f = detail::symbolic_equations<M, C>(own);
        for (int i = 0; i < n_angles; ++i) f[static_cast<std::size_t>(i)] += PolynomialOf<M, C>(p[first_torque + i]);
        return f;
    }
};

namespace detail {

/// Sums over points of z_i and of 1/z_i, and of their absolute values.
template <Model M>
struct TorqueTrace {
    Array<std::complex<double>, 2 * n_angles<M>> sum;
    Array<double, 2 * n_angles<M>> size;

    void add(double weight, const Point<WithTorques<M>, double>& q) {
        for (int i = 0; i < n_angles<M>; ++i) {
            const std::complex<double> c = lane(q.c[i], 0), s = lane(q.s[i], 0), turned(-s.imag(), s.real());
            const std::complex<double> z[] = {c + turned, c - turned};
            for (int k = 0; k < 2; ++k) sum[2 * i + k] += weight * z[k], size[2 * i + k] += weight * std::abs(z[k]);
        }
    }
};

}  // namespace detail

/// The trace test on the roots of `set`, to be stored in set.alarms.trace. options: seed of the torques, threads,
/// tracker. It applies to angles-only models whose paths have all ended at regular roots or at infinity.
template <Model M>
Alarm torque_trace(const RootSet<M>& set, const EnumerateOptions& options = {}) {
    Alarm y;
    y.tolerance = 1e-9;
    options.validate();
    if constexpr (n_coordinates < M >> 0) {
        y.sentence = "the trace test does not apply: the unknowns are not only angles";
        return y;
    } else {
        if (set.paths.failed > 0 || set.paths.singular > 0) {
            y.sentence = "the trace test does not apply: there are failed or singular paths";
            return y;
        }
        using W = WithTorques<M>;
        using H = Homotopy<W, StartKind::parameter, double>;
        std::vector<Point<W, double>> starts(set.roots.size());
        for (std::size_t k = 0; k < starts.size(); ++k)
            for (int i = 0; i < n_angles<M>; ++i) {
                set_lane(starts[k].c[i], 0, std::cos(set.roots[k].q[i]));
                set_lane(starts[k].s[i], 0, std::sin(set.roots[k].q[i]));
            }
        // a root that is there twice is followed once, and counts twice
        std::vector<double> weight(starts.size(), 1);
        for (const auto& group : detail::CoincidenceFinder<W>(false).groups(
                 starts.size(), [&](std::size_t k) { return &starts[k]; }, 1e-8))
            for (const std::size_t k : group) weight[k] = k == group.front() ? static_cast<double>(group.size()) : 0;
        std::vector<std::uint64_t> paths;
        for (std::size_t k = 0; k < starts.size(); ++k)
            if (weight[k] > 0) paths.push_back(k);
        const auto start = [&](std::uint64_t k) { return starts[paths[k]]; };
        EnumerateOptions own = options;  // a checkpoint would be of the enumeration
        own.checkpoint.clear();
        Parameters<W> at{};
        for (int k = 0; k < n_parameters<M>; ++k) at[k] = set.parameters[k];
        const auto from = coefficients<W, double>(at);
        const auto scale = detail::equation_scales<W, double>(from);
        Generator generator(options.seed);
        for (int attempt = 0; attempt < 3 && !y.applied; ++attempt) {
            detail::TorqueTrace<M> difference;
            const auto add = [&](double by, const detail::TorqueTrace<M>& t) {
                for (int k = 0; k < t.sum.size(); ++k) {
                    difference.sum[k] += by * t.sum[k];
                    difference.size[k] += std::abs(by) * t.size[k];
                }
            };
            Array<double, n_angles<M>> torque;
            for (int i = 0; i < n_angles<M>; ++i)
                torque[i] = (generator() & 1 ? 1 : -1) * uniform(generator, 0.1, 0.3) * scale[i];
            std::uint64_t lost = 0;
            for (const double s : {1.0, -1.0}) {
                for (int i = 0; i < n_angles<M>; ++i) at[W::first_torque + i] = s * torque[i];
                detail::PathSolver<W, StartKind::parameter, double> solver(
                    H::parameter(from, coefficients<W, double>(at), unit_complex(generator)), at, scale, own);
                PathCounts counts;
                detail::TorqueTrace<M> trace;
                auto ends = solver.store(paths.size(), start, "torques", false);
                solver.run(ends, start, {}, false, counts);
                if (!ends.complete()) {
                    y.sentence = "the trace test was cancelled";
                    return y;
                }
                for (std::uint64_t k = 0; k < ends.size(); ++k) {
                    lost += ends[k].status != PathStatus::finite;
                    trace.add(weight[paths[k]], ends[k].q);
                }
                add(1, trace);
            }
            if (lost > 0) {
                y.sentence =
                    "the trace test is undecided: " + std::to_string(lost) + " of its paths reached no regular root";
                continue;
            }
            detail::TorqueTrace<M> trace;
            for (const auto& q : starts) trace.add(1, q);
            add(-2, trace);
            y.applied = true;
            for (int k = 0; k < difference.sum.size(); ++k)
                if (difference.size[k] > 0)
                    y.value = std::max(y.value, std::abs(difference.sum[k]) / difference.size[k]);
            char value[32];
            std::snprintf(value, sizeof value, "%.1e", y.value);
            y.sentence = std::string("the sums of z and 1/z along a line of torques have a second difference of ") +
                         value + " of their size" + (y.raised() ? ": a root is lost or doubled" : "");
        }
        return y;
    }
}

}  // namespace equilibria
