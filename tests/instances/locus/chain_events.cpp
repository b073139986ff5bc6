#include "instances/locus/chain_events.hpp"

template INSTANCES_EVENTS(equilibria::mechanisms::TwoLinkChain);
template INSTANCES_EVENTS(equilibria::mechanisms::RotatingChain<3>);
