#include <vector>

#include <equilibria/polyhedral/affine_supports.hpp>
#include <equilibria/polyhedral/mixed_cells.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Points = std::vector<std::vector<Supports::Point>>;

TEST_CASE("the exponent 0 is added where no equation keeps a single term on a hyperplane") {
    Points with{{{1, 1}, {0, 0}}, {{1, 0}, {0, 1}}};  // x y and 1: one term left where x or y is 0
    add_origin(0, with);
    CHECK(with == Points{{{1, 1}, {0, 0}}, {{1, 0}, {0, 1}}});
    Points without{{{2, 0}, {1, 0}}, {{1, 1}, {0, 2}, {0, 1}}};
    add_origin(0, without);
    CHECK(without[0].size() == 3);
    CHECK(without[1].size() == 4);
    CHECK(mixed_volume(Supports(2, without)).value == 4);
    Points angles{{{2, 0}, {1, 0}}, {{1, 1}, {0, 2}, {0, 1}}};
    add_origin(2, angles);  // no unknown may be 0
    CHECK(angles[0].size() == 2);
}
