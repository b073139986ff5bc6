// What stands before a script file, and, where gnuplot is installed, that it reads what was given.
#include <cstdlib>
#include <string>

#include <equilibria/io/gnuplot.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("gnuplot: data blocks, and rows for those that are empty") {
    GnuplotData data;
    data.block("points", "1 2\n3 4\n").block("none", "").block("wide", "", 3);
    CHECK(data.text() ==
          "$points << EOD\n1 2\n3 4\nEOD\n$none << EOD\nnan nan \nEOD\n$wide << EOD\nnan nan nan \nEOD\n");
}

TEST_CASE("gnuplot: numbers are no integers, text is quoted, arrays are never empty") {
    GnuplotData data;
    data.value("a", 3).value("b", 0.1).value("c", 1e-20).integer("n", 3).string("t", "it's {/:Italic x}");
    CHECK(data.text() ==
          "a = 3.0\nb = 0.10000000000000001\nc = 9.9999999999999995e-21\nn = 3\nt = 'it''s {/:Italic x}'\n");
    GnuplotData arrays;
    arrays.values("x", {1, 2.5}).strings("s", {"a", "b,c"}).values("none", {}).strings("no_text", {});
    CHECK(arrays.text() ==
          "array x[2] = [1.0,2.5]\narray s[2] = ['a','b,c']\narray none[1] = [0]\narray no_text[1] = ['']\n");
    GnuplotData text;
    text.string("lines", "a\nb");
    CHECK(text.text() == "lines = 'a b'\n");
}

TEST_CASE("gnuplot: a script reads what stands before it") {
    if (std::system("gnuplot --version > /dev/null 2>&1") != 0) {
        WARN("not checked against gnuplot, which is not installed");
        return;
    }
    GnuplotData data;
    data.value("third", 1)
        .integer("n", 2)
        .string("t", "it's")
        .values("places", {0.5, -1e-3})
        .strings("words", {"a", "b c"});
    data.block("points", "1 2\n2 4\n").block("none", "");
    // a wrong value makes the script fail
    const std::string script =
        "if (third / 3 == 0 || n != 2 || t ne \"it's\" || places[2] != -0.001 || words[2] ne 'b c') { exit status 3 }\n"
        "plot $points with lines, $none with points\n";
    CHECK(gnuplot("svg size 200,100", data.text() + script).find("<svg") != std::string::npos);
    CHECK_THROWS_AS(gnuplot("svg size 200,100", data.text() + "if (n == 2) { exit status 3 }\n"), std::runtime_error);
}
