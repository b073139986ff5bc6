// The length of a spring whose end moves on a circle, as a root.
// expect: equilibria: the model is not a trigonometric polynomial: it takes sqrt, exp, log, sin or cos of something
// that
#include <equilibria/algebra/formulation.hpp>

struct SpringWithRestLength {
    static constexpr int n_angles = 1;
    enum Parameter { stiffness, distance, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto square = 1 + p[distance] * p[distance] - 2 * p[distance] * cos(theta[0]);
#ifdef EQUILIBRIA_CONTROL
        return p[stiffness] * square + sqrt(p[distance]) * sin(theta[0]);
#else
        return p[stiffness] * pow(sqrt(square) - 1, 2);
#endif
    }
};

static_assert(equilibria::Formulation<SpringWithRestLength>::unknowns == 1);
