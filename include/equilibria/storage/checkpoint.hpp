/// \file
/// The checkpoint of an enumeration: its header, which names everything that the bits of an endpoint depend on, and its
/// records, each a block of endpoints, finished but for what can only be seen when all paths are there.
///
/// A record holds the block's number, how many of its paths were tracked again, and the endpoints field by field. The
/// blocks come in the order in which threads finish them; nothing depends on it.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/homotopy/tracker_options.hpp>
#include <equilibria/storage/checkpoint_fields.hpp>
#include <equilibria/storage/checkpoint_file.hpp>
#include <equilibria/storage/fingerprint.hpp>
#include <equilibria/version.hpp>

namespace equilibria::detail {

/// The fields of an endpoint, to or from an archive: a(field), a(enumeration, its largest value). The structured
/// bindings name all fields of each type, so that one more cannot be forgotten here.
template <class Archive, class E>
void transfer(Archive& a, E& end) {
    // nothing that is written has more digits: such paths are tracked after the others, from what is in the file
    auto& [q, t, steps, arrival, status, reason, precision, winding_number, evidence] = end;
    auto& [c, s, x] = q;
    auto& [residual, condition, correction] = evidence;
    for (auto& z : c) a(z.re), a(z.im);
    for (auto& z : s) a(z.re), a(z.im);
    for (auto& z : x) a(z.re), a(z.im);
    a(t), a(residual), a(condition), a(correction), a(steps), a(winding_number);
    a(arrival, Arrival::stuck), a(status, PathStatus::failed), a(reason, FailureReason::endgame_undecided);
    a(precision, Precision::in_double);
}

/// Appends numbers to bytes, little-endian.
class Writer {
public:
    explicit Writer(Bytes& to) : to_(&to) {}
    void operator()(double value) { put<8>(std::bit_cast<std::uint64_t>(value)); }
    template <class T>
    requires std::is_integral_v<T>
    void operator()(T value) {
        put<sizeof(T)>(static_cast<std::make_unsigned_t<T>>(value));
    }
    template <class E>
    void operator()(E value, E) {
        put<1>(static_cast<std::uint64_t>(value));
    }

private:
    template <int bytes>
    void put(std::uint64_t value) {
        to_->resize(to_->size() + bytes);
        put_number<bytes>(to_->data() + to_->size() - bytes, value);
    }
    Bytes* to_;
};

/// Takes them out again. The caller has made sure that there are enough.
class Reader {
public:
    explicit Reader(std::span<const std::uint8_t> from) : at_(from.data()) {}
    void operator()(double& value) { value = std::bit_cast<double>(get<8>()); }
    template <class T>
    requires std::is_integral_v<T>
    void operator()(T& value) {
        value = static_cast<T>(static_cast<std::make_unsigned_t<T>>(get<sizeof(T)>()));
    }
    template <class E>
    void operator()(E& value, E largest) {
        const std::uint64_t number = get<1>();
        sound_ = sound_ && number <= static_cast<std::uint64_t>(largest);
        value = sound_ ? static_cast<E>(number) : largest;
    }
    /// Whether each enumeration had one of its values.
    bool sound() const { return sound_; }

private:
    template <int bytes>
    std::uint64_t get() {
        const std::uint64_t value = get_number<bytes>(at_);
        at_ += bytes;
        return value;
    }
    const std::uint8_t* at_;
    bool sound_ = true;
};

/// What is tracked in a run, beside the model and its parameters.
struct CheckpointRun {
    std::uint64_t seed;
    std::string_view start;
    Fingerprint numbers;  ///< the coefficients of the homotopy and all start points
    std::uint64_t paths, block;
};

inline CheckpointFields checkpoint_header(const CheckpointFields& model, const CheckpointRun& run,
                                          const TrackerOptions& tracker) {
    const auto& [seed, start, numbers, paths, block] = run;
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
    fields.push_back({"build", build_name()});
    fields.push_back({"start", std::string(start)});
    fields.push_back({"paths", std::to_string(paths) + " in blocks of " + std::to_string(block)});
    fields.push_back({"homotopy", numbers.text()});
    return fields;
}

/// The blocks of endpoints in a checkpoint.
class Checkpoint {
public:
    static constexpr std::uint64_t block_head = 8 + 8;
    /// Bytes of an endpoint.
    static std::uint64_t endpoint_size(const RuntimeSizes& sizes) {
        return 16 * static_cast<std::uint64_t>(2 * sizes.angles + sizes.coordinates) + 4 * 8 + 4 + 2 + 4;
    }

    /// Opens or creates the file and checks all of it; take(block, endpoints, retracked) gets each block that
    /// is there.
    template <class Take>
    Checkpoint(std::string path, const CheckpointFields& header, std::uint64_t paths, std::uint64_t block, Take&& take,
               const RuntimeSizes& sizes)
        : sizes_(sizes), endpoint_size_(endpoint_size(sizes)), paths_(paths), block_(block),
          offset_((paths + block - 1) / block),
          file_(std::move(path), header,
                [&, ends = std::vector<Endpoint>()](std::uint64_t offset,
                                                    std::span<const std::uint8_t> bytes) mutable -> std::string {
                    if (bytes.size() < block_head) return "is too short";
                    const std::uint64_t which = get_number(&bytes[0]), retracked = get_number(&bytes[8]);
                    if (which >= offset_.size()) return "is of a block that the run does not have";
                    if (offset_[which] != 0) return "repeats a block";
                    ends.resize(size(which));
                    if (bytes.size() != block_head + ends.size() * endpoint_size_) return "has a wrong size";
                    if (!decode(bytes.subspan(block_head), ends)) return "holds an unknown status";
                    offset_[which] = offset;
                    take(which, std::span<const Endpoint>(ends), retracked);
                    return "";
                }) {}

    bool has(std::uint64_t block) const { return offset_[block] != 0; }
    /// The number of paths of a block.
    std::uint64_t size(std::uint64_t block) const { return std::min(block_, paths_ - block * block_); }

    /// Appends a block. One call at a time.
    void append(std::uint64_t block, std::span<const Endpoint> ends, std::uint64_t retracked) {
        Bytes bytes;
        bytes.reserve(block_head + ends.size() * endpoint_size_);
        Writer write(bytes);
        write(block), write(retracked);
        for (const Endpoint& end : ends) transfer(write, end);
        offset_[block] = file_.append(bytes);
    }

    /// The endpoints of a block from path number `first` of it on.
    void read(std::uint64_t block, std::uint64_t first, std::span<Endpoint> ends) const {
        Bytes bytes(ends.size() * endpoint_size_);
        file_.file().read(offset_[block] + block_head + first * endpoint_size_, bytes);
        if (!decode(bytes, ends)) file_.file().refuse("was changed while it was in use");
    }

private:
    bool decode(std::span<const std::uint8_t> bytes, std::span<Endpoint> ends) const {
        Reader read(bytes);
        for (Endpoint& end : ends) {
            end.q = point_of_zeros<RuntimeUnknowns, double>(sizes_);
            transfer(read, end);
        }
        return read.sound();
    }

    RuntimeSizes sizes_;
    std::uint64_t endpoint_size_;
    std::uint64_t paths_, block_;
    std::vector<std::uint64_t> offset_;  // of each block's record, 0 where there is none
    CheckpointFile file_;
};

}  // namespace equilibria::detail
