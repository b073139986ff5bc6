// The enumeration of the holonomic mechanism and its proofs, compiled once for the tests and examples that include
// this.
#pragma once

#include <equilibria/mechanisms/holonomic_mechanism.hpp>

#include "instances/enumerate/chain_enumerations.hpp"
#include "instances/enumerate/chain_proofs.hpp"

#ifdef EQUILIBRIA_SHARED_INSTANCES
extern template INSTANCES_ENUMERATION(equilibria::mechanisms::HolonomicMechanism, TotalDegree);
extern template INSTANCES_PROOF(equilibria::mechanisms::HolonomicMechanism);
#endif
