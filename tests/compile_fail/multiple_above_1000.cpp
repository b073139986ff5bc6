// expect: equilibria: the model has a multiple of an angle, or a power of a coordinate, above 1000
#include <equilibria/algebra/formulation.hpp>

struct Gear {
    static constexpr int n_angles = 1, n_parameters = 0;
#ifdef EQUILIBRIA_CONTROL
    static constexpr int teeth = 1000;
#else
    static constexpr int teeth = 1001;
#endif
    constexpr auto potential(const auto& theta, const auto&) const { return cos(teeth * theta[0]); }
};

static_assert(equilibria::Formulation<Gear>::unknowns == 1);
