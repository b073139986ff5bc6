// Systems with known numbers of roots from polyhedral starts, over many seeds: what was found, lost, failed and proved.
//     known_roots [--seeds N] [NAME ...]      names as of tests/support/families.hpp, and cycle-N: the uniform cycle of
//     N oscillators without loads (one bond reversed where N is divisible by 4), all of whose roots are real, with the
//     number of each index in closed form: of m < N/2 edges at pi - a, index m where cos a > 0, else N - m - 1
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/enumerate/prove_complex_roots.hpp>
#include <equilibria/paths/generic_instance.hpp>

#include "support/families.hpp"

using namespace equilibria;

namespace {

/// V = -sum cos(theta_(e+1) - theta_e) over a cycle of n + 1 oscillators, the last at angle 0; times -1 on one edge.
struct UniformCycle {
    int n;
    bool reversed;

    int angles() const { return n; }
    int parameters() const { return 1; }
    auto potential(const auto& theta, const auto& p) const {
        auto v = -(p[0] * cos(theta[0])) * (reversed ? -1.0 : 1.0);
        for (int i = 1; i < n; ++i) v -= p[0] * cos(theta[i] - theta[i - 1]);
        return v - p[0] * cos(theta[n - 1]);
    }
};

/// How many equilibria have each index: N - 2m values of a for each choice of m edges.
std::vector<std::int64_t> cycle_by_index(int edges, bool reversed) {
    std::vector<std::int64_t> y(static_cast<std::size_t>(edges));
    std::int64_t choices = 1;
    for (int m = 0; 2 * m < edges; ++m) {
        for (int k = 0; k < edges - 2 * m; ++k) {
            const double a =
                (2 * std::numbers::pi * k + (reversed ? std::numbers::pi : 0) - m * std::numbers::pi) / (edges - 2 * m);
            y[static_cast<std::size_t>(std::cos(a) > 0 ? m : edges - m - 1)] += choices;
        }
        choices = choices * (edges - m) / (m + 1);
    }
    return y;
}

struct Sums {
    std::uint64_t known = 0, volume = 0, runs = 0, short_runs = 0, failed = 0, retracked = 0, not_proved = 0,
                  complete = 0;
    std::uint64_t wrong_tables = 0;
    double seconds = 0, proving = 0;
};

void add(Sums& sums, std::uint64_t found, const PathCounts& paths, const ProofOfRoots& proof, double seconds) {
    ++sums.runs;
    sums.volume = paths.total;
    sums.short_runs += found != sums.known;
    sums.failed += paths.failed;
    sums.retracked += paths.retracked;
    sums.not_proved += found - proof.distinct;
    sums.complete += proof.complete;
    sums.seconds += seconds;
    sums.proving += proof.seconds;
}

template <class T>
void run_model(const T& model, const RuntimeArray<double>& p, std::uint64_t seed, Sums& sums,
               const std::vector<std::int64_t>& by_index = {}) {
    const auto set = enumerate_from<Polyhedral>(model, p, {.seed = seed}, {}, more_digits);
    add(sums, set.distinct(), set.paths, prove(model, set), set.seconds);
    sums.wrong_tables += !by_index.empty() && set.by_index() != by_index;
}

Sums run(const std::string& name, std::uint64_t seeds) {
    const auto dash = name.rfind('-');
    const std::string family = name.substr(0, dash);
    const int n = std::atoi(name.c_str() + dash + 1);
    Sums sums;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        if (family == "cycle") {
            const UniformCycle model{n - 1, n % 4 == 0};
            const auto by_index = cycle_by_index(n, model.reversed);
            sums.known = 0;
            for (const auto count : by_index) sums.known += static_cast<std::uint64_t>(count);
            run_model(model, RuntimeArray<double>{1.0}, seed, sums, by_index);
            continue;
        }
        sums.known = static_cast<std::uint64_t>(families::known_roots(name));
        if (family == "loaded" || family == "row") {
            const families::LoadedAngles model{n, family == "row" ? families::row(n) : families::complete(n)};
            run_model(model, families::generic(model.parameters(), 1), seed, sums);
        } else if (family.starts_with("kuramoto")) {
            const families::Oscillators model{n - 1,
                                              family == "kuramoto-cycle" ? families::cycle(n) : families::complete(n)};
            run_model(model,
                      family == "kuramoto-equal" ? families::equal_couplings(model, 1)
                                                 : families::generic(model.parameters(), 1),
                      seed, sums);
        } else {
            const auto system = sparse_system(families::by_name(name));
            const auto begin = std::chrono::steady_clock::now();
            const auto found = solve_polyhedral(system, {.seed = seed}, {}, more_digits);
            const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
            std::uint64_t regular = 0;
            for (const auto& root : found.roots) regular += root.status == PathStatus::finite;
            add(sums, regular, found.paths, prove(system, found, proved_bounds(system)), seconds.count());
        }
    }
    return sums;
}

}  // namespace

int main(int argc, char** argv) {
    std::uint64_t seeds = 20;
    std::vector<std::string> names;
    for (int k = 1; k < argc; ++k) {
        const std::string argument = argv[k];
        if (argument == "--seeds" && k + 1 < argc)
            seeds = std::strtoull(argv[++k], nullptr, 10);
        else
            names.push_back(argument);
    }
    if (names.empty())
        names = {"cyclic-5", "cyclic-6",         "cyclic-7",        "katsura-5", "katsura-6", "katsura-7",
                 "noon-3",   "noon-4",           "noon-5",          "eco-6",     "eco-8",     "loaded-3",
                 "loaded-4", "loaded-5",         "loaded-6",        "row-3",     "row-4",     "row-5",
                 "row-6",    "kuramoto-4",       "kuramoto-5",      "cycle-5",   "cycle-6",   "cycle-7",
                 "cycle-8",  "kuramoto-equal-3", "kuramoto-equal-4"};
    std::printf("%-18s %8s %8s %5s %6s %6s %9s %10s %8s %6s %10s %10s\n", "system", "roots", "paths", "runs", "short",
                "failed", "retracked", "not proved", "complete", "tables", "seconds", "proving");
    for (const auto& name : names) {
        const Sums s = run(name, seeds);
        const auto whole = [](std::uint64_t k) { return static_cast<unsigned long long>(k); };
        std::printf("%-18s %8llu %8llu %5llu %6llu %6llu %9llu %10llu %8llu %6llu %10.4g %10.4g\n", name.c_str(),
                    whole(s.known), whole(s.volume), whole(s.runs), whole(s.short_runs), whole(s.failed),
                    whole(s.retracked), whole(s.not_proved), whole(s.complete), whole(s.wrong_tables),
                    s.seconds / static_cast<double>(s.runs), s.proving / static_cast<double>(s.runs));
        std::fflush(stdout);
    }
}
