#include "instances/enumerate/chain_enumerations.hpp"

template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<2>, reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<4>, reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<6>, reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<8>, reflected);
