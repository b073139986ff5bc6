// What results have in common as JSON.
#if __has_include(<nlohmann/json.hpp>)

#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/random.hpp>
#include <equilibria/io/results/json.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"
#include "support/read_json.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;

TEST_CASE("json: numbers are read again bit by bit, what is not finite is null, -0 is 0") {
    std::vector<double> values{0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -2.5e-7};
    Generator generator(3);
    for (int k = 0; k < 1000; ++k) {
        const double x = std::bit_cast<double>(generator());
        if (std::isfinite(x) && x != 0) values.push_back(x);
    }
    const Json again = tests::read_json(json_text(json_list(values)));
    REQUIRE(again.size() == values.size());
    for (std::size_t k = 0; k < values.size(); ++k)
        CHECK(std::bit_cast<std::uint64_t>(again[k].get<double>()) == std::bit_cast<std::uint64_t>(values[k]));

    CHECK(json_text(json_of(std::nan("")), -1) == "null\n");
    CHECK(json_text(json_of(-std::numeric_limits<double>::infinity()), -1) == "null\n");
    CHECK(json_text(json_of(-0.0), -1) == "0.0\n");
}

TEST_CASE("json: lists, pairs, rows, ranges, what is not known") {
    CHECK(json_of(std::complex<double>(1, -0.0)).dump() == "[1.0,0.0]");
    CHECK(json_list(std::vector<std::complex<double>>{{1, 2}}).dump() == "[[1.0,2.0]]");
    CHECK(json_list(std::vector<int>{1, 2}).dump() == "[1,2]");
    CHECK(json_list(std::vector<std::string>{"a", "b"}).dump() == R"(["a","b"])");
    CHECK(json_rows(Eigen::Matrix2d{{1, 2}, {3, 4}}).dump() == "[[1.0,2.0],[3.0,4.0]]");
    CHECK(json_range(0, 0.5).dump() == "[0.0,0.5]");
    CHECK(json_or_null(std::optional<int>()).is_null());
    CHECK(json_or_null(std::optional<int>(4)) == 4);
}

TEST_CASE("json: angles apart from coordinates, keys in their order") {
    Json out{{"first", 1}};
    add_unknowns<models::ElasticPendulum>(out, {0.5, 2.0});
    CHECK(out.dump() == R"({"first":1,"angles":[0.5],"coordinates":[2.0]})");
    Json angles = Json::object();
    add_unknowns<models::Pendulum>(angles, {0.5});
    CHECK(angles.dump() == R"({"angles":[0.5]})");
    add_keys(out, {{"last", true}, {"first", 2}});
    CHECK(out.dump() == R"({"first":2,"angles":[0.5],"coordinates":[2.0],"last":true})");
}

TEST_CASE("json: a file holds the document") {
    const tests::ScratchFile file("document.json");
    write_json(file.name(), {{"a", 0.1}}, -1);
    std::ifstream in(file.name());
    CHECK(std::string{std::istreambuf_iterator<char>(in), {}} == "{\"a\":0.1}\n");
}

#endif
