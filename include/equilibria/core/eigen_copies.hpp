/// \file
/// Arrays and matrices of a size known at run time as Eigen's, and back.
#pragma once

#include <algorithm>

#include <Eigen/Core>

#include <equilibria/core/sized_array.hpp>

namespace equilibria {

/// A copy of the entries.
/// \{
inline Eigen::VectorXd eigen_vector(const RuntimeArray<double>& a) {
    return Eigen::Map<const Eigen::VectorXd>(a.begin(), a.size());
}
inline Eigen::MatrixXd eigen_matrix(const RuntimeMatrix<double>& a) {
    Eigen::MatrixXd y(a.size(), a.size());
    for (int r = 0; r < a.size(); ++r)
        for (int c = 0; c < a.size(); ++c) y(r, c) = a[r][c];
    return y;
}
inline RuntimeArray<double> runtime_array(const Eigen::VectorXd& v) {
    RuntimeArray<double> y(static_cast<int>(v.size()));
    std::copy(v.begin(), v.end(), y.begin());
    return y;
}
/// \}
/// Of a square matrix.
inline RuntimeMatrix<double> runtime_matrix(const Eigen::MatrixXd& a) {
    RuntimeMatrix<double> y(static_cast<int>(a.rows()));
    for (int r = 0; r < y.size(); ++r)
        for (int c = 0; c < y.size(); ++c) y[r][c] = a(r, c);
    return y;
}

}  // namespace equilibria
