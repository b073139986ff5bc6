/// \file
/// The factors of a system's terms, cos k theta, sin k theta (or exp(i k theta), exp(-i k theta)) and x^k, and their
/// products: values at a point, Taylor coefficients along a path, and slopes.
#pragma once

#include <cstddef>
#include <tuple>

#include <equilibria/core/aligned_vector.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/term_tables.hpp>

namespace equilibria::detail {

/// The factors and their products at a point, with Taylor coefficients along a path up to order 3.
template <class R>
class FactorSeries {
public:
    using Z = Complex<R>;
    static constexpr int order = 3;

    explicit FactorSeries(const TermTables& tables)
        : tables_(&tables), size_(static_cast<std::size_t>(tables.operands())), value_((order + 1) * size_),
          slope_(static_cast<std::size_t>(tables.slope_places())), path_((order + 1) * index(tables.sizes.unknowns)) {}

    const TermTables& tables() const { return *tables_; }
    /// The Taylor coefficient k of an operand.
    const Z& operator()(int k, int operand) const {
        return value_[static_cast<std::size_t>(k) * size_ + static_cast<std::size_t>(operand)];
    }
    /// The slope in this place of the tables, after `begin_slopes`: of a factor the derivative by its unknown.
    const Z& slope(int place) const { return slope_[static_cast<std::size_t>(place)]; }
    /// The Taylor coefficients k of all operands, `size()` of them; those of order k + 1 lie behind them.
    std::size_t size() const { return size_; }
    const Z* values(int k) const { return value_.data() + static_cast<std::size_t>(k) * size_; }
    const Z* slopes() const { return slope_.data(); }

    void begin(const RuntimePoint<R>& q) {
        for (int u = 0; u < tables_->sizes.unknowns; ++u) {
            const int first = tables_->offset[index(u)], highest = tables_->highest[index(u)];
            if (u < tables_->sizes.angles && tables_->laurent) {
                std::tie(at(0, first), at(0, first + 1)) = exponentials(q.c[u], q.s[u]);
                for (int k = 2; k < 2 * highest; ++k) at(0, first + k) = at(0, first + k - 2) * at(0, first + k % 2);
            } else if (u < tables_->sizes.angles) {
                at(0, first) = q.c[u];
                at(0, first + 1) = q.s[u];
                for (int k = 1; k < highest; ++k) {
                    const Z c = at(0, first + 2 * (k - 1)), s = at(0, first + 2 * (k - 1) + 1);
                    at(0, first + 2 * k) = c * q.c[u] - s * q.s[u];
                    at(0, first + 2 * k + 1) = s * q.c[u] + c * q.s[u];
                }
            } else {
                path(0, u) = at(0, first) = q.x[u - tables_->sizes.angles];
                for (int k = 1; k < highest; ++k) at(0, first + k) = at(0, first + k - 1) * at(0, first);
            }
        }
        multiply_nodes(0);
    }
    /// (cos k)' = -k sin k, (sin k)' = k cos k, (exp(i k))' = i k exp(i k), (x^k)' = k x^(k-1).
    void begin_slopes() {
        for (int u = 0; u < tables_->sizes.unknowns; ++u) {
            const int first = tables_->offset[index(u)];
            for (int k = 1; k <= tables_->highest[index(u)]; ++k) {
                const double multiple = k;
                if (u < tables_->sizes.angles) {
                    const int c = first + 2 * (k - 1), s = c + 1;
                    if (tables_->laurent) {
                        slope_[static_cast<std::size_t>(c)] = turned(multiple * at(0, c));
                        slope_[static_cast<std::size_t>(s)] = turned(-multiple * at(0, s));
                        continue;
                    }
                    slope_[static_cast<std::size_t>(c)] = -multiple * at(0, s);
                    slope_[static_cast<std::size_t>(s)] = multiple * at(0, c);
                } else {
                    slope_[static_cast<std::size_t>(first + k - 1)] =
                        k == 1 ? Z{broadcast<R>(1.0), broadcast<R>(0.0)} : Z(multiple * at(0, first + k - 2));
                }
            }
        }
        multiply_slopes();
    }
    /// The Taylor coefficients k of the factors, the k-th of the path being 0.
    void extend(int k) {
        for (int u = 0; u < tables_->sizes.unknowns; ++u) {
            path(k, u) = {broadcast<R>(0.0), broadcast<R>(0.0)};
            if (u >= tables_->sizes.angles) {
                raise_powers(u, k);
                continue;
            }
            for (int m = 1; m <= tables_->highest[index(u)]; ++m) {
                const int c = tables_->offset[index(u)] + 2 * (m - 1), s = c + 1;
                Z cosine{broadcast<R>(0.0), broadcast<R>(0.0)}, sine = cosine;
                for (int l = 1; l < k; ++l) {
                    const double weight = m * fraction[k][l];
                    if (tables_->laurent) {
                        cosine += turned(weight * (path(l, u) * at(k - l, c)));
                        sine -= turned(weight * (path(l, u) * at(k - l, s)));
                        continue;
                    }
                    cosine -= weight * (path(l, u) * at(k - l, s));
                    sine += weight * (path(l, u) * at(k - l, c));
                }
                at(k, c) = cosine;
                at(k, s) = sine;
            }
        }
        multiply_nodes(k);
    }
    /// And with the k-th of the path as it is.
    void complete(int k, const auto& d) {
        for (int u = 0; u < tables_->sizes.unknowns; ++u) {
            path(k, u) = d[u];
            if (u >= tables_->sizes.angles) {
                raise_powers(u, k);
                continue;
            }
            for (int m = 1; m <= tables_->highest[index(u)]; ++m) {
                const int c = tables_->offset[index(u)] + 2 * (m - 1), s = c + 1;
                const Z step = static_cast<double>(m) * d[u];
                if (tables_->laurent) {
                    at(k, c) += turned(step * at(0, c));
                    at(k, s) -= turned(step * at(0, s));
                    continue;
                }
                at(k, c) -= step * at(0, s);
                at(k, s) += step * at(0, c);
            }
        }
        multiply_nodes(k);
    }

private:
    static constexpr double fraction[order + 1][order + 1] = {
        {}, {0, 1}, {0, 1 / 2., 1}, {0, 1 / 3., 2 / 3., 1}};  // l / k

    /// i z.
    static Z turned(const Z& z) { return Z(-z.im, z.re); }

    static constexpr std::size_t index(int u) { return static_cast<std::size_t>(u); }
    Z& at(int k, int operand) {
        return value_[static_cast<std::size_t>(k) * size_ + static_cast<std::size_t>(operand)];
    }

    /// The Taylor coefficient k of unknown u along the path.
    Z& path(int k, int u) { return path_[index(k * tables_->sizes.unknowns + u)]; }

    void raise_powers(int u, int k) {
        const int first = tables_->offset[index(u)];
        at(k, first) = path(k, u);
        for (int m = 1; m < tables_->highest[index(u)]; ++m) {
            Z sum = at(0, first + m - 1) * at(k, first);
            for (int l = 1; l <= k; ++l) sum += at(l, first + m - 1) * at(k - l, first);
            at(k, first + m) = sum;
        }
    }
    void multiply_slopes() {
        int target = tables_->factors;
        for (const auto& node : tables_->nodes) {
            const auto place = [this](int operand, int u) { return index(tables_->slope_place(operand, u)); };
            for (const int u : tables_->unknowns(node.left))
                slope_[place(target, u)] = slope_[place(node.left, u)] * at(0, node.right);
            const int own = tables_->unknowns(node.right).front();
            slope_[place(target, own)] = at(0, node.left) * slope_[index(node.right)];
            ++target;
        }
    }
    void multiply_nodes(int k) {
        int target = tables_->factors;
        for (const auto& node : tables_->nodes) {
            Z sum = at(0, node.left) * at(k, node.right);
            for (int l = 1; l <= k; ++l) sum += at(l, node.left) * at(k - l, node.right);
            at(k, target++) = sum;
        }
    }

    const TermTables* tables_;
    std::size_t size_;
    AlignedVector<Z> value_, slope_, path_;
};

}  // namespace equilibria::detail
