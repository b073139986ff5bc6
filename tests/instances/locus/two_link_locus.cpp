#include "instances/locus/two_link_locus.hpp"

template INSTANCES_TWO_LINK_LOCUS;
