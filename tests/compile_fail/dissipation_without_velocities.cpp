// expect: equilibria: dissipation must be callable as dissipation(theta, v, p), with the coordinates x after theta
// where
#include <equilibria/model/kinetics.hpp>

struct Pendulum {
    static constexpr int n_angles = 1, n_parameters = 1;
    constexpr auto potential(const auto& theta, const auto&) const { return -cos(theta[0]); }
    constexpr auto kinetic_energy(const auto&, const auto& v, const auto&) const { return 0.5 * v[0] * v[0]; }
#ifdef EQUILIBRIA_CONTROL
    constexpr auto dissipation(const auto&, const auto& v, const auto& p) const { return p[0] * v[0] * v[0]; }
#else
    constexpr auto dissipation(const auto& v, const auto& p) const { return p[0] * v[0] * v[0]; }
#endif
};

double power() { return equilibria::dissipation<Pendulum>({0.0}, {1.0}, {1.0}); }
