// A structure in rotation vectors from fixed reference frames: the chart of Cardona and Huespe's equations, for tests
// of what must not depend on it.
#pragma once

#include <algorithm>
#include <equilibria/fem/structure.hpp>
#include <equilibria/rotation/tangent_map.hpp>
#include <utility>
#include <vector>

namespace states {

using namespace equilibria;
using namespace equilibria::fem;

/// g(x, Psi, lambda) with frames R = Rref exp(Psi): g_Psi = T^T g_Theta, K_Psi = T^T K_Theta T + D(T^T m).
template <class S>
class ChartedStructure {
public:
    ChartedStructure(const S& structure, std::vector<Eigen::Quaterniond> reference)
        : structure_(structure), reference_(std::move(reference)) {}
    /// The reference is a configuration's frames: there Psi = 0.
    ChartedStructure(const S& structure, const StructureState& reference) : structure_(structure) {
        for (const auto& frame : reference.frames) reference_.push_back(frame.q);
    }

    /// The flat coordinates of a configuration.
    Eigen::VectorXd coordinates(const StructureState& state) const {
        Eigen::VectorXd y = Eigen::VectorXd::Zero(structure_.size());
        for (int node = 0; node < structure_.model().nodes(); ++node) {
            const auto& frame = state.frames[static_cast<std::size_t>(node)];
            set(y, node, ux, frame.x - structure_.model().at(node));
            set(y, node, rx, shortest_rotation_vector(Eigen::Quaterniond(reference(node).conjugate() * frame.q)));
        }
        y.tail(structure_.multipliers()) = state.multipliers;
        return y;
    }
    StructureState state(const Eigen::VectorXd& q) const {
        StructureState y = structure_.initial();
        for (int node = 0; node < structure_.model().nodes(); ++node) {
            auto& frame = y.frames[static_cast<std::size_t>(node)];
            frame.x += get(q, node, ux);
            if (turns(node)) frame.q = reference(node) * quaternion<double>(get(q, node, rx));
        }
        y.multipliers = q.tail(structure_.multipliers());
        return y;
    }
    /// Spins of a tangent vector at q: T applied, node by node.
    Eigen::VectorXd spin(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const {
        return mapped(q, v, [](const Eigen::Vector3d& psi) { return tangent_map(psi).value(); });
    }

    Eigen::VectorXd residual(const Eigen::VectorXd& q, double p) const {
        return transposed(q, structure_.residual(state(q), p));
    }
    Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& q, double p) const {
        const StructureState at = state(q);
        const Eigen::VectorXd g = structure_.residual(at, p);
        Eigen::SparseMatrix<double> y = structure_.tangent(at, p);
        Eigen::MatrixXd k = y, t = Eigen::MatrixXd::Identity(k.rows(), k.cols()),
                        chart = Eigen::MatrixXd::Zero(k.rows(), k.cols());
        for (int node = 0; node < structure_.model().nodes(); ++node) {
            if (structure_.model().rotates_with(node) != node) continue;
            const Eigen::Vector3d psi = get(q, node, rx), m = get(g, node, rx);
            const auto map = tangent_map(psi);
            const Eigen::Matrix3d value = map.value(), own = map.transposed().gradient(m), s = skew(m);
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c) {
                    const int i = structure_.unknown(node, Component(rx + r)),
                              j = structure_.unknown(node, Component(rx + c));
                    if (i < 0 || j < 0) continue;
                    t(i, j) = value(r, c);
                    chart(i, j) = own(r, c);
                    // K of increments at 0 has D(T^T m) at 0, -m~ / 2
                    k(i, j) += 0.5 * s(r, c);
                }
        }
        chart += t.transpose() * k * t;
        // in the same pattern: T is within nodes
        for (int column = 0; column < y.cols(); ++column)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(y, column); entry; ++entry)
                entry.valueRef() = chart(entry.row(), column);
        return y;
    }
    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& q, double p) const {
        return transposed(q, structure_.parameter_derivative(state(q), p));
    }
    int multipliers() const { return structure_.multipliers(); }

private:
    const Eigen::Quaterniond& reference(int node) const { return reference_[static_cast<std::size_t>(node)]; }
    bool turns(int node) const {
        return structure_.unknown(node, rx) >= 0 || structure_.unknown(node, ry) >= 0 ||
               structure_.unknown(node, rz) >= 0;
    }
    /// Three components of a node, 0 where there is none.
    Eigen::Vector3d get(const Eigen::VectorXd& v, int node, Component first) const {
        Eigen::Vector3d y = Eigen::Vector3d::Zero();
        for (int c = 0; c < 3; ++c)
            if (const int i = structure_.unknown(node, Component(first + c)); i >= 0) y(c) = v(i);
        return y;
    }
    void set(Eigen::VectorXd& v, int node, Component first, const Eigen::Vector3d& value) const {
        for (int c = 0; c < 3; ++c)
            if (const int i = structure_.unknown(node, Component(first + c)); i >= 0) v(i) = value(c);
    }
    Eigen::VectorXd mapped(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const auto& map) const {
        Eigen::VectorXd y = v;
        for (int node = 0; node < structure_.model().nodes(); ++node)
            set(y, node, rx, map(get(q, node, rx)) * get(v, node, rx));
        return y;
    }
    Eigen::VectorXd transposed(const Eigen::VectorXd& q, const Eigen::VectorXd& g) const {
        return mapped(q, g, [](const Eigen::Vector3d& psi) { return tangent_map(psi).transposed().value(); });
    }

    const S& structure_;
    std::vector<Eigen::Quaterniond> reference_;
};

/// How far K v and dg/dp are from differences of the residual, and K from symmetric, relative to the sizes of K and v,
/// dg/dp and K.
struct DerivativeErrors {
    double tangent, symmetry, parameter;
};
template <class S>
DerivativeErrors derivative_errors(const S& structure, const StructureState& q, double p, const Eigen::VectorXd& v,
                                   double h) {
    // K is the derivative in the chart whose reference is the present configuration
    const ChartedStructure<S> chart(structure, q);
    const Eigen::VectorXd at = chart.coordinates(q);
    const auto slope = [&](const auto& f) -> Eigen::VectorXd {
        return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + f(3 * h) - f(-3 * h)) / (60 * h);
    };
    const Eigen::VectorXd along = slope([&](double by) -> Eigen::VectorXd { return chart.residual(at + by * v, p); }),
                          by_p = slope([&](double by) { return structure.residual(q, p + by); }),
                          g_p = structure.parameter_derivative(q, p);
    const Eigen::SparseMatrix<double> k = structure.tangent(q, p), transposed = k.transpose();
    return {(k * v - along).norm() / k.norm() / v.norm(), (k - transposed).norm() / k.norm(),
            (g_p - by_p).norm() / std::max(1.0, g_p.norm())};
}

}  // namespace states
