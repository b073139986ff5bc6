/// \file
/// See fem/symmetry.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>

#include <equilibria/core/compiled.hpp>
#include <equilibria/fem/symmetry.hpp>

namespace equilibria::fem {

namespace detail {

/// Finds the place at a point, by its coordinate along a generic direction.
class PlaceFinder {
public:
    explicit PlaceFinder(const std::vector<Eigen::Vector3d>& places) : places_(&places) {
        double size = 0;
        for (std::size_t k = 0; k < places.size(); ++k) {
            along_.emplace_back(direction().dot(places[k]), static_cast<int>(k));
            size = std::max(size, (places[k] - places[0]).norm());
        }
        tolerance_ = 1e-8 * size;
        std::sort(along_.begin(), along_.end());
    }
    std::optional<int> operator()(const Eigen::Vector3d& x) const {
        const double at = direction().dot(x);
        for (auto k = std::lower_bound(along_.begin(), along_.end(), std::pair(at - tolerance_, -1));
             k != along_.end() && k->first <= at + tolerance_; ++k)
            if (((*places_)[static_cast<std::size_t>(k->second)] - x).norm() <= tolerance_) return k->second;
        return std::nullopt;
    }

private:
    static Eigen::Vector3d direction() { return {0.61, 0.37, 0.7007}; }

    const std::vector<Eigen::Vector3d>* places_;
    std::vector<std::pair<double, int>> along_;
    double tolerance_ = 0;
};

}  // namespace detail

EQUILIBRIA_INLINE std::vector<Symmetry> symmetries_of(const std::vector<Eigen::Vector3d>& places) {
    std::vector<Symmetry> y;
    if (places.empty()) return y;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& x : places) center += x / static_cast<double>(places.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& x : places) spread += (x - center) * (x - center).transpose();
    // of axes that could be any the fixed ones are taken
    const double size = spread.trace();
    const bool fixed = (spread - Eigen::Matrix3d(spread.diagonal().asDiagonal())).norm() <= 1e-9 * size;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(spread);
    const Eigen::Matrix3d axes = fixed ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : eigen.eigenvectors();
    const Eigen::Vector3d moments = fixed ? Eigen::Vector3d(spread.diagonal()) : eigen.eigenvalues();

    const detail::PlaceFinder find(places);
    const auto attempt = [&](const Eigen::Matrix3d& turn) {
        for (const Symmetry& other : y)
            if ((other.turn - turn).norm() < 1e-8) return;
        Symmetry s{.turn = turn, .center = center};
        for (const Eigen::Vector3d& x : places) {
            const auto node = find(center + turn * (x - center));
            if (!node) return;
            s.node.push_back(*node);
        }
        y.push_back(std::move(s));
    };
    const auto with_reflections = [&](const Eigen::Matrix3d& turn) {
        for (int signs = 0; signs < 8; ++signs) {
            const Eigen::Vector3d sign(signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1);
            const Eigen::Matrix3d all = turn * axes * sign.asDiagonal() * axes.transpose();
            if ((all - Eigen::Matrix3d::Identity()).norm() > 1e-8) attempt(all);
        }
    };
    with_reflections(Eigen::Matrix3d::Identity());
    for (int axis = 0; axis < 3; ++axis) {
        const double a = moments((axis + 1) % 3), b = moments((axis + 2) % 3);
        if (!(std::abs(a - b) <= 1e-8 * size) || !(a > 1e-8 * size)) continue;
        for (int parts = 3; parts <= 12; ++parts)
            for (int k = 1; k < parts; ++k)
                with_reflections(
                    Eigen::AngleAxisd(2 * std::numbers::pi * k / parts, axes.col(axis)).toRotationMatrix());
    }
    return y;
}

}  // namespace equilibria::fem
