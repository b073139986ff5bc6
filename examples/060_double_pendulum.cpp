// A model of one's own that is no chain: two rods stand on each other, held upright by springs.
//
//   wall |/\/\/\/\/ o            Rods of length 1 and weight 1 at their tips. From each tip a horizontal spring goes to
//        |          |            a wall, on which its other end slides; relaxed, it holds its tip at x = offset. With
//        |          o /\/\/\/|   enough stiffness the rods stand; as it falls they buckle to either side, and with an
//        |          |        |   offset the springs push them to one side: then the pitchfork breaks up into folds
//        |         _|_       |   that end in a cusp, the shape of Euler's column with an imperfection.
//
// The angles are measured from the upright.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <iostream>

struct SpringLoadedDoublePendulum {
    static constexpr int n_angles = 2;
    enum Parameter { stiffness, offset, n_parameters };

    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto x1 = sin(theta[0]), x2 = x1 + sin(theta[1]);
        const auto z1 = cos(theta[0]), z2 = z1 + cos(theta[1]);
        const auto stretch1 = x1 - p[offset], stretch2 = x2 - p[offset];
        return z1 + z2 + 0.5 * p[stiffness] * (stretch1 * stretch1 + stretch2 * stretch2);
    }
};

int main() {
    for (const double offset : {0.05, 0.2})
        for (const double stiffness : {4.0, 3.0, 2.0, 1.0}) {
            const auto found = equilibria::enumerate<SpringLoadedDoublePendulum>({stiffness, offset});
            std::printf("stiffness %.0f, offset %.2f\n", stiffness, offset);
            std::cout << "  " << found << "\n";
            for (const auto& e : found.equilibria)
                if (e.stable()) std::printf("    stable at %8.4f %8.4f, energy %7.4f\n", e.q[0], e.q[1], e.energy);
        }

    // the buckling loads are the cusps: stiffness 2 - sqrt 2, sqrt 2 (twice) and 2 + sqrt 2, at offset 0
    using Model = SpringLoadedDoublePendulum;
    const auto locus = equilibria::trace_locus<Model, Model::offset, Model::stiffness>({1, 0}, {{-0.5, 0.5}, {0.5, 4}});
    auto cusps = locus.of(equilibria::SingularityKind::cusp);
    std::sort(cusps.begin(), cusps.end(), [](const auto& a, const auto& b) { return a.y() < b.y(); });
    std::printf("%zu fold curves, %s\n", locus.curves.size(),
                locus.evidence.complete() ? "all events on all lines explained" : "NOT ALL EXPLAINED");
    for (const auto& cusp : cusps) std::printf("cusp at offset %.10f, stiffness %.10f\n", std::abs(cusp.x()), cusp.y());
}

// clang-format off
/* Output:
stiffness 4, offset 0.05
  16 paths: 16 finite, 0 at infinity, 0 singular, 0 failed; 16 distinct roots, 12 real: index 0: 4, 1: 6, 2: 2; Morse relations hold
    stable at   0.2409  -0.2571, energy  2.9891
    stable at   3.1130   0.0286, energy -0.9986
    stable at   0.0860  -3.1128, energy  0.9957
    stable at   3.1063   3.1298, energy -2.9982
stiffness 3, offset 0.05
  16 paths: 16 finite, 0 at infinity, 0 singular, 0 failed; 16 distinct roots, 10 real: index 0: 3, 1: 5, 2: 2; Morse relations hold
    stable at   3.1202   0.0429, energy -0.9989
    stable at   0.1081  -3.0982, energy  0.9946
    stable at   3.1090   3.1285, energy -2.9984
stiffness 2, offset 0.05
  16 paths: 16 finite, 0 at infinity, 0 singular, 0 failed; 16 distinct roots, 10 real: index 0: 3, 1: 5, 2: 2; Morse relations hold
    stable at  -3.1411   0.1018, energy -1.0000
    stable at   0.2164  -3.0318, energy  0.9895
    stable at   3.1130   3.1273, energy -2.9986
stiffness 1, offset 0.05
  16 paths: 16 finite, 0 at infinity, 0 singular, 0 failed; 16 distinct roots, 6 real: index 0: 1, 1: 3, 2: 2; Morse relations hold
    stable at   3.1202   3.1273, energy -2.9989
stiffness 4, offset 0.20
  16 paths: 16 finite, 0 at infinity, 0 singular, 0 failed; 16 distinct roots, 10 real: index 0: 3, 1: 5, 2: 2; Morse relations hold
    stable at   3.0276   0.1155, energy -0.9771
    stable at   0.3696  -3.0125, energy  0.9274
    stable at   3.0004   3.0942, energy -2.9717
stiffness 3, offset 0.20
  16 paths: 16 finite, 0 at infinity, 0 singular, 0 failed; 16 distinct roots, 10 real: index 0: 3, 1: 5, 2: 2; Morse relations hold
    stable at   3.0571   0.1757, energy -0.9830
    stable at   0.5753  -2.8828, energy  0.9006
    stable at   3.0112   3.0891, energy -2.9738
stiffness 2, offset 0.20
  16 paths: 16 finite, 0 at infinity, 0 singular, 0 failed; 16 distinct roots, 6 real: index 0: 1, 1: 3, 2: 2; Morse relations hold
    stable at   3.0274   3.0842, energy -2.9771
stiffness 1, offset 0.20
  16 paths: 16 finite, 0 at infinity, 0 singular, 0 failed; 16 distinct roots, 6 real: index 0: 1, 1: 3, 2: 2; Morse relations hold
    stable at   3.0559   3.0844, energy -2.9828
4 fold curves, all events on all lines explained
cusp at offset 0.0000000000, stiffness 0.5857864376
cusp at offset 0.0000000000, stiffness 1.4142135624
cusp at offset 0.0000000000, stiffness 1.4142135624
cusp at offset 0.0000000000, stiffness 3.4142135624
*/
