#include <equilibria/enumerate/enumerate.hpp>
