#include <equilibria/model/detail/angle.hpp>
