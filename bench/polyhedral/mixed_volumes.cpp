// Mixed volumes of well-known families, for bench/peers/mixed_volumes, which compares them with gfan_mixedvolume.
//
//   mixed_volumes names                    the families' systems, one a line, with the mixed volumes published or found
//                                          by others
//   mixed_volumes gfan NAME                the supports, as gfan_mixedvolume --vectorinput reads them
//   mixed_volumes run NAME RUNS [THREADS]  mixed volume, exchanges, seconds: the least processor time of RUNS runs, or
//                                          more until a fifth of a second has gone; of several threads their wall time
//   mixed_volumes random COUNT SEED DIR    so many random supports with 2 to 6 unknowns, written for gfan to DIR/k: one
//                                          line `k volume` each. Each is computed in two orders of the equations and by
//                                          the cells of a random lifting too; exits with 1 where these differ.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <equilibria/core/random.hpp>
#include <equilibria/polyhedral/mixed_cells.hpp>
#include <equilibria/run/threads.hpp>
#include <exception>
#include <fstream>
#include <functional>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "../../tests/support/support_families.hpp"

using namespace equilibria;

namespace {

struct Family {
    std::string name;
    std::uint64_t volume;
    std::function<Supports()> supports;
};

std::vector<Family> families() {
    using namespace support_families;
    std::vector<Family> y;
    const auto add = [&](const char* name, Supports (*make)(int),
                         std::initializer_list<std::pair<int, std::uint64_t>> volumes) {
        for (const auto& [n, volume] : volumes)
            y.push_back(
                {std::string(name).append("-").append(std::to_string(n)), volume, [make, n = n] { return make(n); }});
    };
    add("cyclic", cyclic, {{7, 924}, {8, 2560}, {9, 11016}, {10, 35940}, {11, 184756}});
    add("noon", noon, {{8, 6545}, {10, 59029}, {12, 531417}});
    add("chandra", chandra, {{8, 128}, {12, 2048}});
    add("katsura", katsura, {{8, 240}, {10, 990}, {12, 4020}});
    add("gaukwa", gaukwa, {{3, 49}, {4, 729}, {5, 14641}});
    add("eco", eco, {{10, 256}, {12, 1024}, {15, 8192}});
    add("chain", chain, {{4, 256}, {5, 1024}, {6, 4096}, {7, 16384}, {8, 65536}});
    add("all-to-all", all_to_all, {{4, 70}, {5, 252}, {6, 924}, {7, 3432}, {8, 12870}});
    add("neighbours", nearest_neighbour,
        {{3, 16}, {4, 44}, {5, 120}, {6, 328}, {7, 896}, {8, 2448}, {9, 6688}, {10, 18272}, {11, 49920}, {12, 136384}});
    add("kuramoto", kuramoto_complete, {{3, 6}, {4, 20}, {5, 70}, {6, 252}, {7, 924}, {8, 3432}});
    y.push_back({"grid-3x3", 1280, [] { return kuramoto_grid(3, 3, false); }});
    y.push_back({"grid-3x4", 22720, [] { return kuramoto_grid(3, 4, false); }});
    y.push_back({"torus-3x3", 5220, [] { return kuramoto_grid(3, 3, true); }});
    y.push_back({"power-9", 768, [] { return power_flow_9(); }});
    y.push_back({"power-14", 422640, [] { return power_flow_14(); }});
    return y;
}

Supports of_name(std::string_view name) {
    for (const auto& family : families())
        if (family.name == name) return family.supports();
    throw std::invalid_argument(std::string(name) + " is none of `mixed_volumes names`");
}

void run(const Supports& supports, int runs, unsigned count) {
    MixedCellOptions options;
    options.executor = threads(count);
    const auto now = [&] {
        return count == 1 ? static_cast<double>(std::clock()) / CLOCKS_PER_SEC
                          : std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    };
    double least = 1e300, all = 0;
    MixedVolume volume;
    for (int k = 0; k < runs || (all < 0.2 && k < 1000); ++k) {
        const double begin = now();
        volume = mixed_volume(supports, options);
        const double seconds = now() - begin;
        least = std::min(least, seconds);
        all += seconds;
    }
    std::printf("%llu %llu %.6f\n", static_cast<unsigned long long>(volume.value),
                static_cast<unsigned long long>(volume.exchanges), least);
}

Supports random_supports(Generator& generator) {
    const auto draw = [&](int low, int high) {
        return low + static_cast<int>(generator() % static_cast<std::uint64_t>(high - low + 1));
    };
    const int n = draw(2, 6), range = draw(1, n > 4 ? 2 : 6), most = draw(2, n > 4 ? 7 : 10);
    support_families::Equations y(static_cast<std::size_t>(n));
    for (auto& equation : y) {
        const int size = draw(2, most);
        const bool plane = draw(0, 9) == 0;  // a few that depend on one unknown less
        for (int k = 0; k < size; ++k) {
            auto& point = equation.emplace_back();
            for (int l = 0; l < n; ++l) point.push_back(plane && l == n - 1 ? 0 : draw(-range, range));
        }
    }
    return support_families::without_copies(n, std::move(y));
}

bool compare_random(int count, std::uint64_t seed, const std::string& folder) {
    Generator generator(seed);
    bool same = true;
    for (int k = 0; k < count; ++k) {
        const auto supports = random_supports(generator);
        const auto volume = mixed_volume(supports).value;
        MixedCellOptions options;
        options.order.resize(static_cast<std::size_t>(supports.unknowns()));
        std::iota(options.order.rbegin(), options.order.rend(), 0);
        Lifting lifting(static_cast<std::size_t>(supports.columns()));
        for (auto& w : lifting) w = static_cast<std::int64_t>(generator() % 2048);
        std::uint64_t sum = 0;
        mixed_cells(supports, lifting, [&](const MixedCell& cell) { sum += cell.volume; });
        if (mixed_volume(supports, options).value != volume || sum != volume) {
            std::fprintf(stderr, "%d: orders or cells differ\n", k);
            same = false;
        }
        std::ofstream(folder + "/" + std::to_string(k)) << support_families::gfan_text(supports);
        std::printf("%d %llu\n", k, static_cast<unsigned long long>(volume));
    }
    return same;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    try {
        if (words.size() == 1 && words[0] == "names") {
            for (const auto& family : families())
                std::printf("%s %llu\n", family.name.c_str(), static_cast<unsigned long long>(family.volume));
        } else if (words.size() == 2 && words[0] == "gfan") {
            std::fputs(support_families::gfan_text(of_name(words[1])).c_str(), stdout);
        } else if ((words.size() == 3 || words.size() == 4) && words[0] == "run") {
            run(of_name(words[1]), std::stoi(words[2]),
                words.size() == 4 ? static_cast<unsigned>(std::stoul(words[3])) : 1);
        } else if (words.size() == 4 && words[0] == "random") {
            return compare_random(std::stoi(words[1]), std::stoull(words[2]), words[3]) ? 0 : 1;
        } else {
            std::fputs("mixed_volumes names | gfan NAME | run NAME RUNS [THREADS] | random COUNT SEED DIR\n", stderr);
            return 2;
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "mixed_volumes: %s\n", error.what());
        return 2;
    }
}
