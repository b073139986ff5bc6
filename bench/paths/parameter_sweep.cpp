// Many parameter points of a model from the roots of one generic instance: points a second, and whether each has as
// many real roots as from a total-degree start, on some of them.
//     parameter_sweep [POINTS [COMPARED [THREADS]]]      default 10000 200 1
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/paths/generic_instance.hpp>

#include "support/families.hpp"

using namespace equilibria;

namespace {

struct Counts {
    std::uint64_t regular = 0, real = 0, failed = 0;
    friend bool operator==(const Counts& a, const Counts& b) { return a.regular == b.regular && a.real == b.real; }
};
Counts counts_of(const ComplexRoots<>& found) {
    Counts y{0, 0, found.paths.failed};
    for (const auto& root : found.roots) {
        if (root.status != PathStatus::finite) continue;
        ++y.regular;
        y.real += is_real(root);
    }
    return y;
}

/// system_at(k): that of point number k.
void sweep(const char* name, const auto& system_at, std::size_t points, std::size_t compared, unsigned workers) {
    const GenericInstance instance(system_at(0));
    std::vector<Counts> counts(points);
    const auto begin = std::chrono::steady_clock::now();
    threads(workers).for_blocks(points, 16, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) counts[k] = counts_of(instance.solve(system_at(k)));
    });
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::uint64_t failed = 0, differ = 0, least = ~std::uint64_t{0}, most = 0;
    for (const Counts& c : counts) {
        failed += c.failed;
        least = std::min(least, c.real);
        most = std::max(most, c.real);
    }
    const std::size_t stride = std::max<std::size_t>(1, points / std::max<std::size_t>(1, compared));
    std::size_t done = 0;
    for (std::size_t k = 0; k < points && done < compared; k += stride, ++done)
        differ += !(counts_of(solve_total_degree(system_at(k))) == counts[k]);
    std::printf(
        "%s: %zu points, %llu paths each, %.0f points a second; %llu to %llu real roots, %llu paths failed; %llu of "
        "%zu "
        "points differ from a total-degree start\n",
        name, points, static_cast<unsigned long long>(instance.mixed_volume()),
        static_cast<double>(points) / seconds.count(), static_cast<unsigned long long>(least),
        static_cast<unsigned long long>(most), static_cast<unsigned long long>(failed),
        static_cast<unsigned long long>(differ), done);
}

}  // namespace

int main(int argc, char** argv) {
    const auto number = [&](int k, unsigned long otherwise) {
        if (argc <= k) return otherwise;
        char* end = nullptr;
        const long value = std::strtol(argv[k], &end, 10);
        if (*end != '\0' || value < 1 || argc > 4) {
            std::fprintf(stderr, "parameter_sweep: %s: must be an integer above 0, of [POINTS [COMPARED [THREADS]]]\n",
                         argv[argc > 4 ? 4 : k]);
            std::exit(2);
        }
        return static_cast<unsigned long>(value);
    };
    const std::size_t points = number(1, 10000), compared = number(2, 200);
    const auto workers = static_cast<unsigned>(number(3, 1));

    const families::Oscillators oscillators{3, families::complete(4)};
    const RuntimeFormulation formulation(oscillators);
    sweep(
        "four coupled oscillators",
        [&](std::size_t k) {
            auto p = families::generic(oscillators.parameters(), k + 1);
            for (int w = static_cast<int>(oscillators.edges.size()); w < p.size(); ++w) p[w] -= 1;
            return SparseSystem(formulation.sizes(), formulation.terms(oscillators, p));
        },
        points, compared, workers);

    using Mechanism = mechanisms::HolonomicMechanism;
    sweep(
        "the mechanism",
        [](std::size_t k) {
            Generator generator(k + 1);
            auto p = Mechanism::paper_parameters(0);
            p[Mechanism::stiffness_1] *= uniform(generator, 0.2, 2);
            p[Mechanism::stiffness_2] *= uniform(generator, 0.2, 2);
            p[Mechanism::force] = uniform(generator, -300, 300);
            return sparse_system<Mechanism>(p);
        },
        points, compared, workers);
}
