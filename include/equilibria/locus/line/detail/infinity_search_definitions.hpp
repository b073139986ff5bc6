/// \file
/// See locus/line/infinity_search.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <utility>

#include <equilibria/core/eigen_copies.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/core/symmetric_eigen.hpp>
#include <equilibria/locus/line/infinity_search.hpp>
#include <equilibria/paths/choose_start.hpp>

namespace equilibria {

namespace detail {

EQUILIBRIA_INLINE ComplexRoots<> solve_equations(const RuntimePolynomials<>& equations, const RuntimeSizes& sizes,
                                                 const std::vector<int>& grouping, const RunOptions& run,
                                                 MoreDigits<> resort) {
    for (const auto& equation : equations) {
        if (!equation.pruned().is_constant()) continue;
        ComplexRoots<> none;
        none.start = "trivial";
        return none;
    }
    return solve_least_cost(sparse_system(equations, sizes), grouping, run, {}, resort);
}

/// The search for what comes from infinity. Unknowns: angles, X, the parameter, u.
class InfinityFinder {
public:
    InfinityFinder(const SearchedModel& model, const RuntimeArray<double>& p, int active, const Interval& range,
                   std::vector<double> sizes, const RunOptions& run)
        : model_(model), p_(p), active_(active), range_(range), sizes_(std::move(sizes)), run_(run),
          coordinates_(model.sizes().coordinates), scale_(std::max(std::abs(range.low), std::abs(range.high))) {}

    InfinitySearch run() {
        if (coordinates_ == 0) return {};
        InfinitySearch found;
        for (std::uint64_t attempt = 0; attempt < 4 && (attempt == 0 || found.paths.failed > 0); ++attempt) {
            found = {};
            search(found, run_.with_seed(seed_of_attempt(run_.seed, attempt)));
        }
        return found;
    }

private:
    using Roots = std::vector<Root<RuntimeUnknowns>>;
    /// Limits of the parameter that are one value.
    struct Limit {
        std::complex<double> value;
        std::uint64_t paths = 0;
        double spread = 0;
        bool singular = false;
    };
    /// Real equilibria far out: the side of the parameter and the index, sorted.
    using Far = std::vector<std::pair<int, int>>;

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    int parameter_code() const { return most_angles + coordinates_; }

    /// The equations in X and u, each times the power of u that makes it a polynomial; without powers of the parameter
    /// that all its terms have.
    RuntimePolynomials<> homogeneous() const {
        const int active[] = {active_};
        const double scale[] = {scale_};
        RuntimePolynomials<> y;
        for (const auto& whole : model_.polynomials->equations(p_, active, scale, coordinates_)) {
            const auto f = whole.pruned();
            int degree = 0, content = RuntimePolynomial<>::Basis::highest;
            const auto degree_of = [&](const auto& monomial) {
                int sum = 0;
                for (int j = 0; j < coordinates_; ++j) sum += monomial.code(most_angles + j);
                return sum;
            };
            for (const auto& term : f.terms()) {
                degree = std::max(degree, degree_of(term.monomial));
                content = std::min(content, term.monomial.code(parameter_code()));
            }
            RuntimePolynomial<> g;
            for (const auto& term : f.terms()) {
                auto monomial = term.monomial;
                double coefficient = term.coefficient;
                for (int j = 0; j < coordinates_; ++j)
                    coefficient *= std::pow(sizes_[at(j)], monomial.code(most_angles + j));
                monomial.set_code(parameter_code() + 1, degree - degree_of(monomial));
                if (content > 0) monomial.set_code(parameter_code(), monomial.code(parameter_code()) - content);
                g += RuntimePolynomial<>(monomial, coefficient);
            }
            y.push_back(g);
        }
        return y;
    }

    void search(InfinitySearch& found, const RunOptions& run) {
        Generator generator(run.seed);
        RuntimePolynomials<> equations = homogeneous();
        RuntimePolynomial<> plane(-1.0);
        for (int j = 0; j < coordinates_; ++j)
            plane +=
                coordinate_polynomial<>(j) * (uniform(generator) < 0.5 ? -1.0 : 1.0) * uniform(generator, 0.4, 1.0);
        equations.push_back(plane);
        const RuntimeSizes sizes(model_.sizes().angles, coordinates_ + 2);
        const auto system = [&](double u) {
            RuntimePolynomials<> all = equations;
            all.push_back(coordinate_polynomial<>(coordinates_ + 1) - RuntimePolynomial<>(u));
            return all;
        };
        std::vector<int> grouping(at(sizes.unknowns), 0);
        grouping[at(sizes.unknowns - 2)] = 1;
        grouping[at(sizes.unknowns - 1)] = 2;
        const double first = uniform(generator, 0.6, 1.4);
        auto begin = solve_equations(system(first), sizes, grouping, run);
        found.start = begin.start;
        found.paths = begin.paths;
        // a singular point of a generic u cannot be followed
        for (const auto& root : begin.roots)
            if (root.status == PathStatus::singular) {
                const auto paths = std::min(found.paths.singular, static_cast<std::uint64_t>(root.paths));
                found.paths.singular -= paths, found.paths.failed += paths;
            }
        std::erase_if(begin.roots,
                      [](const auto& root) { return root.status != PathStatus::finite || root.paths != 1; });
        if (begin.roots.empty()) return;
        const auto from = sparse_system(system(first), sizes);
        const auto at_u = [&](double u) {
            ComplexRoots<> y;
            for (std::uint64_t k = 0; k < 3 && (k == 0 || y.paths.failed > 0); ++k)
                y = solve_from(begin.roots, from, sparse_system(system(u), sizes), run.with_seed(run.seed + k));
            return y;
        };
        const auto end = at_u(0);
        found.paths.add(end.paths);
        const auto limits = limits_of(end.roots);
        found.solutions = limits.size();
        std::vector<Limit> wanted;
        for (const auto& limit : limits)
            if (std::abs(limit.value.imag()) < (limit.singular || limit.paths > 1 ? 1e-4 : 1e-8) &&
                range_.contains(rounded(limit.value.real()) * scale_))
                wanted.push_back(limit);
        if (!wanted.empty()) come_and_go(found, limits, wanted, at_u);
        std::sort(found.events.begin(), found.events.end(),
                  [](const auto& a, const auto& b) { return a.value < b.value; });
    }

    /// What is 0 but for the digits of a singular endpoint.
    static double rounded(double value) { return std::abs(value) < 1e-9 ? 0 : value; }
    std::complex<double> parameter_of(const auto& root) const { return root.q[model_.sizes().angles + coordinates_]; }

    /// A limit that m paths share has the digits of an m-fold root: what is not further apart is one.
    std::vector<Limit> limits_of(const Roots& roots) const {
        auto limits = limits_within(1e-4, roots);
        const auto several = [](const Limit& limit) {
            return limit.spread > 30 * std::pow(2e-16, 1.0 / static_cast<double>(limit.paths));
        };
        return std::any_of(limits.begin(), limits.end(), several) ? limits_within(1e-6, roots) : limits;
    }
    std::vector<Limit> limits_within(double tolerance, const Roots& roots) const {
        std::vector<Limit> limits;
        for (const auto& root : roots) {
            if (root.status != PathStatus::finite && root.status != PathStatus::singular) continue;
            const std::complex<double> value = parameter_of(root);
            const bool singular = root.status == PathStatus::singular;
            const auto paths = static_cast<std::uint64_t>(root.paths);
            const auto same = std::find_if(limits.begin(), limits.end(), [&](const Limit& limit) {
                return std::abs(limit.value - value) < tolerance * (1 + std::abs(value));
            });
            if (same == limits.end()) {
                limits.push_back({value, paths, 0, singular});
                continue;
            }
            same->spread = std::max(same->spread, std::abs(value - same->value));
            same->singular = same->singular || singular;
            same->paths += paths;
        }
        return limits;
    }

    /// Solutions next to a limit: their number and mean.
    std::pair<std::uint64_t, std::complex<double>> near(const Limit& limit, const std::vector<Limit>& limits,
                                                        const Roots& roots) const {
        const double radius = radius_of(limit, limits);
        std::pair<std::uint64_t, std::complex<double>> y{};
        for (const auto& root : roots) {
            const std::complex<double> value = parameter_of(root);
            if (!(std::abs(value - limit.value) < radius)) continue;
            ++y.first;
            y.second += value;
        }
        y.second /= std::max(1.0, static_cast<double>(y.first));
        return y;
    }
    double radius_of(const Limit& limit, const std::vector<Limit>& limits) const {
        double radius = 0.2 * range_.width() / scale_;
        for (const auto& other : limits)
            if (std::abs(other.value - limit.value) > 1e-6)
                radius = std::min(radius, 0.4 * std::abs(other.value - limit.value));
        return radius;
    }
    Roots on_both_sides(double u, const auto& at_u) const {
        Roots roots;
        for (const double side : {1.0, -1.0}) {
            const auto there = at_u(side * u);
            roots.insert(roots.end(), there.roots.begin(), there.roots.end());
        }
        return roots;
    }

    /// Limits of several paths have few digits. The mean of all solutions at u and at -u is an even power series in u:
    /// two of them give the limit by Richardson's extrapolation.
    void refine(std::vector<Limit>& wanted, const std::vector<Limit>& limits, const auto& at_u) const {
        bool any = false;
        for (const auto& limit : wanted) any = any || limit.singular || limit.paths > 1;
        if (!any) return;
        const Roots near_roots = on_both_sides(1e-4, at_u), far_roots = on_both_sides(2e-4, at_u);
        for (auto& limit : wanted) {
            if (!limit.singular && limit.paths == 1) continue;
            const auto [n, mean] = near(limit, limits, near_roots);
            const auto [m, further] = near(limit, limits, far_roots);
            const double value = (4 * mean.real() - further.real()) / 3;
            if (n != 2 * limit.paths || m != n || !(std::abs(value - limit.value.real()) < 1e-4)) continue;
            limit.value = value;
            limit.spread = 1e-12 + 1e-4 * std::abs(mean - further);
        }
    }

    /// Fills in the events at the limits.
    void come_and_go(InfinitySearch& found, const std::vector<Limit>& limits, std::vector<Limit> wanted,
                     const auto& at_u) const {
        refine(wanted, limits, at_u);
        std::vector<std::vector<Far>> seen(wanted.size());
        std::vector<std::optional<Far>> decided(wanted.size());
        // far out first: between there and infinity nothing happens any more
        for (const double u : {1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1}) {
            const Roots roots = on_both_sides(u, at_u);
            bool all = true;
            for (std::size_t k = 0; k < wanted.size(); ++k) {
                if (decided[k]) continue;
                const auto far = far_of(wanted[k], limits, roots, u);
                if (far && !seen[k].empty() && seen[k].back() == *far) decided[k] = far;
                if (far) seen[k].push_back(*far);
                all = all && decided[k];
            }
            if (all) break;
        }
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            InfinityEvent event;
            event.value = rounded(wanted[k].value.real()) * scale_;
            event.error = std::max(1e-15, wanted[k].spread) * scale_;
            event.decided = decided[k].has_value();
            if (model_.has_potential()) event.change.assign(at(model_.unknowns() + 1), 0);
            if (decided[k]) {
                for (const auto& [side, index] : *decided[k]) {
                    ++event.equilibria[side > 0 ? 1 : 0];
                    if (model_.has_potential()) event.change[at(index)] += side;
                }
                if (decided[k]->empty()) continue;  // no real equilibrium
            } else {
                event.change.clear();
            }
            found.events.push_back(std::move(event));
        }
    }

    /// The real equilibria at the distance 1/u that go to infinity at the limit; nothing where the solutions next to
    /// the limit are not yet as many as it has paths.
    std::optional<Far> far_of(const Limit& limit, const std::vector<Limit>& limits, const Roots& roots,
                              double u) const {
        const double radius = radius_of(limit, limits);
        std::uint64_t near = 0;
        Far far;
        for (const auto& root : roots) {
            const std::complex<double> value = parameter_of(root);
            if (!(std::abs(value - limit.value) < radius)) continue;
            ++near;
            bool real = true;
            for (int i = 0; i < model_.unknowns(); ++i) real = real && std::abs(root.q[i].imag()) < 1e-7;
            if (!real) continue;
            // the side is not known to within the limit's own digits; a curve of equilibria at the value has none
            const std::complex<double> away = value - rounded(limit.value.real());
            if (!(std::abs(away) > std::max(10 * limit.spread, 1e-13 * std::abs(limit.value)))) return std::nullopt;
            if (!(std::abs(away.imag()) < 1e-3 * std::abs(away))) continue;
            const double side_of_u = root.q[model_.unknowns() + 1].real();
            far.emplace_back(away.real() > 0 ? 1 : -1,
                             index_at(root, value.real() * scale_, std::copysign(u, side_of_u)));
        }
        if (near != 2 * limit.paths) return std::nullopt;
        std::sort(far.begin(), far.end());
        return far;
    }

    int index_at(const auto& root, double parameter, double u) const {
        if (!model_.has_potential()) return 0;
        RuntimeArray<double> q(model_.unknowns()), p = p_;
        p[active_] = parameter;
        for (int i = 0; i < q.size(); ++i) {
            q[i] = root.q[i].real();
            if (i >= model_.sizes().angles) q[i] *= sizes_[at(i - model_.sizes().angles)] / u;
        }
        // with each unknown in a unit that suits it: the inertia is the same
        Eigen::MatrixXd j = eigen_matrix(jacobian(*model_.functions, q, p));
        for (int round = 0; round < 4; ++round) {
            Eigen::VectorXd unit(j.rows());
            for (Eigen::Index i = 0; i < j.rows(); ++i) {
                const double largest = j.row(i).cwiseAbs().maxCoeff();
                unit(i) = largest > 0 ? 1 / std::sqrt(largest) : 1;
            }
            j = (unit.asDiagonal() * j * unit.asDiagonal()).eval();
        }
        const auto values = symmetric_eigenvalues(j).eval();
        int index = 0;
        for (Eigen::Index k = 0; k < values.size(); ++k) index += values(k) < 0;
        return index;
    }

    const SearchedModel& model_;
    RuntimeArray<double> p_;
    int active_;
    Interval range_;
    std::vector<double> sizes_;
    RunOptions run_;
    int coordinates_;
    double scale_;
};

}  // namespace detail

EQUILIBRIA_INLINE InfinitySearch search_infinity(const SearchedModel& model, const RuntimeArray<double>& p, int active,
                                                 const Interval& range, const std::vector<double>& sizes,
                                                 const RunOptions& run) {
    return detail::InfinityFinder(model, p, active, range, sizes, run).run();
}

}  // namespace equilibria
