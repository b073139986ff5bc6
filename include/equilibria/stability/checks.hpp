/// \file
/// Checks of what the criteria are given, and matrices in error messages.
#pragma once

#include <string>

#include <Eigen/Core>

#include <equilibria/core/error.hpp>
#include <equilibria/core/streamed_text.hpp>

namespace equilibria::detail {

/// A matrix in one line: "[1 2; 3 4]".
template <class Derived>
std::string in_one_line(const Eigen::MatrixBase<Derived>& a) {
    return streamed(a.format(Eigen::IOFormat(Eigen::FullPrecision, Eigen::DontAlignCols, " ", "; ", "", "", "[", "]")));
}

/// Throws InvalidArgument unless these are the coefficients of a polynomial of degree 1 or more, the highest one first.
template <class Derived>
void require_polynomial(const Eigen::MatrixBase<Derived>& coefficients) {
    require(coefficients.size() >= 2 && coefficients.allFinite() && coefficients[0] != 0, "coefficients",
            in_one_line(coefficients.transpose()), "must be two or more, finite, the first one not 0");
}

}  // namespace equilibria::detail
