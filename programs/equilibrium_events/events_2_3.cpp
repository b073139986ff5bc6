#include "equilibrium_events/events_definition.hpp"

template ChainEvents chain_events<2>(const Chain&, const Options&);
template ChainEvents chain_events<3>(const Chain&, const Options&);
