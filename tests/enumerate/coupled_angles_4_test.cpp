#include "enumerate/coupled_angles.hpp"

TEST_CASE("4 coupled angles: every path to infinity is seen") { CHECK(tests::check_coupled_angles<4>(70, 44, 3) == 6); }
