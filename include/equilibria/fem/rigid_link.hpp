/// \file
/// Rigid bodies: points that move with a node. Their nodes share its rotation, Model::share_rotation, and each is held
/// at its place by three constraints (Cardona and Huespe 1999, (18)-(25)):
///
///     Phi = x_B - x_A - R_A X                                                          (19)
#pragma once

#include <array>

#include <equilibria/fem/model.hpp>

namespace equilibria::fem {

/// Holds node B at the place X of the body of node A, whose rotation it shares. Its multipliers are minus the force on B.
struct RigidLink {
    static constexpr int n_nodes = 2, n_constraints = 3;
    static constexpr auto components = spatial;
    Eigen::Vector3d offset;  ///< X, from A to B without load

    template <class T>
    Vector3<T> constraints(const std::array<Frame<T>, 2>& at, const T&) const {
        const Vector3<T> x = offset.cast<T>();
        return at[1].x - at[0].x - at[0].q * x;
    }
};

/// Makes one rigid body of nodes: the first one is its reference.
inline void add_rigid_body(Model& model, const std::vector<int>& nodes) {
    require(nodes.size() >= 2, "nodes", nodes.size(), "must be at least 2 nodes");
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        model.share_rotation(nodes[k], nodes[0]);
        model.add(RigidLink{model.at(nodes[k]) - model.at(nodes[0])}, {nodes[0], nodes[k]});
    }
}

}  // namespace equilibria::fem
