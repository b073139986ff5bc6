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
    // nothing else is left beside it
    const std::filesystem::path place(file.name());
    for (const auto& entry : std::filesystem::directory_iterator(place.parent_path()))
        CHECK((entry.path() == place || !entry.path().string().starts_with(file.name())));

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
    CHECK_THROWS_AS(write_text(folder.name(), "four"), std::system_error);  // no file, and not to be written to
    CHECK(std::filesystem::is_empty(folder.name()));
}

TEST_CASE("text file: devices stay devices, links stay links") {
    write_text("/dev/null", "nothing");
    CHECK(std::filesystem::is_character_file("/dev/null"));

    const tests::ScratchFile file("target"), link("link");
    write_text(file.name(), "before");
    std::filesystem::create_symlink(file.name(), link.name());
    write_text(link.name(), "after");
    CHECK(std::filesystem::is_symlink(link.name()));
    std::ifstream in(file.name());
    CHECK(std::string{std::istreambuf_iterator<char>(in), {}} == "after");
}
