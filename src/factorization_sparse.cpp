#include <equilibria/continuation/factorization/detail/sparse_factors_definitions.hpp>
#include <equilibria/continuation/factorization/detail/sparse_ldlt_definitions.hpp>

using Matrix = Eigen::SparseMatrix<double>;

#include "factorization_any.hpp"
