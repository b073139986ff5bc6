// The benchmark chain of 9 and 10 links, once: 262,144 and 1,048,576 paths, with the peak of the memory (of both, where
// both are run) and a hash of the roots.
//
//   large_chain_bench [--threads K] [--seed S] [--links 9|10] [--checkpoint FILE] [--stream yes]
#include <sys/resource.h>

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <equilibria/enumerate/stream.hpp>
#include <string>

#include "../support.hpp"

namespace {

/// The same whatever the order of the roots.
template <class M>
std::uint64_t hash_of(const equilibria::Root<M>& root) {
    std::uint64_t h = root.path;
    for (const auto& q : root.q)
        for (const double part : {q.real(), q.imag()}) {
            h = (h ^ std::bit_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15;
            h ^= h >> 29;
        }
    return h;
}

template <int N>
bool run(const equilibria::RunOptions& options, bool stream) {
    using M = Chain<N>;
    std::uint64_t hash = 0;
    const auto report = [&](const auto& r, std::uint64_t distinct, std::uint64_t real) {
        const auto& n = r.paths;
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        const auto count = [](std::uint64_t k) { return static_cast<unsigned long long>(k); };
        std::printf("%5d %9llu %9llu %8llu %9llu %9llu %7llu %6s %10.1f %9.1f %9.0f %9.3f  %016llx\n", N,
                    count(n.total), count(n.finite), count(n.crossed), count(n.retracked), count(distinct), count(real),
                    r.morse() ? "yes" : "no", r.tracking_seconds, r.seconds,
                    static_cast<double>(n.total) / r.tracking_seconds,
                    static_cast<double>(usage.ru_maxrss) / (1024 * 1024), count(hash));
        return r.clean();
    };
    if (stream) {
        const auto r =
            equilibria::enumerate<M>(benchmark_chain<N>(), options,
                                     [&](const equilibria::Root<M>& root, const auto*) { hash += hash_of(root); });
        return report(r, r.distinct, r.real);
    }
    const auto r = equilibria::enumerate<M>(benchmark_chain<N>(), options);
    for (const auto& root : r.roots) hash += hash_of(root);
    return report(r, r.distinct(), r.real());
}

const char* text(int argc, char** argv, const std::string& option) {
    for (int k = 1; k + 1 < argc; k += 2)
        if (argv[k] == option) return argv[k + 1];
    return nullptr;
}
unsigned long long value(int argc, char** argv, const std::string& option, unsigned long long otherwise) {
    const char* given = text(argc, argv, option);
    return given ? std::strtoull(given, nullptr, 10) : otherwise;
}

}  // namespace

int main(int argc, char** argv) {
    equilibria::RunOptions options;
    options.executor = equilibria::threads(static_cast<unsigned>(value(argc, argv, "--threads", 1)));
    options.seed = value(argc, argv, "--seed", 1);
    const auto links = value(argc, argv, "--links", 0);
    if (const char* file = text(argc, argv, "--checkpoint")) options.checkpoint = file;
    const bool stream = text(argc, argv, "--stream") != nullptr;
    std::printf("%5s %9s %9s %8s %9s %9s %7s %6s %10s %9s %9s %9s  %s\n", "links", "paths", "finite", "crossed",
                "retracked", "distinct", "real", "Morse", "tracking/s", "all/s", "paths/s", "peak/GiB",
                "hash of the roots");
    bool clean = true;
    if (links != 10) clean = run<9>(options, stream) && clean;
    if (links != 9) clean = run<10>(options, stream) && clean;
    return clean ? 0 : 1;
}
