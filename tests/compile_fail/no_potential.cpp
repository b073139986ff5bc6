// expect: equilibria: a model needs `constexpr auto potential(const auto& theta, const auto& p) const`, or
#include <equilibria/algebra/formulation.hpp>

struct Pendulum {
    static constexpr int n_angles = 1, n_parameters = 0;
#ifdef EQUILIBRIA_CONTROL
    constexpr auto potential(const auto& theta, const auto&) const { return cos(theta[0]); }
#else
    constexpr auto energy(const auto& theta, const auto&) const { return cos(theta[0]); }
#endif
};

static_assert(equilibria::Formulation<Pendulum>::unknowns == 1);
