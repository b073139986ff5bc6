/// \file
/// The circuit table of a mixed cell. A column k belongs to the configuration i(k) of points and is its point with a 1
/// at place i(k) of n more coordinates; the 2n columns of the cell's edges are a basis D of all. Of volume D^-1 column,
/// which are integers, the two entries of a configuration j add up to volume where j = i(k) and to 0 elsewhere: those
/// of the first points are the row j of the table.
///
/// Source: A. N. Jensen, Tropical homotopy continuation, arXiv:1601.02818 (2016).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <equilibria/polyhedral/detail/table_integers.hpp>

namespace equilibria::detail {

/// The columns of a table: those of a configuration follow one another, and earlier columns are perturbed more.
struct ColumnLayout {
    /// Where the columns of each configuration begin, and their number.
    std::vector<int> first;
    /// The configuration of each column.
    std::vector<int> configuration;
    /// The configuration that is exchanged in this stage (-1: none); its first `artificial` columns are to go.
    int stage = -1;
    int artificial = 0;

    int configurations() const { return static_cast<int>(first.size()) - 1; }
    int columns() const { return first.back(); }
    bool is_artificial(int column) const {
        return stage >= 0 && column >= first[static_cast<std::size_t>(stage)] &&
               column < first[static_cast<std::size_t>(stage)] + artificial;
    }

    /// Of configurations of these sizes.
    static ColumnLayout of(const std::vector<int>& sizes, int stage, int artificial) {
        ColumnLayout y;
        y.stage = stage;
        y.artificial = artificial;
        y.first.push_back(0);
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            y.first.push_back(y.first.back() + sizes[i]);
            y.configuration.insert(y.configuration.end(), static_cast<std::size_t>(sizes[i]), static_cast<int>(i));
        }
        return y;
    }
};

template <class Integer>
class CircuitTable {
public:
    using Bound = std::uint64_t;

    CircuitTable() = default;
    /// Zeros, of a volume and edges that are not set yet.
    explicit CircuitTable(const ColumnLayout& layout) { reset(layout); }

    void reset(const ColumnLayout& layout) {
        rows_ = static_cast<std::size_t>(layout.configurations());
        columns_ = static_cast<std::size_t>(layout.columns());
        stride_ = (columns_ + 15) / 16 * 16;  // whole vectors of instructions: the rest stays 0
        entries_.assign(rows_ * stride_, Integer(0));
        edges.resize(rows_);
        bounds_.assign(rows_, std::numeric_limits<Bound>::max());
    }

    int rows() const { return static_cast<int>(rows_); }
    int columns() const { return static_cast<int>(columns_); }
    Integer* row(int j) { return entries_.data() + static_cast<std::size_t>(j) * stride_; }
    const Integer* row(int j) const { return entries_.data() + static_cast<std::size_t>(j) * stride_; }
    const Integer& at(int j, int column) const { return row(j)[static_cast<std::size_t>(column)]; }

    /// |det| of the edges, and the columns of the edge of each configuration.
    Integer volume = 0;
    std::vector<std::array<int, 2>> edges;

    /// The entry of volume D^-1 column for the first (0) or second (1) point of configuration j.
    Integer entry(const ColumnLayout& layout, int j, int end, int column) const {
        if (end == 0) return at(j, column);
        return layout.configuration[static_cast<std::size_t>(column)] == j ? Integer(volume - at(j, column))
                                                                           : Integer(-at(j, column));
    }

    /// The largest magnitude in row j, as the entries are.
    Bound largest(int j) const {
        if constexpr (is_unlimited<Integer>) {
            return std::numeric_limits<Bound>::max();
        } else {
            Integer low = 0, high = 0;
            const Integer* const x = row(j);
            for (std::size_t k = 0; k < stride_; ++k) {
                low = std::min(low, x[k]);
                high = std::max(high, x[k]);
            }
            return std::max(static_cast<Bound>(high), Bound(0) - static_cast<Bound>(low));
        }
    }
    /// At least that, known without looking.
    Bound bound(int j) const { return bounds_[static_cast<std::size_t>(j)]; }
    void measure(int j) { bounds_[static_cast<std::size_t>(j)] = largest(j); }

    /// Takes `column` into the cell for the first (0) or second (1) point of its configuration, whose entry there is
    /// not 0: the point that stays is the first one then, the column the second. False, and nothing changed, where an
    /// entry's magnitude might exceed `limit`.
    bool exchange(const ColumnLayout& layout, int column, int leaving, const Integer& limit) {
        const int i = layout.configuration[static_cast<std::size_t>(column)];
        const Integer at_column = at(i, column);
        if constexpr (!is_unlimited<Integer>)
            if (!fits(i, column, leaving, limit)) return false;
        const Integer pivot = leaving == 0 ? at_column : Integer(volume - at_column);
        const Integer p = absolute_value(pivot);
        const bool positive = pivot > 0;
        const auto begin = static_cast<std::size_t>(layout.first[static_cast<std::size_t>(i)]);
        const auto end = static_cast<std::size_t>(layout.first[static_cast<std::size_t>(i) + 1]);
        const bool same_volume = p == volume;
        for (int j = 0; j < rows(); ++j) {
            if (j == i) continue;
            const Integer r = at(j, column);
            if (r == 0 && same_volume) continue;
            const Integer signed_r = positive ? r : Integer(-r);
            combine_rows<Integer>(row(j), row(i), stride_, p, leaving == 0 ? Integer(-signed_r) : signed_r, volume);
            if (leaving == 1)
                for (std::size_t k = begin; k < end; ++k) row(j)[k] -= signed_r;
        }
        // what stays: entries of the second point where the first one leaves
        Integer* const x = row(i);
        if ((leaving == 0) == positive)
            for (std::size_t k = 0; k < stride_; ++k) x[k] = -x[k];
        const Integer more = leaving == 0 ? p : positive ? Integer(-at_column) : at_column;
        if (more != 0)
            for (std::size_t k = begin; k < end; ++k) x[k] += more;
        volume = p;
        auto& edge = edges[static_cast<std::size_t>(i)];
        edge = {edge[leaving == 0 ? 1 : 0], column};
        return true;
    }

    /// Calls the second point of configuration i the first. False, and nothing changed, where an entry might exceed
    /// `limit`.
    bool swap_ends(const ColumnLayout& layout, int i, const Integer& limit) {
        if constexpr (!is_unlimited<Integer>) {
            if (!in_range(bound(i), limit)) measure(i);
            if (!in_range(bound(i), limit)) return false;
            bounds_[static_cast<std::size_t>(i)] = bound(i) + static_cast<Bound>(volume);
        }
        Integer* const x = row(i);
        for (std::size_t k = 0; k < stride_; ++k) x[k] = -x[k];
        for (int k = layout.first[static_cast<std::size_t>(i)]; k < layout.first[static_cast<std::size_t>(i) + 1]; ++k)
            x[static_cast<std::size_t>(k)] += volume;
        auto& edge = edges[static_cast<std::size_t>(i)];
        std::swap(edge[0], edge[1]);
        return true;
    }

    /// The same of another kind of integers, which hold the entries.
    template <class Other>
    void assign(const CircuitTable<Other>& other) {
        rows_ = other.rows_;
        columns_ = other.columns_;
        stride_ = other.stride_;
        entries_.resize(other.entries_.size());
        for (std::size_t k = 0; k < entries_.size(); ++k) entries_[k] = converted<Integer>(other.entries_[k]);
        volume = converted<Integer>(other.volume);
        edges = other.edges;
        bounds_.assign(rows_, std::numeric_limits<Bound>::max());
    }

private:
    template <class Other>
    friend class CircuitTable;

    bool in_range(Bound b, const Integer& limit) const {
        const auto most = static_cast<Bound>(limit);
        return b <= most && static_cast<Bound>(volume) <= most - b;
    }

    /// Whether no entry for either end can exceed the limit in magnitude after this exchange, by bounds of the rows,
    /// which are measured where those known do not say so; then they are those after it. Products and their sums fit
    /// then.
    bool fits(int i, int column, int leaving, const Integer& limit) {
        using Wide = typename TableInteger<Integer>::UnsignedProduct;
        if (!in_range(bound(i), limit)) measure(i);
        if (!in_range(bound(i), limit)) return false;
        const Integer at_column = at(i, column);
        const auto p = static_cast<Bound>(absolute_value(leaving == 0 ? at_column : Integer(volume - at_column)));
        const auto most = static_cast<Bound>(limit);
        const auto after = [&](int j) {
            const auto r = static_cast<Bound>(absolute_value(at(j, column)));
            const Wide sum = (Wide(p) * bound(j) + Wide(r) * bound(i)) / static_cast<Bound>(volume);
            return leaving == 0 ? sum : sum + r;
        };
        after_.resize(rows_);
        for (int j = 0; j < rows(); ++j) {
            if (j == i) continue;
            auto& y = after_[static_cast<std::size_t>(j)];
            if (at(j, column) == 0 && p == static_cast<Bound>(volume)) {
                y = bound(j);
                continue;
            }
            if (bound(j) > most || after(j) + p > most) {
                measure(j);
                measure(i);
                if (bound(j) > most || after(j) + p > most) return false;
            }
            y = static_cast<Bound>(after(j));
        }
        const Bound more = leaving == 0 ? p : static_cast<Bound>(absolute_value(at_column));
        if (Wide(bound(i)) + more + p > most) measure(i);
        if (Wide(bound(i)) + more + p > most) return false;
        after_[static_cast<std::size_t>(i)] = bound(i) + more;
        bounds_.swap(after_);
        return true;
    }

    std::size_t rows_ = 0, columns_ = 0, stride_ = 0;
    std::vector<Integer> entries_;
    std::vector<Bound> bounds_, after_;
};

}  // namespace equilibria::detail
