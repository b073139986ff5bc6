// Branches of structures, compiled once for the tests and examples that include this.
#pragma once

#include <equilibria/continuation/branch.hpp>
#include <equilibria/fem/structure.hpp>

#define INSTANCES_STRUCTURE_STEPPER class equilibria::BranchStepper<equilibria::fem::Structure>

#define INSTANCES_STRUCTURE_FOLLOW                                                                          \
    equilibria::Branch<equilibria::fem::Structure> equilibria::follow(                                      \
        equilibria::BranchStepper<equilibria::fem::Structure>&,                                             \
        const equilibria::BranchPoint<equilibria::fem::Structure>&, const equilibria::ContinuationOptions&, \
        const std::vector<equilibria::EventFunction<equilibria::fem::Structure>>&)

#define INSTANCES_STRUCTURE_BRANCH                                                              \
    equilibria::Branch<equilibria::fem::Structure> equilibria::continue_branch(                 \
        const equilibria::fem::Structure&, const equilibria::fem::StructureState&, double, int, \
        const equilibria::ContinuationOptions&,                                                 \
        const std::vector<equilibria::EventFunction<equilibria::fem::Structure>>&)

#ifdef EQUILIBRIA_SHARED_INSTANCES
extern template INSTANCES_STRUCTURE_STEPPER;
extern template INSTANCES_STRUCTURE_FOLLOW;
extern template INSTANCES_STRUCTURE_BRANCH;
#endif
