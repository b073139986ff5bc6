#include <equilibria/continuation/factorization/detail/dense_factors_definitions.hpp>
#include <equilibria/core/detail/dense_solvers_definitions.hpp>

using Matrix = Eigen::MatrixXd;

#include "factorization_any.hpp"
