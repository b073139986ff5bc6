// The benchmark chain of 9 and 10 links, once: 262,144 and 1,048,576 paths, with the peak of the memory.
//
//   large_chain_bench [--threads K] [--seed S] [--links 9|10]
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <equilibria/enumerate/enumerate.hpp>
#include <string>

#include "../support.hpp"

namespace {

template <int N>
bool run(const equilibria::EnumerateOptions& options) {
    const auto r = equilibria::enumerate<Chain<N>>(benchmark_chain<N>(), options);
    const auto& n = r.paths;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto count = [](std::uint64_t k) { return static_cast<unsigned long long>(k); };
    std::printf("%5d %9llu %9llu %8llu %9llu %9llu %7llu %6s %10.1f %9.1f %9.0f %9.2f\n", N, count(n.total),
                count(n.finite), count(n.crossed), count(n.retracked), count(r.distinct()), count(r.real()),
                r.morse() ? "yes" : "no", r.tracking_seconds, r.seconds,
                static_cast<double>(n.total) / r.tracking_seconds,
                static_cast<double>(usage.ru_maxrss) / (1024 * 1024));
    return r.clean();
}

unsigned long long value(int argc, char** argv, const std::string& option, unsigned long long otherwise) {
    for (int k = 1; k + 1 < argc; k += 2)
        if (argv[k] == option) return std::strtoull(argv[k + 1], nullptr, 10);
    return otherwise;
}

}  // namespace

int main(int argc, char** argv) {
    equilibria::EnumerateOptions options;
    options.threads = static_cast<unsigned>(value(argc, argv, "--threads", 1));
    options.seed = value(argc, argv, "--seed", 1);
    const auto links = value(argc, argv, "--links", 0);
    std::printf("%5s %9s %9s %8s %9s %9s %7s %6s %10s %9s %9s %9s\n", "links", "paths", "finite", "crossed",
                "retracked", "distinct", "real", "Morse", "tracking/s", "all/s", "paths/s", "peak/GiB");
    bool clean = true;
    if (links != 10) clean = run<9>(options) && clean;
    if (links != 9) clean = run<10>(options) && clean;
    return clean ? 0 : 1;
}
