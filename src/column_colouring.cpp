#include <equilibria/continuation/detail/column_colouring_definitions.hpp>
