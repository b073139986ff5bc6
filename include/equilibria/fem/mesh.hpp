/// \file
/// Lines and arcs of beam elements: Beam, or MixedBeam where some stiffnesses are far above others.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <type_traits>
#include <vector>

#include <equilibria/fem/beam.hpp>
#include <equilibria/fem/structure_model.hpp>

namespace equilibria::fem {

/// Calls add(std::integral_constant<int, N>()), N the number of nodes of a beam element: 2, 3 or 4. Throws
/// InvalidArgument for others.
auto with_beam_nodes(int nodes, const auto& add) {
    require(nodes >= 2 && nodes <= 4, "nodes", nodes, "must be 2, 3 or 4");
    if (nodes == 2) return add(std::integral_constant<int, 2>());
    if (nodes == 3) return add(std::integral_constant<int, 3>());
    return add(std::integral_constant<int, 4>());
}

/// Whether some stiffnesses of a section are far above others over this length, so that MixedBeam is better.
bool unequal_stiffness(const auto& section, double length) {
    constexpr int f = std::remove_cvref_t<decltype(section)>::n_forces;
    const auto stiffness = section.stiffness();
    const auto bending = stiffness.tail(stiffness.size() - f);
    return std::max(stiffness.template head<f>().maxCoeff() * length * length, bending.maxCoeff()) / 100 >
           bending.minCoeff();
}

namespace detail {

template <class B, class Mixed>
std::vector<int> add_line(Model& model, const auto& section, const auto& frame, int elements, int first, int last) {
    require(elements >= 1, "elements", elements, "must be at least 1");
    constexpr int nodes_each = B::n_nodes;
    constexpr std::size_t count = static_cast<std::size_t>(nodes_each);
    const int steps = elements * (nodes_each - 1);
    std::vector<decltype(frame(0.0))> at;
    std::vector<int> nodes;
    for (int k = 0; k <= steps; ++k) {
        const int given = k == 0 ? first : k == steps ? last : -1;
        at.push_back(frame(double(k) / steps));
        nodes.push_back(given >= 0 ? given : model.add_node(at.back().x));
        at.back().x = model.at(nodes.back());
    }
    for (int begin = 0; begin < steps; begin += nodes_each - 1) {
        std::array<decltype(frame(0.0)), count> own_at;
        std::array<int, count> own{};
        std::copy_n(at.begin() + begin, count, own_at.begin());
        std::copy_n(nodes.begin() + begin, count, own.begin());
        if (unequal_stiffness(section, (own_at.back().x - own_at.front().x).norm()))
            model.add(Mixed(section, own_at), own);
        else
            model.add(B(section, own_at), own);
    }
    return nodes;
}

}  // namespace detail

/// A beam along a curve: frame(t) of t in [0, 1], by arc length, split into equal elements of `Nodes` nodes. first and
/// last: existing nodes at its ends, or -1 for new ones. All nodes, in order.
template <int Nodes>
std::vector<int> add_beam(Model& model, const Section& section, const std::function<SectionFrame(double)>& frame,
                          int elements, int first = -1, int last = -1) {
    return detail::add_line<Beam<Nodes>, MixedBeam<Nodes>>(model, section, frame, elements, first, last);
}

/// A straight beam between two nodes; second: towards which axis 2 of its cross-section points.
template <int Nodes>
std::vector<int> add_straight_beam(Model& model, const Section& section, int first, int last,
                                   const Eigen::Vector3d& second, int elements) {
    const Eigen::Vector3d a = model.at(first), d = model.at(last) - a;
    return add_beam<Nodes>(
        model, section, [&](double t) { return section_frame(a + t * d, d, second); }, elements, first, last);
}

/// A planar beam along a curve in the x-y plane; see add_beam. frame(t).angle is continuous.
template <int Nodes>
std::vector<int> add_planar_beam(Model& model, const PlanarSection& section,
                                 const std::function<PlanarSectionFrame(double)>& frame, int elements, int first = -1,
                                 int last = -1) {
    return detail::add_line<PlanarBeam<Nodes>, PlanarMixedBeam<Nodes>>(model, section, frame, elements, first, last);
}

/// A straight planar beam between two nodes.
template <int Nodes>
std::vector<int> add_straight_planar_beam(Model& model, const PlanarSection& section, int first, int last,
                                          int elements) {
    const Eigen::Vector3d a = model.at(first), d = model.at(last) - a;
    const auto frame = [&](double t) { return PlanarSectionFrame{a + t * d, std::atan2(d(1), d(0))}; };
    return add_planar_beam<Nodes>(model, section, frame, elements, first, last);
}

#ifdef EQUILIBRIA_COMPILED
/// \cond
extern template std::vector<int> add_beam<2>(Model&, const Section&, const std::function<SectionFrame(double)>&, int,
                                             int, int);
extern template std::vector<int> add_beam<3>(Model&, const Section&, const std::function<SectionFrame(double)>&, int,
                                             int, int);
extern template std::vector<int> add_beam<4>(Model&, const Section&, const std::function<SectionFrame(double)>&, int,
                                             int, int);
extern template std::vector<int> add_planar_beam<2>(Model&, const PlanarSection&,
                                                    const std::function<PlanarSectionFrame(double)>&, int, int, int);
extern template std::vector<int> add_planar_beam<3>(Model&, const PlanarSection&,
                                                    const std::function<PlanarSectionFrame(double)>&, int, int, int);
extern template std::vector<int> add_planar_beam<4>(Model&, const PlanarSection&,
                                                    const std::function<PlanarSectionFrame(double)>&, int, int, int);
/// \endcond
#endif

}  // namespace equilibria::fem
