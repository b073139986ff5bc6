#include "equilibrium_events/events_definition.hpp"

template equilibria::Json chain_events<2>(const Chain&, const Options&);
template equilibria::Json chain_events<3>(const Chain&, const Options&);
