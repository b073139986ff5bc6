// Enumerations that are cancelled, killed and resumed, and those that are streamed: the same bytes as of one that was
// never interrupted.
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <chrono>
#include <csignal>
#include <limits>
#include <sstream>
#include <thread>

#include <equilibria/enumerate/stream.hpp>
#include <equilibria/storage/checkpoint.hpp>

#include "support/enumeration.hpp"
#include "support/models.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;
using tests::Chain;
using tests::ScratchFile;

namespace {

/// How `text` begins before the part of it that depends on the compiler.
bool starts_with(const std::string& text, const std::string& begin) { return text.rfind(begin, 0) == 0; }

template <class M, class StartSystem = NaturalStart<M>>
std::string refused(const Parameters<M>& p, const RunOptions& run, const TrackerOptions& tracker = {}) {
    const std::string begin = "checkpoint = " + run.checkpoint + ": ";
    const std::string said = tests::refusal([&] { enumerate<M, StartSystem>(p, run, tracker); });
    return starts_with(said, begin) ? said.substr(begin.size()) : said;
}

/// Cancels `run`, an enumeration with the given options, after about `part` of the paths, again and again, until it
/// gets to its end; returns the result and how often it was cancelled.
template <class Run>
auto with_interruptions(RunOptions options, double part, int& cancellations, Run&& run) {
    std::atomic<bool> cancel = false;
    std::uint64_t done = 0, before = 0;
    options.cancel = &cancel;
    options.progress = [&](std::uint64_t now, std::uint64_t all) {
        done = now;
        if (static_cast<double>(now - before) >= part * static_cast<double>(all)) cancel = true;
    };
    for (cancellations = 0;; ++cancellations) {
        cancel = false;
        before = done;
        const auto r = run(options);
        REQUIRE(r.paths.accounted_for());
        if (!r.cancelled()) return r;
        CHECK_FALSE(r.clean());
        CHECK_FALSE(r.morse_applies());
        // at least one block was finished
        REQUIRE(done > before);
    }
}

/// Makes paths cross.
TrackerOptions careless() {
    return {.contraction = 0.05, .largest_contraction = 0.1, .largest_turn = 0.5, .pole_fraction = 0.99};
}

/// Of one angle and three coordinates.
const RuntimeSizes sizes(1, 3);

Endpoint random_endpoint(Generator& generator) {
    Endpoint e;
    e.q = point_of_zeros<RuntimeUnknowns, double>(sizes);
    const auto any = [&] { return std::bit_cast<double>(generator()); };
    for (auto& z : e.q.c) z = {any(), any()};
    for (auto& z : e.q.s) z = {any(), any()};
    for (auto& z : e.q.x) z = {any(), any()};
    e.t = any();
    e.steps = static_cast<std::int32_t>(generator());
    e.arrival = static_cast<Arrival>(generator() % 3);
    e.status = static_cast<PathStatus>(generator() % 4);
    e.reason = static_cast<FailureReason>(generator() % 4);
    e.precision = static_cast<Precision>(generator() % 2);
    e.winding_number = static_cast<std::int16_t>(generator());
    e.evidence = {any(), any(), any()};
    return e;
}

/// Each field's bits, one after the other.
std::vector<std::uint64_t> bits(const Endpoint& e) {
    std::vector<std::uint64_t> all;
    const auto add = [&](double x) { all.push_back(std::bit_cast<std::uint64_t>(x)); };
    for (const auto& z : e.q.c) add(z.re), add(z.im);
    for (const auto& z : e.q.s) add(z.re), add(z.im);
    for (const auto& z : e.q.x) add(z.re), add(z.im);
    add(e.t);
    for (const double x : {e.evidence.residual, e.evidence.condition, e.evidence.correction}) add(x);
    for (const std::int64_t k : {std::int64_t{e.steps}, std::int64_t{e.winding_number}})
        all.push_back(static_cast<std::uint64_t>(k));
    all.push_back(static_cast<std::uint64_t>(e.arrival));
    all.push_back(static_cast<std::uint64_t>(e.status));
    all.push_back(static_cast<std::uint64_t>(e.reason));
    all.push_back(static_cast<std::uint64_t>(e.precision));
    return all;
}

}  // namespace

TEST_CASE("every field of an endpoint comes back bit by bit, whatever it holds") {
    using Checkpoint = detail::Checkpoint;
    const ScratchFile scratch("fields.ckpt");
    const detail::CheckpointField name{"model", "everything"};
    Generator generator(1);
    std::vector<Endpoint> ends;
    for (int k = 0; k < 25; ++k) ends.push_back(random_endpoint(generator));
    ends[0].t = -0.0;
    ends[1].t = std::numeric_limits<double>::signaling_NaN();
    {
        Checkpoint file(scratch.name(), {name}, 25, 10, [](auto...) { FAIL("a new file holds a block"); }, sizes);
        file.append(2, std::span<const Endpoint>(ends).subspan(20, 5), 3);
        file.append(0, std::span<const Endpoint>(ends).first(10), 0);
    }
    std::vector<std::uint64_t> blocks;
    const Checkpoint file(
        scratch.name(), {name}, 25, 10,
        [&](std::uint64_t block, std::span<const Endpoint> found, std::uint64_t retracked) {
            blocks.push_back(block);
            CHECK(retracked == (block == 2 ? 3 : 0));
            REQUIRE(found.size() == (block == 2 ? 5 : 10));
            for (std::size_t k = 0; k < found.size(); ++k) CHECK(bits(found[k]) == bits(ends[10 * block + k]));
        },
        sizes);
    CHECK(blocks == std::vector<std::uint64_t>{2, 0});
    CHECK(file.has(0));
    CHECK_FALSE(file.has(1));
    CHECK(file.size(1) == 10);
    CHECK(file.size(2) == 5);
    std::vector<Endpoint> two(2);
    file.read(2, 3, two);
    CHECK(bits(two[0]) == bits(ends[23]));
    CHECK(bits(two[1]) == bits(ends[24]));
    // 5 points of the plane, 4 numbers, and the rest: 4 + 2 + 4 bytes
    CHECK(detail::BlockCodec(sizes).endpoint_size() == 5 * 16 + 4 * 8 + 10);
    CHECK(scratch.bytes().size() == 1536 + std::string("model: everything\n").size() + 2 * (16 + 16) +
                                        15 * detail::BlockCodec(sizes).endpoint_size());
}

TEST_CASE("records that do not fit the run are refused with their number") {
    const detail::CheckpointField name{"model", "everything"};
    const auto said = [&](const std::vector<detail::Bytes>& records) -> std::string {
        const ScratchFile scratch("misfits.ckpt");
        {
            detail::CheckpointFile file(scratch.name(), {name}, [](auto...) { return std::string(); });
            for (const auto& r : records) file.append(r);
        }
        const auto before = scratch.bytes();
        std::string wrong = "nothing";
        try {
            detail::Checkpoint(scratch.name(), {name}, 25, 10, [](auto...) {}, sizes);
        } catch (const CheckpointError& error) {
            wrong = error.wrong().substr(0, error.wrong().find(';'));
        }
        CHECK(scratch.bytes() == before);
        return wrong;
    };
    const auto record = [](std::uint8_t block, std::size_t size) {
        detail::Bytes bytes(16 + size * detail::BlockCodec(sizes).endpoint_size());
        bytes[0] = block;
        return bytes;
    };
    CHECK(said({record(0, 10), record(1, 10), record(2, 5)}) == "nothing");
    CHECK(said({record(0, 10), detail::Bytes(15)}) == "record 1 is too short");
    CHECK(said({record(3, 10)}) == "record 0 is of a block that the run does not have");
    CHECK(said({record(1, 10), record(0, 10), record(1, 10)}) == "record 2 repeats a block");
    CHECK(said({record(2, 10)}) == "record 0 has a wrong size");
    auto unknown = record(0, 10);
    unknown.back() = 4;
    CHECK(said({unknown}) == "record 0 holds an unknown status");
}

TEST_CASE("cancelled and resumed, the result is that of a run that was never interrupted") {
    const auto p = tests::benchmark_chain<4>();
    const auto whole = enumerate<Chain<4>>(p);
    for (const unsigned count : {1u, 2u}) {
        const ScratchFile scratch("resumed.ckpt");
        int cancellations = 0;
        const auto resumed =
            with_interruptions({.executor = threads(count), .checkpoint = scratch.name()}, 0.2, cancellations,
                               [&](const RunOptions& o) { return enumerate<Chain<4>>(p, o); });
        CHECK(cancellations > 0);
        CHECK(tests::identical(resumed, whole));
        CHECK(resumed.paths.tracked == whole.paths.tracked);
        // and once more, from the finished file
        const auto before = scratch.bytes();
        const auto read = enumerate<Chain<4>>(p, {.executor = threads(3 - count), .checkpoint = scratch.name()});
        CHECK(tests::identical(read, whole));
        CHECK(scratch.bytes() == before);
    }
}

TEST_CASE("paths to infinity, failed, singular and retracked ones are resumed as they are") {
    TrackerOptions few_steps;
    few_steps.most_steps = 12;
    Generator generator(5);
    auto crossing = tests::random_chain<3>(generator);
    for (int k = 1; k < 36; ++k) crossing = tests::random_chain<3>(generator);
    const auto rotating = tests::benchmark_chain<3>(), resting = tests::benchmark_chain<3>(0.0),
               degenerate = tests::chain<3>({1, 1, 1}, {1, 1, 1}, 1.7, 0);
    const auto check = [](const Parameters<Chain<3>>& p, const TrackerOptions& tracker, std::uint64_t seed = 1) {
        const auto whole = enumerate<Chain<3>>(p, {.seed = seed}, tracker);
        const ScratchFile scratch("kinds.ckpt");
        int cancellations = 0;
        const auto resumed =
            with_interruptions({.seed = seed, .checkpoint = scratch.name()}, 0.1, cancellations,
                               [&](const RunOptions& o) { return enumerate<Chain<3>>(p, o, tracker); });
        CHECK(tests::identical(resumed, whole));
        CHECK(resumed.failures.size() == whole.failures.size());
        return whole.paths;
    };
    CHECK(check(rotating, few_steps).retracked > 0);
    CHECK(check(resting, {}).at_infinity > 0);
    CHECK(check(degenerate, {}).singular > 0);
    check(crossing, careless(), 72);
}

TEST_CASE("a parameter homotopy is resumed too, from the same solved instance only") {
    const auto solved = enumerate<Chain<3>>(tests::benchmark_chain<3>());
    Generator generator(11);
    const auto p = tests::random_chain<3>(generator);
    const auto whole = enumerate(solved, p);
    const ScratchFile scratch("parameter.ckpt");
    int cancellations = 0;
    const auto resumed = with_interruptions({.checkpoint = scratch.name()}, 0.2, cancellations,
                                            [&](const RunOptions& o) { return enumerate(solved, p, o); });
    CHECK(tests::identical(resumed, whole));
    const auto other = enumerate<Chain<3>>(tests::benchmark_chain<3>(1.6));
    const auto said = tests::refusal([&] { enumerate(other, p, {.checkpoint = scratch.name()}); });
    CHECK(said.find(": is of another run: its homotopy is ") != std::string::npos);
    CHECK(refused<Chain<3>>(p, {.checkpoint = scratch.name()})
              .find("its start is a solved instance, this run's is reflected") != std::string::npos);
}

TEST_CASE("the checkpoint of another model, seed, parameter, start or option is refused by name and left alone") {
    const ScratchFile scratch("other_run.ckpt");
    const auto p = tests::benchmark_chain<3>();
    const RunOptions options{.seed = 5, .checkpoint = scratch.name()};
    enumerate<Chain<3>>(p, options);
    const auto before = scratch.bytes();
    const auto said = [&](auto change) {
        auto q = p;
        auto o = options;
        TrackerOptions tracker;
        change(q, o, tracker);
        return refused<Chain<3>>(q, o, tracker);
    };
    CHECK(starts_with(said([](auto&, auto& o, auto&) { o.seed = 6; }),
                      "is of another run: its seed is 5, this run's is 6; its homotopy is "));
    CHECK(starts_with(said([](auto& q, auto&, auto&) { q[3] = 0.5; }),
                      "is of another run: its parameters[3] is 1.05, this run's is 0.5; its homotopy is "));
    CHECK(said([](auto&, auto&, auto& o) { o.contraction = 0.001; }) ==
          "is of another run: its contraction is 0.002, this run's is 0.001");
    CHECK(said([](auto&, auto&, auto& o) { o.largest_contraction = 0.03; }) ==
          "is of another run: its largest_contraction is 0.050000000000000003, this run's is 0.029999999999999999");
    CHECK(said([](auto&, auto&, auto& o) { o.largest_turn = 0.25; }) ==
          "is of another run: its largest_turn is 0.40000000000000002, this run's is 0.25");
    CHECK(said([](auto&, auto&, auto& o) { o.pole_fraction = 0.5; }) ==
          "is of another run: its pole_fraction is 0.40000000000000002, this run's is 0.5");
    CHECK(said([](auto&, auto&, auto& o) { o.smallest_step = 0.0009765625; }) ==
          "is of another run: its smallest_step is 9.9999999999999998e-13, this run's is 0.0009765625");
    CHECK(said([](auto&, auto&, auto& o) { o.endgame_start = 0.0625; }) ==
          "is of another run: its endgame_start is 1.0000000000000001e-05, this run's is 0.0625");
    CHECK(said([](auto&, auto&, auto& o) { o.single_precision = false; }) ==
          "is of another run: its single_precision is yes, this run's is no");
    CHECK(said([](auto&, auto&, auto& o) { o.most_steps = 100; }) ==
          "is of another run: its most_steps is 3000, this run's is 100");
    CHECK(said([](auto&, auto& o, auto&) { o.executor = threads(2); }) == "nothing was refused");
    CHECK(refused<Chain<3>, TotalDegree<Chain<3>>>(p, options)
              .find("its start is reflected, this run's is total degree") != std::string::npos);
    const auto other_model = refused<Chain<2>>(tests::benchmark_chain<2>(), options);
    CHECK(starts_with(other_model, "is of another run: its model is "));
    CHECK(other_model.find("RotatingChain<3> (3 angles, 0 coordinates, ") != std::string::npos);
    CHECK(other_model.find("RotatingChain<2> (2 angles, 0 coordinates, ") != std::string::npos);
    CHECK(scratch.bytes() == before);
}

TEST_CASE("a checkpoint that is cut or damaged is refused and left alone") {
    const ScratchFile scratch("damaged.ckpt");
    const auto p = tests::benchmark_chain<3>();
    const RunOptions options{.checkpoint = scratch.name()};
    enumerate<Chain<3>>(p, options);
    const auto sound = scratch.bytes();
    auto damaged = sound;
    damaged[sound.size() - 100] ^= 1;
    scratch.write(damaged);
    const std::string said = refused<Chain<3>>(p, options);
    CHECK(starts_with(said, "record "));
    CHECK(said.find(" is damaged (checksum); restore the file from a copy, or name another one to start anew") !=
          std::string::npos);
    CHECK(scratch.bytes() == damaged);
    auto cut = sound;
    cut.pop_back();
    scratch.write(cut);
    CHECK(refused<Chain<3>>(p, options) == "is truncated: " + std::to_string(sound.size()) + " bytes were committed, " +
                                               std::to_string(cut.size()) + " are there");
    CHECK(scratch.bytes() == cut);
}

TEST_CASE("without a checkpoint a cancelled run says what it did not finish") {
    std::atomic<bool> cancel = true;
    const auto none = enumerate<Chain<3>>(tests::benchmark_chain<3>(), {.cancel = &cancel});
    CHECK(none.cancelled());
    CHECK(none.paths.accounted_for());
    CHECK(none.paths.total == 64);
    CHECK(none.paths.cancelled == 56);
    CHECK(none.paths.finite == 8);  // those that rest
    CHECK(none.paths.tracked == 0);
    CHECK_FALSE(none.clean());
    std::ostringstream out;
    out << none;
    CHECK(out.str().find("; CANCELLED: 56 paths are not finished") != std::string::npos);
    CHECK(out.str().find("Morse") == std::string::npos);
    cancel = false;
    CHECK(tests::identical(enumerate<Chain<3>>(tests::benchmark_chain<3>(), {.cancel = &cancel}),
                           enumerate<Chain<3>>(tests::benchmark_chain<3>())));
}

TEST_CASE("streamed roots are those of a run that keeps them, and take no part in a cancelled one") {
    const auto check = [](const Parameters<Chain<3>>& p, RunOptions options, const TrackerOptions& tracker = {}) {
        const auto whole = enumerate<Chain<3>>(p, options, tracker);
        const ScratchFile scratch("streamed.ckpt");
        options.checkpoint = scratch.name();
        std::vector<Root<Chain<3>>> roots;
        std::vector<Equilibrium<Chain<3>>> equilibria;
        int cancellations = 0;
        const auto streamed = with_interruptions(options, 0.3, cancellations, [&](const RunOptions& o) {
            CHECK(roots.empty());
            const auto take = [&](const Root<Chain<3>>& root, const Equilibrium<Chain<3>>* e) {
                roots.push_back(root);
                if (e) equilibria.push_back(*e);
            };
            return enumerate<Chain<3>>(p, o, take, tracker);
        });
        RootSet<Chain<3>> kept = whole;
        std::sort(roots.begin(), roots.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
        kept.roots = roots;
        const auto order = [](const auto& e) { return std::tuple(e.index, e.nullity, e.path); };
        std::sort(equilibria.begin(), equilibria.end(), [&](auto& a, auto& b) { return order(a) < order(b); });
        kept.equilibria = equilibria;
        kept.paths = streamed.paths;
        CHECK(tests::identical(kept, whole));
        CHECK(streamed.distinct == whole.distinct());
        CHECK(streamed.real == whole.real());
        CHECK(streamed.degenerate == whole.degenerate());
        CHECK(streamed.by_index == whole.by_index());
        CHECK(streamed.clean() == whole.clean());
        CHECK(streamed.morse() == whole.morse());
        CHECK(streamed.failures.size() == whole.failures.size());
        CHECK(streamed.largest_real_imaginary == whole.largest_real_imaginary);
        CHECK(streamed.smallest_nonreal_imaginary == whole.smallest_nonreal_imaginary);
    };
    check(tests::benchmark_chain<3>(), {.executor = threads(2)});
    check(tests::benchmark_chain<3>(0.0), {});
    Generator generator(5);
    auto crossing = tests::random_chain<3>(generator);
    for (int k = 1; k < 36; ++k) crossing = tests::random_chain<3>(generator);
    check(tests::chain<3>({1, 1, 1}, {1, 1, 1}, 1.7, 0), {});
    check(crossing, {.seed = 72}, careless());  // one path does cross, with g++

    const auto ignore = [](const auto&, const auto*) {};
    CHECK(tests::refusal([&] { enumerate<Chain<3>>(tests::benchmark_chain<3>(), {}, ignore); }) ==
          "checkpoint = '': must name a file: roots that are streamed wait there");
}

TEST_CASE("killed at any moment and resumed, the result is the same", "[kill]") {
    const auto p = tests::benchmark_chain<4>();
    const auto whole = enumerate<Chain<4>>(p);
    Generator generator(3);
    int kills = 0;
    for (int round = 0; round < 4; ++round) {
        const ScratchFile scratch("killed.ckpt");
        const RunOptions options{.executor = threads(round % 2 == 0 ? 1u : 2u), .checkpoint = scratch.name()};
        for (int attempt = 0;; ++attempt) {
            const pid_t child = fork();
            REQUIRE(child >= 0);
            if (child == 0) {
                // slow enough to be hit: a real run's blocks take a second
                RunOptions slow = options;
                slow.progress = [](auto, auto) { std::this_thread::sleep_for(std::chrono::milliseconds(2)); };
                _exit(enumerate<Chain<4>>(p, slow).clean() ? 0 : 1);
            }
            std::this_thread::sleep_for(std::chrono::microseconds(static_cast<int>(uniform(generator, 0, 8000))));
            if (attempt < 50) kill(child, SIGKILL);
            int status = 0;
            REQUIRE(waitpid(child, &status, 0) == child);
            if (WIFEXITED(status)) {
                CHECK(WEXITSTATUS(status) == 0);
                break;
            }
            ++kills;
        }
        CHECK(tests::identical(enumerate<Chain<4>>(p, options), whole));
    }
    CHECK(kills > 4);
}
