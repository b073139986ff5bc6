// A proof as JSON, alone and beside the enumeration that it is of.
#if __has_include(<nlohmann/json.hpp>)

#include <string>
#include <vector>

#include <equilibria/io/results/proof_output.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"
#include "support/read_json.hpp"

using namespace equilibria;
using M = models::ElasticPendulum;

namespace {

Proof<M> a_proof() {
    Proof<M> p;
    p.certificates = {{.path = 3,
                       .exists = true,
                       .distinct = true,
                       .reality = Reality::real,
                       .index_proved = true,
                       .index = 1,
                       .digits = 16,
                       .radius = 1e-12},
                      {.path = 5, .exists = true, .reality = Reality::non_real, .radius = 2e-12}};
    p.distinct = 2, p.real = 1, p.non_real = 1, p.undecided = 4, p.duplicates = 5, p.index = 1, p.contradictions = 6,
    p.more_digits = 7, p.by_index = {0, 1, 0}, p.bound = ProvedBound{8, "Bezout's", "theorem"}, p.complete = true,
    p.reason = "because", p.seconds = 0.5;
    return p;
}

}  // namespace

TEST_CASE("proof: an object of its own") {
    const Json again = tests::read_json(json_text(json_of(a_proof())));
    CHECK(again == Json{{"complete", true},
                        {"reason", "because"},
                        {"bound", 8},
                        {"distinct", 2},
                        {"real", 1},
                        {"non_real", 1},
                        {"undecided", 4},
                        {"duplicates", 5},
                        {"index", 1},
                        {"contradictions", 6},
                        {"more_digits", 7},
                        {"by_index", {0, 1, 0}},
                        {"seconds", 0.5}});
    Proof<M> open = a_proof();
    open.bound.reset();
    CHECK(json_of(open)["bound"].is_null());
}

TEST_CASE("proof: keys of a document that has the enumeration's") {
    Json out{{"distinct", 11}, {"real", 12}};
    add_proof(out, a_proof());
    CHECK(out["distinct"] == 11);
    CHECK(out["real"] == 12);
    for (const auto& [key, value] : std::vector<std::pair<std::string, Json>>{{"complete", true},
                                                                              {"reason", "because"},
                                                                              {"proved_bound", 8},
                                                                              {"proved_distinct", 2},
                                                                              {"proved_real", 1},
                                                                              {"proved_non_real", 1},
                                                                              {"undecided", 4},
                                                                              {"duplicates", 5},
                                                                              {"proved_index", 1},
                                                                              {"contradictions", 6},
                                                                              {"proved_with_more_digits", 7},
                                                                              {"proving_seconds", 0.5}}) {
        CAPTURE(key);
        CHECK(out.at(key) == value);
    }
    CHECK(out["proved_by_index"].dump() == "[0,1,0]");
}

TEST_CASE("proof: certificates go to the equilibria by their paths") {
    Json equilibria = Json::array({{{"path", 5}}, {{"path", 3}}, {{"path", 4}}});
    add_certificates(equilibria, a_proof());
    CHECK(equilibria[0]["certificate"]["reality"] == "non-real");
    CHECK(equilibria[1]["certificate"] == Json{{"exists", true},
                                               {"distinct", true},
                                               {"reality", "real"},
                                               {"index_proved", true},
                                               {"index", 1},
                                               {"radius", 1e-12},
                                               {"digits", 16}});
    CHECK(!equilibria[2].contains("certificate"));
}

#endif
