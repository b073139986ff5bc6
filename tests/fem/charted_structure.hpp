// A structure in rotation vectors from fixed reference frames: the chart of Cardona and Huespe's equations, for tests of
// what must not depend on it.
#pragma once

#include <equilibria/fem/structure.hpp>
#include <vector>

namespace states {

using namespace equilibria;
using namespace equilibria::fem;

/// g(x, Psi, lambda) with frames R = Rref exp(Psi): g_Psi = T^T g_Theta, K_Psi = T^T K_Theta T + D(T^T m).
class ChartedStructure {
public:
    ChartedStructure(const Structure& structure, std::vector<Eigen::Quaterniond> reference)
        : structure_(structure), reference_(std::move(reference)) {}

    /// The flat coordinates of a configuration.
    Eigen::VectorXd coordinates(const StructureState& state) const {
        Eigen::VectorXd y = Eigen::VectorXd::Zero(structure_.size());
        for_nodes([&](int node, Component first, bool rotation) {
            const auto& frame = state.frames[static_cast<std::size_t>(node)];
            const Eigen::Vector3d value =
                rotation ? shortest_rotation_vector(Eigen::Quaterniond(
                               reference_[static_cast<std::size_t>(node)].conjugate() * frame.q))
                         : Eigen::Vector3d(frame.x - structure_.model().at(node));
            set(y, node, first, value);
        });
        y.tail(structure_.multipliers()) = state.multipliers;
        return y;
    }
    StructureState state(const Eigen::VectorXd& q) const {
        StructureState y = structure_.initial();
        for_nodes([&](int node, Component first, bool rotation) {
            auto& frame = y.frames[static_cast<std::size_t>(node)];
            if (rotation)
                frame.q = reference_[static_cast<std::size_t>(node)] * quaternion<double>(get(q, node, first));
            else
                frame.x += get(q, node, first);
        });
        y.multipliers = q.tail(structure_.multipliers());
        return y;
    }
    /// Spins of a tangent vector at q: T applied, node by node; and back.
    Eigen::VectorXd spin(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const {
        return mapped(q, v, [](const Eigen::Vector3d& psi) { return tangent_map(psi).value(); });
    }
    Eigen::VectorXd from_spin(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const {
        return mapped(q, v, [](const Eigen::Vector3d& psi) { return inverse_tangent_map(psi).value(); });
    }

    Eigen::VectorXd residual(const Eigen::VectorXd& q, double p) const {
        return transposed(q, structure_.residual(state(q), p));
    }
    Eigen::MatrixXd tangent(const Eigen::VectorXd& q, double p) const {
        const StructureState at = state(q);
        const Eigen::VectorXd g = structure_.residual(at, p);
        Eigen::MatrixXd k = structure_.tangent(at, p), t = Eigen::MatrixXd::Identity(k.rows(), k.cols()),
                        chart = Eigen::MatrixXd::Zero(k.rows(), k.cols());
        for_nodes([&](int node, Component first, bool rotation) {
            if (!rotation) return;
            const Eigen::Vector3d psi = get(q, node, first), m = get(g, node, first);
            const auto map = tangent_map(psi);
            const Eigen::Matrix3d value = map.value(), own = map.transposed().gradient(m), s = skew(m);
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c) {
                    const int i = structure_.unknown(node, Component(first + r)),
                              j = structure_.unknown(node, Component(first + c));
                    t(i, j) = value(r, c);
                    chart(i, j) = own(r, c);
                    // K of increments at 0 has D(T^T m) at 0, -m~ / 2
                    k(i, j) += 0.5 * s(r, c);
                }
        });
        return t.transpose() * k * t + chart;
    }
    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& q, double p) const {
        return transposed(q, structure_.parameter_derivative(state(q), p));
    }
    int multipliers() const { return structure_.multipliers(); }

private:
    /// Calls f(node, first component, whether of its rotation) for nodes whose three components are all free.
    void for_nodes(const auto& f) const {
        for (int node = 0; node < structure_.model().nodes(); ++node) {
            if (structure_.unknown(node, ux) >= 0) f(node, ux, false);
            if (structure_.unknown(node, rx) >= 0) f(node, rx, true);
        }
    }
    Eigen::Vector3d get(const Eigen::VectorXd& v, int node, Component first) const {
        return v.segment<3>(structure_.unknown(node, first));
    }
    void set(Eigen::VectorXd& v, int node, Component first, const Eigen::Vector3d& value) const {
        v.segment<3>(structure_.unknown(node, first)) = value;
    }
    Eigen::VectorXd mapped(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const auto& map) const {
        Eigen::VectorXd y = v;
        for_nodes([&](int node, Component first, bool rotation) {
            if (rotation) set(y, node, first, map(get(q, node, first)) * get(v, node, first));
        });
        return y;
    }
    Eigen::VectorXd transposed(const Eigen::VectorXd& q, const Eigen::VectorXd& g) const {
        return mapped(q, g, [](const Eigen::Vector3d& psi) { return tangent_map(psi).transposed().value(); });
    }

    const Structure& structure_;
    std::vector<Eigen::Quaterniond> reference_;
};

}  // namespace states
