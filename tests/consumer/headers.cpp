// What compiles in seconds and needs all that a package of the headers has to bring: Eigen, Boost and the version.
#include <Eigen/Core>
#include <cstdio>
#include <equilibria/core/key_sort.hpp>
#include <equilibria/stability/inertia.hpp>
#include <equilibria/version.hpp>
#include <vector>

struct Length {
    double key;
};

int main() {
    std::vector<Length> lengths{{3}, {1}, {2}};
    equilibria::sort_by_key(lengths);
    const auto inertia = equilibria::inertia(Eigen::Matrix2d{{1, 2}, {2, 1}});
    std::printf("equilibria %s: %d negative\n", EQUILIBRIA_VERSION_STRING, inertia.negative);
    return lengths[0].key == 1 && lengths[2].key == 3 && inertia.negative == 1 ? 0 : 1;
}
