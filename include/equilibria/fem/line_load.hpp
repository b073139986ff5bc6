/// \file
/// Loads along lines of elements: dead ones per length, as forces on the nodes that do the same work, and pressure.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/error.hpp>
#include <equilibria/core/streamed_text.hpp>
#include <equilibria/fem/interpolation.hpp>
#include <equilibria/fem/loads.hpp>
#include <equilibria/fem/structure_model.hpp>

namespace equilibria::fem {

namespace detail {

/// Calls add(nodes of an element, Nodes of them) for each element of a line.
template <int Nodes>
void for_each_element(std::span<const int> line, const auto& add) {
    require(line.size() >= Nodes && (line.size() - 1) % (Nodes - 1) == 0, "line", line.size(),
            "must have the nodes of whole elements of " + std::to_string(Nodes) + " nodes");
    for (std::size_t begin = 0; begin + 1 < line.size(); begin += Nodes - 1) {
        std::array<int, static_cast<std::size_t>(Nodes)> own{};
        for (std::size_t k = 0; k < own.size(); ++k) own[k] = line[begin + k];
        add(own);
    }
}

}  // namespace detail

/// Adds a dead load per length of the line without load, in fixed axes: the integrals of the shape functions times the
/// load, on each node. line: the nodes in order, of elements of `Nodes` nodes each, as add_beam gives them; two for a
/// bar. Throws InvalidArgument for a load that is not finite.
template <int Nodes>
void add_line_load(Model& model, std::span<const int> line, const Eigen::Vector3d& load,
                   LoadKind kind = LoadKind::proportional) {
    require(load.allFinite(), "load", streamed(load.transpose()), "must be finite");
    detail::for_each_element<Nodes>(line, [&](const auto& own) {
        const auto& rule = gauss_rule<3>();
        std::array<double, static_cast<std::size_t>(Nodes)> share{};
        for (std::size_t g = 0; g < rule.point.size(); ++g) {
            const ShapeFunctions<Nodes> n(rule.point[g]);
            Eigen::Vector3d speed = Eigen::Vector3d::Zero();
            for (std::size_t k = 0; k < own.size(); ++k) speed += n.slope[k] * model.at(own[k]);
            for (std::size_t k = 0; k < own.size(); ++k) share[k] += rule.weight[g] * speed.norm() * n.value[k];
        }
        for (std::size_t k = 0; k < own.size(); ++k) model.load(own[k], share[k] * load, Eigen::Vector3d::Zero(), kind);
    });
}

/// Adds a pressure on a line in the x-y plane, per length of the deformed line, from the right hand side of its
/// direction. See PlanarPressure: the line is closed, or its ends are fixed. line: as of add_line_load.
template <int Nodes>
void add_line_pressure(Model& model, std::span<const int> line, double pressure,
                       LoadKind kind = LoadKind::proportional) {
    detail::for_each_element<Nodes>(line,
                                    [&](const auto& own) { model.add(PlanarPressure<Nodes>{pressure}, own, kind); });
}

}  // namespace equilibria::fem
