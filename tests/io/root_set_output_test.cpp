// An enumeration as JSON and CSV: all keys, with the values that the result itself gives.
#if __has_include(<nlohmann/json.hpp>)

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/io/results/root_set_output.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "io/read_csv.hpp"
#include "support/catch.hpp"
#include "support/read_json.hpp"

using namespace equilibria;
using Chain = mechanisms::TwoLinkChain;

namespace {

const RootSet<Chain>& a_set() {
    static const RootSet<Chain> set = enumerate<Chain>({0.4, 1.5, 2});
    return set;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

}  // namespace

TEST_CASE("root set: the keys of its JSON, in their order") {
    const Json out = json_of(a_set());
    std::vector<std::string> keys;
    for (const auto& [key, value] : out.items()) keys.push_back(key);
    CHECK(keys == std::vector<std::string>{"parameters",     "seed",
                                           "start",          "start_reason",
                                           "paths",          "finite",
                                           "at_infinity",    "singular",
                                           "failed",         "cancelled",
                                           "tracked",        "retracked",
                                           "crossed",        "in_double",
                                           "more_digits",    "steps",
                                           "distinct",       "real",
                                           "by_index",       "degenerate",
                                           "multiplicities", "winding_numbers",
                                           "families",       "clean",
                                           "alarms",         "morse_applies",
                                           "morse",          "tracking_seconds",
                                           "seconds",        "failures",
                                           "equilibria",     "roots"});
    CHECK(!json_of(a_set(), {.roots = false}).contains("roots"));
}

TEST_CASE("root set: the values of its JSON are those of the result, and are read again") {
    const auto& set = a_set();
    REQUIRE(set.real() >= 4);
    const Json out = json_of(set, {.parameter_names = {"alpha", "ratio", "omega"}});
    const Json again = tests::read_json(json_text(out));
    CHECK(again == out);
    CHECK(again["parameters"] == Json{{"alpha", 0.4}, {"ratio", 1.5}, {"omega", 2.0}});
    CHECK(again["seed"] == set.seed);
    CHECK(again["paths"] == set.paths.total);
    CHECK(again["paths"] == again["finite"].get<std::uint64_t>() + again["at_infinity"].get<std::uint64_t>() +
                                again["singular"].get<std::uint64_t>() + again["failed"].get<std::uint64_t>() +
                                again["cancelled"].get<std::uint64_t>());
    CHECK(again["distinct"] == set.distinct());
    CHECK(again["real"] == set.real());
    CHECK(again["by_index"].get<std::vector<std::int64_t>>() == set.by_index());
    CHECK(again["clean"] == set.clean());
    CHECK(again["morse"] == set.morse());
    CHECK(again["multiplicities"].size() == set.distinct());
    CHECK(again["failures"].empty());
    REQUIRE(again["equilibria"].size() == set.real());
    REQUIRE(again["roots"].size() == set.distinct());
    for (std::size_t k = 0; k < set.equilibria.size(); ++k) {
        const auto& e = set.equilibria[k];
        const Json& j = again["equilibria"][k];
        for (std::size_t i = 0; i < 2; ++i)
            CHECK(same_bits(j["angles"][i].get<double>(), e.q[static_cast<int>(i)] + 0.0));
        CHECK(same_bits(j["energy"].get<double>(), e.energy));
        CHECK(j["index"] == e.index);
        CHECK(j["nullity"] == e.nullity);
        CHECK(j["stable"] == e.stable());
        CHECK(j["degenerate"] == e.degenerate());
        CHECK(j["multiplicity"] == e.multiplicity);
        CHECK(j["path"] == e.path);
        for (const char* key : {"residual", "condition", "margin"}) CHECK(j[key].is_number());
    }
    for (std::size_t k = 0; k < set.roots.size(); ++k)
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(same_bits(again["roots"][k][i][0].get<double>(), set.roots[k].q[static_cast<int>(i)].real() + 0.0));
            CHECK(same_bits(again["roots"][k][i][1].get<double>(), set.roots[k].q[static_cast<int>(i)].imag() + 0.0));
        }
    CHECK_THROWS_AS(json_of(set, {.parameter_names = {"alpha"}}), InvalidArgument);
}

TEST_CASE("root set: failures, families and an energy that is not there") {
    RootSet<Chain> set = a_set();
    set.failures.push_back({7, FailureReason::step_too_small, {}});
    Family<Chain> family;
    family.dimension = 1;
    family.real_point = Unknowns<Chain>{0.5, 0.25};
    family.points.resize(2);
    set.families.push_back(family);
    set.equilibria.front().energy = std::numeric_limits<double>::quiet_NaN();
    const Json again = tests::read_json(json_text(json_of(set)));
    CHECK(again["failures"] == Json::array({{{"path", 7}, {"reason", "step too small"}}}));
    CHECK(again["families"] == Json::array({"a real curve of solutions (2 paths)"}));
    CHECK(again["equilibria"][0]["energy"].is_null());
    CHECK(tests::read_csv(equilibria_csv(set).text())[1][6] == "nan");
}

TEST_CASE("root set: CSV of equilibria and of roots, bit by bit") {
    const auto& set = a_set();
    const auto lines = tests::read_csv(equilibria_csv(set).text());
    CHECK(lines[0] == std::vector<std::string>{"q1", "q2", "index", "nullity", "multiplicity", "stable", "energy",
                                               "residual", "condition", "margin", "path"});
    REQUIRE(lines.size() == set.equilibria.size() + 1);
    for (std::size_t k = 0; k < set.equilibria.size(); ++k) {
        const auto& e = set.equilibria[k];
        const auto& line = lines[k + 1];
        for (std::size_t i = 0; i < 2; ++i)
            CHECK(same_bits(std::strtod(line[i].c_str(), nullptr), e.q[static_cast<int>(i)] + 0.0));
        CHECK(line[2] == std::to_string(e.index));
        CHECK(line[5] == (e.stable() ? "1" : "0"));
        CHECK(same_bits(std::strtod(line[6].c_str(), nullptr), e.energy));
        CHECK(same_bits(std::strtod(line[8].c_str(), nullptr), e.condition));
        CHECK(line[10] == std::to_string(e.path));
    }
    const auto roots = tests::read_csv(roots_csv(set).text());
    CHECK(roots[0] == std::vector<std::string>{"q1_re", "q1_im", "q2_re", "q2_im", "residual", "condition", "path",
                                               "paths", "winding_number", "status"});
    REQUIRE(roots.size() == set.roots.size() + 1);
    for (std::size_t k = 0; k < set.roots.size(); ++k) {
        CHECK(same_bits(std::strtod(roots[k + 1][3].c_str(), nullptr), set.roots[k].q[1].imag() + 0.0));
        CHECK(roots[k + 1][9] == "finite");
    }
}

#endif
