/// \file
/// Planar chains of massless links with point masses, hanging in a vertical plane that turns about the vertical axis
/// through the first joint. Source: Baillieul, "Parametric dependence in the equilibrium dynamics of rotating
/// structures", section 3, equations (3.1) and (3.2).
#pragma once

#include <equilibria/model/model.hpp>

namespace equilibria::mechanisms {

namespace detail {
/// Of so many links. Parameters p: as of RotatingChain.
constexpr auto rotating_chain_potential(int links, const auto& theta, const auto& p) {
    const auto &omega = p[2 * links], &gravity = p[2 * links + 1];
    scalar_of<decltype(theta)> x{}, z{}, v{};
    for (int k = 0; k < links; ++k) {
        x += p[k] * sin(theta[k]);
        z += p[k] * cos(theta[k]);
        v -= p[links + k] * (0.5 * omega * omega * x * x + gravity * z);
    }
    return v;
}
}  // namespace detail

/// N links of lengths l_i with mass m_i at the end of each, angular speed omega, gravity g. The angles are measured
/// from the hanging vertical, in radians. With X_k = sum_{j<=k} l_j sin theta_j and mass m_k at depth
/// Z_k = sum_{j<=k} l_j cos theta_j, V = -1/2 omega^2 sum m_k X_k^2 - g sum m_k Z_k.
///
/// Parameters p: l_0 .. l_{N-1}, m_0 .. m_{N-1}, omega, g.
template <int N>
struct RotatingChain {
    static_assert(N >= 1);
    static constexpr int n_angles = N;              ///< one of each link
    static constexpr int length = 0;                ///< place of the first length
    static constexpr int mass = N;                  ///< place of the first mass
    static constexpr int omega = 2 * N;             ///< place of the angular speed
    static constexpr int gravity = 2 * N + 1;       ///< place of gravity
    static constexpr int n_parameters = 2 * N + 2;  ///< two for each link, and two

    /// V, see above.
    constexpr auto potential(const auto& theta, const auto& p) const {
        return detail::rotating_chain_potential(N, theta, p);
    }
};

/// The same of a number of links that is known at run time, with the same parameters.
struct RuntimeRotatingChain {
    int links;  ///< N, at least 1

    int angles() const { return links; }              ///< one of each link
    int parameters() const { return 2 * links + 2; }  ///< number of parameters
    /// V of RotatingChain.
    auto potential(const auto& theta, const auto& p) const { return detail::rotating_chain_potential(links, theta, p); }
};

/// Two links, l_1 = g = 1, in the normal form (3.2): alpha = m_2 / (m_1 + m_2), ratio = l_2 / l_1, omega. The potential
/// is divided by m_1 + m_2.
struct TwoLinkChain {
    static constexpr int n_angles = 2;  ///< theta_1 and theta_2
    /// Share of the second mass, ratio of the lengths, angular speed.
    enum Parameter { alpha, ratio, omega, n_parameters };

    /// V over m_1 + m_2.
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto x1 = sin(theta[0]);
        const auto x2 = x1 + p[ratio] * sin(theta[1]);
        return -0.5 * p[omega] * p[omega] * ((1 - p[alpha]) * x1 * x1 + p[alpha] * x2 * x2) - cos(theta[0]) -
               p[alpha] * p[ratio] * cos(theta[1]);
    }
};

}  // namespace equilibria::mechanisms
