#include "instances/enumerate/chain_enumerations.hpp"

template INSTANCES_ENUMERATION(equilibria::mechanisms::TwoLinkChain, Reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<1>, Reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<3>, Reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<5>, Reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<7>, Reflected);
