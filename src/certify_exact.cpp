#include <equilibria/certify/exact_system.hpp>

namespace equilibria {

template class RuntimePool<ExactBall>;
template class RuntimeScalar<ExactBall>;
template class RuntimeAngle<ExactBall>;
template class RuntimePool<Dual<ExactBall, 2>>;
template class RuntimeScalar<Dual<ExactBall, 2>>;
template class RuntimeAngle<Dual<ExactBall, 2>>;

}  // namespace equilibria
