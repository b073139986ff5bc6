/// \file
/// Assembly of sparse matrices and vectors from elements: the pattern is found once, then each entry of an element's
/// tangent knows its place. Elements are evaluated side by side and added in their order, so that the sums do not
/// depend on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/SparseCore>

#include <equilibria/fem/element.hpp>
#include <equilibria/run/threads.hpp>

namespace equilibria::fem {

/// Where the unknowns of a group's elements are among the structure's.
class GroupAssembly {
public:
    /// `unknowns`: of each element in turn, group.unknowns() numbers, -1 where there is none.
    GroupAssembly(const ElementGroup& group, std::vector<int> unknowns)
        : group_(&group), unknowns_(std::move(unknowns)), size_(static_cast<std::size_t>(group.unknowns())) {}

    const ElementGroup& group() const { return *group_; }  ///< the elements
    /// Of element e: group().unknowns() numbers, -1 where there is none.
    const int* unknowns(std::size_t e) const { return unknowns_.data() + e * size_; }

    /// Adds an entry for each pair of unknowns that an element joins.
    void add_pattern(std::vector<Eigen::Triplet<double>>& entries) const {
        for (std::size_t e = 0; e < group_->size(); ++e)
            for (std::size_t i = 0; i < size_; ++i)
                for (std::size_t k = 0; k < size_; ++k)
                    if (unknowns(e)[i] >= 0 && unknowns(e)[k] >= 0)
                        entries.emplace_back(unknowns(e)[i], unknowns(e)[k], 0.0);
    }
    /// Finds the places of the elements' entries in a compressed matrix of the whole pattern.
    void find_places(const Eigen::SparseMatrix<double>& pattern) {
        places_.assign(group_->size() * size_ * size_, -1);
        auto place = places_.begin();
        for (std::size_t e = 0; e < group_->size(); ++e)
            for (std::size_t k = 0; k < size_; ++k)
                for (std::size_t i = 0; i < size_; ++i, ++place) {
                    const int row = unknowns(e)[i], column = unknowns(e)[k];
                    if (row < 0 || column < 0) continue;
                    const int* begin = pattern.innerIndexPtr() + pattern.outerIndexPtr()[column];
                    const int* end = pattern.innerIndexPtr() + pattern.outerIndexPtr()[column + 1];
                    *place = static_cast<int>(std::lower_bound(begin, end, row) - pattern.innerIndexPtr());
                }
    }

    /// Calls evaluate(e, out) for all elements, side by side, and add(e, out) in their order.
    void for_each(const Executor& executor, const auto& evaluate, const auto& add) const {
        const std::size_t elements = group_->size();
        // an evaluation takes about a microsecond, a thread's start tens
        const std::size_t chunk = executor.workers() == 1 || elements < 256 ? 1 : std::min<std::size_t>(elements, 8192);
        std::vector<ElementValues> out(std::min(chunk, elements));
        for (ElementValues& values : out) {
            values.residual.resize(static_cast<Eigen::Index>(size_));
            values.parameter_derivative.resize(static_cast<Eigen::Index>(size_));
            values.tangent.resize(static_cast<Eigen::Index>(size_), static_cast<Eigen::Index>(size_));
        }
        for (std::size_t begin = 0; begin < elements; begin += chunk) {
            const std::size_t count = std::min(chunk, elements - begin);
            executor.for_blocks(count, 64, [&](std::size_t first, std::size_t last) {
                for (std::size_t k = first; k < last; ++k) evaluate(begin + k, out[k]);
            });
            for (std::size_t k = 0; k < count; ++k) add(begin + k, out[k]);
        }
    }
    /// Adds what element e gives; the matrix has the pattern of `find_places`.
    /// \{
    void add(std::size_t e, const Eigen::VectorXd& values, Eigen::VectorXd& to) const {
        for (std::size_t i = 0; i < size_; ++i)
            if (unknowns(e)[i] >= 0) to(unknowns(e)[i]) += values(static_cast<Eigen::Index>(i));
    }
    void add(std::size_t e, const Eigen::MatrixXd& values, Eigen::SparseMatrix<double>& to) const {
        const int* place = places_.data() + e * size_ * size_;
        const double* from = values.data();
        for (std::size_t k = 0; k < size_ * size_; ++k)
            if (place[k] >= 0) to.valuePtr()[place[k]] += from[k];
    }
    /// \}

private:
    const ElementGroup* group_;
    std::vector<int> unknowns_, places_;
    std::size_t size_;
};

}  // namespace equilibria::fem
