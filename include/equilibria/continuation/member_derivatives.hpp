/// \file
/// The derivatives of a member of a parametric problem by the second parameter (critical_curve.hpp).
#pragma once

#include <Eigen/Core>

namespace equilibria {

/// What changes in a member with the second parameter r.
struct MemberDerivatives {
    Eigen::VectorXd residual;      ///< dg/dr
    Eigen::VectorXd tangent_of_v;  ///< (dK/dr) v
};

}  // namespace equilibria
