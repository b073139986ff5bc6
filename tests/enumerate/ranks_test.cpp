// Enumerations that several ranks share are those of one, at each of them.
#include <complex>
#include <mutex>
#include <vector>

#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/enumerate/stream.hpp>
#include <equilibria/enumerate/sweep.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/paths/generic_instance.hpp>

#include "support/enumeration.hpp"
#include "support/families.hpp"
#include "support/scratch_file.hpp"
#include "support/thread_ranks.hpp"

using namespace equilibria;

namespace {

/// Catch's macros are for one thread: what each rank found is compared afterwards.
template <class Found>
std::vector<Found> at_each(int size, const std::function<Found(const Ranks&)>& run) {
    std::vector<Found> y(static_cast<std::size_t>(size));
    tests::on_ranks(size, [&](const Ranks& ranks) { y[static_cast<std::size_t>(ranks.rank())] = run(ranks); });
    return y;
}

}  // namespace

TEST_CASE("a chain's equilibria and their proofs are the same at each of several ranks as at one") {
    const auto p = tests::benchmark_chain<4>();
    const auto alone = enumerate<tests::Chain<4>>(p);
    const auto proof = prove(alone);
    for (const int size : {2, 3}) {
        const auto found =
            at_each<std::pair<RootSet<tests::Chain<4>>, Proof<tests::Chain<4>>>>(size, [&](const Ranks& ranks) {
                auto set = enumerate<tests::Chain<4>>(p, {.ranks = ranks});
                auto proved = prove(set, {.ranks = ranks});
                return std::pair(std::move(set), std::move(proved));
            });
        for (const auto& [set, proved] : found) {
            CHECK(tests::identical(set, alone));
            CHECK(proved.complete);
            CHECK(proved.by_index == proof.by_index);
            for (std::size_t k = 0; k < proof.certificates.size(); ++k) {
                const Certificate &a = proved.certificates[k], &b = proof.certificates[k];
                CHECK((a.path == b.path && a.exists == b.exists && a.distinct == b.distinct));
                CHECK((a.reality == b.reality && a.index == b.index && a.digits == b.digits && a.radius == b.radius));
            }
        }
    }
}

TEST_CASE("so are those from a polyhedral start, and from a solved instance") {
    const families::LoadedAngles model{4, families::complete(4)};
    const auto p = families::generic(model.parameters(), 1), q = families::generic(model.parameters(), 2);
    const auto alone = enumerate_from<Polyhedral>(model, p);
    const auto followed = enumerate(model, alone, q);
    const auto found =
        at_each<std::pair<RootSet<RuntimeUnknowns>, RootSet<RuntimeUnknowns>>>(2, [&](const Ranks& ranks) {
            auto set = enumerate_from<Polyhedral>(model, p, {.ranks = ranks});
            auto next = enumerate(model, set, q, {.ranks = ranks});
            return std::pair(std::move(set), std::move(next));
        });
    for (const auto& [set, next] : found) {
        CHECK(set.roots.size() == 70);
        CHECK(tests::identical(set, alone));
        CHECK(tests::identical(next, followed));
    }
}

TEST_CASE("paths that need more digits are shared as well, and are written as they are") {
    const auto system = sparse_system(families::chandra(7));
    const auto alone = solve_polyhedral(system, {}, {}, more_digits);
    const auto found = at_each<ComplexRoots<>>(
        2, [&](const Ranks& ranks) { return solve_polyhedral(system, {.ranks = ranks}, {}, more_digits); });
    for (const auto& set : found) {
        CHECK(set.paths.finite == alone.paths.finite);
        CHECK(set.paths.more_digits == alone.paths.more_digits);
        REQUIRE(set.roots.size() == alone.roots.size());
        for (std::size_t k = 0; k < set.roots.size(); ++k) CHECK(set.roots[k].q == alone.roots[k].q);
    }
}

TEST_CASE("roots that are streamed are handed on at rank 0 alone") {
    using M = tests::Chain<3>;
    const auto p = tests::benchmark_chain<3>();
    const tests::ScratchFile scratch("ranks.ckpt");
    std::mutex guard;
    std::vector<int> at;
    const auto found = at_each<StreamedRoots<M>>(2, [&](const Ranks& ranks) {
        return enumerate<M>(p, {.ranks = ranks, .checkpoint = scratch.name()},
                            [&](const Root<M>&, const Equilibrium<M>*) {
                                const std::lock_guard lock(guard);
                                at.push_back(ranks.rank());
                            });
    });
    CHECK(found[0].distinct == 64);
    CHECK(found[0].clean());
    CHECK(found[1].distinct == 0);
    CHECK(at == std::vector<int>(64, 0));
}

TEST_CASE("streamed roots are the same where keys go to files for want of memory") {
    using M = tests::Chain<4>;
    const auto p = tests::benchmark_chain<4>();
    const auto with_memory = [&](std::uint64_t bytes) {
        const tests::ScratchFile scratch("few_keys.ckpt");
        std::vector<std::pair<std::uint64_t, std::int32_t>> roots;
        const auto set = enumerate<M>(
            p, {.checkpoint = scratch.name(), .key_memory = bytes},
            [&](const Root<M>& root, const Equilibrium<M>*) { roots.emplace_back(root.path, root.paths); });
        CHECK(set.clean());
        CHECK(set.distinct == 256);
        return roots;
    };
    const auto whole = with_memory(std::uint64_t{1} << 30);
    CHECK(with_memory(1000) == whole);
    CHECK(with_memory(1) == whole);
}

TEST_CASE("ranks that do another run are refused, by all") {
    const auto p = tests::benchmark_chain<3>();
    const auto said = at_each<std::string>(3, [&](const Ranks& ranks) -> std::string {
        try {
            enumerate<tests::Chain<3>>(p, {.seed = ranks.rank() == 2 ? 5u : 1u, .ranks = ranks});
        } catch (const RankError& error) {
            return error.what();
        }
        return "";
    });
    for (const auto& text : said)
        CHECK_THAT(text, Catch::Contains("rank 2 does another run than rank 0: its seed is 5, rank 0's is 1"));
}

TEST_CASE("the points of a sweep come at rank 0, its counts at all") {
    using M = mechanisms::TwoLinkChain;
    const auto grid = parameter_grid(RuntimeArray<double>{0.3, 1.5, 2.0}, {{M::omega, 0.5, 4.5, 200}});
    std::vector<std::uint32_t> alone;
    const auto counts = sweep<M>(grid, [&](const SweptPoint& point) { alone.push_back(point.real); });
    using Found = std::pair<std::vector<std::uint32_t>, SweepCounts>;
    const auto found = at_each<Found>(2, [&](const Ranks& ranks) {
        Found y;
        y.second = sweep<M>(grid, [&](const SweptPoint& point) { y.first.push_back(point.real); }, {.ranks = ranks});
        return y;
    });
    CHECK(found[0].first == alone);
    CHECK(found[1].first.empty());
    for (const auto& [_, of] : found) {
        CHECK(of.done == grid.size);
        CHECK(of.paths == counts.paths);
        CHECK(of.by_real == counts.by_real);
    }
}
