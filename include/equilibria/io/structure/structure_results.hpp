/// \file
/// A state of a structure as an engineer reads it: displacements, reactions, section forces; as JSON, CSV and VTK.
#pragma once

#include <algorithm>
#include <cstddef>
#include <locale>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/fem/structure.hpp>
#include <equilibria/io/results/csv.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/io/structure/structure_input.hpp>
#include <equilibria/io/structure/structure_output.hpp>

namespace equilibria::fem {

namespace detail {

inline Json json_vector(const Eigen::Vector3d& v) { return {json_of(v(0)), json_of(v(1)), json_of(v(2))}; }

/// The nodes with a fixed component, and what supports exert there.
template <bool Conservative>
std::vector<std::pair<int, NodalForce>> reactions(const BasicStructure<Conservative>& structure,
                                                  const StructureState& q, double p) {
    const auto all = structure.support_forces(q, p);
    const auto held = structure.model().held();
    std::vector<std::pair<int, NodalForce>> y;
    for (int k = 0; k < structure.model().nodes(); ++k) {
        NodalForce own = all[static_cast<std::size_t>(k)];
        const auto& fixed = held[static_cast<std::size_t>(k)];
        if (std::ranges::none_of(fixed, [](bool f) { return f; })) continue;
        // where nothing is held the sum is rounding
        for (int c = 0; c < 3; ++c)
            if (!fixed[static_cast<std::size_t>(c)]) own.force(c) = 0;
        if (!fixed[rx] && !fixed[ry] && !fixed[rz]) own.moment.setZero();
        y.emplace_back(k, own);
    }
    return y;
}

}  // namespace detail

/// "nodes": by name "displacement" and "rotation" (the shortest rotation vector, radians); "reactions": by name "force"
/// and "moment" by the supports on the structure, in fixed axes; "elements": for each place at which an element carries
/// something its "element" (name, or place in the text), "place", and the forces by their names: of a beam at its Gauss
/// points N, Q2, Q3, M1, M2, M3 or N, Q, M in the axes of its section, of a bar N (tension positive), of a spring
/// moments, of prescribed motions and joints what they exert. Nodes within beams have no name and are left out.
template <bool Conservative>
Json structure_results(const BasicStructure<Conservative>& structure, const StructureInput& input,
                       const StructureState& q, double p) {
    Json nodes = Json::object(), reactions = Json::object(), elements = Json::array();
    for (const auto& [name, k] : input.nodes) {
        const auto& frame = q.frames[static_cast<std::size_t>(k)];
        nodes[name] = {{"displacement", detail::json_vector(frame.x - structure.model().at(k))},
                       {"rotation", detail::json_vector(shortest_rotation_vector(frame.q))}};
    }
    for (const auto& [node, own] : detail::reactions(structure, q, p))
        for (const auto& [name, k] : input.nodes)
            if (k == node)
                reactions[name] = {{"force", detail::json_vector(own.force)},
                                   {"moment", detail::json_vector(own.moment)}};
    const auto& groups = structure.model().groups();
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const auto names = groups[g]->force_names();
        structure.for_each_force(*groups[g], q, p, [&](std::size_t e, const std::vector<InternalForce>& forces) {
            for (const InternalForce& at : forces) {
                Json row{{"element", input.elements.of(g, e)}, {"place", detail::json_vector(at.place)}};
                for (std::size_t k = 0; k < names.size(); ++k) row[names[k]] = json_of(at.values[k]);
                elements.push_back(std::move(row));
            }
        });
    }
    return {{"nodes", std::move(nodes)}, {"reactions", std::move(reactions)}, {"elements", std::move(elements)}};
}

/// Rows of states that structure_results made, a number each: "state" (its number), "of" (nodes, reactions, elements),
/// "name", "x", "y", "z" (the place of an element's point), "quantity", "value".
inline CsvTable structure_results_csv(const std::vector<Json>& states) {
    CsvTable table({"state", "of", "name", "x", "y", "z", "quantity", "value"});
    const auto add = [&](std::size_t state, const char* of, const std::string& name, const Json& place,
                         const std::string& quantity, const Json& value) {
        CsvRow row;
        row.add(state).add(std::string(of)).add(name);
        for (std::size_t c = 0; c < 3; ++c)
            if (place.is_array() && place[c].is_number())
                row.add(place[c].template get<double>());
            else
                row.add(std::string());
        row.add(quantity);
        if (value.is_number())
            row.add(value.template get<double>());
        else
            row.add(std::string());
        table.add(std::move(row));
    };
    constexpr const char* axes[] = {"x", "y", "z"};
    for (std::size_t s = 0; s < states.size(); ++s) {
        for (const char* of : {"nodes", "reactions"})
            for (const auto& [name, quantities] : states[s].at(of).items())
                for (const auto& [quantity, vector] : quantities.items())
                    for (std::size_t c = 0; c < 3; ++c) add(s, of, name, nullptr, quantity + " " + axes[c], vector[c]);
        for (const Json& row : states[s].at("elements"))
            for (const auto& [quantity, value] : row.items())
                if (quantity != "element" && quantity != "place")
                    add(s, "elements", row.at("element").get<std::string>(), row.at("place"), quantity, value);
    }
    return table;
}

/// As vtk, with a structure's reactions of each node (zero where nothing is fixed), and of each line the mean of the
/// forces and moments that it carries, by their names, zero where it has none of that name.
template <bool Conservative>
std::string vtk(const BasicStructure<Conservative>& structure, const StructureState& state, double p, double parameter,
                std::string title) {
    const Model& model = structure.model();
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    std::vector<NodalForce> at(static_cast<std::size_t>(model.nodes()));
    for (const auto& [node, own] : detail::reactions(structure, state, p)) at[static_cast<std::size_t>(node)] = own;
    const auto vectors = [&](const char* name, auto member) {
        out << "VECTORS " << name << " double\n";
        for (const NodalForce& own : at)
            out << (own.*member)(0) << ' ' << (own.*member)(1) << ' ' << (own.*member)(2) << '\n';
    };
    vectors("reaction", &NodalForce::force);
    vectors("reaction_moment", &NodalForce::moment);
    std::map<std::string, std::vector<double>> means;
    std::size_t lines = 0;
    for (const auto& group : model.groups())
        if (group->n_nodes() >= 2) {
            const auto names = group->force_names();
            structure.for_each_force(*group, state, p, [&](std::size_t e, const std::vector<InternalForce>& forces) {
                for (const InternalForce& own : forces)
                    for (std::size_t k = 0; k < names.size(); ++k) {
                        auto& mean = means[names[k]];
                        mean.resize(std::max(mean.size(), lines + e + 1));
                        mean[lines + e] += own.values[k] / static_cast<double>(forces.size());
                    }
            });
            lines += group->size();
        }
    if (!means.empty()) out << "CELL_DATA " << lines << '\n';
    for (auto& [name, mean] : means) {
        mean.resize(lines);
        out << "SCALARS " << name << " double 1\nLOOKUP_TABLE default\n";
        for (const double value : mean) out << value << '\n';
    }
    return vtk(model, state, parameter, std::move(title)) + out.str();
}

}  // namespace equilibria::fem
