/// \file
/// The checkpoint of an enumeration: its header, which names everything that the bits of an endpoint depend on, and its
/// records, each a block of endpoints, finished but for what can only be seen when all paths are there.
///
/// A record holds the block's number, how many of its paths were tracked again, and the endpoints field by field. The
/// blocks come in the order in which threads finish them; nothing depends on it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/homotopy/tracker_options.hpp>
#include <equilibria/storage/checkpoint_fields.hpp>
#include <equilibria/storage/checkpoint_file.hpp>
#include <equilibria/storage/endpoint_bytes.hpp>
#include <equilibria/storage/fingerprint.hpp>
#include <equilibria/version.hpp>

namespace equilibria::detail {

/// What is tracked in a run, beside the model and its parameters.
struct CheckpointRun {
    std::uint64_t seed;
    std::string_view start;
    Fingerprint numbers;  ///< the coefficients of the homotopy and start points
    std::uint64_t paths, block;
    bool more_digits;  ///< whether they may end paths
};

inline CheckpointFields checkpoint_header(const CheckpointFields& model, const CheckpointRun& run,
                                          const TrackerOptions& tracker) {
    const auto& [seed, start, numbers, paths, block, more_digits] = run;
    CheckpointFields fields{{"equilibria", EQUILIBRIA_VERSION_STRING}};
    fields.insert(fields.end(), model.begin(), model.end());
    fields.push_back({"seed", std::to_string(seed)});
    const auto& [contraction, largest_contraction, largest_turn, pole_fraction, smallest_step, endgame_start,
                 most_steps, single_precision] = tracker;
    fields.push_back({"contraction", to_text(contraction)});
    fields.push_back({"largest_contraction", to_text(largest_contraction)});
    fields.push_back({"largest_turn", to_text(largest_turn)});
    fields.push_back({"pole_fraction", to_text(pole_fraction)});
    fields.push_back({"smallest_step", to_text(smallest_step)});
    fields.push_back({"endgame_start", to_text(endgame_start)});
    fields.push_back({"most_steps", to_text(most_steps)});
    fields.push_back({"single_precision", single_precision ? "yes" : "no"});
    fields.push_back({"more_digits", more_digits ? "yes" : "no"});
    fields.push_back({"build", build_name()});
    fields.push_back({"start", std::string(start)});
    fields.push_back({"paths", std::to_string(paths) + " in blocks of " + std::to_string(block)});
    fields.push_back({"homotopy", numbers.text()});
    return fields;
}

/// The blocks of endpoints in a checkpoint.
class Checkpoint {
public:
    /// The block's number stands before what BlockCodec writes.
    static constexpr std::uint64_t number = 8;

    /// Opens or creates the file and checks all of it; take(block, endpoints, retracked) gets each block that
    /// is there.
    template <class Take>
    Checkpoint(std::string path, const CheckpointFields& header, std::uint64_t paths, std::uint64_t block, Take&& take,
               const RuntimeSizes& sizes)
        : codec_(sizes), paths_(paths), block_(block), offset_((paths + block - 1) / block),
          file_(std::move(path), header,
                [&, ends = std::vector<Endpoint>()](std::uint64_t offset,
                                                    std::span<const std::uint8_t> bytes) mutable -> std::string {
                    if (bytes.size() < number + BlockCodec::head) return "is too short";
                    const std::uint64_t which = get_number(&bytes[0]);
                    if (which >= offset_.size()) return "is of a block that the run does not have";
                    if (offset_[which] != 0) return "repeats a block";
                    ends.resize(size(which));
                    if (bytes.size() != number + codec_.size(ends.size())) return "has a wrong size";
                    const auto record = bytes.subspan(number);
                    if (!codec_.decode(record.subspan(BlockCodec::head), ends)) return "holds an unknown status";
                    offset_[which] = offset;
                    take(which, std::span<const Endpoint>(ends), BlockCodec::retracked(record));
                    return "";
                }) {}

    bool has(std::uint64_t block) const { return offset_[block] != 0; }
    /// The number of paths of a block.
    std::uint64_t size(std::uint64_t block) const { return std::min(block_, paths_ - block * block_); }

    /// Appends a block. One call at a time.
    void append(std::uint64_t block, std::span<const Endpoint> ends, std::uint64_t retracked) {
        append(block, codec_.encode(ends, retracked));
    }
    /// The same of what a BlockCodec has written.
    void append(std::uint64_t block, std::span<const std::uint8_t> encoded) {
        std::array<std::uint8_t, number> head;
        put_number(head.data(), block);
        offset_[block] = file_.append(head, encoded);
    }

    /// The endpoints of a block from path number `first` of it on.
    void read(std::uint64_t block, std::uint64_t first, std::span<Endpoint> ends) const {
        Bytes bytes(ends.size() * codec_.endpoint_size());
        file_.file().read(offset_[block] + number + codec_.size(first), bytes);
        if (!codec_.decode(bytes, ends)) file_.file().refuse("was changed while it was in use");
    }

private:
    BlockCodec codec_;
    std::uint64_t paths_, block_;
    std::vector<std::uint64_t> offset_;  // of each block's record, 0 where there is none
    CheckpointFile file_;
};

}  // namespace equilibria::detail
