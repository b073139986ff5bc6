#include <equilibria/formula/detail/formula_builder_definitions.hpp>
#include <equilibria/formula/detail/formula_model_definitions.hpp>
#include <equilibria/studies/formula_model/detail/formula_motion_definitions.hpp>
#include <equilibria/studies/formula_model/detail/formula_searches_definitions.hpp>
