#include <equilibria/model/model.hpp>
