// What other units are compared with: three dense solves by Eigen.
#include <Eigen/Dense>
#include <iostream>

int main() {
    Eigen::Matrix3d a = Eigen::Matrix3d::Random();
    Eigen::MatrixXd b = Eigen::MatrixXd::Random(9, 9);
    std::cout << a.fullPivLu().solve(Eigen::Vector3d::Ones()) << b.partialPivLu().solve(Eigen::VectorXd::Ones(9))
              << b.ldlt().solve(Eigen::VectorXd::Ones(9)) << "\n";
}
