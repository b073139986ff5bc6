#include <equilibria/stability/hurwitz.hpp>
#include <equilibria/stability/routh.hpp>
#include <equilibria/stability/second_order_system.hpp>

namespace equilibria {

template struct SecondOrderSystem<Eigen::MatrixXd>;
template Eigen::VectorXcd poles(const SecondOrderSystem<Eigen::MatrixXd>&);
template Eigen::VectorXd characteristic_polynomial(const SecondOrderSystem<Eigen::MatrixXd>&);
template RouthTable<Eigen::VectorXd> routh_table(const Eigen::VectorXd&);
template HurwitzCriterion<Eigen::VectorXd> hurwitz_criterion(const Eigen::VectorXd&);

}  // namespace equilibria
