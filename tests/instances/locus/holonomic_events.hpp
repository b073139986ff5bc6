// The events of the holonomic mechanism over its stiffness c2, compiled once for the tests and examples that include
// this.
#pragma once

#include <equilibria/locus/line/line_events.hpp>

#include "instances/enumerate/holonomic_enumeration.hpp"

#ifdef EQUILIBRIA_SHARED_INSTANCES
extern template equilibria::LineEvents<equilibria::mechanisms::HolonomicMechanism> equilibria::find_events<
    equilibria::mechanisms::HolonomicMechanism, equilibria::mechanisms::HolonomicMechanism::stiffness_2>(
    const equilibria::Parameters<equilibria::mechanisms::HolonomicMechanism>&, const equilibria::Interval&,
    const equilibria::RunOptions&);
#endif
