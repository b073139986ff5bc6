#include <Eigen/Core>

using Tangent = Eigen::MatrixXd;

#include "continuation_any.hpp"
