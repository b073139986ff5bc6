// What a first program of a user looks like, however the library came to it: a model of its own, enumerated.
#include <cstdio>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/version.hpp>

struct DoublePendulum {
    static constexpr int n_angles = 2;
    enum Parameter { load, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        return -2 * cos(theta[0]) - cos(theta[1]) - p[load] * (sin(theta[0]) + sin(theta[1]));
    }
};

int main() {
    const auto found = equilibria::enumerate<DoublePendulum>({0.5});
    std::printf("equilibria %s: %llu of them\n", EQUILIBRIA_VERSION_STRING,
                static_cast<unsigned long long>(found.real()));
    return found.paths.accounted_for() && found.clean() && found.real() == 4 ? 0 : 1;
}
