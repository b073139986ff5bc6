// expect: equilibria: dissipation must be callable as dissipation(theta, v, p), with the coordinates x after theta
// where
#include <equilibria/model/runtime_kinetics.hpp>

struct Row {
    int n;
    int angles() const { return n; }
    int parameters() const { return 1; }
    auto potential(const auto& theta, const auto&) const { return -cos(theta[0]); }
    auto kinetic_energy(const auto&, const auto& v, const auto&) const { return 0.5 * v[0] * v[0]; }
#ifdef EQUILIBRIA_CONTROL
    auto dissipation(const auto&, const auto& v, const auto& p) const { return p[0] * v[0] * v[0]; }
#else
    auto dissipation(const auto& v, const auto& p) const { return p[0] * v[0] * v[0]; }
#endif
};

auto functions() { return equilibria::kinetic_functions(Row{1}); }
