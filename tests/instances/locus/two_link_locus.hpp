// The locus of the two-link chain over alpha and omega, compiled once for the tests and examples that include this.
#pragma once

#include <equilibria/locus/plane/trace_locus.hpp>

#include "instances/enumerate/chain_enumerations.hpp"

#define INSTANCES_TWO_LINK_LOCUS                                                                               \
    equilibria::Locus<equilibria::mechanisms::TwoLinkChain>                                                    \
    equilibria::trace_locus<equilibria::mechanisms::TwoLinkChain, equilibria::mechanisms::TwoLinkChain::alpha, \
                            equilibria::mechanisms::TwoLinkChain::omega>(                                      \
        const equilibria::Parameters<equilibria::mechanisms::TwoLinkChain>&, const equilibria::Window&,        \
        const equilibria::RunOptions&, const equilibria::LocusOptions&, equilibria::MoreDigits<>)

#ifdef EQUILIBRIA_SHARED_INSTANCES
extern template INSTANCES_TWO_LINK_LOCUS;
#endif
