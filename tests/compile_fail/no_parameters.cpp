// expect: equilibria: a model needs its number of parameters, `n_parameters`
#include <equilibria/algebra/formulation.hpp>

struct Pendulum {
    static constexpr int n_angles = 1;
#ifdef EQUILIBRIA_CONTROL
    enum Parameter { gravity, n_parameters };
#else
    enum Parameter { gravity };
#endif
    constexpr auto potential(const auto& theta, const auto& p) const { return -p[gravity] * cos(theta[0]); }
};

static_assert(equilibria::Formulation<Pendulum>::unknowns == 1);
