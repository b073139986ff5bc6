// What is proved of a plane as JSON and CSV.
#if __has_include(<nlohmann/json.hpp>)

#include <equilibria/io/results/locus_proof_output.hpp>

#include "support/catch.hpp"
#include "support/read_json.hpp"

using namespace equilibria;

namespace {
const AxisNames names{"alpha", "omega", "ratio"};
}

TEST_CASE("locus proof: shares proved, and cells") {
    LocusProof proof;
    proof.folds = {9, 10};
    proof.largest_radius = 0.5;
    CHECK(json_of(proof)["folds"].dump() == R"({"proved":9,"of":10})");
    CHECK(json_of(proof)["largest_radius"] == 0.5);
    for (const char* key : {"pitchforks", "cusps", "extremal", "degenerate_pitchforks", "regions"})
        CHECK(json_of(proof)[key].dump() == R"({"proved":0,"of":0})");

    RegionProof cells;
    cells.window = {{0, 1}, {0, 3}};
    cells.cells = {{{{0, 0.5}, {0, 3}}, CountArgument::real_search, 4, {1, 2, 1}}};
    cells.undecided.resize(2);
    cells.proved_area_share = 0.5;
    const Json again = tests::read_json(json_text(json_of(cells, names), -1));
    CHECK(again["cells"].dump() ==
          R"([{"alpha":[0.0,0.5],"omega":[0.0,3.0],"count":4,"by_index":[1,2,1],"argument":"real search"}])");
    CHECK(again["undecided"] == 2);
    CHECK(again["proved_area_share"] == 0.5);
    CHECK(cells_csv(cells, names).text() ==
          "alpha_low,alpha_high,omega_low,omega_high,count,argument,index_0,index_1,"
          "index_2\n0,0.5,0,3,4,real search,1,2,1\n");
    CHECK(cells_csv(RegionProof{}, names).text() == "alpha_low,alpha_high,omega_low,omega_high,count,argument\n");
}

#endif
