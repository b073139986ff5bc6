// Random vectors, and frames of nodes, for tests.
#pragma once

#include <equilibria/fem/frame.hpp>
#include <equilibria/rotation/tangent_map.hpp>
#include <random>
#include <vector>

namespace states {

using namespace equilibria;
using namespace equilibria::fem;

inline Eigen::Vector3d random_vector(std::mt19937& draw, double size = 1) {
    std::normal_distribution<double> normal;
    return size * Eigen::Vector3d(normal(draw), normal(draw), normal(draw));
}
inline Eigen::VectorXd random_vector(std::mt19937& draw, int entries, double size) {
    std::normal_distribution<double> normal;
    Eigen::VectorXd y(entries);
    for (double& entry : y) entry = size * normal(draw);
    return y;
}
/// A rotation vector of at most 3 radians.
inline Eigen::Vector3d random_rotation(std::mt19937& draw, double most = 3) {
    std::uniform_real_distribution<double> angle(0, most);
    return random_vector(draw).normalized() * angle(draw);
}

/// Nodes about `size` off their places, turned by a common rotation of up to 3 radians and by up to `apart` each: in
/// the x-y plane, or in space.
inline std::vector<Frame<double>> random_frames(std::mt19937& draw, const std::vector<Eigen::Vector3d>& x, bool planar,
                                                double size, double apart) {
    const auto rotation = [&](double most) {
        Eigen::Vector3d psi = random_rotation(draw, most);
        if (planar) psi(0) = psi(1) = 0;
        return quaternion<double>(psi);
    };
    std::vector<Frame<double>> y;
    const auto common = rotation(3);
    for (const Eigen::Vector3d& place : x) {
        Eigen::Vector3d shift = random_vector(draw, size);
        if (planar) shift(2) = 0;
        y.push_back({common * Eigen::Vector3d(place + shift), (common * rotation(apart)).normalized()});
    }
    return y;
}

}  // namespace states
