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
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2, n_constraints = Dimension, n_multipliers = Dimension;
    static constexpr auto components = motion_components<Dimension>();
    static constexpr bool depends_on_parameter = false;
    /// \}
    Eigen::Vector3d offset;  ///< X, from A to B without load

    /// Phi of (19).
    template <class T>
    Eigen::Matrix<T, Dimension, 1> constraints(const std::array<Frame<T>, 2>& at, const T&) const {
        const Vector3<T> x = offset.cast<T>(), gap = at[1].x - at[0].x - at[0].q * x;
        return gap.template head<Dimension>();
    }

    /// The same as by the constraints, in closed form: with f = R_A^T t, t = k lambda + rho Phi, the rotation Psi of
    /// node A has the tangent f . X - (f X^T + X f^T) / 2 beside that of the derivatives of Phi.
    void evaluate(const std::array<Frame<double>, 2>& at, const double* multipliers, double p,
                  const ConstraintScale& scale, Need need, ElementValues& out) const {
        constexpr int each = static_cast<int>(components.size()), own = 2 * each, turns = each - Dimension;
        using Force = Eigen::Matrix<double, Dimension, 1>;
        const Eigen::Matrix3d r = at[0].q.toRotationMatrix();
        const Eigen::Matrix3d turn = r * skew(offset);  // of -R_A X, by Psi
        Eigen::Matrix<double, Dimension, own> by = Eigen::Matrix<double, Dimension, own>::Zero();
        by.template leftCols<Dimension>().diagonal().setConstant(-1);
        by.template middleCols<turns>(Dimension) = turn.template topRightCorner<Dimension, turns>();
        by.template middleCols<Dimension>(each).diagonal().setConstant(1);
        const Force phi = constraints<double>(at, p);
        const Force t = scale.multiplier * Eigen::Map<const Force>(multipliers) + scale.penalty * phi;
        if (need == Need::residual) {
            out.residual.template head<own>() = by.transpose() * t;
            out.residual.template tail<Dimension>() = scale.multiplier * phi;
        } else if (need == Need::tangent) {
            const Eigen::Vector3d f = r.template topRows<Dimension>().transpose() * t;
            const Eigen::Matrix3d dyad = f * offset.transpose();
            const Eigen::Matrix3d curvature =
                f.dot(offset) * Eigen::Matrix3d::Identity() - 0.5 * (dyad + dyad.transpose());
            out.tangent.template topLeftCorner<own, own>() = scale.penalty * by.transpose() * by;
            out.tangent.template block<turns, turns>(Dimension, Dimension) +=
                curvature.template bottomRightCorner<turns, turns>();
            out.tangent.template bottomLeftCorner<Dimension, own>() = scale.multiplier * by;
            out.tangent.template topRightCorner<own, Dimension>() = scale.multiplier * by.transpose();
            out.tangent.template bottomRightCorner<Dimension, Dimension>().setZero();
        } else {
            out.parameter_derivative.setZero();
        }
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
