#include "equilibrium_events/events_definition.hpp"

template ChainEvents chain_events<1>(const Chain&, const Options&);
template ChainEvents chain_events<4>(const Chain&, const Options&);
