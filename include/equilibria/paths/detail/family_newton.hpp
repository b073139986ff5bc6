/// \file
/// Newton's method on a family of systems: for a root and its parameters together, or for a root of a member.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/system/system_family.hpp>

namespace equilibria::detail {

/// A point of the unknowns (complex radians, then coordinates), and parameters.
class FamilyNewton {
public:
    using Number = std::complex<double>;
    using Unknowns = UnknownArray<RuntimeUnknowns, Number>;
    struct Pair {
        Unknowns q;
        std::vector<Number> p;
    };

    /// sizes: of each parameter, 0 where it is fixed.
    FamilyNewton(const SystemFamily& family, std::vector<double> sizes) : family_(&family), sizes_(std::move(sizes)) {}

    Unknowns random_unknowns(Generator& generator) const {
        Unknowns q(n());
        for (int u = 0; u < n(); ++u) {
            const double a = uniform(generator), b = uniform(generator);
            q[u] = u < family_->sizes().angles ? Number(2 * std::numbers::pi * a, b - 0.5)
                                               : std::polar(0.5 + b, 2 * std::numbers::pi * a);
        }
        return q;
    }

    /// A root and its parameters: least steps in both, of the parameters relative to their sizes.
    bool solve(Pair& at) const {
        for (int step = 0; step < 60; ++step) {
            Equations e(n());
            Eigen::MatrixXcd j(n(), n() + static_cast<int>(sizes_.size()));
            try {
                e = equations(at.q, family_->coefficients(at.p));
                j.leftCols(n()) = e.jacobian;
                for (std::size_t k = 0; k < sizes_.size(); ++k)
                    j.col(n() + static_cast<int>(k)) = slope(at, k) * sizes_[k];
            } catch (const InvalidArgument&) {  // a coefficient is not finite there
                return false;
            }
            const Eigen::MatrixXcd normal = j * j.adjoint();
            const Eigen::VectorXcd d = -j.adjoint() * normal.partialPivLu().solve(e.values);
            if (!d.allFinite()) return false;
            const double length = d.norm(), factor = std::min(1.0, 1.0 / length);
            for (int u = 0; u < n(); ++u) at.q[u] += factor * d(u);
            for (std::size_t k = 0; k < sizes_.size(); ++k)
                at.p[k] += factor * sizes_[k] * d(n() + static_cast<int>(k));
            if (length < 1e-8) return polish(at.q, family_->coefficients(at.p));
        }
        return false;
    }
    /// A root of the member with these coefficients, near q.
    bool solve(Unknowns& q, std::span<const Number> coefficients) const {
        for (int step = 0; step < 60; ++step) {
            const Equations e = equations(q, coefficients);
            const Eigen::VectorXcd d = -e.jacobian.partialPivLu().solve(e.values);
            if (!d.allFinite()) return false;
            const double length = d.norm(), factor = std::min(1.0, 1.0 / length);
            for (int u = 0; u < n(); ++u) q[u] += factor * d(u);
            if (length < 1e-8) return polish(q, coefficients);
        }
        return false;
    }

private:
    struct Equations {
        explicit Equations(int n) : values(Eigen::VectorXcd::Zero(n)), jacobian(Eigen::MatrixXcd::Zero(n, n)) {}
        Eigen::VectorXcd values;  // relative to the terms of their equation
        Eigen::MatrixXcd jacobian;
        std::vector<double> size;  // of the terms of each
    };

    int n() const { return family_->sizes().unknowns; }

    /// A factor of a term and its derivative by its unknown.
    std::pair<Number, Number> factor(int u, int code, const Unknowns& q) const {
        const double k = std::abs(code);
        if (u >= family_->sizes().angles)
            return {std::pow(q[u], std::abs(code)), k * std::pow(q[u], std::abs(code) - 1)};
        const Number c = std::cos(k * q[u]), s = std::sin(k * q[u]);
        return code > 0 ? std::pair(c, -k * s) : std::pair(s, k * c);
    }
    /// The values of the terms without their coefficients, and their slopes.
    Equations equations(const Unknowns& q, std::span<const Number> a) const {
        Equations y(n());
        y.size.assign(static_cast<std::size_t>(n()), 0);
        for (std::size_t k = 0; k < a.size(); ++k) {
            const SparseTerm& term = family_->support()[k];
            const int i = term.equation;
            const Number value = a[k] * monomial(term.monomial, q);
            y.values(i) += value;
            y.size[static_cast<std::size_t>(i)] += std::abs(value);
            for (int u = 0; u < n(); ++u) {
                if (term.monomial.code(u) == 0) continue;
                Number slope = a[k] * factor(u, term.monomial.code(u), q).second;
                for (int v = 0; v < n(); ++v)
                    if (v != u && term.monomial.code(v) != 0) slope *= factor(v, term.monomial.code(v), q).first;
                y.jacobian(i, u) += slope;
            }
        }
        for (int i = 0; i < n(); ++i) {
            const double size = y.size[static_cast<std::size_t>(i)];
            if (size > 0) y.values(i) /= size, y.jacobian.row(i) /= size;
        }
        return y;
    }
    Number monomial(const SparseMonomial& of, const Unknowns& q) const {
        Number y = 1;
        for (int u = 0; u < n(); ++u)
            if (of.code(u) != 0) y *= factor(u, of.code(u), q).first;
        return y;
    }
    /// The derivative of the equations by a parameter, a central difference: they are analytic.
    Eigen::VectorXcd slope(const Pair& at, std::size_t parameter) const {
        Eigen::VectorXcd y = Eigen::VectorXcd::Zero(n());
        if (sizes_[parameter] == 0) return y;
        const double h = 1e-5 * sizes_[parameter];
        auto p = at.p;
        p[parameter] += h;
        const auto above = family_->coefficients(p);
        p[parameter] -= 2 * h;
        const auto below = family_->coefficients(p);
        std::vector<double> size(static_cast<std::size_t>(n()));
        for (std::size_t k = 0; k < above.size(); ++k) {
            const SparseTerm& term = family_->support()[k];
            const Number m = monomial(term.monomial, at.q);
            y(term.equation) += (above[k] - below[k]) / (2 * h) * m;
            size[static_cast<std::size_t>(term.equation)] += std::abs(0.5 * (above[k] + below[k]) * m);
        }
        for (int i = 0; i < n(); ++i)
            if (size[static_cast<std::size_t>(i)] > 0) y(i) /= size[static_cast<std::size_t>(i)];
        return y;
    }
    /// To rounding; false where that is no regular root.
    bool polish(Unknowns& q, std::span<const Number> coefficients) const {
        double last = std::numeric_limits<double>::infinity();
        for (int step = 0; step < 6; ++step) {
            const Equations e = equations(q, coefficients);
            const Eigen::VectorXcd d = -e.jacobian.partialPivLu().solve(e.values);
            if (!d.allFinite()) return false;
            for (int u = 0; u < n(); ++u) q[u] += d(u);
            last = d.norm();
        }
        double size = 1;
        for (int u = 0; u < n(); ++u) size = std::max(size, std::abs(q[u]));
        for (int u = 0; u < family_->sizes().angles; ++u)
            if (std::abs(q[u].imag()) > 20) return false;  // at infinity
        return last < 1e-10 * size && size < 1e6;
    }

    const SystemFamily* family_;
    std::vector<double> sizes_;
};

}  // namespace equilibria::detail
