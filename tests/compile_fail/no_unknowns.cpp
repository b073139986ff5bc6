// expect: equilibria: a model needs at least one unknown angle or coordinate
#include <equilibria/algebra/formulation.hpp>

struct Nothing {
#ifdef EQUILIBRIA_CONTROL
    static constexpr int n_angles = 1, n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) const { return cos(theta[0]); }
#else
    static constexpr int n_angles = 0, n_parameters = 0;
    constexpr auto potential(const auto&, const auto&) const { return 1.0; }
#endif
};

static_assert(equilibria::Formulation<Nothing>::unknowns == 1);
