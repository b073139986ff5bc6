// pow with an exponent that is no whole number, which must not be rounded to one.
// expect: equilibria: the model is not a trigonometric polynomial: it takes sqrt, exp, log, sin or cos of something
// that
#include <equilibria/algebra/formulation.hpp>

struct Power {
    static constexpr int n_angles = 1, n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) const {
#ifdef EQUILIBRIA_CONTROL
        return pow(2 + cos(theta[0]), 2.0);
#else
        return pow(2 + cos(theta[0]), 0.5);
#endif
    }
};

static_assert(equilibria::Formulation<Power>::unknowns == 1);
