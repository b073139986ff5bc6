/// \file
/// Deformed structures as text: VTK (legacy format, which ParaView opens) and polylines.
#pragma once

#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <equilibria/fem/structure.hpp>

namespace equilibria::fem {

/// The nodes of each element with two nodes or more, in their order: what a structure looks like. Fixed ends of springs
/// and joints between nodes at one place are lines without length.
inline std::vector<std::vector<int>> element_lines(const Model& model) {
    std::vector<std::vector<int>> lines;
    for (const auto& group : model.groups()) {
        if (group->n_nodes() < 2) continue;
        for (std::size_t e = 0; e < group->size(); ++e)
            lines.emplace_back(group->nodes(e), group->nodes(e) + group->n_nodes());
    }
    return lines;
}

/// A VTK file of a configuration: points, lines, and of each node its displacement and rotation vector (radians, the
/// shortest). `parameter` is written as field data, title into the header (its first 255 characters, without line
/// ends).
inline std::string vtk(const Model& model, const StructureState& state, double parameter, std::string title) {
    for (char& c : title)
        if (c == '\n' || c == '\r') c = ' ';
    const auto lines = element_lines(model);
    std::size_t entries = 0;
    for (const auto& line : lines) entries += 1 + line.size();
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    const auto vector = [&](const Eigen::Vector3d& v) { out << v(0) << ' ' << v(1) << ' ' << v(2) << '\n'; };
    out << "# vtk DataFile Version 3.0\n"
        << title.substr(0, 255) << "\nASCII\nDATASET POLYDATA\n"
        << "FIELD FieldData 1\nparameter 1 1 double\n"
        << parameter << "\nPOINTS " << model.nodes() << " double\n";
    for (const auto& frame : state.frames) vector(frame.x);
    out << "LINES " << lines.size() << ' ' << entries << '\n';
    for (const auto& line : lines) {
        out << line.size();
        for (const int node : line) out << ' ' << node;
        out << '\n';
    }
    out << "POINT_DATA " << model.nodes() << "\nVECTORS displacement double\n";
    for (int k = 0; k < model.nodes(); ++k) vector(state.frames[static_cast<std::size_t>(k)].x - model.at(k));
    out << "VECTORS rotation double\n";
    for (const auto& frame : state.frames) vector(shortest_rotation_vector(frame.q));
    return out.str();
}

}  // namespace equilibria::fem
