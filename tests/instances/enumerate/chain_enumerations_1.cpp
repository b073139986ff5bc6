#include "instances/enumerate/chain_enumerations.hpp"

template INSTANCES_ENUMERATION(equilibria::mechanisms::TwoLinkChain, reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<1>, reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<3>, reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<5>, reflected);
template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<7>, reflected);
