// Structures as continuation problems: an arch of two modes, trusses, chains of links with torsion springs. Their
// critical points are known; the tests of continuation/ use them too.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace support {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Shallow arch of two modes: V = (A1 - l)^2/2 + 8 A2^2 + (A1^2 + 4 A2^2 - l^2)^2/4 + q A1. Folds at
/// q = l +- 2 (l^2 - 1)^1.5 / (3 sqrt 3), bifurcations at l +- 3 sqrt(l^2 - 4), side branch q = l + 3 A1.
struct ShallowArch {
    double l;
    double stretch(const VectorXd& a) const { return a(0) * a(0) + 4 * a(1) * a(1) - l * l; }
    VectorXd residual(const VectorXd& a, double q) const {
        return Eigen::Vector2d(a(0) - l + stretch(a) * a(0) + q, 16 * a(1) + 4 * stretch(a) * a(1));
    }
    MatrixXd tangent(const VectorXd& a, double) const {
        Eigen::Matrix2d k;
        k << 1 + stretch(a) + 2 * a(0) * a(0), 8 * a(0) * a(1), 8 * a(0) * a(1), 16 + 4 * stretch(a) + 32 * a(1) * a(1);
        return k;
    }
    VectorXd parameter_derivative(const VectorXd&, double) const { return Eigen::Vector2d(1, 0); }

    double fold() const { return l + 2 * std::pow(l * l - 1, 1.5) / (3 * std::sqrt(3.0)); }
    double bifurcation() const { return l + 3 * std::sqrt(l * l - 4); }
};

enum class Strain { green, engineering };

/// Bars with EA = 1 between nodes, of which some coordinates are free; dead loads p times `load`.
class Truss {
public:
    Truss(std::vector<Eigen::Vector3d> nodes, std::vector<std::array<std::size_t, 2>> bars, std::size_t first_free,
          std::size_t free_nodes, int coordinates, Strain strain)
        : nodes_(std::move(nodes)), bars_(std::move(bars)), unknown_(3 * nodes_.size(), -1), strain_(strain) {
        for (std::size_t k = first_free; k < first_free + free_nodes; ++k)
            for (int c = 0; c < coordinates; ++c) unknown_[3 * k + static_cast<std::size_t>(c)] = size_++;
        load = VectorXd::Zero(size_);
    }

    VectorXd load;

    VectorXd residual(const VectorXd& q, double p) const {
        VectorXd g = -p * load;
        for (const auto& [a, b] : bars_) {
            const Eigen::Vector3d d = at(q, b) - at(q, a), force = tension(a, b, d).first * d;
            for (int c = 0; c < 3; ++c) {
                if (unknown(a, c) >= 0) g(unknown(a, c)) -= force(c);
                if (unknown(b, c) >= 0) g(unknown(b, c)) += force(c);
            }
        }
        return g;
    }
    MatrixXd tangent(const VectorXd& q, double) const {
        MatrixXd k = MatrixXd::Zero(size_, size_);
        for (const auto& [a, b] : bars_) {
            const Eigen::Vector3d d = at(q, b) - at(q, a);
            const auto [tension_over_length, slope] = tension(a, b, d);
            const Eigen::Matrix3d m = tension_over_length * Eigen::Matrix3d::Identity() + slope * d * d.transpose();
            const std::size_t ends[] = {a, b};
            for (int s = 0; s < 2; ++s)
                for (int t = 0; t < 2; ++t)
                    for (int r = 0; r < 3; ++r)
                        for (int c = 0; c < 3; ++c) {
                            const int i = unknown(ends[s], r), j = unknown(ends[t], c);
                            if (i >= 0 && j >= 0) k(i, j) += (s == t ? 1 : -1) * m(r, c);
                        }
        }
        return k;
    }
    VectorXd parameter_derivative(const VectorXd&, double) const { return -load; }
    VectorXd unloaded() const { return VectorXd::Zero(size_); }
    /// Where a node is.
    Eigen::Vector3d at(const VectorXd& q, std::size_t node) const {
        Eigen::Vector3d x = nodes_[node];
        for (int c = 0; c < 3; ++c)
            if (unknown(node, c) >= 0) x(c) += q(unknown(node, c));
        return x;
    }

private:
    int unknown(std::size_t node, int c) const { return unknown_[3 * node + static_cast<std::size_t>(c)]; }
    /// The force of a bar over its length, which times d is the force vector, and its derivative by |d|^2 / 2.
    std::pair<double, double> tension(std::size_t a, std::size_t b, const Eigen::Vector3d& d) const {
        const double l = (nodes_[b] - nodes_[a]).norm();
        if (strain_ == Strain::green) return {(d.squaredNorm() - l * l) / (2 * l * l * l), 1 / (l * l * l)};
        const double now = d.norm();
        return {1 / l - 1 / now, 1 / (now * now * now)};
    }

    std::vector<Eigen::Vector3d> nodes_;
    std::vector<std::array<std::size_t, 2>> bars_;
    std::vector<int> unknown_;
    Strain strain_;
    int size_ = 0;
};

/// Two bars from (-1, 0) and (1, 0) to the apex (0, h), load down at the apex.
inline Truss von_mises_truss(double h, Strain strain = Strain::green) {
    Truss truss({{-1, 0, 0}, {0, h, 0}, {1, 0, 0}}, {{0, 1}, {1, 2}}, 1, 1, 2, strain);
    truss.load(1) = -1;
    return truss;
}

/// The 24-bar star dome: apex, ring of six, six supports turned by 30 degrees.
inline Truss star_dome(double apex_load, double ring_load, Strain strain = Strain::green) {
    std::vector<Eigen::Vector3d> nodes{{0, 0, 8.216}};
    std::vector<std::array<std::size_t, 2>> bars;
    const auto ring = [&](double radius, double z, double turn) {
        for (int k = 0; k < 6; ++k) {
            const double angle = k * std::numbers::pi / 3 + turn;
            nodes.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
        }
    };
    ring(25, 6.216, 0);
    ring(50, 0, std::numbers::pi / 6);
    for (std::size_t k = 0; k < 6; ++k) {
        bars.push_back({0, 1 + k});
        bars.push_back({1 + k, 1 + (k + 1) % 6});
        bars.push_back({1 + k, 7 + k});
        bars.push_back({1 + k, 7 + (k + 5) % 6});
    }
    Truss dome(nodes, bars, 0, 7, 3, strain);
    dome.load(2) = -apex_load;
    for (int k = 1; k < 7; ++k) dome.load(3 * k + 2) = -ring_load;
    return dome;
}

/// A planar chain of rigid links of length 1 with torsion springs c = 1 at the clamped base and at each joint, axial
/// load P at the tip: V = sum (theta_i - theta_(i-1))^2 / 2 + P sum cos theta_i. Straight up to P = 2 (1 -
/// cos(pi/(2N+1))).
struct SpringElastica {
    int links;
    VectorXd residual(const VectorXd& theta, double load) const {
        VectorXd g = -load * theta.array().sin();
        for (int i = 0; i < links; ++i) {
            const double bend = theta(i) - (i > 0 ? theta(i - 1) : 0);
            g(i) += bend;
            if (i > 0) g(i - 1) -= bend;
        }
        return g;
    }
    Eigen::SparseMatrix<double> tangent(const VectorXd& theta, double load) const {
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < links; ++i) {
            entries.emplace_back(i, i, 1 + (i + 1 < links) - load * std::cos(theta(i)));
            if (i > 0) {
                entries.emplace_back(i, i - 1, -1);
                entries.emplace_back(i - 1, i, -1);
            }
        }
        Eigen::SparseMatrix<double> k(links, links);
        k.setFromTriplets(entries.begin(), entries.end());
        return k;
    }
    VectorXd parameter_derivative(const VectorXd& theta, double) const { return -theta.array().sin(); }
    /// Lengths are root mean squares of angles.
    VectorXd weights(const VectorXd&) const { return VectorXd::Constant(links, 1.0 / links); }

    double buckling_load() const {
        const double half = std::sin(std::numbers::pi / (4.0 * links + 2));
        return 4 * half * half;
    }
};

/// The same with a dense tangent.
struct DenseSpringElastica : SpringElastica {
    MatrixXd tangent(const VectorXd& theta, double load) const { return SpringElastica::tangent(theta, load); }
};

}  // namespace support
