// Loci in a plane, what is proved of them, and curves of cusps, as JSON and CSV.
#if __has_include(<nlohmann/json.hpp>)

#include <string>
#include <vector>

#include <equilibria/io/results/cusp_locus_output.hpp>
#include <equilibria/io/results/locus_output.hpp>
#include <equilibria/io/results/locus_proof_output.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "io/read_csv.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using M = mechanisms::TwoLinkChain;

namespace {

const AxisNames names{"alpha", "omega", "ratio"};

LocusPoint<M> point(double x, double y) { return {.x = x, .y = y, .q = {0.25, -0.5}, .v = {1, 0}}; }

Locus<M> a_locus() {
    Locus<M> locus;
    locus.window = {0, 1, 0, 5};
    locus.curves = {{LocusKind::fold, {point(0.25, 1), point(0.5, 2)}, {CurveEnd::window, CurveEnd::symmetric}},
                    {LocusKind::pitchfork, {point(0.125, 3)}, {CurveEnd::closed, CurveEnd::closed}}};
    locus.cusps = {{point(0.5, 2), 1e-15, -3.5}};
    locus.degenerate_pitchforks = {point(0.75, 4)};
    locus.regions = {{{0.5, 1.5}, 4, {2, 1, 1}, 0.5, true, true, {{{0, 0}, {1, 0}, {1, 1}}}},
                     {{0.5, 3}, 6, {2, 3, 1}, 4.5, true, false, {}}};
    locus.borders = {{0, 1, 1}};
    locus.extremal = {{LocusKind::fold, M::omega, point(0.5, 2)}, {LocusKind::fold, M::alpha, point(0.5, 2)}};
    locus.evidence.lines = 12, locus.evidence.wrong_counts = 1;
    return locus;
}

}  // namespace

TEST_CASE("locus: its JSON") {
    const auto locus = a_locus();
    const Json again = Json::parse(json_text(json_of(locus, names, M::alpha)));
    CHECK(again["alpha"].dump() == "[0.0,1.0]");
    CHECK(again["omega"].dump() == "[0.0,5.0]");
    CHECK(again["cusps"].dump() ==
          R"([{"alpha":0.5,"omega":2.0,"angles":[0.25,-0.5],"residual":1e-15,"fourth_derivative":-3.5}])");
    CHECK(again["degenerate_pitchforks"].dump() == R"([{"alpha":0.75,"omega":4.0,"angles":[0.25,-0.5]}])");
    CHECK(again["curves"][0].dump() == R"({"kind":"fold","points":[[0.25,1.0],[0.5,2.0]],"ends":["window","symmetric"]})");
    CHECK(again["curves"][1]["kind"] == "pitchfork");
    CHECK(again["regions"][0]["count"] == 4);
    CHECK(again["regions"][0]["confirmed"] == true);
    CHECK(again["regions"][1]["confirmed"] == false);
    CHECK(again["regions"][0]["polygons"].dump() == "[[[0.0,0.0],[1.0,0.0],[1.0,1.0]]]");
    CHECK(again["regions"][0]["point"].dump() == "[0.5,1.5]");
    CHECK(again["borders"].dump() == R"([{"regions":[0,1],"curve":1,"kind":"pitchfork"}])");
    CHECK(again["extremal"][0]["of"] == "omega");
    CHECK(again["extremal"][1]["of"] == "alpha");
    CHECK(again["argument"] == locus.argument());
    CHECK(again["evidence"]["lines"] == 12);
    CHECK(again["evidence"]["wrong_counts"] == 1);
    CHECK(again["evidence"]["complete"] == false);
}

TEST_CASE("locus: its CSV") {
    CHECK(curves_csv(a_locus(), names).text() == "curve,kind,alpha,omega,q1,q2\n0,fold,0.25,1,0.25,-0.5\n"
                                                 "0,fold,0.5,2,0.25,-0.5\n1,pitchfork,0.125,3,0.25,-0.5\n");
    CHECK(regions_csv(a_locus(), names).text() ==
          "region,alpha,omega,area,count,confirmed,index_0,index_1,index_2\n0,0.5,1.5,0.5,4,1,2,1,1\n"
          "1,0.5,3,4.5,6,0,2,3,1\n");
}

TEST_CASE("locus: shares proved, and cells") {
    LocusProof proof;
    proof.folds = {9, 10};
    proof.largest_radius = 0.5;
    CHECK(json_of(proof)["folds"].dump() == R"({"proved":9,"of":10})");
    CHECK(json_of(proof)["largest_radius"] == 0.5);
    for (const char* key : {"pitchforks", "cusps", "extremal", "degenerate_pitchforks", "regions"})
        CHECK(json_of(proof)[key].dump() == R"({"proved":0,"of":0})");

    RegionProof cells;
    cells.window = {0, 1, 0, 3};
    cells.cells = {{{0, 0.5, 0, 3}, CountArgument::real_search, 4, {1, 2, 1}}};
    cells.undecided.resize(2);
    cells.proved_area_share = 0.5;
    const Json again = Json::parse(json_text(json_of(cells, names), -1));
    CHECK(again["cells"].dump() == R"([{"alpha":[0.0,0.5],"omega":[0.0,3.0],"count":4,"by_index":[1,2,1],"argument":"real search"}])");
    CHECK(again["undecided"] == 2);
    CHECK(again["proved_area_share"] == 0.5);
    CHECK(cells_csv(cells, names).text() == "alpha_low,alpha_high,omega_low,omega_high,count,argument,index_0,index_1,"
                                            "index_2\n0,0.5,0,3,4,real search,1,2,1\n");
    CHECK(cells_csv(RegionProof{}, names).text() == "alpha_low,alpha_high,omega_low,omega_high,count,argument\n");
}

TEST_CASE("cusp locus: curves, transitions and planes") {
    CuspLocus<M> locus;
    locus.box = {0, 1, 0, 20, 1, 3};
    CuspCurvePoint<M> at;
    at.x = 0.5, at.y = 2, at.z = 1.5, at.q = {0.25, -0.5}, at.fourth = 3;
    CuspTransition<M> t;
    t.x = 0.0625, t.y = 1.5, t.z = 1.75;
    t.at.kind = SingularityKind::beak_to_beak;
    t.at.nullity = 1;
    t.at.derivatives = {0, 1, 2, 3, 4, 5};
    t.at.form = {-1, 2};
    locus.curves = {{{at, at}, {CuspCurveEnd::box, CuspCurveEnd::degenerate}, {t}}};
    locus.planes.resize(1);
    locus.planes[0].z = 1.5;
    locus.planes[0].cusps = {point(0.5, 2)};
    locus.planes[0].given_up = {{1.25, 2, 3}};
    const Json again = Json::parse(json_text(json_of(locus, names)));
    CHECK(again["ratio"].dump() == "[1.0,3.0]");
    CHECK(again["cusp_curves"][0]["points"][0].dump() == R"({"ratio":1.5,"alpha":0.5,"omega":2.0})");
    CHECK(again["cusp_curves"][0]["ends"].dump() == R"(["box","degenerate"])");
    const Json& found = again["transitions"][0];
    CHECK(found["kind"] == "beak_to_beak");
    CHECK(found["alpha"] == 0.0625);
    CHECK(found["derivatives"].dump() == "[0.0,1.0,2.0,3.0,4.0,5.0]");
    CHECK(found["form"].dump() == "[-1.0,2.0]");
    CHECK(again["planes"][0]["cusps"].dump() == R"([{"alpha":0.5,"omega":2.0,"angles":[0.25,-0.5]}])");
    CHECK(again["planes"][0]["given_up"].dump() == R"([{"ratio":1.25,"failed":2,"solutions":3}])");
    CHECK(again["planes"][0]["paths"]["total"] == 0);
    CHECK(again["complete"] == true);
    CHECK(cusp_curves_csv(locus, names).text() == "curve,ratio,alpha,omega,q1,q2,fourth_derivative\n"
                                                  "0,1.5,0.5,2,0.25,-0.5,3\n0,1.5,0.5,2,0.25,-0.5,3\n");

    Singularity<M> umbilic;
    umbilic.kind = SingularityKind::hyperbolic_umbilic;
    umbilic.nullity = 2;
    umbilic.cubic = {1, 2, 3, 4};
    CHECK(json_of(umbilic)["kind"] == "hyperbolic_umbilic");
    CHECK(json_of(umbilic)["derivatives"].dump() == "[1.0,2.0,3.0,4.0]");
    CHECK(!json_of(umbilic).contains("form"));
}

#endif
