// Prints what is found with an executor of four threads, to the last bit: without threads (EQUILIBRIA_NO_THREADS) it is
// the same. That the headers compile then is a part of the test.
#include <cstdio>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/run/mutex.hpp>
#include <equilibria/run/threads.hpp>

int main() {
#ifdef EQUILIBRIA_NO_THREADS
    constexpr unsigned workers = 1;
#else
    constexpr unsigned workers = 4;
#endif
    equilibria::RunOptions run;
    run.executor = equilibria::threads(4);
    if (run.executor.workers() != workers) return 1;

    equilibria::detail::Mutex mutex;
    equilibria::detail::OnceFlag flag;
    int calls = 0;
    for (int k = 0; k < 2; ++k) {
        equilibria::detail::Lock lock(mutex);
        lock.unlock();
        lock.lock();
        call_once(flag, [&] { ++calls; });
    }
    if (calls != 1) return 1;

    const auto found = equilibria::enumerate<equilibria::mechanisms::TwoLinkChain>({.3, 1.5, 2.0}, run);
    const auto proof = equilibria::prove(found, run);
    for (const auto& e : found.equilibria) std::printf("%a %a  %d %a\n", e.q[0], e.q[1], e.index, e.energy);
    std::printf("%llu steps, %s\n", static_cast<unsigned long long>(found.paths.steps),
                proof.complete ? "complete" : "not complete");
}
