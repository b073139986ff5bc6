/// \file
/// Turns and reflections of space that map a structure onto itself, with its supports and its loads: what happens on
/// one side happens on the other one too, and is followed once (`images` of continuation/problem.hpp).
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

namespace equilibria::fem {

/// x goes to center + turn (x - center), and the rotation R of a node to turn R turn^T.
struct Symmetry {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< orthogonal; of determinant -1: a reflection
    Eigen::Vector3d center = Eigen::Vector3d::Zero();    ///< a point that stays where it is
    std::vector<int> node{};                             ///< node k goes to where node[k] is without load
    Eigen::SparseMatrix<double> multipliers{};           ///< what those of the structure become

    /// What `turn` makes of rotation vectors.
    Eigen::Matrix3d axial() const { return turn.determinant() < 0 ? Eigen::Matrix3d(-turn) : turn; }
};

/// What maps these places onto themselves, but for the identity: reflections in the principal axes of the places, taken
/// for unit masses, halves of a turn about them and, where two principal moments are equal, n-th parts, n up to 12.
/// Places are the same that are closer than 1e-8 of the largest distance; of nodes at one place any is taken.
std::vector<Symmetry> symmetries_of(const std::vector<Eigen::Vector3d>& places);

}  // namespace equilibria::fem

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/fem/detail/symmetry_definitions.hpp>
#endif
