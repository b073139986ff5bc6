// The smallest program: a model of one's own, and all its equilibria. README shows it.
// [quickstart]
#include <cstdio>
#include <equilibria/enumerate/enumerate.hpp>
#include <iostream>

struct TwoLinkChain {  // a double pendulum in a plane that turns about the vertical at the speed omega
    static constexpr int n_angles = 2;
    enum Parameter { alpha, ratio, omega, n_parameters };  // mass ratio m2 / (m1 + m2), length ratio l2 / l1, speed

    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto x1 = sin(theta[0]), x2 = x1 + p[ratio] * sin(theta[1]);
        return -0.5 * p[omega] * p[omega] * ((1 - p[alpha]) * x1 * x1 + p[alpha] * x2 * x2) - cos(theta[0]) -
               p[alpha] * p[ratio] * cos(theta[1]);
    }
};

int main() {
    const auto found = equilibria::enumerate<TwoLinkChain>({.3, 1.5, 2.0});
    std::cout << found << "\n\n  theta 1   theta 2  index   energy\n";
    for (const auto& e : found.equilibria)
        std::printf("%9.5f %9.5f  %5d %8.5f%s\n", e.q[0], e.q[1], e.index, e.energy, e.stable() ? "  stable" : "");
}
// [/quickstart]

// clang-format off
/* Output:
16 paths: 16 finite, 0 at infinity, 0 singular, 0 failed; 16 distinct roots, 12 real: index 0: 2, 1: 6, 2: 4; Morse relations hold

  theta 1   theta 2  index   energy
  1.39806   1.47023      0 -5.25862  stable
 -1.39806  -1.47023      0 -5.25862  stable
  1.23055  -2.58828      1 -1.20925
 -1.23055   2.58828      1 -1.20925
 -0.68757   1.26666      1 -1.85211
 -2.78752   1.35062      1 -0.07732
  0.68757  -1.26666      1 -1.85211
  2.78752  -1.35062      1 -0.07732
  0.00000   0.00000      2 -1.45000
  3.14159   0.00000      2  0.55000
  0.00000   3.14159      2 -0.55000
  3.14159   3.14159      2  1.45000
*/
