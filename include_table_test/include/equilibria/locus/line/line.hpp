#include <equilibria/core/scalar.hpp>
