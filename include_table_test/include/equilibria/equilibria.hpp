#include <equilibria/io/svg.hpp>
