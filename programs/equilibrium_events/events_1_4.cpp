#include "equilibrium_events/events_definition.hpp"

template equilibria::Json chain_events<1>(const Chain&, const Options&);
template equilibria::Json chain_events<4>(const Chain&, const Options&);
