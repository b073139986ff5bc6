// A two-angle model of the user's through trace_locus: two rods on each other, upright, each tip held by a horizontal
// spring.
#include <cstdlib>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <iostream>

struct SpringLoadedDoublePendulum {
    static constexpr int n_angles = 2;
    enum Parameter { stiffness, offset, n_parameters };

    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto x1 = sin(theta[0]), x2 = x1 + sin(theta[1]);
        const auto stretch1 = x1 - p[offset], stretch2 = x2 - p[offset];
        return 2 * cos(theta[0]) + cos(theta[1]) + 0.5 * p[stiffness] * (stretch1 * stretch1 + stretch2 * stretch2);
    }
};

int main() {
    using Model = SpringLoadedDoublePendulum;
    const auto locus = equilibria::trace_locus<Model, Model::offset, Model::stiffness>({1, 0}, {{-0.5, 0.5}, {0.5, 4}});
    const auto cusps = locus.of(equilibria::SingularityKind::cusp).size();
    std::cout << locus.curves.size() << " curves, " << cusps << " cusps\n";
    return locus.evidence.complete() && cusps == 4 ? EXIT_SUCCESS : EXIT_FAILURE;
}
