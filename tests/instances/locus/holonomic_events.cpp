#include "instances/locus/holonomic_events.hpp"

template equilibria::LineEvents<equilibria::mechanisms::HolonomicMechanism> equilibria::find_events<
    equilibria::mechanisms::HolonomicMechanism, equilibria::mechanisms::HolonomicMechanism::stiffness_2>(
    const equilibria::Parameters<equilibria::mechanisms::HolonomicMechanism>&, const equilibria::Interval&,
    const equilibria::RunOptions&);
