// What a sweep over points of the parameter space writes.
#pragma once

#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/enumerate/sweep.hpp>
#include <equilibria/io/results/csv.hpp>
#include <equilibria/io/results/json.hpp>

#include "output_file.hpp"

namespace support {

/// A line for each point, as they come.
class SweepRows {
public:
    /// names: of the parameters.
    SweepRows(const std::optional<OutputFile>& csv, const std::vector<std::string>& names, int unknowns) {
        if (!csv) return;
        name_ = csv->name();
        if (!csv->to_stdout()) file_.open(name_);
        std::vector<std::string> columns = names;
        for (const char* column : {"paths", "finite", "at_infinity", "singular", "failed", "distinct", "real"})
            columns.emplace_back(column);
        equilibria::add_index_columns(columns, unknowns);
        for (const char* column : {"degenerate", "clean", "alarm", "instances", "proved", "proved_real"})
            columns.emplace_back(column);
        out() << equilibria::CsvTable(columns).text();
        check();
    }
    void add(const equilibria::SweptPoint& p) {
        if (name_.empty()) return;
        equilibria::CsvRow row;
        row.add_all(p.parameters).add(p.paths).add(p.finite).add(p.at_infinity).add(p.singular).add(p.failed);
        row.add(p.distinct).add(p.real).add_all(p.by_index).add(p.degenerate).add(p.clean).add(p.alarm);
        row.add(static_cast<int>(p.instances)).add(p.proved).add(p.proved_real);
        out() << row.line();
        check();
    }
    void close() {
        if (name_.empty()) return;
        out().flush();
        check();
    }

private:
    std::ostream& out() { return file_.is_open() ? file_ : std::cout; }
    void check() {
        if (!out()) throw std::runtime_error("--csv " + name_ + ": cannot be written");
    }
    std::string name_;
    std::ofstream file_;
};

/// The counts of all points.
inline equilibria::Json sweep_json(const equilibria::SweepCounts& n) {
    equilibria::Json by_real = equilibria::Json::object();
    for (const auto& [real, points] : n.by_real) by_real[std::to_string(real)] = points;
    return {{"points", n.points},
            {"done", n.done},
            {"mixed_volume", n.mixed_volume},
            {"paths", n.paths},
            {"failed", n.failed},
            {"points_with_a_vanishing_equation", n.vanishing},
            {"points_with_multiple_roots", n.singular_points},
            {"points_with_an_alarm", n.alarms},
            {"points_not_clean", n.unclean},
            {"points_done_again", n.again},
            {"points_proved", n.proved},
            {"points_by_equilibria", std::move(by_real)},
            {"seconds", n.seconds}};
}

}  // namespace support
