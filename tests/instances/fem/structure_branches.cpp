#include "instances/fem/structure_branches.hpp"

template INSTANCES_STRUCTURE_STEPPER;
template INSTANCES_STRUCTURE_FOLLOW;
template INSTANCES_STRUCTURE_BRANCH;
