#include "instances/enumerate/holonomic_enumeration.hpp"

template INSTANCES_ENUMERATION(equilibria::mechanisms::HolonomicMechanism, TotalDegree);
template INSTANCES_PROOF(equilibria::mechanisms::HolonomicMechanism);
