#include <equilibria/locus/line/detail/diagram_definitions.hpp>
#include <equilibria/locus/line/detail/line_events_definitions.hpp>
