/// \file
/// Tables as comma-separated values: RFC 4180 (Shafranovich, 2005) but for line ends, which are single line feeds.
///
/// One header line; a cell with a comma, a quote or a line end stands in quotes, quotes inside it are doubled. Numbers
/// have as few digits as are needed to read the same double again, with a point whatever the locale. NaN is `nan`,
/// infinities are `inf` and `-inf`, which C's strtod, Python's float and gnuplot read. Truth is 1 or 0, and what is not
/// known is an empty cell.
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/io/results/text_file.hpp>

namespace equilibria {

/// A number as text that reads as the same double; -0 is 0.
inline std::string csv_cell(double x) {
    if (std::isnan(x)) return "nan";
    if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, x + 0.0);
    return {text, end.ptr};
}
/// An integer, or 1 and 0 for true and false.
template <std::integral T>
std::string csv_cell(T x) {
    if constexpr (std::same_as<T, bool>)
        return x ? "1" : "0";
    else
        return std::to_string(x);
}
/// Text, in quotes where it must be.
/// \{
inline std::string csv_cell(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}
inline std::string csv_cell(const char* text) { return csv_cell(std::string_view(text)); }
inline std::string csv_cell(const std::string& text) { return csv_cell(std::string_view(text)); }
/// \}
/// Empty where there is no value.
template <class T>
std::string csv_cell(const std::optional<T>& value) {
    return value ? csv_cell(*value) : std::string();
}

/// Cells of one line, in the making.
class CsvRow {
public:
    /// Puts a cell behind the others.
    template <class T>
    CsvRow& add(const T& value) {
        cells_.push_back(csv_cell(value));
        return *this;
    }
    /// A cell for each of the values.
    template <class Values>
    CsvRow& add_all(const Values& values) {
        for (const auto& value : values) add(value);
        return *this;
    }
    const std::vector<std::string>& cells() const { return cells_; }  ///< those so far
    /// With its line feed.
    std::string line() const {
        std::string out;
        for (const std::string& cell : cells_) out += (&cell == &cells_.front() ? "" : ",") + cell;
        return out + '\n';
    }

private:
    std::vector<std::string> cells_;
};

/// A header and its lines.
class CsvTable {
public:
    /// columns: their names.
    explicit CsvTable(std::vector<std::string> columns) : columns_(std::move(columns)) {}

    const std::vector<std::string>& columns() const { return columns_; }  ///< their names
    std::size_t rows() const { return rows_; }                            ///< lines behind the header
    /// Throws InvalidArgument unless there is a cell for each column.
    void add(const CsvRow& row) {
        require(row.cells().size() == columns_.size(), "row", row.cells().size(),
                "must have " + std::to_string(columns_.size()) + " cells, one a column");
        text_ += row.line();
        ++rows_;
    }
    /// Header and lines, each with a line feed.
    std::string text() const { return CsvRow().add_all(columns_).line() + text_; }

private:
    std::vector<std::string> columns_;
    std::string text_;
    std::size_t rows_ = 0;
};

/// name1, name2, .. and what follows them, put behind `columns`.
inline void add_columns(std::vector<std::string>& columns, std::string_view name, int count,
                        std::string_view suffix = "") {
    for (int i = 1; i <= count; ++i) columns.push_back(std::string(name) + std::to_string(i) + std::string(suffix));
}

/// index_0, index_1, .. up to index_n: numbers of equilibria by index.
inline void add_index_columns(std::vector<std::string>& columns, int n) {
    for (int i = 0; i <= n; ++i) columns.push_back("index_" + std::to_string(i));
}

/// Writes a table to a file. Throws std::system_error where that cannot be written.
inline void write_csv(const std::filesystem::path& path, const CsvTable& table) { write_text(path, table.text()); }

}  // namespace equilibria
