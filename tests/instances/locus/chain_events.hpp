// The events of rotating chains over omega, compiled once for the tests and examples that include this.
#pragma once

#include <equilibria/locus/line/line_events.hpp>

#include "instances/enumerate/chain_enumerations.hpp"

#define INSTANCES_EVENTS(Model)                                                 \
    equilibria::LineEvents<Model> equilibria::find_events<Model, Model::omega>( \
        const equilibria::Parameters<Model>&, const equilibria::Interval&, const equilibria::RunOptions&)

#ifdef EQUILIBRIA_SHARED_INSTANCES
extern template INSTANCES_EVENTS(equilibria::mechanisms::TwoLinkChain);
extern template INSTANCES_EVENTS(equilibria::mechanisms::RotatingChain<3>);
#endif
