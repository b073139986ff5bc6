// -torque theta is no function on the circle.
// expect: for a constant torque give equations instead of a potential
#include <equilibria/algebra/formulation.hpp>

#ifdef EQUILIBRIA_CONTROL
#include <array>
#endif

struct Torque {
    static constexpr int n_angles = 1;
    enum Parameter { torque, n_parameters };
#ifdef EQUILIBRIA_CONTROL
    constexpr auto equations(const auto& theta, const auto& p) const { return std::array{sin(theta[0]) - p[torque]}; }
#else
    constexpr auto potential(const auto& theta, const auto& p) const { return -cos(theta[0]) - p[torque] * theta[0]; }
#endif
};

static_assert(equilibria::Formulation<Torque>::unknowns == 1);
