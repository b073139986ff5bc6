#include "enumerate/coupled_angles.hpp"
#include "support/enumeration.hpp"
#include "support/models.hpp"

TEST_CASE("3 coupled angles: every path to infinity is seen") {
    CHECK(tests::check_coupled_angles<3>(20, 16, 10) == 20);
}
