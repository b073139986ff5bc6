#include "enumerate/coupled_angles.hpp"
#include "enumerate/model_enumerations.hpp"

template INSTANCES_ENUMERATION(models::CoupledAngles<3>, TotalDegree);

TEST_CASE("3 coupled angles: every path to infinity is seen") {
    CHECK(tests::check_coupled_angles<3>(20, 16, 10) == 20);
}
