// The equilibria against a parameter as JSON and CSV.
#if __has_include(<nlohmann/json.hpp>)

#include <equilibria/io/results/diagram_output.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"
#include "support/read_json.hpp"

using namespace equilibria;
using M = models::ElasticPendulum;

TEST_CASE("diagram: branches as JSON and CSV") {
    BifurcationDiagram<M> diagram;
    LineEvent<M> event;
    event.value = 1.0 / 3;
    diagram.events = {event};
    diagram.failed_paths = 3;
    diagram.pieces = {{0, {{0.25, {0.5, 1}}, {0.5, {0.75, 2}}}, {PieceEnd::range, PieceEnd::event}},
                      {2, {{0.125, {-0.5, 3}}}, {PieceEnd::stopped, PieceEnd::infinity}}};
    diagram.unfollowed = 1;
    const Json again = tests::read_json(json_text(json_of(diagram, "gravity")));
    CHECK(again["failed_paths"] == 3);
    CHECK(again["events"][0]["gravity"] == 1.0 / 3);
    CHECK(again["branches"].dump() ==
          R"([{"index":0,"points":[[0.25,0.5,1.0],[0.5,0.75,2.0]],"ends":["range","event"]},)"
          R"({"index":2,"points":[[0.125,-0.5,3.0]],"ends":["stopped","infinity"]}])");
    CHECK(again["complete"] == false);
    CHECK(again["unfollowed"] == 1);
    CHECK(diagram_csv(diagram, "gravity").text() ==
          "branch,index,gravity,q1,q2\n0,0,0.25,0.5,1\n0,0,0.5,0.75,2\n1,2,0.125,-0.5,3\n");
}

#endif
