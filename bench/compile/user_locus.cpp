// A two-angle model of the user's through trace_locus: two rods on each other, upright, each tip held by a horizontal
// spring.
#include <cstdlib>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <iostream>

#include "../../tests/support/spring_loaded_double_pendulum.hpp"

int main() {
    using Model = models::SpringLoadedDoublePendulum;
    const auto locus = equilibria::trace_locus<Model, Model::offset, Model::stiffness>({1, 0}, {{-0.5, 0.5}, {0.5, 4}});
    const auto cusps = locus.of(equilibria::SingularityKind::cusp).size();
    std::cout << locus.curves.size() << " curves, " << cusps << " cusps\n";
    return locus.evidence.complete() && cusps == 4 ? EXIT_SUCCESS : EXIT_FAILURE;
}
