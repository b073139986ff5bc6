// expect: for a half angle take the half angle as the unknown
#include <equilibria/algebra/formulation.hpp>

struct HalfAngle {
    static constexpr int n_angles = 1, n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) const {
#ifdef EQUILIBRIA_CONTROL
        return cos(2 * theta[0]);
#else
        return cos(theta[0] / 2);
#endif
    }
};

static_assert(equilibria::Formulation<HalfAngle>::unknowns == 1);
