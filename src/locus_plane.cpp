#include <equilibria/locus/line/detail/coordinate_sizes_definitions.hpp>
#include <equilibria/locus/line/detail/infinity_search_definitions.hpp>
#include <equilibria/locus/plane/detail/locus_result_definitions.hpp>
#include <equilibria/locus/plane/detail/trace_locus_definitions.hpp>
