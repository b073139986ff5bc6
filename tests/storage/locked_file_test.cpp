// A file that one process reads and writes: whole or not there, locked, and every error names it.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <equilibria/storage/locked_file.hpp>

#include "support/catch.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;
using equilibria::detail::Bytes;
using equilibria::detail::LockedFile;
using Catch::Matchers::Contains;
using tests::ScratchFile;

TEST_CASE("A locked file is made whole, read, written and cut") {
    const ScratchFile scratch("locked");
    LockedFile file(scratch.name());
    CHECK_FALSE(file.open());
    REQUIRE(file.create(Bytes{1, 2, 3, 4, 5}));
    CHECK(file.size() == 5);
    file.write(3, Bytes{9, 8, 7});
    file.truncate(5);
    file.sync();
    std::array<std::uint8_t, 3> part{};
    file.read(2, part);
    CHECK(part == std::array<std::uint8_t, 3>{3, 9, 8});
    CHECK(scratch.bytes() == Bytes{1, 2, 3, 9, 8});
}

TEST_CASE("A locked file belongs to one until it is closed") {
    const ScratchFile scratch("owned");
    {
        LockedFile file(scratch.name());
        REQUIRE(file.create(Bytes{1}));
        LockedFile other(scratch.name());
        CHECK_THROWS_WITH(other.open(), "checkpoint = " + scratch.name() + ": is in use by another run");
    }
    LockedFile next(scratch.name());
    CHECK(next.open());
    LockedFile late(scratch.name());
    CHECK_FALSE(late.create(Bytes{2}));  // somebody else was quicker
    CHECK(scratch.bytes() == Bytes{1});
}

TEST_CASE("What a locked file cannot do names the file") {
    const ScratchFile scratch("short");
    LockedFile file(scratch.name());
    REQUIRE(file.create(Bytes{1, 2}));
    std::array<std::uint8_t, 4> part{};
    CHECK_THROWS_WITH(file.read(0, part), "checkpoint = " + scratch.name() + ": is truncated: it ends at byte 2");
    CHECK_THROWS_WITH(LockedFile(""), "checkpoint = '': must be the name of a file");
    LockedFile folder("/");
    CHECK_THROWS_WITH(folder.open(), Contains("checkpoint = /: "));
    LockedFile nowhere(scratch.name() + "/no/such/folder");
    CHECK_THROWS_WITH(nowhere.create(Bytes{1}), Contains("/no/such/folder: cannot be created ("));
}
