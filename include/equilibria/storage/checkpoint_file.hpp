/// \file
/// A file of records that only grows, made for a process that may be killed at any moment. It knows nothing of paths.
///
///     0     magic, format, length of the header, CRC of these and of the header
///     512   commit mark 0:  sequence number, committed length, number of records, CRC
///     1024  commit mark 1
///     1536  header: lines "name: value" that say what the records belong to
///     ...   records: length, bytes, CRC
///
/// Little-endian; CRC-64/XZ, those of marks and records begun with the header's, so that none passes in another file.
///
/// A record is written past those before it; about once a second the file is synced, and only then does the older of
/// the two marks, each in a sector of its own, take in how long it has become: that length is committed. Past it,
/// records are read as long as they are whole; the first that is not is an append that was interrupted, and is cut off.
/// So a killed process loses no record, a power failure those of a second or so. Before the committed length nothing is
/// forgiven: a damaged record, or a file shorter than that, which no interruption can cause, is refused. If the newer
/// mark is damaged the older one holds, and the records behind it are found whole.
///
/// A file that is refused is never written to.
#pragma once

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/storage/bytes.hpp>
#include <equilibria/storage/checkpoint_fields.hpp>
#include <equilibria/storage/locked_file.hpp>

namespace equilibria::detail {

class Crc64 {
public:
    Crc64& add(std::span<const std::uint8_t> bytes) {
        sum_.process_bytes(bytes.data(), bytes.size());
        return *this;
    }
    Crc64& add(std::uint64_t value) {
        std::uint8_t bytes[8];
        put_number(bytes, value);
        return add(bytes);
    }
    std::uint64_t value() const { return sum_.checksum(); }

private:
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~std::uint64_t{0}, ~std::uint64_t{0}, true, true> sum_;
};

class CheckpointFile {
public:
    static constexpr std::array<std::uint8_t, 8> magic{0x89, 'E', 'Q', 'C', '\r', '\n', 0x1a, '\n'};
    static constexpr std::uint64_t format = 1, marks_at[2] = {512, 1024}, header_at = 1536, prologue_size = 24,
                                   mark_size = 32, frame_size = 16;

    /// Opens the file, or creates it where there is none, and calls visit(offset, bytes) for each of its records, in
    /// their order; `offset` is where the bytes are, and visit returns what is wrong with them, or nothing. Throws
    /// CheckpointError if the file cannot be opened, is in use, is no checkpoint, is damaged or truncated, or has
    /// another header; the message names the fields that differ.
    template <class Visit>
    CheckpointFile(std::string path, const CheckpointFields& header, Visit&& visit) : file_(std::move(path)) {
        header_ = text_of(header);
        for (int attempt = 0; !file_.open(); ++attempt) {
            if (attempt == 2) file_.refuse("cannot be created", ENOENT);  // a link that leads nowhere
            if (create()) return;
        }
        read_records(read_head(), visit);
    }
    CheckpointFile(const CheckpointFile&) = delete;
    ~CheckpointFile() {
        try {
            if (end_ != committed_) commit(), file_.sync();
        } catch (const CheckpointError&) {  // the records are as safe as they can be
        }
    }

    const LockedFile& file() const { return file_; }
    std::uint64_t records() const { return records_; }

    /// Appends a record of two parts; returns where its bytes are. No kill of the process can lose it from then on.
    /// Throws CheckpointError if it cannot be written; what is there already stays so. One call at a time.
    std::uint64_t append(std::span<const std::uint8_t> first, std::span<const std::uint8_t> second = {}) {
        const std::size_t size = first.size() + second.size();
        Bytes record(8);
        record.reserve(size + frame_size);
        put_number(record.data(), size);
        record.insert(record.end(), first.begin(), first.end());
        record.insert(record.end(), second.begin(), second.end());
        record.resize(size + frame_size);
        put_number(&record[size + 8], record_sum(std::span(record).subspan(8, size)));
        file_.write(end_, record);
        const std::uint64_t at = end_ + 8;
        end_ += record.size();
        ++records_;
        if (Clock::now() >= next_commit_) commit();
        return at;
    }

private:
    using Clock = std::chrono::steady_clock;
    using Mark = std::array<std::uint8_t, mark_size>;

    std::uint64_t data_at() const { return header_at + header_.size(); }
    [[noreturn]] void refuse(const std::string& wrong) const { file_.refuse(wrong); }

    /// A file without records. False where somebody else was quicker.
    bool create() {
        Bytes head(data_at());
        std::copy(magic.begin(), magic.end(), head.begin());
        put_number<4>(&head[8], format);
        put_number<4>(&head[12], header_.size());
        std::copy(header_.begin(), header_.end(), head.begin() + header_at);
        header_sum_ = head_sum(head);
        put_number(&head[16], header_sum_);
        end_ = committed_ = data_at();
        for (const std::uint64_t k : {0u, 1u}) {
            const Mark m = mark(k, committed_, 0);
            std::copy(m.begin(), m.end(), head.begin() + static_cast<std::ptrdiff_t>(marks_at[k]));
        }
        sequence_ = 1;
        return file_.create(head);
    }

    std::uint64_t record_sum(std::span<const std::uint8_t> bytes) const {
        return Crc64().add(header_sum_).add(bytes.size()).add(bytes).value();
    }
    static std::uint64_t head_sum(std::span<const std::uint8_t> head) {
        return Crc64().add(head.first(16)).add(head.subspan(header_at)).value();
    }
    Mark mark(std::uint64_t sequence, std::uint64_t length, std::uint64_t records) const {
        Mark m;
        put_number(&m[0], sequence);
        put_number(&m[8], length);
        put_number(&m[16], records);
        put_number(&m[24], Crc64().add(header_sum_).add(std::span(m).first<24>()).value());
        return m;
    }

    /// Syncs the file, then lets the older mark say how long it is. A slow disk is asked less often.
    void commit() {
        if (end_ == committed_) return;
        const auto begin = Clock::now();
        file_.sync();
        file_.write(marks_at[(sequence_ + 1) % 2], mark(sequence_ + 1, end_, records_));
        ++sequence_;
        committed_ = end_;
        next_commit_ = Clock::now() + 10 * (Clock::now() - begin) + std::chrono::seconds(1);
    }

    /// Checks the head; returns the size of the file.
    std::uint64_t read_head() {
        const std::uint64_t size = file_.size();
        if (size == 0) refuse("is empty: not a checkpoint");
        std::array<std::uint8_t, prologue_size> prologue;
        const auto known = static_cast<std::size_t>(std::min<std::uint64_t>(size, magic.size()));
        file_.read(0, std::span(prologue).first(known));
        if (!std::equal(magic.begin(), magic.begin() + static_cast<std::ptrdiff_t>(known), prologue.begin()))
            refuse("is not a checkpoint");
        if (size < header_at) refuse("is truncated: its head is incomplete");
        file_.read(0, prologue);
        if (const auto version = get_number<4>(&prologue[8]); version != format)
            refuse("is of format " + std::to_string(version) + "; this program reads format " + std::to_string(format));
        const std::uint64_t length = get_number<4>(&prologue[12]);
        if (length > size - header_at) refuse("is truncated or damaged: its header is incomplete");
        Bytes head(header_at + length);
        file_.read(0, head);
        header_sum_ = head_sum(head);
        if (get_number(&prologue[16]) != header_sum_) refuse("is damaged: its header has a wrong checksum");
        const auto blank = [&](std::uint64_t from, std::uint64_t to) {
            return std::all_of(head.begin() + static_cast<std::ptrdiff_t>(from),
                               head.begin() + static_cast<std::ptrdiff_t>(to), [](std::uint8_t b) { return b == 0; });
        };
        if (!blank(prologue_size, marks_at[0]) || !blank(marks_at[0] + mark_size, marks_at[1]) ||
            !blank(marks_at[1] + mark_size, header_at))
            refuse("is damaged: its head is not blank where it should be");
        const std::string theirs(head.begin() + header_at, head.end());
        if (theirs != header_) refuse_header(theirs);
        bool found = false;
        for (const std::uint64_t at : marks_at) {
            const std::uint64_t sequence = get_number(&head[at]), committed = get_number(&head[at + 8]),
                                records = get_number(&head[at + 16]);
            const Mark m = mark(sequence, committed, records);
            if (!std::equal(m.begin(), m.end(), &head[at]) || (found && sequence < sequence_)) continue;
            found = true;
            sequence_ = sequence, committed_ = committed, records_ = records;
        }
        if (!found) refuse("is damaged: both of its commit marks have wrong checksums");
        if (committed_ > size)
            refuse("is truncated: " + std::to_string(committed_) + " bytes were committed, " + std::to_string(size) +
                   " are there");
        if (committed_ < data_at() || records_ > (committed_ - data_at()) / frame_size)
            refuse("is damaged: its commit marks contradict themselves");
        return size;
    }

    template <class Visit>
    void read_records(std::uint64_t size, Visit&& visit) {
        const std::uint64_t committed_records = std::exchange(records_, 0);
        Bytes bytes;
        for (end_ = data_at(); end_ < size;) {
            const bool committed = end_ < committed_;
            const std::uint64_t left = (committed ? committed_ : size) - end_;
            std::uint8_t number[8];
            std::string wrong = "length";
            if (left >= frame_size) {
                file_.read(end_, number);
                if (const std::uint64_t length = get_number(number); length <= left - frame_size) {
                    bytes.resize(length);
                    file_.read(end_ + 8, bytes);
                    file_.read(end_ + 8 + length, number);
                    wrong = get_number(number) == record_sum(bytes) ? "" : "checksum";
                }
            }
            if (!wrong.empty() && !committed) break;
            if (!wrong.empty())
                wrong = "is damaged (" + wrong + ")";
            else
                wrong = visit(end_ + 8, std::span<const std::uint8_t>(bytes));
            if (!wrong.empty())
                refuse("record " + std::to_string(records_) + " " + wrong +
                       "; restore the file from a copy, or name another one to start anew");
            end_ += frame_size + bytes.size();
            ++records_;
            if (end_ == committed_ && records_ != committed_records) refuse("is damaged: records are missing");
        }
        if (end_ < size) file_.truncate(end_);
    }

    [[noreturn]] void refuse_header(const std::string& theirs) const {
        const std::string text = differences(fields_of(theirs), fields_of(header_), "this run's");
        refuse("is of another run: " + (text.empty() ? "its header is written otherwise" : text));
    }

    LockedFile file_;
    std::string header_;
    std::uint64_t header_sum_ = 0, sequence_ = 0, committed_ = 0, end_ = 0, records_ = 0;
    Clock::time_point next_commit_ = Clock::now() + std::chrono::seconds(1);
};

}  // namespace equilibria::detail
