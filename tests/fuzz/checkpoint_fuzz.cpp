// Any bytes for a checkpoint: taken or refused, never worse; a refused file is not changed, an accepted one is accepted
// again, with one more record after an append. The first byte of the input chooses what the others are: the file as it
// is; the numbers in its commit marks and its records, all checksums being right; or changes of bytes in a sound file.
#include <sys/mman.h>

#include <cstdlib>
#include <optional>
#include <set>

#include <equilibria/storage/checkpoint.hpp>

using namespace equilibria;
using detail::Bytes;
using File = detail::CheckpointFile;
const RuntimeSizes sizes(2, 0);

namespace {

const detail::CheckpointFields header{{"m", "1"}};
const std::string header_text = "m: 1\n";
constexpr std::uint64_t paths = 5, block = 2;

void require_that(bool holds) {
    if (!holds) std::abort();
}

constexpr std::size_t data_at = File::header_at + 5;

/// A file with our header. input: of each mark, sequence, length past the header (2 bytes), records; then the records,
/// of whose lengths the lower two bytes are taken.
Bytes with_right_sums(std::span<const std::uint8_t> input) {
    Bytes bytes(data_at);
    std::copy(File::magic.begin(), File::magic.end(), bytes.begin());
    detail::put_number<4>(&bytes[8], File::format);
    detail::put_number<4>(&bytes[12], header_text.size());
    std::copy(header_text.begin(), header_text.end(), bytes.begin() + File::header_at);
    const auto head = std::span<const std::uint8_t>(bytes);
    const std::uint64_t sum = detail::Crc64().add(head.first(16)).add(head.subspan(File::header_at)).value();
    detail::put_number(&bytes[16], sum);
    for (const std::uint64_t at : File::marks_at) {
        if (input.size() < 4) break;
        detail::put_number(&bytes[at], input[0]);
        detail::put_number(&bytes[at + 8], data_at + detail::get_number<2>(&input[1]));
        detail::put_number(&bytes[at + 16], input[3]);
        detail::put_number(&bytes[at + 24], detail::Crc64().add(sum).add(head.subspan(at, 24)).value());
        input = input.subspan(4);
    }
    bytes.insert(bytes.end(), input.begin(), input.end());
    for (std::size_t at = data_at; bytes.size() - at >= File::frame_size;) {
        const std::uint64_t length = detail::get_number<2>(&bytes[at]);
        detail::put_number(&bytes[at], length);
        if (length > bytes.size() - at - File::frame_size) break;
        const auto record = std::span<const std::uint8_t>(bytes).subspan(at + 8, length);
        detail::put_number(&bytes[at + 8 + length], detail::Crc64().add(sum).add(length).add(record).value());
        at += File::frame_size + length;
    }
    return bytes;
}

/// A sound file of two blocks, changed. input: places (2 bytes) and what is added there.
Bytes with_changes(std::span<const std::uint8_t> input) {
    Bytes records;
    const auto size = detail::BlockCodec(sizes).endpoint_size();
    for (const auto& [which, ends] : {std::pair{2, 1}, std::pair{0, 2}}) {
        Bytes record(24 + static_cast<std::size_t>(ends) * size + 8);
        detail::put_number(&record[0], record.size() - 16);
        detail::put_number(&record[8], static_cast<std::uint64_t>(which));
        records.insert(records.end(), record.begin(), record.end());
    }
    Bytes numbers(8);
    for (const std::size_t at : {std::size_t{0}, std::size_t{4}}) {
        numbers[at] = static_cast<std::uint8_t>(2 + at);
        detail::put_number<2>(&numbers[at + 1], at == 0 ? 32 + size : records.size());
        numbers[at + 3] = at == 0 ? 1 : 2;
    }
    numbers.insert(numbers.end(), records.begin(), records.end());
    Bytes bytes = with_right_sums(numbers);
    for (; input.size() >= 3; input = input.subspan(3)) {
        auto& byte = bytes[detail::get_number<2>(&input[0]) % bytes.size()];
        byte = static_cast<std::uint8_t>(byte + input[2]);
    }
    return bytes;
}

struct Memory {
    int file = memfd_create("checkpoint", MFD_CLOEXEC);
    std::string name = "/proc/self/fd/" + std::to_string(file);
    ~Memory() { close(file); }

    void write(const Bytes& bytes) const {
        require_that(file >= 0 && pwrite(file, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()));
    }
    Bytes bytes() const {
        Bytes all(static_cast<std::size_t>(lseek(file, 0, SEEK_END)));
        require_that(pread(file, all.data(), all.size(), 0) == static_cast<ssize_t>(all.size()));
        return all;
    }
};

/// The records, or nothing where the file is refused.
std::optional<std::vector<Bytes>> records(const std::string& name, const Bytes* append = nullptr) {
    std::vector<Bytes> found;
    try {
        File file(name, header, [&](std::uint64_t, std::span<const std::uint8_t> bytes) {
            found.emplace_back(bytes.begin(), bytes.end());
            return std::string();
        });
        require_that(file.records() == found.size());
        if (append) file.append(*append);
    } catch (const CheckpointError&) {
        return {};
    }
    return found;
}

/// The blocks, or nothing where they are refused.
std::optional<std::set<std::uint64_t>> blocks(const std::string& name) {
    std::set<std::uint64_t> found;
    try {
        detail::Checkpoint checkpoint(
            name, header, paths, block,
            [&](std::uint64_t which, std::span<const Endpoint> ends, std::uint64_t) {
                require_that(which < 3 && ends.size() == (which == 2 ? 1 : 2) && found.insert(which).second);
                for (const auto& end : ends)
                    require_that(end.arrival <= Arrival::stuck && end.status <= PathStatus::failed &&
                                 end.reason <= FailureReason::endgame_undecided);
            },
            sizes);
        for (const std::uint64_t which : found) {
            std::vector<Endpoint> ends(checkpoint.size(which));
            checkpoint.read(which, 0, ends);
        }
    } catch (const CheckpointError&) {
        return {};
    }
    return found;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::span input(data + 1, size - 1);
    const Bytes bytes = data[0] % 3 == 0   ? Bytes(input.begin(), input.end())
                        : data[0] % 3 == 1 ? with_right_sums(input)
                                           : with_changes(input);
    const Memory memory;
    memory.write(bytes);
    const bool taken = blocks(memory.name).has_value();
    require_that(taken || memory.bytes() == bytes);
    if (data[0] % 3 == 2 && input.size() < 3) require_that(taken);
    const auto found = records(memory.name);
    require_that(found || (!taken && memory.bytes() == bytes));
    if (!found) return 0;
    require_that(records(memory.name) == found);
    const Bytes more{1, 2, 3};
    records(memory.name, &more);
    auto longer = *found;
    longer.push_back(more);
    require_that(records(memory.name) == longer);
    return 0;
}
