// The proofs of the locus and of regions of the two-link chain, compiled once for the tests and examples that include
// this.
#pragma once

#include <equilibria/locus/proof/prove_locus.hpp>
#include <equilibria/locus/proof/prove_region.hpp>

#include "instances/enumerate/chain_enumerations.hpp"
#include "instances/enumerate/chain_proofs.hpp"

#define INSTANCES_TWO_LINK_LOCUS_PROOF                                                                         \
    equilibria::LocusProof                                                                                     \
    equilibria::prove_locus<equilibria::mechanisms::TwoLinkChain, equilibria::mechanisms::TwoLinkChain::alpha, \
                            equilibria::mechanisms::TwoLinkChain::omega>(                                      \
        const equilibria::Locus<equilibria::mechanisms::TwoLinkChain>&, const equilibria::RunOptions&)

#define INSTANCES_TWO_LINK_REGION_PROOF                                                                         \
    equilibria::RegionProof                                                                                     \
    equilibria::prove_region<equilibria::mechanisms::TwoLinkChain, equilibria::mechanisms::TwoLinkChain::alpha, \
                             equilibria::mechanisms::TwoLinkChain::omega>(                                      \
        const equilibria::Parameters<equilibria::mechanisms::TwoLinkChain>&, const equilibria::Window&,         \
        const equilibria::RunOptions&, const equilibria::ProveRegionOptions&)

#ifdef EQUILIBRIA_SHARED_INSTANCES
extern template INSTANCES_TWO_LINK_LOCUS_PROOF;
extern template INSTANCES_TWO_LINK_REGION_PROOF;
#endif
