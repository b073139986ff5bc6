/// \file
/// Real eigenvalues of an unsymmetric K, which the sign of its determinant does not count.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <equilibria/continuation/branch_stepper.hpp>

namespace equilibria::detail {

/// How many real eigenvalues of K at a point of a branch are negative, against the problem's weights; -1 where K has
/// more than 150 unknowns, for which it takes 40 ms. The point remembers it.
template <class Matrix>
int negative_real_eigenvalues(const AnyBranchStepper<Matrix>& stepper, const BranchPoint<Erased>& at) {
    constexpr Eigen::Index most = 150;
    if (at.weak_direction.size() > most) at.negative_real = -1;
    if (!at.negative_real) {
        const Eigen::VectorXd by = stepper.metric().cwiseSqrt().cwiseInverse();
        const Eigen::MatrixXd k(stepper.problem().tangent(at.q, at.p));
        const Eigen::VectorXcd values = Eigen::MatrixXd(by.asDiagonal() * k * by.asDiagonal()).eigenvalues();
        at.negative_real =
            static_cast<int>(std::count_if(values.begin(), values.end(), [](const std::complex<double>& z) {
                return z.real() < 0 && std::abs(z.imag()) <= 1e-9 * std::abs(z);
            }));
    }
    return *at.negative_real;
}

}  // namespace equilibria::detail
