// expect: equilibria: equations must return a std::array with one entry for each unknown angle and coordinate
#include <array>

#include <equilibria/algebra/formulation.hpp>

struct Pair {
    static constexpr int n_angles = 2, n_parameters = 0;
    constexpr auto equations(const auto& theta, const auto&) const {
#ifdef EQUILIBRIA_CONTROL
        return std::array{sin(theta[0] - theta[1]), cos(theta[1])};
#else
        return std::array{sin(theta[0] - theta[1])};
#endif
    }
};

static_assert(equilibria::Formulation<Pair>::unknowns == 2);
