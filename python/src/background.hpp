/// \file
/// Long calls from Python: they run in a thread of their own without the interpreter's lock, while the calling thread
/// looks for signals and tells a Python function of the progress, each some 20 times a second.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>

#include <pybind11/pybind11.h>

#include <equilibria/run/run_options.hpp>

namespace equilibria::python {

/// Whether a call may be handed RunOptions::cancel.
enum class Cancel {
    by_flag,      ///< it ends soon after the flag is set
    by_progress,  ///< it ends where it next reports progress, by an exception
};

/// Thrown out of a report of progress by a run that has been interrupted.
struct Interrupted {};

/// How long a call may take.
struct Limit {
    std::optional<double> seconds;  ///< none: as long as it takes
    bool kept = false;              ///< what is found until then is returned; else TimeoutError is raised
};

/// What work(run) returns. What a signal's handler or `progress(done, all)` throws ends the run and is thrown here, and
/// so is the end of a limit; exceptions of the work itself are thrown as well.
template <class Work>
auto in_background(RunOptions run, const pybind11::object& progress, Cancel how, const Work& work,
                   const Limit& limit = {}) {
    namespace py = pybind11;
    using Result = std::invoke_result_t<const Work&, const RunOptions&>;
    std::atomic<std::uint64_t> done = 0, all = 0;
    std::atomic<bool> cancel = false;
    if (how == Cancel::by_flag) run.cancel = &cancel;
    run.progress = [&](std::uint64_t now, std::uint64_t of) {
        done.store(now, std::memory_order_relaxed);
        all.store(of, std::memory_order_relaxed);
        if (how == Cancel::by_progress && cancel.load(std::memory_order_relaxed)) throw Interrupted{};
    };

    std::mutex guard;
    std::condition_variable ended;
    bool has_ended = false;
    const auto begin = std::chrono::steady_clock::now();
    const auto is_over = [&] {
        return limit.seconds &&
               std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() >= *limit.seconds;
    };
    std::optional<Result> result;
    std::exception_ptr failure, interruption;
    {
        const py::gil_scoped_release unlocked;
        std::thread worker([&] {
            try {
                result.emplace(work(std::as_const(run)));
            } catch (...) {
                failure = std::current_exception();
            }
            const std::lock_guard lock(guard);
            has_ended = true;
            ended.notify_one();
        });
        std::unique_lock lock(guard);
        while (!ended.wait_for(lock, std::chrono::milliseconds(50), [&] { return has_ended; })) {
            if (interruption) continue;
            lock.unlock();
            {
                const py::gil_scoped_acquire locked;
                try {
                    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
                    if (!progress.is_none()) progress(done.load(), all.load());
                    if (is_over()) {
                        cancel = true;
                        if (!limit.kept) {
                            const std::string text =
                                "limit = " + py::str(py::float_(*limit.seconds)).cast<std::string>() +
                                ": the call has not ended in so many seconds; more of them, or None, let it end";
                            PyErr_SetString(PyExc_TimeoutError, text.c_str());
                            throw py::error_already_set();
                        }
                    }
                } catch (...) {
                    interruption = std::current_exception();
                    cancel = true;
                }
            }
            lock.lock();
        }
        lock.unlock();
        worker.join();
    }
    if (interruption) std::rethrow_exception(interruption);
    if (failure) std::rethrow_exception(failure);
    if (!progress.is_none() && all > 0) progress(done.load(), all.load());
    return std::move(*result);
}

}  // namespace equilibria::python
