/// \file
/// See continuation/factorization/sparse_ldlt.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/OrderingMethods>

#include <equilibria/continuation/factorization/detail/supernodes.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>

namespace equilibria {

struct SparseLDLT::Factors {
    using Columns = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
    using Panel = Eigen::Map<const Eigen::MatrixXd>;
    using Node = detail::Supernodes::Node;

    Factors(int multipliers, EliminationOrder by) : multipliers_(multipliers), elimination_order_(by) {}

    bool factor(const Matrix& k, const RemovedUnknown& removed) {
        if (!has_pattern(k)) {
            order(k);
            supernodes_ = detail::Supernodes(k, place_);
        }
        l_.assign(supernodes_.panel_size(), 0);
        d_.resize(k.rows());
        auto to = supernodes_.entries().begin();
        for (int c = 0; c < k.outerSize(); ++c)
            for (Matrix::InnerIterator entry(k, c); entry; ++entry) {
                if (entry.row() < c) continue;
                double& in_panel = l_[static_cast<std::size_t>(*to++)];
                if (entry.row() != removed.unknown && c != removed.unknown)
                    in_panel += entry.value();
                else if (entry.row() == c)
                    in_panel += removed.corner;
            }
        updates_.clear();
        updates_.reserve(supernodes_.most_waiting());
        waiting_.clear();
        for (std::size_t s = 0; s < supernodes_.nodes().size(); ++s)
            if (!factor_node(static_cast<int>(s))) return false;
        return true;
    }

    /// The columns of f side by side, in groups: each entry of L is read once for all of a group.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const {
        Eigen::MatrixXd y(f.rows(), f.cols());
        Eigen::Index c = 0;
        for (; f.cols() - c > 4; c += 8) solve_group<8>(f, c, y);
        if (f.cols() - c > 2) return solve_group<4>(f, c, y), y;
        if (f.cols() - c == 2) return solve_group<2>(f, c, y), y;
        if (f.cols() - c == 1) solve_group<1>(f, c, y);
        return y;
    }
    int negative() const { return static_cast<int>((d_.array() < 0).count()); }
    Eigen::Index fill() const { return supernodes_.fill(); }
    double work() const { return supernodes_.work(); }

private:
    template <int N>
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, N, N == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

    /// y = k^-1 f of the columns from number `first` on, at most N.
    template <int N>
    void solve_group(const Eigen::MatrixXd& f, Eigen::Index first, Eigen::MatrixXd& y) const {
        const Eigen::Index columns = std::min<Eigen::Index>(N, f.cols() - first);
        Rows<N> x(f.rows(), N), below;
        if (columns < N) x.setZero();
        for (Eigen::Index c = 0; c < columns; ++c)
            for (Eigen::Index i = 0; i < f.rows(); ++i) x(place_[static_cast<std::size_t>(i)], c) = f(i, first + c);
        for (const Node& node : supernodes_.nodes()) forward(node, x, below);
        x.array().colwise() /= d_.array();
        const auto& nodes = supernodes_.nodes();
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) backward(*node, x, below);
        for (Eigen::Index c = 0; c < columns; ++c)
            for (Eigen::Index i = 0; i < f.rows(); ++i) y(i, first + c) = x(place_[static_cast<std::size_t>(i)], c);
    }
    template <int N>
    void forward(const Node& node, Rows<N>& x, Rows<N>& below) const {
        const Panel panel(l_.data() + node.panel, node.rows, node.width);
        auto own = x.middleRows(node.first, node.width);
        const int* rows = supernodes_.rows().data() + node.row + node.width;
        const Eigen::Index width = node.width, rest = node.below();
        if constexpr (N == 1) {
            panel.topRows(width).template triangularView<Eigen::UnitLower>().solveInPlace(own);
            if (rest == 0) return;
            below.noalias() = panel.bottomRows(rest) * own;
        } else {
            for (Eigen::Index c = 0; c < width; ++c)
                for (Eigen::Index r = c + 1; r < width; ++r) own.row(r) -= panel(r, c) * own.row(c);
            if (rest == 0) return;
            below.setZero(rest, N);
            // four columns at a time
            Eigen::Index c = 0;
            for (; c + 4 <= width; c += 4) {
                const double* l = panel.col(c).data() + width;
                const Eigen::Matrix<double, 1, N> a = own.row(c), b = own.row(c + 1), d = own.row(c + 2),
                                                  e = own.row(c + 3);
                for (Eigen::Index r = 0; r < rest; ++r)
                    below.row(r) +=
                        l[r] * a + l[r + node.rows] * b + l[r + 2 * node.rows] * d + l[r + 3 * node.rows] * e;
            }
            for (; c < width; ++c) {
                const double* l = panel.col(c).data() + width;
                const Eigen::Matrix<double, 1, N> a = own.row(c);
                for (Eigen::Index r = 0; r < rest; ++r) below.row(r) += l[r] * a;
            }
        }
        for (Eigen::Index r = 0; r < rest; ++r) x.row(rows[r]) -= below.row(r);
    }
    template <int N>
    void backward(const Node& node, Rows<N>& x, Rows<N>& below) const {
        const Panel panel(l_.data() + node.panel, node.rows, node.width);
        auto own = x.middleRows(node.first, node.width);
        const int* rows = supernodes_.rows().data() + node.row + node.width;
        const Eigen::Index width = node.width, rest = node.below();
        below.resize(rest, N);
        for (Eigen::Index r = 0; r < rest; ++r) below.row(r) = x.row(rows[r]);
        if constexpr (N == 1) {
            if (rest > 0) own.noalias() -= panel.bottomRows(rest).transpose() * below;
            panel.topRows(width).transpose().template triangularView<Eigen::UnitUpper>().solveInPlace(own);
        } else {
            using Row = Eigen::Matrix<double, 1, N>;
            Eigen::Index c = 0;
            for (; c + 4 <= width && rest > 0; c += 4) {
                const double* l = panel.col(c).data() + width;
                Row a = Row::Zero(), b = a, d = a, e = a;
                for (Eigen::Index r = 0; r < rest; ++r) {
                    const Row v = below.row(r);
                    a += l[r] * v;
                    b += l[r + node.rows] * v;
                    d += l[r + 2 * node.rows] * v;
                    e += l[r + 3 * node.rows] * v;
                }
                own.row(c) -= a;
                own.row(c + 1) -= b;
                own.row(c + 2) -= d;
                own.row(c + 3) -= e;
            }
            for (; c < width && rest > 0; ++c) {
                const double* l = panel.col(c).data() + width;
                Row a = Row::Zero();
                for (Eigen::Index r = 0; r < rest; ++r) a += l[r] * below.row(r);
                own.row(c) -= a;
            }
            for (c = width; c-- > 0;) {
                Row v = own.row(c);
                for (Eigen::Index r = c + 1; r < width; ++r) v -= panel(r, c) * own.row(r);
                own.row(c) = v;
            }
        }
    }

    /// Adds the updates of a node's children to its panel, factors it, and leaves its own update for its parent.
    bool factor_node(int s) {
        const Node& node = supernodes_.nodes()[static_cast<std::size_t>(s)];
        const Eigen::Index rows = node.rows, width = node.width, below = node.below();
        Columns panel(l_.data() + node.panel, rows, width, Eigen::OuterStride<>(rows));
        if (update_.size() < static_cast<std::size_t>(below * below))
            update_.resize(static_cast<std::size_t>(below * below));
        Columns update(update_.data(), below, below, Eigen::OuterStride<>(below));
        update.setZero();
        while (!waiting_.empty() && supernodes_.nodes()[static_cast<std::size_t>(waiting_.back())].parent == s) {
            const Node& child = supernodes_.nodes()[static_cast<std::size_t>(waiting_.back())];
            const Eigen::Index size = child.below();
            const int* relative = supernodes_.relative().data() + child.row + child.width;
            const double* from = updates_.data() + updates_.size() - size * size;
            for (Eigen::Index c = 0; c < size; ++c, from += size) {
                double* column = relative[c] < width ? panel.col(relative[c]).data()
                                                     : update.col(relative[c] - width).data() - width;
                for (Eigen::Index r = c; r < size; ++r) column[relative[r]] += from[r];
            }
            updates_.resize(updates_.size() - static_cast<std::size_t>(size * size));
            waiting_.pop_back();
        }
        // L D L^T of the columns, a block of them after the other
        constexpr Eigen::Index block = 24;
        auto d = d_.segment(node.first, width);
        for (Eigen::Index first = 0; first < width; first += block) {
            const Eigen::Index end = std::min(first + block, width);
            for (Eigen::Index c = first; c < end; ++c) {
                const double pivot = panel(c, c), inverse = 1 / pivot;
                if (!(std::abs(pivot) > 0) || !std::isfinite(inverse)) return false;
                d(c) = pivot;
                const Eigen::Index rest = rows - c - 1;
                auto column = panel.col(c).tail(rest);
                column *= inverse;
                for (Eigen::Index next = c + 1; next < end; ++next)
                    panel.col(next).tail(rows - next) -= (pivot * panel(next, c)) * column.tail(rows - next);
            }
            if (end < width) {
                const auto scaled =
                    panel.block(end, first, width - end, end - first) * d.segment(first, end - first).asDiagonal();
                product_.noalias() = scaled.transpose();
                panel.bottomRightCorner(rows - end, width - end).noalias() -=
                    panel.block(end, first, rows - end, end - first) * product_;
            }
        }
        if (below > 0) {
            product_.noalias() = (panel.bottomRows(below) * d.asDiagonal()).transpose();
            if (below <= 64)
                update.noalias() -= panel.bottomRows(below) * product_;
            else
                update.triangularView<Eigen::Lower>() -= panel.bottomRows(below) * product_;
            updates_.insert(updates_.end(), update_.begin(), update_.begin() + below * below);
        }
        waiting_.push_back(s);
        return true;
    }

    bool has_pattern(const Matrix& k) const {
        return k.isCompressed() && k.outerSize() + 1 == static_cast<Eigen::Index>(columns_.size()) &&
               std::equal(columns_.begin(), columns_.end(), k.outerIndexPtr()) &&
               std::equal(rows_.begin(), rows_.end(), k.innerIndexPtr());
    }
    void order(const Matrix& k) {
        columns_.clear();
        rows_.clear();
        if (k.isCompressed()) {
            columns_.assign(k.outerIndexPtr(), k.outerIndexPtr() + k.outerSize() + 1);
            rows_.assign(k.innerIndexPtr(), k.innerIndexPtr() + k.nonZeros());
        }
        const std::vector<int> unknown = order_with_multipliers(k, multipliers_, elimination_order_);
        place_.resize(unknown.size());
        for (std::size_t i = 0; i < unknown.size(); ++i)
            place_[static_cast<std::size_t>(unknown[i])] = static_cast<int>(i);
    }

    int multipliers_;
    EliminationOrder elimination_order_;
    std::vector<int> columns_, rows_;  // the pattern of the matrices that were analysed
    std::vector<int> place_;           // of each unknown in the order of elimination
    detail::Supernodes supernodes_;
    std::vector<double> l_;  // the nodes' panels, unit lower trapezoids
    Eigen::VectorXd d_;
    std::vector<double> updates_;  // of the nodes in waiting_, which their parents have not taken, one after the other
    std::vector<int> waiting_;
    std::vector<double> update_;  // of the present node
    Eigen::MatrixXd product_;
};

EQUILIBRIA_INLINE std::vector<int> minimum_degree(const SymmetricFactors::Matrix& k) {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order(k.rows());
    Eigen::AMDOrdering<int>()(k, order);
    return {order.indices().begin(), order.indices().end()};
}

EQUILIBRIA_INLINE std::vector<int> order_with_multipliers(const SymmetricFactors::Matrix& k, int multipliers,
                                                          EliminationOrder by) {
    const int size = static_cast<int>(k.rows()), own = size - multipliers;
    if (multipliers == 0) return by(k);
    std::vector<int> unknown;  // those that are no multipliers
    if (own > 0) unknown = by(k.topLeftCorner(own, own));
    std::vector<int> place(unknown.size()), y;
    for (std::size_t i = 0; i < unknown.size(); ++i) place[static_cast<std::size_t>(unknown[i])] = static_cast<int>(i);
    std::vector<std::vector<int>> following(unknown.size() + 1);  // the multipliers after each of them
    for (int m = own; m < size; ++m) {
        int last = -1;
        for (SymmetricFactors::Matrix::InnerIterator entry(k, m); entry; ++entry)
            if (entry.row() < own) last = std::max(last, place[static_cast<std::size_t>(entry.row())]);
        following[static_cast<std::size_t>(last + 1)].push_back(m);
    }
    for (std::size_t i = 0; i < following.size(); ++i) {
        if (i > 0) y.push_back(unknown[i - 1]);
        y.insert(y.end(), following[i].begin(), following[i].end());
    }
    return y;
}

EQUILIBRIA_INLINE SparseLDLT::SparseLDLT(int multipliers, EliminationOrder order)
    : factors_(std::make_unique<Factors>(multipliers, order)) {}
EQUILIBRIA_INLINE SparseLDLT::SparseLDLT(SparseLDLT&&) noexcept = default;
EQUILIBRIA_INLINE SparseLDLT& SparseLDLT::operator=(SparseLDLT&&) noexcept = default;
EQUILIBRIA_INLINE SparseLDLT::~SparseLDLT() = default;

EQUILIBRIA_INLINE bool SparseLDLT::factor(const Matrix& k, const RemovedUnknown& removed) {
    return factors_->factor(k, removed);
}
EQUILIBRIA_INLINE Eigen::MatrixXd SparseLDLT::solve(const Eigen::MatrixXd& f) const { return factors_->solve(f); }
EQUILIBRIA_INLINE int SparseLDLT::negative() const { return factors_->negative(); }
EQUILIBRIA_INLINE Eigen::Index SparseLDLT::fill() const { return factors_->fill(); }
EQUILIBRIA_INLINE double SparseLDLT::work() const { return factors_->work(); }

}  // namespace equilibria
