// The enumeration of the holonomic mechanism, which both of its tests use, compiled in holonomic_mechanism_test.cpp.
#pragma once

#include <equilibria/mechanisms/holonomic_mechanism.hpp>

#include "support/enumeration.hpp"

extern template INSTANCES_ENUMERATION(equilibria::mechanisms::HolonomicMechanism, general);
