// expect: equilibria: the model is not a trigonometric polynomial: it divides by something that depends on the angles
#include <equilibria/algebra/formulation.hpp>

struct Quotient {
    static constexpr int n_angles = 1, n_parameters = 1;
    constexpr auto potential(const auto& theta, const auto& p) const {
#ifdef EQUILIBRIA_CONTROL
        return sin(theta[0]) / (1 + p[0]);
#else
        return sin(theta[0]) / (2 + p[0] * cos(theta[0]));
#endif
    }
};

static_assert(equilibria::Formulation<Quotient>::unknowns == 1);
