// Bordered linear systems with matrices of the type Matrix, which is the includer's.
#include <optional>

#include <equilibria/continuation/factorization/detail/bordered_definitions.hpp>

namespace equilibria {

template class BorderedSolver<Matrix>;
template std::optional<WeakDirection> factor_at_weakest(BorderedSolver<Matrix>&, Matrix&&, const Eigen::VectorXd&, int,
                                                        Border&, const Eigen::MatrixXd&, int);
template std::optional<WeakDirection> weakest_direction(BorderedSolver<Matrix>&, const BorderedSolution&,
                                                        const Eigen::VectorXd&, int, Border&, const Eigen::MatrixXd&,
                                                        int);
template bool detail::factor_with_border(BorderedSolver<Matrix>&, Matrix&&, const Eigen::VectorXd&, int, Border&);

}  // namespace equilibria
