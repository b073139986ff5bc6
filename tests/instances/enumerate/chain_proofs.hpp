// The proofs of the enumerations of the rotating chains, compiled once for the tests and examples that include this.
#pragma once

#include <equilibria/enumerate/prove.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#define INSTANCES_PROOF(Model)                                                           \
    equilibria::Proof<Model> equilibria::prove<Model>(const equilibria::RootSet<Model>&, \
                                                      const equilibria::RunOptions&, const equilibria::ProveOptions&)

#ifdef EQUILIBRIA_SHARED_INSTANCES
extern template INSTANCES_PROOF(equilibria::mechanisms::TwoLinkChain);
extern template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<1>);
extern template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<2>);
extern template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<3>);
extern template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<4>);
extern template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<5>);
extern template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<6>);
extern template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<7>);
extern template INSTANCES_PROOF(equilibria::mechanisms::RotatingChain<8>);
#endif
