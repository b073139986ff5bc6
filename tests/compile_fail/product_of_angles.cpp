// expect: equilibria: an angle may enter a model only inside sin and cos
#include <equilibria/algebra/formulation.hpp>

struct Product {
    static constexpr int n_angles = 2, n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) const {
#ifdef EQUILIBRIA_CONTROL
        return cos(theta[0] - theta[1]) + cos(theta[0]);
#else
        return cos(theta[0] * theta[1]) + cos(theta[0]);
#endif
    }
};

static_assert(equilibria::Formulation<Product>::unknowns == 2);
