/// \file
/// The checkpoint of an enumeration: its header, which names everything that the bits of an endpoint depend on, and its
/// records, each a block of endpoints, finished but for what can only be seen when all paths are there.
///
/// A record holds the block's number, how many of its paths were tracked again, and the endpoints field by field. The
/// blocks come in the order in which threads finish them; nothing depends on it.
#pragma once

#include <algorithm>
#include <bit>
#include <complex>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/core/lanes.hpp>
#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/homotopy/tracker_options.hpp>
#include <equilibria/storage/checkpoint_file.hpp>
#include <equilibria/version.hpp>

namespace equilibria::detail {

/// The fields of an endpoint, to or from an archive: a(field), a(enumeration, its largest value). The structured
/// bindings name all fields of each type, so that one more cannot be forgotten here.
template <class Archive, class E>
void transfer(Archive& a, E& end) {
    // more_digits is false of all that is written: such paths are tracked after the others, from what is in the file
    [[maybe_unused]] auto& [q, t, steps, arrival, status, reason, more_digits, winding_number, evidence] = end;
    auto& [c, s, x] = q;
    auto& [residual, condition, correction] = evidence;
    for (auto& z : c) a(z.re), a(z.im);
    for (auto& z : s) a(z.re), a(z.im);
    for (auto& z : x) a(z.re), a(z.im);
    a(t), a(residual), a(condition), a(correction), a(steps), a(winding_number);
    a(arrival, Arrival::stuck), a(status, PathStatus::failed), a(reason, FailureReason::endgame_undecided);
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

/// A hash of numbers, word by word (the mixing of splitmix64).
class Fingerprint {
public:
    void operator()(std::uint64_t word) {
        std::uint64_t z = (value_ ^ word) + 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        value_ = z ^ (z >> 31);
    }
    void operator()(double number) { (*this)(std::bit_cast<std::uint64_t>(number)); }
    void operator()(const std::complex<double>& z) { (*this)(z.real()), (*this)(z.imag()); }
    std::string text() const {
        std::string hex;
        for (int shift = 60; shift >= 0; shift -= 4) hex += "0123456789abcdef"[(value_ >> shift) & 15];
        return hex;
    }

private:
    std::uint64_t value_ = 0;
};

/// The name of a type as the compiler spells it.
template <class M>
std::string type_name() {
    const std::string_view here = __PRETTY_FUNCTION__;
    const std::size_t begin = here.find("M = ") + 4, semicolon = here.find(';', begin);
    return std::string(here.substr(begin, (semicolon == here.npos ? here.rfind(']') : semicolon) - begin));
}

/// The compiler and its flags, as far as they change the last bits.
inline std::string build_name() {
    std::string name =
#if defined(__clang__)
        "clang " __clang_version__;
#else
        "g++ " __VERSION__;
#endif
#if defined(__x86_64__)
    name += ", x86-64";
#elif defined(__aarch64__)
    name += ", AArch64";
#endif
    name += ", " + std::to_string(native_lanes) + " lanes";
#if defined(__FMA__)
    name += ", fused multiply-add";
#endif
#if defined(__FAST_MATH__)
    name += ", fast-math";
#endif
#if !defined(__OPTIMIZE__)
    name += ", not optimised";
#endif
    return name;
}

/// What is tracked in a run, beside the model and its parameters.
struct CheckpointRun {
    std::uint64_t seed;
    std::string_view start;
    Fingerprint numbers;  ///< the coefficients of the homotopy and all start points
    std::uint64_t paths, block;
};

template <Model M>
std::vector<CheckpointFile::Field> checkpoint_header(const Parameters<M>& p, const CheckpointRun& run,
                                                     const TrackerOptions& tracker) {
    const auto& [seed, start, numbers, paths, block] = run;
    using F = Formulation<M>;
    Fingerprint support;
    for (const auto& term : F::support) {
        support(static_cast<std::uint64_t>(term.equation));
        for (int u = 0; u < n_unknowns<M>; ++u) support(static_cast<std::uint64_t>(term.monomial.code(u)));
    }
    std::vector<CheckpointFile::Field> fields{
        {"equilibria", EQUILIBRIA_VERSION_STRING},
        {"model", type_name<M>() + " (" + std::to_string(n_angles<M>) + " angles, " + std::to_string(n_coordinates<M>) +
                      " coordinates, " + std::to_string(F::terms) + " terms, support " + support.text() + ")"}};
    int k = 0;
    for (const auto& value : p) fields.push_back({"parameters[" + std::to_string(k++) + "]", to_text(value)});
    fields.push_back({"seed", std::to_string(seed)});
    const auto& [contraction, largest_contraction, largest_turn, pole_fraction, smallest_step, endgame_start,
                 most_steps] = tracker;
    fields.push_back({"contraction", to_text(contraction)});
    fields.push_back({"largest_contraction", to_text(largest_contraction)});
    fields.push_back({"largest_turn", to_text(largest_turn)});
    fields.push_back({"pole_fraction", to_text(pole_fraction)});
    fields.push_back({"smallest_step", to_text(smallest_step)});
    fields.push_back({"endgame_start", to_text(endgame_start)});
    fields.push_back({"most_steps", to_text(most_steps)});
    fields.push_back({"build", build_name()});
    fields.push_back({"start", std::string(start)});
    fields.push_back({"paths", std::to_string(paths) + " in blocks of " + std::to_string(block)});
    fields.push_back({"homotopy", numbers.text()});
    return fields;
}

/// The blocks of endpoints in a checkpoint.
template <class M>
class Checkpoint {
public:
    static constexpr std::uint64_t endpoint_size = 16 * (2 * n_angles<M> + n_coordinates<M>)+4 * 8 + 4 + 2 + 3;
    static constexpr std::uint64_t block_head = 8 + 8;

    /// Opens or creates the file and checks all of it; take(block, endpoints, retracked) gets each block that
    /// is there.
    template <class Take>
    Checkpoint(std::string path, const std::vector<CheckpointFile::Field>& header, std::uint64_t paths,
               std::uint64_t block, Take&& take)
        : paths_(paths), block_(block), offset_((paths + block - 1) / block),
          file_(std::move(path), header,
                [&, ends = std::vector<Endpoint<M>>()](std::uint64_t offset,
                                                       std::span<const std::uint8_t> bytes) mutable -> std::string {
                    if (bytes.size() < block_head) return "is too short";
                    const std::uint64_t which = get_number(&bytes[0]), retracked = get_number(&bytes[8]);
                    if (which >= offset_.size()) return "is of a block that the run does not have";
                    if (offset_[which] != 0) return "repeats a block";
                    ends.resize(size(which));
                    if (bytes.size() != block_head + ends.size() * endpoint_size) return "has a wrong size";
                    if (!decode(bytes.subspan(block_head), ends)) return "holds an unknown status";
                    offset_[which] = offset;
                    take(which, std::span<const Endpoint<M>>(ends), retracked);
                    return "";
                }) {}

    bool has(std::uint64_t block) const { return offset_[block] != 0; }
    /// The number of paths of a block.
    std::uint64_t size(std::uint64_t block) const { return std::min(block_, paths_ - block * block_); }

    /// Appends a block. One call at a time.
    void append(std::uint64_t block, std::span<const Endpoint<M>> ends, std::uint64_t retracked) {
        Bytes bytes;
        bytes.reserve(block_head + ends.size() * endpoint_size);
        Writer write(bytes);
        write(block), write(retracked);
        for (const Endpoint<M>& end : ends) transfer(write, end);
        offset_[block] = file_.append(bytes);
    }

    /// The endpoints of a block from path number `first` of it on.
    void read(std::uint64_t block, std::uint64_t first, std::span<Endpoint<M>> ends) const {
        Bytes bytes(ends.size() * endpoint_size);
        file_.file().read(offset_[block] + block_head + first * endpoint_size, bytes);
        if (!decode(bytes, ends)) file_.file().refuse("was changed while it was in use");
    }

private:
    static bool decode(std::span<const std::uint8_t> bytes, std::span<Endpoint<M>> ends) {
        Reader read(bytes);
        for (Endpoint<M>& end : ends) transfer(read, end);
        return read.sound();
    }

    std::uint64_t paths_, block_;
    std::vector<std::uint64_t> offset_;  // of each block's record, 0 where there is none
    CheckpointFile file_;
};

}  // namespace equilibria::detail
