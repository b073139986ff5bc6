// The account of the paths as JSON.
#if __has_include(<nlohmann/json.hpp>)

#include <equilibria/io/results/path_counts_output.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("path counts: nested and flat, the ends of all paths") {
    PathCounts n;
    n.total = 15, n.finite = 5, n.at_infinity = 4, n.singular = 3, n.failed = 2, n.cancelled = 1;
    n.tracked = 8, n.retracked = 7, n.crossed = 6, n.in_double = 10, n.more_digits = 9, n.steps = 100;
    const char* const ends =
        R"("finite":5,"at_infinity":4,"singular":3,"failed":2,"cancelled":1,"tracked":8,"retracked":7,"crossed":6,"in_double":10,"more_digits":9,"steps":100})";
    CHECK(json_of(n).dump() == R"({"total":15,)" + std::string(ends));
    Json flat = Json::object();
    add_paths(flat, n);
    CHECK(flat.dump() == R"({"paths":15,)" + std::string(ends));

    SolutionCounts solved;
    solved.add(n);
    solved.searches = 2, solved.attempts = 3, solved.solutions = 4;
    const Json out = json_of(solved);
    CHECK(out["paths"]["total"] == 15);
    CHECK(out["searches"] == 2);
    CHECK(out["attempts"] == 3);
    CHECK(out["solutions"] == 4);
}

#endif
