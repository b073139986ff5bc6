// Tables as text: what is written is read again, bit by bit.
#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/io/results/csv.hpp>

#include "io/read_csv.hpp"
#include "support/catch.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;
using tests::read_csv;

TEST_CASE("csv: numbers are read again bit by bit") {
    std::vector<double> values{0.1, 1.0 / 3, 1e-308, 5e-324, 1.7976931348623157e308, -2.5, 1e22, 123456789.0, 0, -1e-9};
    Generator generator(7);
    for (int k = 0; k < 1000; ++k) {
        const double x = std::bit_cast<double>(generator());
        if (std::isfinite(x)) values.push_back(x);
    }
    CsvTable table({"x"});
    for (const double x : values) table.add(CsvRow().add(x));
    const auto lines = read_csv(table.text());
    REQUIRE(lines.size() == values.size() + 1);
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double again = std::strtod(lines[k + 1][0].c_str(), nullptr);
        CAPTURE(lines[k + 1][0]);
        CHECK(std::bit_cast<std::uint64_t>(again) == std::bit_cast<std::uint64_t>(values[k]));
    }
}

TEST_CASE("csv: what is not finite, what is not known, truth and -0") {
    const double inf = std::numeric_limits<double>::infinity();
    CHECK(csv_cell(std::nan("")) == "nan");
    CHECK(csv_cell(inf) == "inf");
    CHECK(csv_cell(-inf) == "-inf");
    CHECK(csv_cell(-0.0) == "0");
    CHECK(csv_cell(true) == "1");
    CHECK(csv_cell(false) == "0");
    CHECK(csv_cell(std::optional<int>()) == "");
    CHECK(csv_cell(std::optional<int>(3)) == "3");
    CHECK(csv_cell(std::uint64_t(18446744073709551615u)) == "18446744073709551615");
    CHECK(std::isnan(std::strtod("nan", nullptr)));
    CHECK(std::strtod("-inf", nullptr) == -inf);
}

TEST_CASE("csv: quoting as of RFC 4180") {
    CHECK(csv_cell("plain text") == "plain text");
    CHECK(csv_cell("a,b") == "\"a,b\"");
    CHECK(csv_cell("say \"so\"") == "\"say \"\"so\"\"\"");
    CHECK(csv_cell("two\nlines") == "\"two\nlines\"");
    CsvTable table({"a", "b,c"});
    table.add(CsvRow().add("x\"y").add(""));
    table.add(CsvRow().add("two\nlines").add("z, z"));
    CHECK(table.text() == "a,\"b,c\"\n\"x\"\"y\",\n\"two\nlines\",\"z, z\"\n");
    const auto lines = read_csv(table.text());
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == std::vector<std::string>{"a", "b,c"});
    CHECK(lines[1] == std::vector<std::string>{"x\"y", ""});
    CHECK(lines[2] == std::vector<std::string>{"two\nlines", "z, z"});
}

TEST_CASE("csv: a first cell that is empty keeps its comma") {
    CsvTable table({"a", "b"});
    table.add(CsvRow().add("").add(1));
    CHECK(table.text() == "a,b\n,1\n");
}

TEST_CASE("csv: a line has a cell for each column") {
    CsvTable table({"a", "b"});
    CHECK_THROWS_AS(table.add(CsvRow().add(1)), InvalidArgument);
    CHECK_THROWS_AS(table.add(CsvRow().add(1).add(2).add(3)), InvalidArgument);
    table.add(CsvRow().add(1).add(2));
    CHECK(table.rows() == 1);
}

TEST_CASE("csv: the point is a point in any locale") {
    const std::string before = std::setlocale(LC_NUMERIC, nullptr);
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
        if (std::setlocale(LC_NUMERIC, name)) break;
    const std::string text = csv_cell(0.5);
    std::setlocale(LC_NUMERIC, before.c_str());
    CHECK(text == "0.5");
}

TEST_CASE("csv: a file holds the table, or what it held before") {
    const tests::ScratchFile file("table.csv");
    CsvTable table({"a"});
    table.add(CsvRow().add(0.1));
    write_csv(file.name(), table);
    std::ifstream in(file.name());
    CHECK(std::string{std::istreambuf_iterator<char>(in), {}} == "a\n0.1\n");
    CHECK_THROWS_AS(write_csv(file.name() + "/no/folder.csv", table), std::system_error);
}
