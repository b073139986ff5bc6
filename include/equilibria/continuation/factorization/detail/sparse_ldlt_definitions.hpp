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

    Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const {
        const Eigen::Index n = f.rows();
        Eigen::MatrixXd x(n, f.cols()), below;
        for (Eigen::Index c = 0; c < f.cols(); ++c)
            for (Eigen::Index i = 0; i < n; ++i) x(place_[static_cast<std::size_t>(i)], c) = f(i, c);
        const auto& nodes = supernodes_.nodes();
        for (const Node& node : nodes) {
            const Panel panel(l_.data() + node.panel, node.rows, node.width);
            auto own = x.middleRows(node.first, node.width);
            panel.topRows(node.width).triangularView<Eigen::UnitLower>().solveInPlace(own);
            if (node.below() == 0) continue;
            below.noalias() = panel.bottomRows(node.below()) * own;
            const int* rows = supernodes_.rows().data() + node.row + node.width;
            for (Eigen::Index c = 0; c < x.cols(); ++c)
                for (int r = 0; r < node.below(); ++r) x(rows[r], c) -= below(r, c);
        }
        x.array().colwise() /= d_.array();
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
            const Panel panel(l_.data() + node->panel, node->rows, node->width);
            auto own = x.middleRows(node->first, node->width);
            if (node->below() > 0) {
                const int* rows = supernodes_.rows().data() + node->row + node->width;
                below.resize(node->below(), x.cols());
                for (Eigen::Index c = 0; c < x.cols(); ++c)
                    for (int r = 0; r < node->below(); ++r) below(r, c) = x(rows[r], c);
                own.noalias() -= panel.bottomRows(node->below()).transpose() * below;
            }
            panel.topRows(node->width).transpose().triangularView<Eigen::UnitUpper>().solveInPlace(own);
        }
        Eigen::MatrixXd y(n, f.cols());
        for (Eigen::Index c = 0; c < f.cols(); ++c)
            for (Eigen::Index i = 0; i < n; ++i) y(i, c) = x(place_[static_cast<std::size_t>(i)], c);
        return y;
    }
    int negative() const { return static_cast<int>((d_.array() < 0).count()); }
    Eigen::Index fill() const { return supernodes_.fill(); }

private:
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

}  // namespace equilibria
