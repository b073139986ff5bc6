// expect: equilibria: a model holds no data: what varies belongs into its parameters p
#include <equilibria/algebra/formulation.hpp>

struct Pendulum {
    static constexpr int n_angles = 1, n_parameters = 0;
#ifdef EQUILIBRIA_CONTROL
    static constexpr double gravity = 9.80665;
#else
    double gravity = 9.80665;
#endif
    constexpr auto potential(const auto& theta, const auto&) const { return -gravity * cos(theta[0]); }
};

static_assert(equilibria::Formulation<Pendulum>::unknowns == 1);
