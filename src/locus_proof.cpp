#include <equilibria/certify/detail/real_search_definitions.hpp>
#include <equilibria/locus/proof/detail/prove_locus_definitions.hpp>
#include <equilibria/locus/proof/detail/prove_region_definitions.hpp>
