/// \file
/// Where the endpoints of an enumeration are: in memory, in a checkpoint, or in both. They come in blocks, from any
/// thread, and are looked at when all threads are done.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/huge_pages.hpp>
#include <equilibria/run/mutex.hpp>
#include <equilibria/storage/checkpoint.hpp>

namespace equilibria::detail {

/// Endpoints in memory, their points in one piece: a million of them have no vectors of their own.
class EndpointTable {
public:
    EndpointTable(const RuntimeSizes& sizes, std::uint64_t size)
        : angles_(static_cast<std::size_t>(sizes.angles)), coordinates_(static_cast<std::size_t>(sizes.coordinates)),
          points_(std::make_unique_for_overwrite<Complex<double>[]>(size * (2 * angles_ + coordinates_))),
          records_(size) {
        prefer_huge_pages(points_.get(), size * (2 * angles_ + coordinates_) * sizeof(Complex<double>));
    }

    bool empty() const { return records_.empty(); }
    void set(std::uint64_t k, const Endpoint& end) {
        records_[k] = end;
        Complex<double>* to = place(k);
        for (const auto* part : {&end.q.c, &end.q.s, &end.q.x}) to = std::copy(part->begin(), part->end(), to);
    }
    void get(std::uint64_t k, Endpoint& end) const {
        const auto& [t, evidence, steps, winding_number, arrival, status, reason, precision] = records_[k];
        if (unknowns(end.q) == 0)
            end.q =
                point_of_zeros<RuntimeUnknowns, double>({static_cast<int>(angles_), static_cast<int>(coordinates_)});
        end.t = t, end.evidence = evidence, end.steps = steps, end.winding_number = winding_number;
        end.arrival = arrival, end.status = status, end.reason = reason, end.precision = precision;
        const PointView from = point(k);
        std::copy(from.c.begin(), from.c.end(), end.q.c.begin());
        std::copy(from.s.begin(), from.s.end(), end.q.s.begin());
        std::copy(from.x.begin(), from.x.end(), end.q.x.begin());
    }
    /// Endpoint k where it is, field by field in the order of Endpoint's.
    struct Fields {
        struct {
            std::span<Complex<double>> c, s, x;
        } q;
        double& t;
        std::int32_t& steps;
        Arrival& arrival;
        PathStatus& status;
        FailureReason& reason;
        Precision& precision;
        std::int16_t& winding_number;
        PolishedEvidence& evidence;
    };
    Fields fields(std::uint64_t k) {
        auto& [t, evidence, steps, winding_number, arrival, status, reason, precision] = records_[k];
        Complex<double>* const at = place(k);
        return {{{at, angles_}, {at + angles_, angles_}, {at + 2 * angles_, coordinates_}},
                t,
                steps,
                arrival,
                status,
                reason,
                precision,
                winding_number,
                evidence};
    }
    const EndpointRecord& record(std::uint64_t k) const { return records_[k]; }
    PointView point(std::uint64_t k) const {
        const Complex<double>* const at = place(k);
        return {{at, angles_}, {at + angles_, angles_}, {at + 2 * angles_, coordinates_}};
    }

private:
    Complex<double>* place(std::uint64_t k) const { return &points_[k * (2 * angles_ + coordinates_)]; }

    std::size_t angles_, coordinates_;
    std::unique_ptr<Complex<double>[]> points_;  // written before they are read: no zeros
    std::vector<EndpointRecord> records_;
};

class EndpointStore {
public:
    /// For `size` paths in memory. sizes: of their unknowns.
    EndpointStore(std::uint64_t size, std::uint64_t block, const RuntimeSizes& sizes)
        : EndpointStore(size, block, sizes, size) {}

    /// In a checkpoint, with what it holds already; `in_memory`: also there, which is faster. Throws CheckpointError.
    EndpointStore(std::uint64_t size, std::uint64_t block, std::string path, const CheckpointFields& header,
                  bool in_memory, const RuntimeSizes& sizes)
        : sizes_(sizes), size_(size), block_(block), has_((size + block - 1) / block),
          ends_(sizes, in_memory ? size : 0) {
        const auto take = [&](std::uint64_t which, std::span<const Endpoint> ends, std::uint64_t retracked) {
            enter(which, ends, retracked);
        };
        file_ = std::make_unique<Checkpoint>(std::move(path), header, size, block, take, sizes);
    }

    /// Keeps no endpoints, but for which blocks are done: somebody else has them.
    static EndpointStore elsewhere(std::uint64_t size, std::uint64_t block, const RuntimeSizes& sizes) {
        return {size, block, sizes, 0};
    }

    const RuntimeSizes& sizes() const { return sizes_; }
    std::uint64_t size() const { return size_; }
    std::uint64_t block() const { return block_; }
    /// Paths that are finished, and how many of them were tracked again.
    std::uint64_t finished() const { return finished_ - unsettled_.size(); }
    std::uint64_t retracked() const { return retracked_; }
    void set_retracked(std::uint64_t count) { retracked_ = count; }
    bool complete() const { return finished() == size_; }

    bool has_block(std::uint64_t which) const { return has_[which] != 0; }
    bool finished(std::uint64_t k) const { return has_[k / block_] && (unsettled_.empty() || !unsettled_.contains(k)); }

    /// Keeps a finished block; with a checkpoint it is on the disk afterwards. From any thread, each block once.
    void put(std::uint64_t which, std::span<const Endpoint> ends, std::uint64_t retracked) {
        const Lock lock(*guard_);
        if (file_) file_->append(which, ends, retracked);
        enter(which, ends, retracked);
    }

    /// Appends a finished block of so many paths as BlockCodec writes it, and the same put elsewhere. Of those in
    /// memory.
    void append_to(Bytes& to, std::uint64_t which, std::uint64_t paths) {
        BlockCodec(sizes_).append(to, paths, 0, [&](std::uint64_t k) { return ends_.fields(which * block_ + k); });
    }
    void put(std::uint64_t which, std::span<const std::uint8_t> encoded, std::uint64_t paths) {
        const Lock lock(*guard_);
        if (file_) file_->append(which, encoded);
        if (!ends_.empty()) {
            Reader read(encoded.subspan(BlockCodec::head));
            for (std::uint64_t k = 0; k < paths; ++k) {
                auto fields = ends_.fields(which * block_ + k);
                transfer(read, fields);
            }
        }
        has_[which] = 1;
        finished_ += paths;
        retracked_ += BlockCodec::retracked(encoded);
    }

    /// A finished endpoint; the reference outlives the next call, not the one after it.
    const Endpoint& operator[](std::uint64_t k) {
        if (!ends_.empty()) {
            oldest_ = (oldest_ + 1) % windows_.size();
            Window& w = windows_[oldest_];
            w.ends.resize(1);
            ends_.get(k, w.ends.front());
            return w.ends.front();
        }
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
    EndpointRecord record(std::uint64_t k) { return ends_.empty() ? EndpointRecord((*this)[k]) : ends_.record(k); }
    /// Its point; valid as an endpoint is.
    PointView point(std::uint64_t k) { return ends_.empty() ? PointView((*this)[k].q) : ends_.point(k); }
    /// Another endpoint for a path. Not written to the checkpoint: it follows from what is there.
    void replace(std::uint64_t k, const Endpoint& end) {
        if (!ends_.empty())
            ends_.set(k, end);
        else
            replaced_[k] = end;
    }
    /// The path counts as not finished.
    void unsettle(std::uint64_t k) { unsettled_.insert(k); }

private:
    struct Window {
        std::uint64_t first = 0;
        std::vector<Endpoint> ends;
    };

    EndpointStore(std::uint64_t size, std::uint64_t block, const RuntimeSizes& sizes, std::uint64_t in_memory)
        : sizes_(sizes), size_(size), block_(block), has_((size + block - 1) / block), ends_(sizes, in_memory) {}

    void enter(std::uint64_t which, std::span<const Endpoint> ends, std::uint64_t retracked) {
        if (!ends_.empty())
            for (std::size_t k = 0; k < ends.size(); ++k) ends_.set(which * block_ + k, ends[k]);
        has_[which] = 1;
        finished_ += ends.size();
        retracked_ += retracked;
    }

    RuntimeSizes sizes_;
    std::uint64_t size_, block_, finished_ = 0, retracked_ = 0;
    std::vector<std::uint8_t> has_;
    EndpointTable ends_;
    std::unique_ptr<Checkpoint> file_;
    std::unique_ptr<Mutex> guard_ = std::make_unique<Mutex>();
    std::map<std::uint64_t, Endpoint> replaced_;
    std::set<std::uint64_t> unsettled_;
    std::array<Window, 3> windows_;
    std::size_t oldest_ = 0, latest_ = 0;
    std::uint64_t last_ = ~std::uint64_t{0};
};

}  // namespace equilibria::detail
