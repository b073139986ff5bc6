// What ranks over MPI cost beside the paths: idle time where blocks are uneven, and how many endpoints a second rank 0
// takes in, with a checkpoint and without. Run under mpirun; built with EQUILIBRIA_MPI.
//     mpirun -n 4 mpi_blocks [FOLDER]      FOLDER: where the checkpoint is written (default the current one)
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/mpi.hpp>
#include <equilibria/run/threads.hpp>
#include <equilibria/storage/endpoint_store.hpp>

using namespace equilibria;

namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// The part of all threads' time in which no block ran. Blocks sleep for 1 to `uneven` milliseconds, uniform in the
/// logarithm: more ranks than cores are as good.
double idle_part(const Ranks& ranks, std::size_t blocks, double uneven, unsigned own_threads) {
    Generator generator(1);
    std::vector<double> seconds(blocks);
    double all = 0;
    for (double& s : seconds) all += s = 1e-3 * std::pow(uneven, uniform(generator));
    ranks.any(false);  // all begin together
    const auto begin = Clock::now();
    double wall = 0;
    ranks.for_blocks({.size = blocks,
                      .done = {},
                      .work =
                          [&](std::size_t which) {
                              std::this_thread::sleep_for(std::chrono::duration<double>(seconds[which]));
                              return Ranks::Bytes(1000);
                          },
                      .take = [&](std::size_t, Ranks::BytesView) { wall = seconds_since(begin); },
                      .cancelled = {}},
                     threads(own_threads));
    return 1 - all / (wall * own_threads * ranks.size());
}

enum class Keep { nothing, in_memory, in_checkpoint };

/// Endpoints a second that rank 0 takes, of chains of so many links, in blocks of 512; the other ranks have them ready.
double intake(const Ranks& ranks, int links, std::size_t blocks, Keep keep, const std::string& folder) {
    const RuntimeSizes sizes(links, 0);
    const detail::BlockCodec codec(sizes);
    std::vector<Endpoint> ends(512);
    for (auto& end : ends) end.q = point_of_zeros<RuntimeUnknowns, double>(sizes);
    const auto ready = codec.encode(ends, 0);
    const std::string file = folder + "/mpi_blocks.ckpt";
    std::unique_ptr<detail::EndpointStore> store;
    if (ranks.first()) {
        std::filesystem::remove(file);
        if (keep == Keep::in_memory)
            store = std::make_unique<detail::EndpointStore>(blocks * ends.size(), ends.size(), sizes);
        if (keep == Keep::in_checkpoint)
            store = std::make_unique<detail::EndpointStore>(blocks * ends.size(), ends.size(), file,
                                                            detail::CheckpointFields{{"what", "intake"}}, false, sizes);
    }
    ranks.any(false);
    const auto begin = Clock::now();
    ranks.for_blocks({.size = blocks,
                      .done = {},
                      .work =
                          [&](std::size_t) {
                              // rank 0 takes: it has nothing of its own
                              if (ranks.first() && ranks.several())
                                  std::this_thread::sleep_for(std::chrono::milliseconds(20));
                              return ready;
                          },
                      .take =
                          [&](std::size_t which, Ranks::BytesView bytes) {
                              if (store) store->put(which, bytes, ends.size());
                          },
                      .cancelled = {}},
                     Executor());
    const double seconds = seconds_since(begin);
    store.reset();
    if (ranks.first()) std::filesystem::remove(file);
    return static_cast<double>(blocks * ends.size()) / seconds;
}

}  // namespace

int main(int argc, char** argv) {
    const MpiSession mpi(&argc, &argv);
    const Ranks& ranks = mpi.ranks();
    const std::string folder = argc > 1 ? argv[1] : ".";
    if (ranks.first())
        std::printf("%d ranks\n%-44s %8s %8s\n", ranks.size(), "idle part of the threads' time", "blocks", "idle");
    for (const double uneven : {1.0, 50.0})
        for (const std::size_t blocks : {std::size_t{100}, std::size_t{400}, std::size_t{1600}}) {
            const double idle = idle_part(ranks, blocks, uneven, 2);
            if (ranks.first())
                std::printf("  blocks of 1 to %2.0f ms, two threads a rank      %8zu %7.1f%%\n", uneven, blocks,
                            100 * idle);
        }
    if (ranks.first()) std::printf("%-44s %8s %12s %8s\n", "intake of rank 0", "links", "endpoints/s", "MB/s");
    for (const int links : {8, 12, 16})
        for (const auto& [keep, name] :
             {std::pair(Keep::nothing, "messages alone"), std::pair(Keep::in_memory, "in memory"),
              std::pair(Keep::in_checkpoint, "in a checkpoint")}) {
            const double rate = intake(ranks, links, 2000, keep, folder);
            const auto size = static_cast<double>(detail::BlockCodec(RuntimeSizes(links, 0)).endpoint_size());
            if (ranks.first()) std::printf("  %-42s %8d %12.3g %8.0f\n", name, links, rate, rate * size / 1e6);
        }
}
