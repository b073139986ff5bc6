#include <equilibria/certify/detail/bernstein_bound_definitions.hpp>
#include <equilibria/certify/detail/enclosure_definitions.hpp>
#include <equilibria/certify/detail/refine_root_definitions.hpp>
#include <equilibria/certify/exact_system.hpp>
#include <equilibria/core/detail/big_integer_definitions.hpp>
#include <equilibria/core/detail/exact_ball_definitions.hpp>

namespace equilibria {

template ExactBall sqrt(const ExactBall&);
template ExactBall exp(const ExactBall&);
template ExactBall log(const ExactBall&);
template ExactBall sin(const ExactBall&);
template ExactBall cos(const ExactBall&);
template ExactBall inverse(const ExactBall&);

template class RuntimePool<ExactBall>;
template class RuntimeScalar<ExactBall>;
template class RuntimeAngle<ExactBall>;
template class RuntimePool<Dual<ExactBall, 2>>;
template class RuntimeScalar<Dual<ExactBall, 2>>;
template class RuntimeAngle<Dual<ExactBall, 2>>;

}  // namespace equilibria
