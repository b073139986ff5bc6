// expect: equilibria: potential must return a scalar, and angles enter it only inside sin and cos
#include <equilibria/algebra/formulation.hpp>

struct Forgotten {
    static constexpr int n_angles = 1, n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) const {
#ifdef EQUILIBRIA_CONTROL
        return cos(theta[0]);
#else
        return cos(theta[0]) - theta[0];
#endif
    }
};

static_assert(equilibria::Formulation<Forgotten>::unknowns == 1);
