// Loci in a plane as JSON and CSV, and their points (singular_point_output.hpp).
#if __has_include(<nlohmann/json.hpp>)

#include <equilibria/io/results/locus_output.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/read_json.hpp"

using namespace equilibria;
using M = mechanisms::TwoLinkChain;

namespace {

const AxisNames names{"alpha", "omega", "ratio"};

Singularity<M> point(double x, double y, SingularityKind kind = SingularityKind::fold) {
    auto at = singularity_at<M, M::alpha, M::omega>(kind, {0.25, -0.5}, {x, 1.5, y}, {1, 0});
    return at;
}
Singularity<M> extremal(double x, double y, int parameter) {
    auto at = point(x, y, SingularityKind::extremal_fold);
    at.extremal = parameter;
    return at;
}
Singularity<M> cusp(double x, double y, double residual, double fourth) {
    auto at = point(x, y, SingularityKind::cusp);
    at.residual = residual;
    at.derivatives[1] = fourth;
    return at;
}

Locus<M> a_locus() {
    Locus<M> locus;
    locus.window = {{0, 1}, {0, 5}};
    locus.curves = {{SingularityKind::fold, {point(0.25, 1), point(0.5, 2)}, {CurveEnd::border, CurveEnd::symmetric}},
                    {SingularityKind::pitchfork, {point(0.125, 3)}, {CurveEnd::closed, CurveEnd::closed}}};
    locus.points = {cusp(0.5, 2, 1e-15, -3.5), point(0.75, 4, SingularityKind::tricritical_pitchfork),
                    extremal(0.5, 2, M::omega), extremal(0.5, 2, M::alpha)};
    locus.regions = {{{0.5, 1.5}, 4, {2, 1, 1}, 0.5, true, true, {{{0, 0}, {1, 0}, {1, 1}}}},
                     {{0.5, 3}, 6, {2, 3, 1}, 4.5, true, false, {}}};
    locus.borders = {{0, 1, 1}};
    locus.evidence.lines = 12, locus.evidence.wrong_counts = 1;
    return locus;
}

}  // namespace

TEST_CASE("locus: its JSON") {
    const auto locus = a_locus();
    const Json again = tests::read_json(json_text(json_of(locus, names)));
    CHECK(again["alpha"].dump() == "[0.0,1.0]");
    CHECK(again["omega"].dump() == "[0.0,5.0]");
    CHECK(again["cusps"].dump() ==
          R"([{"alpha":0.5,"omega":2.0,"angles":[0.25,-0.5],"residual":1e-15,"fourth_derivative":-3.5}])");
    CHECK(again["degenerate_pitchforks"].dump() == R"([{"alpha":0.75,"omega":4.0,"angles":[0.25,-0.5]}])");
    CHECK(again["curves"][0].dump() ==
          R"({"kind":"fold","points":[[0.25,1.0],[0.5,2.0]],"ends":["window","symmetric"]})");
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
    CHECK(curves_csv(a_locus(), names).text() ==
          "curve,kind,alpha,omega,q1,q2\n0,fold,0.25,1,0.25,-0.5\n"
          "0,fold,0.5,2,0.25,-0.5\n1,pitchfork,0.125,3,0.25,-0.5\n");
    CHECK(regions_csv(a_locus(), names).text() ==
          "region,alpha,omega,area,count,confirmed,index_0,index_1,index_2\n0,0.5,1.5,0.5,4,1,2,1,1\n"
          "1,0.5,3,4.5,6,0,2,3,1\n");
}

#endif
