// Sections of structures' files whose shear centre is beside the centroid: flexural-torsional buckling of cantilevers,
// against closed forms. With P_k = (2 j - 1)^2 pi^2 EI_k / (4 l^2), j = 1, 2, .., under a load through the point
// (e_2, 0) of the section the modes w_2, w_3 and the twist all go with cos, and
//
//     det [P_2 - P, 0, -P s_3; 0, P_3 - P, P (s_2 - e_2); -P s_3, P (s_2 - e_2), GJ - P (r^2 - e_2 w_3)] = 0.
//
// Source: Trahair, Flexural-torsional buckling of structures (1993), chapters 5 and 11; warping is free.
#if __has_include(<nlohmann/json.hpp>)

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/LU>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/fem/structure.hpp>
#include <equilibria/io/structure/structure_json.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using namespace equilibria::fem;

namespace {

struct Cantilever {
    double gj, ei2, ei3;  // EI_2 bends about axis 2: w_3
    double s2, s3, r, w3, e2;
    double high;

    double determinant(double p, int j) const {
        const double euler = std::pow((2 * j - 1) * std::numbers::pi / 2, 2);
        const double p2 = euler * ei3, p3 = euler * ei2, c = s2 - e2;
        Eigen::Matrix3d y;
        y << p2 - p, 0, -p * s3, 0, p3 - p, p * c, -p * s3, p * c, gj - p * (r * r - e2 * w3);
        return y.determinant();
    }
    /// Zeros of the determinant below `high`, by a scan.
    std::vector<double> expected() const {
        std::vector<double> y;
        const int steps = 20000;
        for (int j = 1; j <= 12; ++j)
            for (int k = 0; k < steps; ++k) {
                double a = high * k / steps, b = high * (k + 1) / steps;
                const bool before = determinant(a, j) > 0;
                if ((determinant(b, j) > 0) == before) continue;
                for (int i = 0; i < 60; ++i) ((determinant((a + b) / 2, j) > 0) == before ? a : b) = (a + b) / 2;
                y.push_back(a);
            }
        std::sort(y.begin(), y.end());
        return y;
    }
    std::string text() const {
        const auto t = [](double x) { return std::to_string(x); };
        const std::string arm = e2 == 0 ? "" : R"(, {"type": "rigid_body", "nodes": ["B", "C"]})",
                          tip = e2 == 0 ? "B" : "C";
        return R"({"nodes": {"A": [0, 0, 0], "B": [1, 0, 0])" + (e2 == 0 ? "" : R"(, "C": [1, )" + t(e2) + ", 0]") +
               R"(}, "sections": {"open": {"ea": "rigid", "ga2": "rigid", "ga3": "rigid", "gj": )" + t(gj) +
               R"(, "ei2": )" + t(ei2) + R"(, "ei3": )" + (e2 == 0 ? t(ei3) : "\"rigid\"") + R"(, "shear_centre": [)" +
               t(s2) + ", " + t(s3) + R"(], "polar_radius": )" + t(r) + R"(, "wagner": [0, )" + t(w3) +
               R"(]}}, "elements": [{"type": "beam", "nodes": ["A", "B"], "section": "open", "second": [0, 1, 0],
               "elements": 6, "order": "cubic"})" +
               arm + R"(], "supports": [{"node": "A", "fix": ["all"]}], "loads": [{"node": ")" + tip +
               R"(", "force": [-1, 0, 0]}], "parameter": {"low": 0, "high": )" + t(high) + "}}";
    }
};

void check_loads(const Cantilever& cantilever, std::size_t least) {
    const auto input = parse_structure(cantilever.text());
    const Structure structure(input.model);
    const auto branch = continue_branch(structure, structure.initial(), 0, 1, continuation_options(input));
    CHECK(branch.unexplained.empty());
    const auto expected = cantilever.expected();
    REQUIRE(expected.size() >= least);
    REQUIRE(branch.events.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
        CHECK(branch.events[k].point.p == Approx(expected[k]).epsilon(2e-6));
}

}  // namespace

TEST_CASE("a column with a shear centre on an axis of symmetry twists as it buckles") {
    check_loads({.gj = 1, .ei2 = 1, .ei3 = 5, .s2 = 0.3, .s3 = 0, .r = 0.36, .w3 = 0, .e2 = 0, .high = 6.5}, 2);
    check_loads({.gj = 1, .ei2 = 1, .ei3 = 5, .s2 = -0.3, .s3 = 0, .r = 0.36, .w3 = 2, .e2 = 0, .high = 6.5}, 2);
}

TEST_CASE("a column with a shear centre beside both axes has three coupled modes") {
    check_loads({.gj = 1, .ei2 = 1, .ei3 = 1.7, .s2 = 0.3, .s3 = -0.2, .r = 0.45, .w3 = 0, .e2 = 0, .high = 3.8}, 2);
}

TEST_CASE("an eccentric load meets the shear centre and Wagner's coefficient") {
    // bending about axis 3 is rigid, so that the bending moment is the same all along
    const double ei3 = 1e9;
    check_loads({.gj = 1, .ei2 = 1, .ei3 = ei3, .s2 = 0.3, .s3 = 0, .r = 0.36, .w3 = 0, .e2 = 0.1, .high = 7}, 2);
    check_loads({.gj = 1, .ei2 = 1, .ei3 = ei3, .s2 = 0.3, .s3 = 0, .r = 0.36, .w3 = 0.4, .e2 = 0.1, .high = 9.5}, 2);
    check_loads({.gj = 1, .ei2 = 1, .ei3 = ei3, .s2 = 0.3, .s3 = 0, .r = 0.36, .w3 = -0.4, .e2 = -0.2, .high = 4}, 1);
}

#endif
