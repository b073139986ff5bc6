/// \file
/// Rigid bodies: points that move with a node. Their nodes share its rotation, Model::share_rotation, and each is held
/// at its place by three constraints (Cardona and Huespe 1999, (18)-(25)):
///
///     Phi = x_B - x_A - R_A X                                                          (19)
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <equilibria/fem/structure_model.hpp>

namespace equilibria::fem {

/// Holds node B at the place X of the body of node A, in space (Dimension 3) or in the plane (2). Node B may have a
/// rotation of its own: then it is a joint of the body. Its multipliers are minus the force on B.
template <int Dimension>
struct RigidLink {
    static constexpr int n_nodes = 2, n_constraints = Dimension;
    static constexpr auto components = motion_components<Dimension>();
    static constexpr bool depends_on_parameter = false;
    Eigen::Vector3d offset;  ///< X, from A to B without load

    template <class T>
    Eigen::Matrix<T, Dimension, 1> constraints(const std::array<Frame<T>, 2>& at, const T&) const {
        const Vector3<T> x = offset.cast<T>(), gap = at[1].x - at[0].x - at[0].q * x;
        return gap.template head<Dimension>();
    }
};

/// Makes one rigid body of nodes, in space or in the plane: the first one is its reference. Throws InvalidArgument for
/// fewer than 2 nodes.
template <int Dimension = 3>
void add_rigid_body(Model& model, const std::vector<int>& nodes) {
    require(nodes.size() >= 2, "nodes", nodes.size(), "must be at least 2 nodes");
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        model.share_rotation(nodes[k], nodes[0]);
        model.add(RigidLink<Dimension>{model.at(nodes[k]) - model.at(nodes[0])}, {nodes[0], nodes[k]});
    }
}

#ifdef EQUILIBRIA_COMPILED
extern template class ElementGroupOf<RigidLink<2>>;
extern template class ElementGroupOf<RigidLink<3>>;
#endif

}  // namespace equilibria::fem
