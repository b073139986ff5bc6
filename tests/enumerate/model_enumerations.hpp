// Enumerations that several files of this folder use, compiled in one of them each.
#pragma once

#include "support/enumeration.hpp"
#include "support/models.hpp"

extern template INSTANCES_ENUMERATION(models::CoupledAngles<3>, TotalDegree);  // coupled_angles_3_test.cpp
extern template INSTANCES_ENUMERATION(models::EqualAngles<4>, Reflected);      // families_test.cpp
extern template INSTANCES_ENUMERATION(models::ElasticPendulum, TotalDegree);   // coordinates_test.cpp
