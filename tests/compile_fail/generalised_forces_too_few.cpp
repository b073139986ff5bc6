// expect: equilibria: generalised_forces must return a std::array with one entry for each unknown
#include <array>

#include <equilibria/model/kinetics.hpp>

struct Pair {
    static constexpr int n_angles = 2, n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) const { return -cos(theta[0]) - cos(theta[1]); }
    constexpr auto kinetic_energy(const auto&, const auto& v, const auto&) const { return v[0] * v[0] + v[1] * v[1]; }
    auto generalised_forces(double t, const auto&, const auto& v, const auto&) const {
#ifdef EQUILIBRIA_CONTROL
        return std::array{t + 0.0 * v[0], t + 0.0 * v[1]};
#else
        return std::array{t + 0.0 * v[0]};
#endif
    }
};

auto forces() { return equilibria::generalised_forces<Pair>(0, {0.0, 0.0}, {1.0, 1.0}, {}); }
