// expect: equilibria: a model needs `static constexpr int n_angles`
#include <equilibria/algebra/formulation.hpp>

struct Pendulum {
#ifdef EQUILIBRIA_CONTROL
    static constexpr int n_angles = 1;
#endif
    enum Parameter { gravity, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const { return -p[gravity] * cos(theta[0]); }
};

static_assert(equilibria::Formulation<Pendulum>::unknowns == 1);
