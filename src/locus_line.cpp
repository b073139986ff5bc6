#include <equilibria/locus/line/detail/line_events_definitions.hpp>
