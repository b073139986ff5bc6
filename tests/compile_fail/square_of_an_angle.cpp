// A torsion spring k theta^2 / 2 is no trigonometric polynomial.
// expect: equilibria: an angle may enter a model only inside sin and cos
// expect: for a torsion spring use its potential in sin and cos or a coordinate
#include <equilibria/algebra/formulation.hpp>

struct TorsionSpring {
    static constexpr int n_angles = 1;
    enum Parameter { stiffness, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
#ifdef EQUILIBRIA_CONTROL
        return p[stiffness] * (1 - cos(theta[0]));
#else
        return 0.5 * p[stiffness] * theta[0] * theta[0] - cos(theta[0]);
#endif
    }
};

static_assert(equilibria::Formulation<TorsionSpring>::unknowns == 1);
