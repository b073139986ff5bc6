// Curves of cusps, and singularities of every kind (singular_point_output.hpp), as JSON and CSV.
#if __has_include(<nlohmann/json.hpp>)

#include <equilibria/io/results/cusp_locus_output.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/read_json.hpp"

using namespace equilibria;
using M = mechanisms::TwoLinkChain;

namespace {
const AxisNames names{"alpha", "omega", "ratio"};
}

TEST_CASE("cusp locus: curves, transitions and planes") {
    CuspLocus<M> locus;
    locus.box = {{0, 1}, {0, 20}, {1, 3}};
    const auto singularity = [](SingularityKind kind, double x, double y, double z) {
        return singularity_at<M, M::alpha, M::omega, M::ratio>(kind, {0.25, -0.5}, {x, z, y}, {1, 0});
    };
    auto at = singularity(SingularityKind::cusp, 0.5, 2, 1.5);
    at.derivatives[1] = 3;
    CuspTransition<M> t;
    t.at = singularity(SingularityKind::beak_to_beak, 0.0625, 1.5, 1.75);
    t.at.nullity = 1;
    t.at.derivatives = {0, 1, 2, 3, 4, 5};
    t.at.form = {-1, 2};
    locus.curves = {{{at, at}, {CurveEnd::border, CurveEnd::degenerate}, {t}}};
    locus.planes.resize(1);
    locus.planes[0].z = 1.5;
    locus.planes[0].cusps = {at};
    locus.planes[0].given_up = {{1.25, 2, 3}};
    const Json again = tests::read_json(json_text(json_of(locus, names)));
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
    CHECK(cusp_curves_csv(locus, names).text() ==
          "curve,ratio,alpha,omega,q1,q2,fourth_derivative\n"
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
