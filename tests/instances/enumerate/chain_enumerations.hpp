// The enumerations of the rotating chains, compiled once for the tests and programs that include this.
#pragma once

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

// The start is named, since finding it derives the model's polynomials, in every unit that includes this.
#define INSTANCES_ENUMERATION(Model, Start)                                            \
    equilibria::RootSet<Model> equilibria::enumerate<Model, equilibria::Start<Model>>( \
        const equilibria::Parameters<Model>&, const equilibria::RunOptions&, const equilibria::TrackerOptions&)

#ifdef EQUILIBRIA_SHARED_INSTANCES
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::TwoLinkChain, Reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<1>, Reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<2>, Reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<3>, Reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<4>, Reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<5>, Reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<6>, Reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<7>, Reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<8>, Reflected);
#endif
