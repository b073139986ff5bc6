// Events on a line as JSON and CSV.
#if __has_include(<nlohmann/json.hpp>)

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include <equilibria/io/results/line_events_output.hpp>

#include "io/read_csv.hpp"
#include "support/catch.hpp"
#include "support/models.hpp"
#include "support/read_json.hpp"

using namespace equilibria;
using M = models::ElasticPendulum;

namespace {

LineEvent<M> an_event() {
    LineEvent<M> e;
    e.kind = CriticalKind::isola_center;
    e.value = 1.0 / 3;
    e.q = {0.1, 1.5};
    e.v = {0.6, -0.8};
    e.residual = 1e-15;
    e.correction = std::numeric_limits<double>::quiet_NaN();
    e.reduced = {-0.0, 2.5};
    e.slope = -1;
    e.index = 1;
    e.change = {1, -1, 0};
    e.interval = 1;
    return e;
}

LineEvents<M> two_intervals() {
    LineEvents<M> found;
    found.range = {0, 1};
    found.events = {an_event()};
    found.intervals = {{{0, 1.0 / 3}, 0.1, 0.3, 2, {1, 1, 0}, true, true},
                       {{1.0 / 3, 1}, 0.5, 0.9, 4, {2, 1, 1}, false, false}};
    found.paths.total = 5, found.paths.finite = 3, found.paths.at_infinity = 2;
    found.attempts = 2, found.unclean = 1;
    return found;
}

}  // namespace

TEST_CASE("line events: an event and the tables beside it") {
    const Json out = json_of(two_intervals(), "gravity"), again = tests::read_json(json_text(out));
    const Json& e = again["events"][0];
    CHECK(e["gravity"].get<double>() == 1.0 / 3);
    CHECK(e["kind"] == "isola centre");
    CHECK(e["angles"].dump() == "[0.1]");
    CHECK(e["coordinates"].dump() == "[1.5]");
    CHECK(e["null_vector"].dump() == "[0.6,-0.8]");
    CHECK(e["correction"].is_null());
    CHECK(e["third_derivative"].dump() == "0.0");
    CHECK(e["change_by_index"].dump() == "[1,-1,0]");
    CHECK(e["before"].dump() == "[1,1,0]");
    CHECK(e["after"].dump() == "[2,1,1]");
    for (const char* key : {"index", "interval", "residual", "fourth_derivative", "slope"}) CHECK(e[key].is_number());
    CHECK(again["intervals"][1].dump() ==
          R"({"low":0.3333333333333333,"high":1.0,"at":0.5,"also_at":0.9,"count":4,"by_index":[2,1,1],"clean":false,)"
          R"("confirmed":false})");
    CHECK(again["paths"]["total"] == 5);
    CHECK(again["paths"]["attempts"] == 2);
    CHECK(again["complete"] == false);
    CHECK(again["argument"] == two_intervals().argument());
    for (const char* key : {"low", "high", "complex_solutions", "regular_solutions", "pitchfork_paths",
                            "other_singular", "unexplained", "compared", "wrong_tables", "unclean", "unconfirmed",
                            "bisected", "unnamed", "infinity_values", "solve_seconds", "seconds"})
        CHECK(again[key].is_number());
}

TEST_CASE("line events: at an end of the line there is no table beyond") {
    auto found = two_intervals();
    found.events[0].interval = 0;
    CHECK(json_of(found, "x")["events"][0]["before"].is_null());
    found.events[0].interval = 2;
    CHECK(json_of(found, "x")["events"][0]["after"].is_null());
}

TEST_CASE("line events: CSV") {
    const auto found = two_intervals();
    const auto events = tests::read_csv(events_csv(found.events, "gravity").text());
    CHECK(events[0] == std::vector<std::string>{"gravity", "kind", "q1", "q2", "v1", "v2", "index", "interval",
                                                "residual", "correction", "third_derivative", "fourth_derivative",
                                                "slope"});
    REQUIRE(events.size() == 2);
    CHECK(std::strtod(events[1][0].c_str(), nullptr) == 1.0 / 3);
    CHECK(events[1][9] == "nan");
    CHECK(events[1][10] == "0");
    CHECK(intervals_csv(found).text() ==
          "low,high,at,count,clean,index_0,index_1,index_2\n0,0.3333333333333333,0.1,2,1,1,1,0\n"
          "0.3333333333333333,1,0.5,4,0,2,1,1\n");
}

#endif
