#include "instances/enumerate/chain_enumerations.hpp"

template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<2>, Reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<4>, Reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<6>, Reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<8>, Reflected);
