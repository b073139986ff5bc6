// A polynomial system in plain coordinates, solved and proved: katsura-5, the field of a spin glass (S. Katsura, Spin
// glass problem by the method of integral equation of the effective field, New Trends in Magnetism, 1990). 32
// solutions.
#include <array>
#include <cstddef>
#include <cstdlib>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <iostream>

struct Katsura {
    static constexpr int n_angles = 0, n_coordinates = 6;
    enum Parameter { total, n_parameters };

    constexpr auto equations(const auto&, const auto& u, const auto& p) const {
        constexpr int n = n_coordinates - 1;
        std::array<equilibria::scalar_of<decltype(u)>, n + 1> f{};
        const auto size = [](int k) { return k < 0 ? -k : k; };
        for (int m = 0; m < n; ++m) {
            auto& sum = f[static_cast<std::size_t>(m)];
            sum = -1.0 * u[m];
            for (int i = -n; i <= n; ++i)
                if (size(m - i) <= n) sum += u[size(i)] * u[size(m - i)];
        }
        f[n] = u[0] - p[total];
        for (int i = 1; i <= n; ++i) f[n] += 2.0 * u[i];
        return f;
    }
};

int main() {
    const auto found = equilibria::enumerate<Katsura>({1.0});
    const auto proof = equilibria::prove(found);
    std::cout << found << '\n' << proof << '\n';
    return proof.complete ? EXIT_SUCCESS : EXIT_FAILURE;
}
