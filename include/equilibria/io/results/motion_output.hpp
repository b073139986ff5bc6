/// \file
/// A motion as JSON and CSV. Times, lengths, masses and angles are in the model's units; angles are in radians.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <equilibria/dynamics/motion.hpp>
#include <equilibria/io/results/csv.hpp>
#include <equilibria/io/results/json.hpp>

namespace equilibria {

/// How the integration went: "status", "time" (how far it came), "steps", "evaluations", "largest_balance" (over the
/// energy), "largest_drift" and "largest_velocity_drift" of the constraints.
template <class M>
Json evidence_json(const Motion<M>& motion) {
    return {{"status", to_string(motion.status)},
            {"time", motion.time},
            {"steps", motion.steps},
            {"evaluations", motion.evaluations},
            {"largest_balance", motion.largest_balance},
            {"largest_drift", motion.largest_drift},
            {"largest_velocity_drift", motion.largest_velocity_drift}};
}

/// The evidence, and "points": each with "t", "q", "velocity", "momentum", "kinetic", "potential", "work",
/// "dissipated", "balance", and, where the model has constraints, "multipliers" and "drift".
template <class M>
Json json_of(const Motion<M>& motion) {
    Json out = evidence_json(motion), points = Json::array();
    for (const auto& x : motion.points) {
        points.push_back({{"t", x.time},
                          {"q", json_list(x.q)},
                          {"velocity", json_list(x.velocity)},
                          {"momentum", json_list(x.momentum)},
                          {"kinetic", json_of(x.kinetic)},
                          {"potential", json_of(x.potential)},
                          {"work", json_of(x.work)},
                          {"dissipated", json_of(x.dissipated)},
                          {"balance", json_of(x.balance)}});
        if (x.multipliers.size() > 0) {
            points.back()["multipliers"] = json_list(x.multipliers);
            points.back()["drift"] = x.drift;
        }
    }
    out["points"] = std::move(points);
    return out;
}

/// Columns of a motion of n unknowns with m multipliers: t, q1 .. qn, q1_rate .. qn_rate, p1 .. pn (momenta), those in
/// `extra`, kinetic, potential, work, dissipated, balance, and, for m > 0, lambda1 .. lambdam, drift.
inline std::vector<std::string> motion_columns(int n, int m, const std::vector<std::string>& extra = {}) {
    std::vector<std::string> columns{"t"};
    add_columns(columns, "q", n);
    add_columns(columns, "q", n, "_rate");
    add_columns(columns, "p", n);
    columns.insert(columns.end(), extra.begin(), extra.end());
    columns.insert(columns.end(), {"kinetic", "potential", "work", "dissipated", "balance"});
    if (m > 0) {
        add_columns(columns, "lambda", m);
        columns.emplace_back("drift");
    }
    return columns;
}

/// A line a time, with motion_columns. n: the number of unknowns, to be given of models at run time.
template <class M>
CsvTable motion_csv(const Motion<M>& motion, int n = n_unknowns<M>) {
    constexpr int m = n_constraints<M>;
    CsvTable table(motion_columns(n, m));
    for (const auto& x : motion.points) {
        CsvRow row;
        row.add(x.time).add_all(x.q).add_all(x.velocity).add_all(x.momentum);
        row.add(x.kinetic).add(x.potential).add(x.work).add(x.dissipated).add(x.balance);
        if constexpr (m > 0) row.add_all(x.multipliers).add(x.drift);
        table.add(row);
    }
    return table;
}

}  // namespace equilibria
