// The enumerations of the rotating chains, compiled once for the tests and examples that include this.
#pragma once

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

// The start is named, since finding it derives the model's polynomials, in every unit that includes this.
#define INSTANCES_ENUMERATION(Model, Start)                                                \
    equilibria::RootSet<Model> equilibria::enumerate<Model, equilibria::StartKind::Start>( \
        const equilibria::Parameters<Model>&, const equilibria::EnumerateOptions&)

#ifdef EQUILIBRIA_SHARED_INSTANCES
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::TwoLinkChain, reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<1>, reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<2>, reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<3>, reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<4>, reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<5>, reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<6>, reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<7>, reflected);
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::RotatingChain<8>, reflected);
#endif
