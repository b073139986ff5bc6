// Files are written whole or stay what they were.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include <equilibria/io/results/text_file.hpp>

#include "support/catch.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;

TEST_CASE("text file: written, replaced, refused") {
    const tests::ScratchFile file("text");
    const auto held = [&] {
        std::ifstream in(file.name(), std::ios::binary);
        return std::string{std::istreambuf_iterator<char>(in), {}};
    };
    write_text(file.name(), "one\n");
    CHECK(held() == "one\n");
    write_text(file.name(), std::string("two\0\r\n", 6));
    CHECK(held() == std::string("two\0\r\n", 6));
    CHECK(!std::filesystem::exists(file.name() + ".part"));

    try {
        write_text(file.name() + "/below/a/file", "three");
        FAIL("a file below a file was written");
    } catch (const std::system_error& error) {
        CHECK(error.code() == std::errc::not_a_directory);
        CHECK(std::string(error.what()).find("below/a/file") != std::string::npos);
    }
    CHECK(held() == std::string("two\0\r\n", 6));

    const tests::ScratchFile folder("folder");
    std::filesystem::create_directory(folder.name());
    CHECK_THROWS_AS(write_text(folder.name(), "four"), std::system_error);
    CHECK(!std::filesystem::exists(folder.name() + ".part"));
}
