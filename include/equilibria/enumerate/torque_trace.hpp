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
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/paths/coincidence.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/paths/path_set.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/start/solved_instance.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

namespace detail {

/// Sums over points of z_i and of 1/z_i, and of their absolute values.
template <int Angles>
struct TorqueTrace {
    Array<std::complex<double>, 2 * Angles> sum;
    Array<double, 2 * Angles> size;

    void add(double weight, const UnknownArray<RuntimeUnknowns, std::complex<double>>& theta) {
        for (int i = 0; i < Angles; ++i) {
            const std::complex<double> z = std::exp(std::complex<double>(-theta[i].imag(), theta[i].real()));
            const std::complex<double> both[] = {z, 1.0 / z};
            for (int k = 0; k < 2; ++k)
                sum[2 * i + k] += weight * both[k], size[2 * i + k] += std::abs(weight) * std::abs(both[k]);
        }
    }
    /// The largest sum, relative to its terms.
    double largest() const {
        double y = 0;
        for (int k = 0; k < sum.size(); ++k)
            if (size[k] > 0) y = std::max(y, std::abs(sum[k]) / size[k]);
        return y;
    }
};

/// The trace test of one set of roots.
template <Model M>
class TorqueTraceTest {
public:
    static constexpr int n = n_angles<M>;

    TorqueTraceTest(const RootSet<M>& set, const RunOptions& run, const TrackerOptions& options)
        : set_(&set), run_(run), options_(options), system_(sparse_system<M>(set.parameters)), generator_(run.seed) {
        run_.checkpoint.clear();  // it would be of the enumeration
        // a root that is there twice is followed once, and counts twice
        std::vector<RuntimePoint<double>> points;
        for (const auto& root : set.roots) points.push_back(runtime_point(point_of<M>(root.q)));
        std::vector<double> weight(points.size(), 1);
        for (const auto& group : coincident(points, 1e-8))
            for (const std::size_t k : group) weight[k] = k == group.front() ? static_cast<double>(group.size()) : 0;
        for (std::size_t k = 0; k < points.size(); ++k)
            if (weight[k] > 0) {
                SolvedInstance::Points::value_type q(n);
                std::copy(set.roots[k].q.begin(), set.roots[k].q.end(), q.begin());
                starts_.push_back(std::move(q)), weights_.push_back(weight[k]);
            }
    }

    Alarm alarm() {
        Alarm y;
        y.tolerance = 1e-9;
        for (int attempt = 0; attempt < 3 && !y.applied; ++attempt) {
            Array<double, n> torque;
            for (int i = 0; i < n; ++i)
                torque[i] = (generator_() & 1 ? 1 : -1) * uniform(generator_, 0.1, 0.3) *
                            system_.scale()[static_cast<std::size_t>(i)];
            TorqueTrace<n> difference;
            std::uint64_t lost = 0;
            for (const double s : {1.0, -1.0})
                if (!add_traced(s, torque, difference, lost)) {
                    y.sentence = "the trace test was cancelled";
                    return y;
                }
            if (lost > 0) {
                y.sentence =
                    "the trace test is undecided: " + std::to_string(lost) + " of its paths reached no regular root";
                continue;
            }
            for (std::size_t k = 0; k < starts_.size(); ++k) difference.add(-2 * weights_[k], starts_[k]);
            y.applied = true;
            y.value = difference.largest();
            char value[32];
            std::snprintf(value, sizeof value, "%.1e", y.value);
            y.sentence = std::string("the sums of z and 1/z along a line of torques have a second difference of ") +
                         value + " of their size" + (y.raised() ? ": a root is lost or doubled" : "");
        }
        return y;
    }

private:
    /// Adds the sums at the torques s tau; `lost` is increased by the paths that reached no regular root. False where
    /// the run was cancelled.
    bool add_traced(double s, Array<double, n> torque, TorqueTrace<n>& difference, std::uint64_t& lost) {
        for (double& value : torque) value *= s;
        const SparseSystem to = system_.with_constants(torque);
        const SolvedInstance start(system_, to, unit_complex(generator_), starts_);
        auto paths = track(PolynomialHomotopy(to, start), start, run_, options_);
        for (std::size_t k = 0; k < paths.size(); ++k) {
            if (!paths.finished(k)) return false;
            lost += paths.status(k) != PathStatus::finite;
            difference.add(weights_[k], root_of(paths.point(k), paths.record(k), k).q);
        }
        return true;
    }

    const RootSet<M>* set_;
    RunOptions run_;
    TrackerOptions options_;
    SparseSystem system_;
    Generator generator_;
    SolvedInstance::Points starts_;
    std::vector<double> weights_;
};

}  // namespace detail

/// The trace test on the roots of `set`, to be stored in set.alarms.trace. It applies to angles-only models whose paths
/// have all ended at regular roots or at infinity. The run's seed is that of the torques. Throws InvalidArgument for
/// options out of range.
template <Model M>
Alarm torque_trace(const RootSet<M>& set, const RunOptions& run = {}, const TrackerOptions& options = {}) {
    options.validate();
    Alarm y;
    y.tolerance = 1e-9;
    if constexpr (n_coordinates<M> != 0) {
        y.sentence = "the trace test does not apply: the unknowns are not only angles";
        return y;
    } else if (set.paths.failed > 0 || set.paths.singular > 0) {
        y.sentence = "the trace test does not apply: there are failed or singular paths";
        return y;
    } else {
        return detail::TorqueTraceTest<M>(set, run, options).alarm();
    }
}

}  // namespace equilibria
