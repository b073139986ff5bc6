#include "instances/locus/two_link_cusps.hpp"

template INSTANCES_TWO_LINK_CUSPS;
