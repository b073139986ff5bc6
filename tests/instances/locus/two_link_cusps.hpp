// The curves of cusps of the two-link chain, compiled once for the tests and examples that include this.
#pragma once

#include <equilibria/locus/space/cusp_locus.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#define INSTANCES_TWO_LINK_CUSPS                                                                     \
    equilibria::CuspLocus<equilibria::mechanisms::TwoLinkChain> equilibria::find_cusp_locus<         \
        equilibria::mechanisms::TwoLinkChain, equilibria::mechanisms::TwoLinkChain::alpha,           \
        equilibria::mechanisms::TwoLinkChain::omega, equilibria::mechanisms::TwoLinkChain::ratio>(   \
        const equilibria::Parameters<equilibria::mechanisms::TwoLinkChain>&, const equilibria::Box&, \
        const equilibria::RunOptions&, const equilibria::CuspLocusOptions&)

#ifdef EQUILIBRIA_SHARED_INSTANCES
extern template INSTANCES_TWO_LINK_CUSPS;
#endif
