#include <Eigen/SparseCore>

using Tangent = Eigen::SparseMatrix<double>;

#include "continuation_any.hpp"
