#include "enumerate/coupled_angles.hpp"

TEST_CASE("5 coupled angles: every path to infinity is seen") {
    CHECK(tests::check_coupled_angles<5>(252, 120, 1) == 2);
}
