/// \file
/// Endpoints as bytes, the same on every machine: what a checkpoint keeps of a block, and what ranks send each other.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/storage/bytes.hpp>

namespace equilibria::detail {

/// The fields of an endpoint, to or from an archive: a(field), a(enumeration, its largest value). The structured
/// bindings name all fields of each type, so that one more cannot be forgotten here.
template <class Archive, class E>
void transfer(Archive& a, E& end) {
    auto& [q, t, steps, arrival, status, reason, precision, winding_number, evidence] = end;
    auto& [c, s, x] = q;
    auto& [residual, condition, correction] = evidence;
    for (auto& z : c) a(z.re), a(z.im);
    for (auto& z : s) a(z.re), a(z.im);
    for (auto& z : x) a(z.re), a(z.im);
    a(t), a(residual), a(condition), a(correction), a(steps), a(winding_number);
    a(arrival, Arrival::stuck), a(status, PathStatus::failed), a(reason, FailureReason::endgame_undecided);
    a(precision, Precision::more_digits);
}

/// Puts numbers into bytes, little-endian. The caller has made sure that there is room.
class PlacedWriter {
public:
    explicit PlacedWriter(std::uint8_t* at) : at_(at) {}
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
        put_number<bytes>(at_, value);
        at_ += bytes;
    }
    std::uint8_t* at_;
};

/// Appends numbers to bytes: where their size is not known before.
class Writer {
public:
    explicit Writer(Bytes& to) : to_(&to) {}
    template <class T, class... Largest>
    void operator()(T value, Largest... largest) {
        const std::size_t at = to_->size();
        to_->resize(at + (sizeof...(largest) > 0 ? 1 : sizeof(T)));
        PlacedWriter(to_->data() + at)(value, largest...);
    }

private:
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

/// A block of endpoints: how many of its paths were tracked again, and the endpoints field by field.
class BlockCodec {
public:
    /// Of the number of paths tracked again.
    static constexpr std::uint64_t head = 8;

    explicit BlockCodec(const RuntimeSizes& sizes)
        : sizes_(sizes),
          endpoint_size_(16 * static_cast<std::uint64_t>(2 * sizes.angles + sizes.coordinates) + 4 * 8 + 4 + 2 + 4) {}

    /// Bytes of an endpoint.
    std::uint64_t endpoint_size() const { return endpoint_size_; }
    /// Bytes of so many in a block.
    std::uint64_t size(std::uint64_t endpoints) const { return head + endpoints * endpoint_size_; }

    /// Appends so many endpoints, end(k) or what has the same fields.
    void append(Bytes& to, std::uint64_t count, std::uint64_t retracked, const auto& end) const {
        const std::size_t at = to.size();
        to.resize(at + size(count));
        PlacedWriter write(&to[at]);
        write(retracked);
        for (std::uint64_t k = 0; k < count; ++k) {
            auto&& fields = end(k);
            transfer(write, fields);
        }
    }
    void append(Bytes& to, std::span<const Endpoint> ends, std::uint64_t retracked) const {
        append(to, ends.size(), retracked, [&](std::uint64_t k) -> const Endpoint& { return ends[k]; });
    }
    Bytes encode(std::span<const Endpoint> ends, std::uint64_t retracked) const {
        Bytes y;
        append(y, ends, retracked);
        return y;
    }
    static std::uint64_t retracked(std::span<const std::uint8_t> block) { return get_number(block.data()); }
    /// Endpoints from their bytes, without a block's head. False where an enumeration has none of its values.
    bool decode(std::span<const std::uint8_t> bytes, std::span<Endpoint> ends) const {
        Reader read(bytes);
        for (Endpoint& end : ends) {
            end.q = point_of_zeros<RuntimeUnknowns, double>(sizes_);
            transfer(read, end);
        }
        return read.sound();
    }

private:
    RuntimeSizes sizes_;
    std::uint64_t endpoint_size_;
};

}  // namespace equilibria::detail
