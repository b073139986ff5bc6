/// \file
/// An enumeration as JSON, its equilibria and its roots as CSV.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/io/results/csv.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/results/path_counts_output.hpp>

namespace equilibria {

/// Of an enumeration's JSON.
struct RootSetJson {
    std::vector<std::string> parameter_names{};  ///< none: "parameters" is an array, else an object with these keys
    bool roots = true;                           ///< whether "roots" is there: all complex ones, which may be many
};

/// "a real curve of solutions (18 paths)".
template <class M>
std::string in_words(const Family<M>& family) {
    return std::string(family.real() ? "a real " : "a ") + family_kind(family.dimension) + " of solutions (" +
           std::to_string(family.paths()) + " paths)";
}

/// One equilibrium: "angles" in (-pi, pi], radians, and the evidence.
template <class M>
Json json_of(const Equilibrium<M>& e, const Sizes<M>& sizes = {}) {
    Json out = Json::object();
    add_unknowns<M>(out, e.q, sizes);
    add_keys(out, {{"index", e.index},
                   {"degenerate", e.degenerate()},
                   {"nullity", e.nullity},
                   {"multiplicity", e.multiplicity},
                   {"stable", e.stable()},
                   {"energy", json_of(e.energy)},
                   {"residual", e.residual},
                   {"condition", e.condition},
                   {"margin", e.margin},
                   {"path", e.path}});
    return out;
}

/// The parameters as an array in the model's order, or by their names. Throws InvalidArgument unless there is a name
/// for each.
template <class M>
Json parameters_json(const ParameterArray<M, double>& p, const std::vector<std::string>& names = {}) {
    if (names.empty()) return json_list(p);
    require(names.size() == static_cast<std::size_t>(p.size()), "names", names.size(),
            "must be one a parameter of the model");
    Json out = Json::object();
    for (int k = 0; k < p.size(); ++k) out[names[static_cast<std::size_t>(k)]] = json_of(p[k]);
    return out;
}

/// What speaks for or against a count, with its times and failures: "clean", "alarms", "morse_applies", "morse",
/// "tracking_seconds", "seconds", "failures". Of a root set, or of one whose roots were handed on.
void add_verdict(Json& out, const auto& set) {
    Json failures = Json::array();
    for (const auto& f : set.failures) failures.push_back({{"path", f.path}, {"reason", to_string(f.reason)}});
    add_keys(out, {{"clean", set.clean()},
                   {"alarms", set.alarms.sentences()},
                   {"morse_applies", set.morse_applies()},
                   {"morse", set.morse()},
                   {"tracking_seconds", set.tracking_seconds},
                   {"seconds", set.seconds},
                   {"failures", std::move(failures)}});
}

/// The keys "parameters", "seed", "start", "start_reason", those of the paths, "distinct", "real", "by_index",
/// "degenerate", "multiplicities", "winding_numbers", "families", "clean", "alarms", "morse_applies", "morse",
/// "tracking_seconds", "seconds", "failures", "equilibria" and "roots": see docs/output.md.
template <class M>
Json json_of(const RootSet<M>& set, const RootSetJson& how = {}) {
    Json out{{"parameters", parameters_json<M>(set.parameters, how.parameter_names)}, {"seed", set.seed}};
    add_keys(out, {{"start", set.start.name}, {"start_reason", set.start.why}});
    add_paths(out, set.paths);
    Json multiplicities = Json::array(), winding_numbers = Json::array(), families = Json::array(),
         equilibria = Json::array();
    for (const auto& root : set.roots) {
        multiplicities.push_back(root.paths);
        winding_numbers.push_back(root.winding_number);
    }
    for (const auto& family : set.families) families.push_back(in_words(family));
    for (const auto& e : set.equilibria) equilibria.push_back(json_of(e, set.model.sizes));
    add_keys(out, {{"distinct", set.distinct()},
                   {"real", set.real()},
                   {"by_index", set.by_index()},
                   {"degenerate", set.degenerate()},
                   {"multiplicities", std::move(multiplicities)},
                   {"winding_numbers", std::move(winding_numbers)},
                   {"families", std::move(families)}});
    add_verdict(out, set);
    out["equilibria"] = std::move(equilibria);
    if (how.roots) {
        out["roots"] = Json::array();
        for (const auto& root : set.roots) out["roots"].push_back(json_list(root.q));
    }
    return out;
}

/// A line an equilibrium: q1, q2, .. (angles in radians, then coordinates), index, nullity, multiplicity, stable,
/// energy, residual, condition, margin, path.
template <class M>
CsvTable equilibria_csv(const RootSet<M>& set) {
    std::vector<std::string> columns;
    add_columns(columns, "q", set.model.sizes.unknowns);
    for (const char* column :
         {"index", "nullity", "multiplicity", "stable", "energy", "residual", "condition", "margin", "path"})
        columns.emplace_back(column);
    CsvTable table(columns);
    for (const auto& e : set.equilibria)
        table.add(CsvRow()
                      .add_all(e.q)
                      .add(e.index)
                      .add(e.nullity)
                      .add(e.multiplicity)
                      .add(e.stable())
                      .add(e.energy)
                      .add(e.residual)
                      .add(e.condition)
                      .add(e.margin)
                      .add(e.path));
    return table;
}

/// A line a root, real or not: q1_re, q1_im, q2_re, .., residual, condition, path, paths, winding_number, status.
template <class M>
CsvTable roots_csv(const RootSet<M>& set) {
    std::vector<std::string> columns;
    for (int i = 1; i <= set.model.sizes.unknowns; ++i)
        for (const char* part : {"_re", "_im"}) columns.push_back("q" + std::to_string(i) + part);
    for (const char* column : {"residual", "condition", "path", "paths", "winding_number", "status"})
        columns.emplace_back(column);
    CsvTable table(columns);
    for (const auto& root : set.roots) {
        CsvRow row;
        for (const auto& z : root.q) row.add(z.real()).add(z.imag());
        table.add(row.add(root.residual)
                      .add(root.condition)
                      .add(root.path)
                      .add(root.paths)
                      .add(root.winding_number)
                      .add(to_string(root.status)));
    }
    return table;
}

}  // namespace equilibria
