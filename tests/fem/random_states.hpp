// Random frames and derivatives for tests of elements.
#pragma once

#include <algorithm>
#include <equilibria/fem/element.hpp>
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
/// A rotation vector of at most 3 radians.
inline Eigen::Vector3d random_rotation(std::mt19937& draw, double most = 3) {
    std::uniform_real_distribution<double> angle(0, most);
    return random_vector(draw).normalized() * angle(draw);
}

/// Nodes about `size` off their places, turned by a common rotation of up to 3 radians and by up to `apart` each.
template <class E>
std::array<Frame<double>, static_cast<std::size_t>(E::n_nodes)> random_frames(
    std::mt19937& draw, const std::vector<Eigen::Vector3d>& x, double size, double apart) {
    std::array<Frame<double>, static_cast<std::size_t>(E::n_nodes)> y;
    const bool in_plane = std::find(E::components.begin(), E::components.end(), uz) == E::components.end() &&
                          std::find(E::components.begin(), E::components.end(), rx) == E::components.end();
    const auto flat = [&](Eigen::Vector3d v, bool rotation) {
        if (in_plane && rotation) v(0) = v(1) = 0;
        if (in_plane && !rotation) v(2) = 0;
        return v;
    };
    const auto common = quaternion<double>(flat(random_rotation(draw), true));
    for (std::size_t k = 0; k < y.size(); ++k) {
        y[k].x = common * Eigen::Vector3d(x[k] + flat(random_vector(draw, size), false));
        y[k].q = (common * quaternion<double>(flat(random_rotation(draw, apart), true))).normalized();
    }
    return y;
}

template <class E>
ElementValues values(const E& element, const fem::detail::Frames<E, double>& at, const std::vector<double>& multipliers,
                     double p, const ConstraintScale& scale) {
    constexpr int n = node_unknowns_of<E> + multipliers_of<E>;
    ElementValues y{Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)}, tangent = y,
                                                                                                      slope = y;
    fem::detail::evaluate(element, at, multipliers.data(), p, scale, Need::residual, y);
    fem::detail::evaluate(element, at, multipliers.data(), p, scale, Need::tangent, tangent);
    fem::detail::evaluate(element, at, multipliers.data(), p, scale, Need::parameter_derivative, slope);
    y.tangent = tangent.tangent;
    y.parameter_derivative = slope.parameter_derivative;
    return y;
}

/// The frames moved by h times the increment u, exactly.
template <class E>
fem::detail::Frames<E, double> moved(const fem::detail::Frames<E, double>& at, const Eigen::VectorXd& u, double h) {
    auto y = at;
    Eigen::Index next = 0;
    for (Frame<double>& frame : y) {
        Eigen::Vector3d dx = Eigen::Vector3d::Zero(), dpsi = dx;
        for (const Component c : E::components) (c < rx ? dx(c) : dpsi(c - rx)) = h * u(next++);
        frame = retract(frame, dx, dpsi);
    }
    return y;
}

/// How far K u and dg/dp are from differences of the residual, and K from symmetric, relative to the sizes of K u, dg/dp
/// and K. Increments move along with the frames: of the residual at the moved state T^T at the increment is taken off, the
/// definition of K in a chart.
struct Errors {
    double tangent = 0, symmetry = 0, parameter = 0;
};
template <class E>
Errors derivative_errors(const E& element, const fem::detail::Frames<E, double>& at, std::mt19937& draw, double p = 0.7,
                         const ConstraintScale& scale = {3, 5}) {
    constexpr int own = node_unknowns_of<E>, n = own + multipliers_of<E>;
    std::normal_distribution<double> normal;
    std::vector<double> multipliers(multipliers_of<E>);
    for (double& m : multipliers) m = normal(draw);
    const ElementValues here = values(element, at, multipliers, p, scale);
    Eigen::VectorXd u(n);
    for (double& entry : u) entry = normal(draw);

    const auto residual = [&](double h, double dp) {
        auto shifted = multipliers;
        for (std::size_t k = 0; k < shifted.size(); ++k) shifted[k] += h * u(own + static_cast<Eigen::Index>(k));
        Eigen::VectorXd g = values(element, moved<E>(at, u, h), shifted, p + dp, scale).residual;
        // moments by increments of Psi: T^T times those by the spin
        Eigen::Index next = 0;
        for (std::size_t k = 0; k < at.size(); ++k) {
            Eigen::Vector3d psi = Eigen::Vector3d::Zero(), moment = psi;
            for (std::size_t c = 0; c < E::components.size(); ++c)
                if (E::components[c] >= rx) {
                    psi(E::components[c] - rx) = h * u(next + static_cast<Eigen::Index>(c));
                    moment(E::components[c] - rx) = g(next + static_cast<Eigen::Index>(c));
                }
            const Eigen::Vector3d turned = tangent_map<double>(psi).transposed().value() * moment;
            for (std::size_t c = 0; c < E::components.size(); ++c)
                if (E::components[c] >= rx) g(next + static_cast<Eigen::Index>(c)) = turned(E::components[c] - rx);
            next += static_cast<Eigen::Index>(E::components.size());
        }
        return g;
    };
    // sixth order: (45 (f1 - f-1) - 9 (f2 - f-2) + f3 - f-3) / 60 h
    const auto slope = [&](const auto& f) -> Eigen::VectorXd {
        const double h = 2e-3;
        return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + f(3 * h) - f(-3 * h)) / (60 * h);
    };
    const Eigen::VectorXd ku = here.tangent * u, difference = slope([&](double h) { return residual(h, 0); }),
                          by_p = slope([&](double h) { return residual(0, h); });
    Errors y;
    y.tangent = (ku - difference).norm() / here.tangent.norm() / u.norm();
    y.symmetry = (here.tangent - here.tangent.transpose()).norm() / here.tangent.norm();
    y.parameter = (here.parameter_derivative - by_p).norm() / std::max(1.0, here.parameter_derivative.norm());
    return y;
}

}  // namespace states
