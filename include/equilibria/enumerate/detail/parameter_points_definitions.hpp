/// \file
/// See enumerate/parameter_points.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string_view>
#include <system_error>

#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <equilibria/core/grid_value.hpp>
#include <equilibria/core/read_number.hpp>
#include <equilibria/core/splitmix.hpp>
#include <equilibria/enumerate/parameter_points.hpp>
#include <equilibria/paths/complex_roots.hpp>

namespace equilibria {

namespace detail {

EQUILIBRIA_INLINE void require_axes(const RuntimeArray<double>& fixed, const std::vector<VariedParameter>& axes) {
    for (std::size_t k = 0; k < axes.size(); ++k) {
        const std::string name = "axes[" + std::to_string(k) + "]";
        require(axes[k].parameter >= 0 && axes[k].parameter < fixed.size(), name + ".parameter", axes[k].parameter,
                "must be the number of a parameter, less than " + std::to_string(fixed.size()));
        require(std::isfinite(axes[k].low) && std::isfinite(axes[k].high), name + ".low, .high",
                std::to_string(axes[k].low) + ", " + std::to_string(axes[k].high), "must be finite");
        require(axes[k].count > 0, name + ".count", axes[k].count, "must be 1 or more");
        for (std::size_t j = 0; j < k; ++j)
            require(axes[j].parameter != axes[k].parameter, name + ".parameter", axes[k].parameter,
                    "must be another one than that of axes[" + std::to_string(j) + "]");
    }
}

EQUILIBRIA_INLINE std::vector<std::string> cells(std::string_view line) {
    std::vector<std::string> y;
    boost::algorithm::split(y, line, [](char c) { return c == ','; });
    for (std::string& cell : y) boost::algorithm::trim(cell);
    return y;
}

}  // namespace detail

EQUILIBRIA_INLINE ParameterPoints parameter_grid(const RuntimeArray<double>& fixed,
                                                 const std::vector<VariedParameter>& axes) {
    detail::require_axes(fixed, axes);
    std::uint64_t size = 1;
    for (const auto& axis : axes) {
        require(axis.count <= std::numeric_limits<std::uint64_t>::max() / size, "axes", "more than 2^64 points",
                "must be fewer");
        size *= axis.count;
    }
    return {size, [fixed, axes](std::uint64_t k) {
                RuntimeArray<double> p = fixed;
                for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
                    const std::uint64_t at = k % axis->count;
                    k /= axis->count;
                    p[axis->parameter] = grid_value(axis->low, axis->high, at, axis->count);
                }
                return p;
            }};
}

EQUILIBRIA_INLINE ParameterPoints random_parameters(const RuntimeArray<double>& fixed,
                                                    const std::vector<VariedParameter>& axes, std::uint64_t size,
                                                    std::uint64_t seed) {
    detail::require_axes(fixed, axes);
    return {size, [fixed, axes, seed](std::uint64_t k) {
                RuntimeArray<double> p = fixed;
                std::uint64_t state = seed_of_attempt(seed, k + 1);  // a Mersenne twister takes longer to seed
                for (const auto& axis : axes)
                    p[axis.parameter] = axis.low + (axis.high - axis.low) * unit_interval(splitmix64(state));
                return p;
            }};
}

EQUILIBRIA_INLINE ParameterPoints listed_parameters(const std::string& csv, const RuntimeArray<double>& fixed,
                                                    const std::function<int(const std::string& name)>& parameter_of) {
    std::vector<int> columns;
    auto values = std::make_shared<std::vector<double>>();
    int number = 0;
    for (std::size_t at = 0; at < csv.size();) {
        const std::size_t end = std::min(csv.find('\n', at), csv.size());
        const std::string line = boost::algorithm::trim_copy(csv.substr(at, end - at));
        at = end + 1;
        ++number;
        if (line.empty()) continue;
        const auto cells = detail::cells(line);
        const auto place = [&](std::size_t column) {
            return "line " + std::to_string(number) + ", column " + std::to_string(column + 1);
        };
        if (columns.empty()) {
            for (std::size_t k = 0; k < cells.size(); ++k) {
                const int parameter = parameter_of(cells[k]);
                require(parameter >= 0 && parameter < fixed.size(), place(k), '"' + cells[k] + '"',
                        "must name a parameter");
                require(std::find(columns.begin(), columns.end(), parameter) == columns.end(), place(k),
                        '"' + cells[k] + '"', "must be there once");
                columns.push_back(parameter);
            }
            continue;
        }
        require(cells.size() == columns.size(), "line " + std::to_string(number),
                std::to_string(cells.size()) + " values", "must have " + std::to_string(columns.size()));
        for (std::size_t k = 0; k < cells.size(); ++k) {
            double value = 0;
            const auto [rest, error] = detail::read_number(cells[k].data(), cells[k].data() + cells[k].size(), value);
            require(error == std::errc() && rest == cells[k].data() + cells[k].size() && std::isfinite(value), place(k),
                    '"' + cells[k] + '"', "must be a finite number");
            values->push_back(value);
        }
    }
    require(!columns.empty(), "csv", "no line", "must begin with the names of parameters");
    return {values->size() / columns.size(), [fixed, columns, values](std::uint64_t k) {
                RuntimeArray<double> p = fixed;
                for (std::size_t c = 0; c < columns.size(); ++c) p[columns[c]] = (*values)[k * columns.size() + c];
                return p;
            }};
}

}  // namespace equilibria
