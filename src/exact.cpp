#include <equilibria/core/detail/big_integer_definitions.hpp>
#include <equilibria/core/detail/exact_ball_definitions.hpp>

namespace equilibria {

template ExactBall sqrt(const ExactBall&);
template ExactBall exp(const ExactBall&);
template ExactBall log(const ExactBall&);
template ExactBall sin(const ExactBall&);
template ExactBall cos(const ExactBall&);
template ExactBall inverse(const ExactBall&);

}  // namespace equilibria
