#include "instances/enumerate/chain_proofs.hpp"

template INSTANCES_PROOF(equilibria::mechanisms::TwoLinkChain);
template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<1>);
template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<2>);
template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<3>);
template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<4>);
template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<5>);
template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<6>);
template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<7>);
template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<8>);
