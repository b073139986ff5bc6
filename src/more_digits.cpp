#include <equilibria/enumerate/detail/more_digits_definitions.hpp>
