// Ranks that are threads of this process: what speaks for itself needs no MPI.
#pragma once

#include <barrier>
#include <cstddef>
#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include <equilibria/run/ranks.hpp>

namespace tests {

using equilibria::Ranks;

/// What the ranks share.
struct Meeting {
    explicit Meeting(int size) : said(static_cast<std::size_t>(size)), all(size) {}
    std::vector<Ranks::Bytes> said;
    std::barrier<> all;
};

/// Blocks go to the ranks in turn; rank 0 takes them when all are done.
class ThreadRank final : public Ranks::Backend {
public:
    ThreadRank(std::shared_ptr<Meeting> meeting, int rank) : meeting_(std::move(meeting)), rank_(rank) {}
    int rank() const override { return rank_; }
    int size() const override { return static_cast<int>(meeting_->said.size()); }
    void for_blocks(const Ranks::Loop& loop, const equilibria::Executor&) const override {
        Ranks::Bytes done(loop.size);
        for (std::size_t k = 0; rank_ == 0 && loop.done && k < loop.size; ++k) done[k] = loop.done(k);
        broadcast(done);
        std::vector<std::size_t> open;
        for (std::size_t k = 0; k < loop.size; ++k)
            if (done[k] == 0) open.push_back(k);
        for (std::size_t first = 0; first < open.size(); first += meeting_->said.size()) {
            const std::size_t own = first + static_cast<std::size_t>(rank_);
            const auto given = gather(own < open.size() ? loop.work(open[own]) : Ranks::Bytes());
            for (std::size_t k = 0; rank_ == 0 && k < given.size() && first + k < open.size(); ++k)
                loop.take(open[first + k], given[k]);
        }
    }
    void broadcast(Ranks::Bytes& bytes) const override { bytes = gather(bytes)[0]; }
    std::vector<Ranks::Bytes> gather(const Ranks::Bytes& own) const override {
        meeting_->said[static_cast<std::size_t>(rank_)] = own;
        meeting_->all.arrive_and_wait();
        auto y = meeting_->said;
        meeting_->all.arrive_and_wait();
        return y;
    }

private:
    std::shared_ptr<Meeting> meeting_;
    int rank_;
};

/// Calls run(ranks) for each of so many.
inline void on_ranks(int size, const std::function<void(const Ranks&)>& run) {
    const auto meeting = std::make_shared<Meeting>(size);
    std::vector<std::thread> all;
    for (int rank = 0; rank < size; ++rank)
        all.emplace_back([&, rank] { run(Ranks(std::make_shared<const ThreadRank>(meeting, rank))); });
    for (auto& thread : all) thread.join();
}

}  // namespace tests
