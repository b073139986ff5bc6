#include <equilibria/certify/detail/real_search_definitions.hpp>
