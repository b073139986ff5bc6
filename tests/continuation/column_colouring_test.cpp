#include <algorithm>
#include <vector>

#include <equilibria/continuation/column_colouring.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Pattern = Eigen::SparseMatrix<double>;

Pattern with_entries(int rows, int columns, const std::vector<Eigen::Triplet<double>>& entries) {
    Pattern y(rows, columns);
    y.setFromTriplets(entries.begin(), entries.end());
    return y;
}
Pattern band(int n, int half_width) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int r = 0; r < n; ++r)
        for (int c = std::max(0, r - half_width); c <= std::min(n - 1, r + half_width); ++c)
            entries.emplace_back(r, c, 0);
    return with_entries(n, n, entries);
}
/// No row has two entries in columns of one colour.
bool separates(const Pattern& pattern, const ColumnColouring& colouring) {
    const Eigen::SparseMatrix<double, Eigen::RowMajor> by_rows = pattern;
    for (Eigen::Index r = 0; r < by_rows.rows(); ++r) {
        std::vector<int> seen;
        for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(by_rows, r); entry; ++entry)
            seen.push_back(colouring.colour[static_cast<std::size_t>(entry.col())]);
        std::sort(seen.begin(), seen.end());
        if (std::adjacent_find(seen.begin(), seen.end()) != seen.end()) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("bands are coloured with as many colours as they are wide") {
    for (const int half_width : {0, 1, 2, 4})
        for (const int n : {1, 2, 9, 50}) {
            const ColumnColouring y = colour_columns(band(n, half_width));
            CHECK(y.colours == std::min(n, 2 * half_width + 1));
            CHECK(separates(band(n, half_width), y));
        }
}

TEST_CASE("a full row needs a colour a column, empty columns one") {
    std::vector<Eigen::Triplet<double>> entries;
    for (int c = 0; c < 12; ++c) entries.emplace_back(3, c, 0);
    CHECK(colour_columns(with_entries(12, 12, entries)).colours == 12);
    CHECK(colour_columns(with_entries(5, 5, {})).colours == 1);
}

TEST_CASE("random patterns: columns of one colour share no row") {
    Generator generator(1);
    for (int trial = 0; trial < 50; ++trial) {
        const int rows = 1 + static_cast<int>(uniform(generator, 0, 40));
        const int columns = 1 + static_cast<int>(uniform(generator, 0, 40));
        std::vector<Eigen::Triplet<double>> entries;
        for (int k = 0; k < 3 * columns; ++k)
            entries.emplace_back(static_cast<int>(uniform(generator, 0, rows)),
                                 static_cast<int>(uniform(generator, 0, columns)), 0);
        const Pattern pattern = with_entries(rows, columns, entries);
        const ColumnColouring y = colour_columns(pattern);
        CHECK(separates(pattern, y));
        CHECK(*std::max_element(y.colour.begin(), y.colour.end()) + 1 == y.colours);
    }
}
