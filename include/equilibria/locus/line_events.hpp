/// \file
/// All folds and pitchforks on a line of the parameter space, on which one parameter is active.
///
/// Folds: the complex solutions of the fold system (see fold_model.hpp), all of them, real ones kept. The system is
/// solved once, on a generic line, from a total-degree start; every other line follows by parameter homotopy.
/// Pitchforks on the symmetric branches theta in {0, pi}^n: det J restricted to the branch is a polynomial of known
/// degree in the active parameter; interpolated at Chebyshev points, its roots are eigenvalues of the colleague matrix.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/fold_model.hpp>

namespace equilibria {

enum class LocusKind { fold, pitchfork };

/// A degenerate equilibrium on a line: where it is, and the unit null vector.
template <Model M>
struct LineEvent {
    LocusKind kind;
    double value;  ///< of the active parameter
    Unknowns<M> q, v;
};

/// The symmetric branches of a model: theta in {0, pi}^n where it has the symmetry theta -> -theta, else none.
template <Model M>
std::vector<Unknowns<M>> symmetric_branches() {
    std::vector<Unknowns<M>> branches;
    if constexpr (Formulation<M>::reflection_symmetric)
        for (unsigned bits = 0; bits < 1u << n_angles<M>; ++bits) {
            Unknowns<M> q;
            for (int i = 0; i < n_angles<M>; ++i) q[i] = bits >> i & 1 ? std::numbers::pi : 0;
            branches.push_back(q);
        }
    return branches;
}

namespace detail {

/// The real roots in [low, high] of a polynomial of degree at most `degree`, from its values: Chebyshev interpolation,
/// then the eigenvalues of the colleague matrix. None where the values are rounding of zero throughout.
template <class F>
std::vector<double> polynomial_roots(F&& f, int degree, double low, double high) {
    const int m = degree + 1;
    const auto to_interval = [&](double t) { return 0.5 * (low + high) + 0.5 * (high - low) * t; };
    Eigen::VectorXd values(m), c = Eigen::VectorXd::Zero(m);
    for (int k = 0; k < m; ++k) values(k) = f(to_interval(std::cos(std::numbers::pi * (k + 0.5) / m)));
    for (int j = 0; j < m; ++j) {
        for (int k = 0; k < m; ++k) c(j) += values(k) * std::cos(std::numbers::pi * j * (k + 0.5) / m);
        c(j) *= (j == 0 ? 1.0 : 2.0) / m;
    }
    int d = degree;
    while (d > 0 && std::abs(c(d)) <= 1e-13 * c.cwiseAbs().maxCoeff()) --d;
    std::vector<double> roots;
    if (d == 0) return roots;
    Eigen::MatrixXd colleague = Eigen::MatrixXd::Zero(d, d);
    for (int k = 0; k < d; ++k) {
        if (k > 0) colleague(k, k - 1) = k == d - 1 && d == 1 ? 1 : 0.5;
        if (k + 1 < d) colleague(k, k + 1) = k == 0 ? 1 : 0.5;
    }
    for (int k = 0; k < d; ++k) colleague(d - 1, k) -= (d == 1 ? 1.0 : 0.5) * c(k) / c(d);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(colleague, false);
    for (int k = 0; k < d; ++k) {
        const std::complex<double> t = solver.eigenvalues()(k);
        // a double root may come out as a pair with an imaginary part of sqrt(epsilon)
        if (std::abs(t.imag()) < 1e-7 && std::abs(t.real()) <= 1 + 1e-12)
            roots.push_back(to_interval(std::clamp(t.real(), -1.0, 1.0)));
    }
    std::sort(roots.begin(), roots.end());
    return roots;
}

/// The unit vector that J maps to the shortest one.
template <Model M>
Unknowns<M> null_vector(const UnknownMatrix<M>& j) {
    const Eigen::SelfAdjointEigenSolver<UnknownMatrix<M>> solver(j.transpose() * j);
    Unknowns<M> v;
    for (int i = 0; i < n_unknowns<M>; ++i) v[i] = solver.eigenvectors()(i, 0);
    return v;
}

}  // namespace detail

/// Solves lines with active parameter `Active`, all other parameters but `fixed` being those of the instance.
template <Model M, int Active>
class LineSolver {
public:
    using Fold = FoldModel<M, Active>;

    /// p: the parameters; fixed: the number of the one that tells the lines apart; [low, high]: its range, in which a
    /// generic line is taken.
    LineSolver(const Parameters<M>& p, int fixed, double low, double high, const EnumerateOptions& options)
        : options_(options), fixed_(fixed) {
        // a generic line and basis are a choice: where one leaves paths undecided, another may not
        constexpr std::uint64_t attempts = 4;
        for (std::uint64_t attempt = 0; attempt < attempts && (attempt == 0 || paths_.failed > 0); ++attempt) {
            EnumerateOptions with_seed = options;
            with_seed.seed = options.seed + 0x9e3779b97f4a7c15 * attempt;
            Generator generator(with_seed.seed);
            Parameters<Fold> generic;
            for (int k = 0; k < n_parameters<M>; ++k) generic[k] = p[k];
            generic[fixed] = uniform(generator, low, high);
            for (int k = n_parameters<M>; k < n_parameters<Fold>; ++k) generic[k] = uniform(generator, -1, 1);
            const RootSet<Fold> solved = enumerate<Fold, StartKind::parameter>(generic, with_seed);
            if (attempt > 0 && solved.paths.failed >= paths_.failed) continue;
            paths_ = solved.paths;
            generic_ = generic;
            roots_.clear();
            for (const auto& root : solved.roots)
                if (root.status == PathStatus::finite && root.paths == 1) roots_.push_back(root);
        }
        // parameter homotopy runs on a line in the space of coefficients: safe only if the lines' own lie on one
        auto other = generic_, third = generic_;
        const double spread = 1 + std::abs(generic_[fixed]);  // a narrow window's own values would be too close to tell
        other[fixed] += 0.37 * spread;
        third[fixed] += 0.83 * spread;
        const auto a = coefficients<Fold, double>(generic_), b = coefficients<Fold, double>(other),
                   c = coefficients<Fold, double>(third);
        // the distance of c from the plane of a and b
        double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0, cc = 0, distance2 = 0;
        for (int k = 0; k < a.size(); ++k) {
            aa += a[k] * a[k], ab += a[k] * b[k], bb += b[k] * b[k];
            ac += a[k] * c[k], bc += b[k] * c[k], cc += c[k] * c[k];
        }
        const double det = aa * bb - ab * ab, of_a = (ac * bb - bc * ab) / det, of_b = (bc * aa - ac * ab) / det;
        for (int k = 0; k < a.size(); ++k) {
            const double d = c[k] - of_a * a[k] - of_b * b[k];
            distance2 += d * d;
        }
        pencil_ = distance2 < 1e-18 * cc;
    }

    /// The paths of the generic line.
    const PathCounts& paths() const { return paths_; }
    /// Regular complex folds of a generic line.
    std::size_t complex_folds() const { return roots_.size(); }

    /// All folds on the line fixed = value; `failed` is increased by the paths that failed.
    std::vector<LineEvent<M>> folds(double value, std::uint64_t& failed) const {
        Parameters<Fold> p = generic_;
        p[fixed_] = value;
        const RootSet<Fold> set = pencil_ ? detail::enumerate_from<Fold>(roots_, generic_, p, options_)
                                          : enumerate<Fold, StartKind::parameter>(p, options_);
        failed += set.paths.failed;
        std::vector<LineEvent<M>> events;
        for (const auto& e : set.equilibria) {
            if (!(e.condition < regular_condition) || e.multiplicity > 1) continue;  // a pitchfork, or a family
            LineEvent<M> event{LocusKind::fold, e.q[n_unknowns<Fold> - 1], {}, {}};
            double norm = 0;
            for (int i = 0; i < n_unknowns<M>; ++i) {
                event.q[i] = e.q[i];
                event.v[i] = p[Fold::first_basis + i * n_unknowns<M>];
                for (int k = 1; k < n_unknowns<M>; ++k)
                    event.v[i] += p[Fold::first_basis + i * n_unknowns<M> + k] * e.q[n_unknowns<M> + k - 1];
                norm += event.v[i] * event.v[i];
            }
            for (double& v : event.v) v /= std::sqrt(norm);
            events.push_back(event);
        }
        return events;
    }

    /// All pitchforks of the symmetric branches on the line fixed = value, with the active parameter in [low, high].
    std::vector<LineEvent<M>> pitchforks(double value, double low, double high) const {
        std::vector<LineEvent<M>> events;
        Parameters<M> p;
        for (int k = 0; k < n_parameters<M>; ++k) p[k] = generic_[k];
        p[fixed_] = value;
        const int degree = n_unknowns<M> * Formulation<Fold>::degree_in(n_unknowns<Fold> - 1);
        for (const Unknowns<M>& branch : symmetric_branches<M>()) {
            const auto at = [&](double active) {
                p[Active] = active;
                return jacobian<M, double>(branch, p);
            };
            for (const double root :
                 detail::polynomial_roots([&](double a) { return at(a).determinant(); }, degree, low, high))
                events.push_back({LocusKind::pitchfork, root, branch, detail::null_vector<M>(at(root))});
        }
        return events;
    }

private:
    EnumerateOptions options_;
    int fixed_;
    Parameters<Fold> generic_;
    std::vector<Root<Fold>> roots_;
    PathCounts paths_;
    bool pencil_ = true;
};

}  // namespace equilibria
