// The file of records: it survives every interruption, and every damage is seen or does no harm.
#include <sys/resource.h>

#include <csignal>

#include <equilibria/storage/checkpoint_file.hpp>

#include "support/catch.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;
using detail::Bytes;
using detail::CheckpointFile;

namespace {

using Header = detail::CheckpointFields;
const Header header{{"model", "a pendulum"}, {"seed", "1"}};
const std::vector<Bytes> records{{1, 2, 3}, {}, {0xff, 0, 7, 9, 11, 13, 17}};

const auto any_record = [](std::uint64_t, std::span<const std::uint8_t>) { return std::string(); };

/// What speaks against the file, or nothing; and the records found in it.
std::string opened(const std::string& name, std::vector<Bytes>* found = nullptr, const Header& mine = header) {
    try {
        std::vector<Bytes> read;
        std::vector<std::uint64_t> offsets;
        const CheckpointFile file(name, mine, [&](std::uint64_t offset, std::span<const std::uint8_t> bytes) {
            read.emplace_back(bytes.begin(), bytes.end());
            offsets.push_back(offset);
            return std::string();
        });
        CHECK(file.records() == read.size());
        for (std::size_t k = 0; k < read.size(); ++k) {
            Bytes again(read[k].size());
            file.file().read(offsets[k], again);
            CHECK(again == read[k]);
        }
        if (found) *found = read;
    } catch (const CheckpointError& error) {
        const std::string said = error.what(), begin = "checkpoint = " + name + ": ";
        CHECK(said == begin + error.wrong());
        return error.wrong();
    }
    return "";
}

void append(const std::string& name, const Bytes& record) {
    CheckpointFile file(name, header, any_record);
    file.append(record);
}
void write_records(const std::string& name) {
    CheckpointFile file(name, header, any_record);
    for (const Bytes& bytes : records) file.append(bytes);
}

bool starts_with(const std::string& text, const std::string& begin) { return text.rfind(begin, 0) == 0; }

}  // namespace

TEST_CASE("the checksum is CRC-64/XZ") {
    const std::string digits = "123456789";
    const Bytes bytes(digits.begin(), digits.end());
    CHECK(detail::Crc64().add(bytes).value() == 0x995DC9BBDF1939FA);
    CHECK(detail::Crc64().value() == 0);
}

TEST_CASE("records come back in their order, also over several openings") {
    const tests::ScratchFile scratch("records.ckpt");
    std::vector<Bytes> found;
    CHECK(opened(scratch.name(), &found).empty());
    CHECK(found.empty());
    for (std::size_t k = 0; k < records.size(); ++k) {
        append(scratch.name(), records[k]);
        CHECK(opened(scratch.name(), &found).empty());
        CHECK(found == std::vector<Bytes>(records.begin(), records.begin() + static_cast<std::ptrdiff_t>(k) + 1));
    }
    const std::string text = "model: a pendulum\nseed: 1\n";
    const auto bytes = scratch.bytes();
    CHECK(std::search(bytes.begin(), bytes.end(), text.begin(), text.end()) - bytes.begin() ==
          CheckpointFile::header_at);
}

TEST_CASE("each flipped bit is refused, or is in a commit mark and loses nothing") {
    const tests::ScratchFile scratch("flipped.ckpt");
    write_records(scratch.name());
    const auto sound = scratch.bytes();
    const auto within = [](std::size_t at, std::uint64_t mark) {
        return at >= mark && at < mark + CheckpointFile::mark_size;
    };
    int refused = 0;
    for (std::size_t at = 0; at < sound.size(); ++at)
        for (int bit = 0; bit < 8; ++bit) {
            if (bit % 3 > 0 && (within(at, CheckpointFile::marks_at[0]) || within(at, CheckpointFile::marks_at[1])))
                continue;  // these are synced: slow
            auto damaged = sound;
            damaged[at] ^= static_cast<std::uint8_t>(1 << bit);
            scratch.write(damaged);
            std::vector<Bytes> found;
            const bool accepted = opened(scratch.name(), &found).empty();
            const bool in_mark = within(at, CheckpointFile::marks_at[0]) || within(at, CheckpointFile::marks_at[1]);
            if (accepted != in_mark || (accepted && found != records) || (!accepted && scratch.bytes() != damaged))
                FAIL("byte " << at << ", bit " << bit << ": accepted " << accepted);
            refused += !accepted;
        }
    CHECK(refused == 8 * static_cast<int>(sound.size() - 2 * CheckpointFile::mark_size));
    // both marks: refused
    auto damaged = sound;
    damaged[CheckpointFile::marks_at[0]] ^= 1;
    damaged[CheckpointFile::marks_at[1]] ^= 1;
    scratch.write(damaged);
    CHECK(opened(scratch.name()) == "is damaged: both of its commit marks have wrong checksums");
}

TEST_CASE("a file shorter than what was committed is refused, what lies beyond is overwritten") {
    const tests::ScratchFile scratch("truncated.ckpt");
    write_records(scratch.name());
    const auto sound = scratch.bytes();
    for (std::size_t size = 0; size < sound.size(); ++size) {
        const Bytes shorter(sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(size));
        scratch.write(shorter);
        const std::string said = opened(scratch.name());
        const bool right = size == 0 ? said == "is empty: not a checkpoint" : starts_with(said, "is truncated");
        if (!right) FAIL(size << " bytes: '" << said << "'");
        CHECK(scratch.bytes() == shorter);
    }
    auto longer = sound;
    for (std::uint8_t k = 0; k < 100; ++k) longer.push_back(k);
    scratch.write(longer);
    std::vector<Bytes> found;
    CHECK(opened(scratch.name(), &found).empty());
    CHECK(found == records);
    append(scratch.name(), {4, 5, 6});
    CHECK(opened(scratch.name(), &found).empty());
    REQUIRE(found.size() == records.size() + 1);
    CHECK(found.back() == Bytes{4, 5, 6});
}

TEST_CASE("an append that stopped anywhere leaves the records before it, and itself where it was whole") {
    const tests::ScratchFile scratch("interrupted.ckpt");
    write_records(scratch.name());
    const auto before = scratch.bytes();
    const Bytes more{21, 22, 23, 24, 25};
    append(scratch.name(), more);
    const auto after = scratch.bytes();
    auto all = records;
    all.push_back(more);
    // the writes of an append, in their order: the record, then the older mark
    std::vector<std::size_t> written;
    for (std::size_t at = before.size(); at < after.size(); ++at) written.push_back(at);
    for (std::size_t k = 0; k < CheckpointFile::mark_size; ++k) written.push_back(CheckpointFile::marks_at[1] + k);
    auto partly = before;
    for (std::size_t k = 0; k < written.size(); ++k) {
        scratch.write(partly);
        std::vector<Bytes> found;
        const bool whole = partly.size() == after.size();
        if (!opened(scratch.name(), &found).empty() || found != (whole ? all : records))
            FAIL("stopped after " << k << " bytes");
        if (!whole) CHECK(scratch.bytes() == before);
        if (written[k] == partly.size()) partly.push_back(0);
        partly[written[k]] = after[written[k]];
    }
    CHECK(partly == after);
}

TEST_CASE("damage behind what is committed costs no more than the records there") {
    const tests::ScratchFile scratch("tail.ckpt");
    Bytes during;
    {
        CheckpointFile file(scratch.name(), header, any_record);
        for (const Bytes& bytes : records) file.append(bytes);
        during = scratch.bytes();  // as a killed process would leave it: nothing is committed yet
    }
    std::vector<Bytes> found;
    scratch.write(during);
    CHECK(opened(scratch.name(), &found).empty());
    CHECK(found == records);
    for (std::size_t at = scratch.bytes().size() - 3; at > CheckpointFile::header_at + 26; --at) {
        auto damaged = during;
        damaged[at] ^= 16;
        scratch.write(damaged);
        CHECK(opened(scratch.name(), &found).empty());
        CHECK(found.size() < records.size());
        CHECK(found ==
              std::vector<Bytes>(records.begin(), records.begin() + static_cast<std::ptrdiff_t>(found.size())));
    }
}

TEST_CASE("a record that its reader cannot use is refused, with its number") {
    const tests::ScratchFile scratch("unusable.ckpt");
    write_records(scratch.name());
    const auto sound = scratch.bytes();
    std::string said;
    try {
        CheckpointFile(scratch.name(), header, [](std::uint64_t, std::span<const std::uint8_t> bytes) {
            return std::string(bytes.empty() ? "has a wrong size" : "");
        });
    } catch (const CheckpointError& error) {
        said = error.wrong();
    }
    CHECK(said == "record 1 has a wrong size; restore the file from a copy, or name another one to start anew");
    CHECK(scratch.bytes() == sound);
}

TEST_CASE("the file of another run is refused by name and stays as it is") {
    const tests::ScratchFile scratch("other.ckpt");
    write_records(scratch.name());
    const auto sound = scratch.bytes();
    const auto said = [&](const Header& mine) { return opened(scratch.name(), nullptr, mine); };
    CHECK(said({{"model", "a chain"}, {"seed", "1"}}) ==
          "is of another run: its model is a pendulum, this run's is a chain");
    CHECK(said({{"model", "a pendulum"}, {"seed", "2"}}) == "is of another run: its seed is 1, this run's is 2");
    CHECK(said({{"model", "x"}, {"seed", "2"}}) ==
          "is of another run: its model is a pendulum, this run's is x; its seed is 1, this run's is 2");
    CHECK(said({{"model", "a pendulum"}}) == "is of another run: its seed is 1, this run's is nothing");
    CHECK(said({{"a", "1"}, {"b", "1"}, {"c", "1"}, {"d", "1"}}) ==
          "is of another run: its a is nothing, this run's is 1; its b is nothing, this run's is 1; its c is nothing, "
          "this run's is 1; 3 more differ");
    CHECK(said({{"seed", "1"}, {"model", "a pendulum"}}) == "is of another run: its header is written otherwise");
    CHECK(scratch.bytes() == sound);
}

TEST_CASE("what is no checkpoint is refused and stays as it is") {
    const tests::ScratchFile scratch("none.ckpt");
    const std::string text = "theta_1,theta_2\n0,3.14159\n";
    for (const std::size_t size : {std::size_t{1}, std::size_t{7}, text.size()}) {
        const Bytes bytes(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size));
        scratch.write(bytes);
        CHECK(opened(scratch.name()) == "is not a checkpoint");
        CHECK(scratch.bytes() == bytes);
    }
    scratch.write(Bytes(10000, 0));
    CHECK(opened(scratch.name()) == "is not a checkpoint");
    scratch.write({});
    CHECK(opened(scratch.name()) == "is empty: not a checkpoint");

    std::filesystem::remove(scratch.name());
    write_records(scratch.name());
    auto newer = scratch.bytes();
    newer[8] = 2;
    scratch.write(newer);
    CHECK(opened(scratch.name()) == "is of format 2; this program reads format 1");

    std::filesystem::remove(scratch.name());
    CHECK(opened(scratch.name() + "/missing/folder.ckpt") == "cannot be created (No such file or directory)");
    std::filesystem::create_directory(scratch.name());
    CHECK(opened(scratch.name()) == "cannot be opened (Is a directory)");
    std::filesystem::remove(scratch.name());
    CHECK(opened("/dev/null") == "is not a regular file");
    std::filesystem::create_symlink(scratch.name() + "_missing", scratch.name());
    CHECK(opened(scratch.name()) == "cannot be created (No such file or directory)");
    std::filesystem::remove(scratch.name());

    try {
        CheckpointFile file("", header, any_record);
        FAIL("an empty name was taken");
    } catch (const CheckpointError& error) {
        CHECK(std::string(error.what()) == "checkpoint = '': must be the name of a file");
    }
}

TEST_CASE("a file is used by one run at a time") {
    const tests::ScratchFile scratch("locked.ckpt");
    {
        CheckpointFile first(scratch.name(), header, any_record);
        CHECK(opened(scratch.name()) == "is in use by another run");
        first.append(records[0]);
    }
    std::vector<Bytes> found;
    CHECK(opened(scratch.name(), &found).empty());
    CHECK(found.size() == 1);
}

TEST_CASE("a full disk ends the run, and what was committed is kept") {
    const tests::ScratchFile scratch("full.ckpt");
    rlimit before{};
    REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    std::string said;
    std::size_t written = 0;
    {
        CheckpointFile file(scratch.name(), header, any_record);
        file.append(records[0]);
        written = scratch.bytes().size();
        rlimit limit = before;
        limit.rlim_cur = written + 1000;
        setrlimit(RLIMIT_FSIZE, &limit);
        try {
            file.append(Bytes(2000, 1));
        } catch (const CheckpointError& error) {
            said = error.wrong();
        }
        setrlimit(RLIMIT_FSIZE, &before);
    }
    std::signal(SIGXFSZ, handler);
    CHECK(said == "cannot be written, what is in it is kept (File too large)");
    CHECK(scratch.bytes().size() > written);  // half of a record
    std::vector<Bytes> found;
    CHECK(opened(scratch.name(), &found).empty());
    CHECK(found == std::vector<Bytes>{records[0]});
}
