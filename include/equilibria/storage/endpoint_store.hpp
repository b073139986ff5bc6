/// \file
/// Where the endpoints of an enumeration are: in memory, in a checkpoint, or in both. They come in blocks, from any
/// thread, and are looked at when all threads are done.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/storage/checkpoint.hpp>

namespace equilibria::detail {

template <class M>
class EndpointStore {
public:
    /// For `size` paths in memory.
    EndpointStore(std::uint64_t size, std::uint64_t block)
        : size_(size), block_(block), has_((size + block - 1) / block), ends_(size) {}

    /// In a checkpoint, with what it holds already; `in_memory`: also there, which is faster. Throws CheckpointError.
    EndpointStore(std::uint64_t size, std::uint64_t block, std::string path,
                  const std::vector<CheckpointFile::Field>& header, bool in_memory)
        : size_(size), block_(block), has_((size + block - 1) / block), ends_(in_memory ? size : 0) {
        file_ = std::make_unique<Checkpoint<M>>(std::move(path), header, size, block,
                                                [&](std::uint64_t which, std::span<const Endpoint<M>> ends,
                                                    std::uint64_t retracked) { enter(which, ends, retracked); });
    }

    std::uint64_t size() const { return size_; }
    std::uint64_t block() const { return block_; }
    /// Paths that are finished, and how many of them were tracked again.
    std::uint64_t finished() const { return finished_ - unsettled_.size(); }
    std::uint64_t retracked() const { return retracked_; }
    bool complete() const { return finished() == size_; }

    bool has_block(std::uint64_t which) const { return has_[which] != 0; }
    bool finished(std::uint64_t k) const { return has_[k / block_] && (unsettled_.empty() || !unsettled_.contains(k)); }

    /// Keeps a finished block; with a checkpoint it is on the disk afterwards. From any thread, each block once.
    void put(std::uint64_t which, std::span<const Endpoint<M>> ends, std::uint64_t retracked) {
        const std::lock_guard lock(*guard_);
        if (file_) file_->append(which, ends, retracked);
        enter(which, ends, retracked);
    }

    /// A finished endpoint; the reference outlives the next call, not the one after it.
    const Endpoint<M>& operator[](std::uint64_t k) {
        if (!ends_.empty()) return ends_[k];
        if (const auto at = replaced_.find(k); at != replaced_.end()) return at->second;
        const std::uint64_t which = k / block_, first = which * block_;
        for (std::size_t j = 0; j < windows_.size(); ++j)
            if (const Window& w = windows_[j]; k >= w.first && k - w.first < w.ends.size()) {
                latest_ = j;
                return w.ends[k - w.first];
            }
        // all of the block for those who go through them in order, else one endpoint
        oldest_ = (oldest_ + 1) % windows_.size();
        if (oldest_ == latest_) oldest_ = (oldest_ + 1) % windows_.size();
        latest_ = oldest_;
        Window& w = windows_[latest_];
        const bool in_order = k == first || k == last_ + 1;
        w.first = in_order ? first : k;
        w.ends.resize(in_order ? file_->size(which) : 1);
        file_->read(which, w.first - first, w.ends);
        last_ = w.first + w.ends.size() - 1;
        return w.ends[k - w.first];
    }
    /// Another endpoint for a path. Not written to the checkpoint: it follows from what is there.
    void replace(std::uint64_t k, const Endpoint<M>& end) {
        if (!ends_.empty())
            ends_[k] = end;
        else
            replaced_[k] = end;
    }
    /// The path counts as not finished.
    void unsettle(std::uint64_t k) { unsettled_.insert(k); }

private:
    struct Window {
        std::uint64_t first = 0;
        std::vector<Endpoint<M>> ends;
    };

    void enter(std::uint64_t which, std::span<const Endpoint<M>> ends, std::uint64_t retracked) {
        if (!ends_.empty()) std::copy(ends.begin(), ends.end(), &ends_[which * block_]);
        has_[which] = 1;
        finished_ += ends.size();
        retracked_ += retracked;
    }

    std::uint64_t size_, block_, finished_ = 0, retracked_ = 0;
    std::vector<std::uint8_t> has_;
    std::vector<Endpoint<M>> ends_;
    std::unique_ptr<Checkpoint<M>> file_;
    std::unique_ptr<std::mutex> guard_ = std::make_unique<std::mutex>();
    std::map<std::uint64_t, Endpoint<M>> replaced_;
    std::set<std::uint64_t> unsettled_;
    std::array<Window, 3> windows_;
    std::size_t oldest_ = 0, latest_ = 0;
    std::uint64_t last_ = ~std::uint64_t{0};
};

}  // namespace equilibria::detail
