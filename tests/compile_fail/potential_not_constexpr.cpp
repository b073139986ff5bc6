// expect: equilibria: the model's potential or equations must be declared constexpr
#include <equilibria/algebra/formulation.hpp>

#ifdef EQUILIBRIA_CONTROL
#define SOMETIMES constexpr
#else
#define SOMETIMES
#endif

SOMETIMES inline double gravity() { return 9.80665; }

struct Pendulum {
    static constexpr int n_angles = 1, n_parameters = 0;
    SOMETIMES auto potential(const auto& theta, const auto&) const { return -gravity() * cos(theta[0]); }
};

static_assert(equilibria::Formulation<Pendulum>::unknowns == 1);
