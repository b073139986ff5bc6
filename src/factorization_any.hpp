// Bordered linear systems with matrices of the type Matrix, which is the includer's.
#include <optional>

#include <equilibria/continuation/factorization/detail/bordered_definitions.hpp>

namespace equilibria {

template class BorderedSolver<Matrix>;
template std::optional<WeakDirection> factor_at_weakest(BorderedSolver<Matrix>&, const Matrix&, const Eigen::VectorXd&,
                                                        int, Border&);
template bool detail::factor_with_border(BorderedSolver<Matrix>&, const Matrix&, const Eigen::VectorXd&, int, Border&);

}  // namespace equilibria
