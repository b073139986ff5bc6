// expect: equilibria: one of the model's equations does not depend on its unknowns
#include <equilibria/algebra/formulation.hpp>

struct Idle {
    static constexpr int n_angles = 2, n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) const {
#ifdef EQUILIBRIA_CONTROL
        return cos(theta[0]) + cos(theta[1]);
#else
        return cos(theta[0]);
#endif
    }
};

static_assert(equilibria::Formulation<Idle>::unknowns == 2);
