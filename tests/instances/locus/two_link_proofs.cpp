#include "instances/locus/two_link_proofs.hpp"

template INSTANCES_TWO_LINK_LOCUS_PROOF;
template INSTANCES_TWO_LINK_REGION_PROOF;
