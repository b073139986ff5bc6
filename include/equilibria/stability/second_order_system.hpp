/// \file
/// Linear motion M x'' + D x' + C x = 0: its characteristic polynomial and its poles, each from the matrices. D may
/// hold gyroscopic terms and C circulatory ones: neither needs to be symmetric.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/core/eigenvalues.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/stability/checks.hpp>

namespace equilibria {

namespace detail {
/// The size that a compile-time size n leads to by f, dynamic if n is.
constexpr int size_from(int n, auto f) { return n == Eigen::Dynamic ? Eigen::Dynamic : f(n); }
}  // namespace detail

/// M, D, C, square matrices of one size n, fixed or dynamic. M is symmetric and positive definite.
template <class Matrix>
struct SecondOrderSystem {
    using Scalar = typename Matrix::Scalar;                                              ///< of the entries
    static constexpr int size = Matrix::RowsAtCompileTime;                               ///< n
    static constexpr int states = detail::size_from(size, [](int n) { return 2 * n; });  ///< 2 n: x and x'
    /// 2 n + 1: of the characteristic polynomial.
    static constexpr int coefficients = detail::size_from(size, [](int n) { return 2 * n + 1; });
    using StateMatrix = Eigen::Matrix<Scalar, states, states>;  ///< of the equations of first order
    using Polynomial = Eigen::Vector<Scalar, coefficients>;     ///< coefficients, from the highest power
    using Poles = Eigen::Vector<std::complex<Scalar>, states>;  ///< one for each state, with their multiplicities

    Matrix mass;       ///< M
    Matrix damping;    ///< D
    Matrix stiffness;  ///< C

    /// The same of a size known at run time, by which all of this is computed: of doubles the library has it compiled.
    SecondOrderSystem<Eigen::MatrixX<Scalar>> of_any_size() const { return {mass, damping, stiffness}; }

    /// Throws InvalidArgument unless the sizes agree, all entries are finite and M is symmetric and positive definite.
    void validate() const;
    /// A of z' = A z for z = (x, unit x'), where `unit` is the unit of time: [0 I; -unit^2 M^-1 C, -unit M^-1 D].
    StateMatrix state_matrix(Scalar unit = 1) const;
    /// A unit of time in which M^-1 D and M^-1 C are of size 1 or less, and the state matrix is balanced.
    Scalar natural_time() const;
};

template <class Matrix>
void SecondOrderSystem<Matrix>::validate() const {
    if constexpr (size != Eigen::Dynamic) {
        of_any_size().validate();
    } else {
        const auto square = [&](const Matrix& a, const char* name) {
            require(a.rows() == mass.rows() && a.cols() == mass.rows(), name,
                    to_text(a.rows()) + " x " + to_text(a.cols()), "must be square, of the size of mass");
            require(a.allFinite(), name, detail::in_one_line(a), "must be finite");
        };
        require(mass.rows() > 0, "mass", "0 x 0", "must have a row at least");
        square(mass, "mass");
        square(damping, "damping");
        square(stiffness, "stiffness");
        const Scalar largest = mass.cwiseAbs().maxCoeff();
        require((mass - mass.transpose()).cwiseAbs().maxCoeff() <= 1e-10 * largest &&
                    Eigen::LLT<Matrix>(mass).info() == Eigen::Success,
                "mass", detail::in_one_line(mass), "must be symmetric and positive definite");
    }
}

template <class Matrix>
typename SecondOrderSystem<Matrix>::StateMatrix SecondOrderSystem<Matrix>::state_matrix(Scalar unit) const {
    if constexpr (size != Eigen::Dynamic) {
        return of_any_size().state_matrix(unit);
    } else {
        const Eigen::LLT<Matrix> factored(mass);
        const auto n = mass.rows();
        StateMatrix a = StateMatrix::Zero(2 * n, 2 * n);
        a.topRightCorner(n, n).setIdentity();
        a.bottomLeftCorner(n, n) = -unit * unit * factored.solve(stiffness);
        a.bottomRightCorner(n, n) = -unit * factored.solve(damping);
        return a;
    }
}

template <class Matrix>
typename SecondOrderSystem<Matrix>::Scalar SecondOrderSystem<Matrix>::natural_time() const {
    if constexpr (size != Eigen::Dynamic) {
        return of_any_size().natural_time();
    } else {
        const StateMatrix a = state_matrix();
        const auto n = mass.rows();
        const Scalar rate =
            std::max(Scalar(std::sqrt(a.bottomLeftCorner(n, n).norm())), a.bottomRightCorner(n, n).norm());
        return rate > 0 ? 1 / rate : Scalar(1);
    }
}

/// The poles, eigenvalues of the state matrix: those with the largest real part last, of a conjugate pair the one with
/// the negative imaginary part first.
template <class Matrix>
typename SecondOrderSystem<Matrix>::Poles poles(const SecondOrderSystem<Matrix>& system) {
    using System = SecondOrderSystem<Matrix>;
    if constexpr (System::size != Eigen::Dynamic) {
        return poles(system.of_any_size());
    } else {
        const auto unit = system.natural_time();
        const typename System::StateMatrix matrix = system.state_matrix(unit);
        const auto values = eigenvalues(static_cast<std::size_t>(matrix.rows()),
                                        std::vector(matrix.data(), matrix.data() + matrix.size()));
        typename System::Poles y(matrix.rows());
        for (Eigen::Index k = 0; k < y.size(); ++k) y[k] = values[static_cast<std::size_t>(k)] / unit;
        std::sort(y.begin(), y.end(), [](const auto& a, const auto& b) {
            return a.real() != b.real() ? a.real() < b.real() : a.imag() < b.imag();
        });
        return y;
    }
}

/// det(M s^2 + D s + C) / det M, from s^2n to the constant; the first coefficient is 1. Each is interpolated on the
/// circle where its term is among the largest, its radius taken from the sizes of the poles, so that small ones are as
/// accurate as large ones; what rounding hides there is 0. (The recurrence of Faddeev and LeVerrier loses six digits of
/// 12 states.)
template <class Matrix>
typename SecondOrderSystem<Matrix>::Polynomial characteristic_polynomial(const SecondOrderSystem<Matrix>& system) {
    using System = SecondOrderSystem<Matrix>;
    if constexpr (System::size != Eigen::Dynamic) {
        return characteristic_polynomial(system.of_any_size());
    } else {
        using Scalar = typename System::Scalar;
        using Complex = std::complex<Scalar>;
        // dynamic sizes: of fixed ones Eigen compiles a factorisation each, for minutes
        const Eigen::LLT<Eigen::MatrixX<Scalar>> factored(system.mass);
        const Eigen::MatrixX<Scalar> damping = factored.solve(system.damping),
                                     stiffness = factored.solve(system.stiffness);
        const auto n = system.mass.rows(), degree = 2 * n, points = degree + 1;
        typename System::Polynomial c(points);
        c[0] = 1;
        Eigen::Vector<Scalar, System::states> sizes = poles(system).cwiseAbs();
        std::sort(sizes.begin(), sizes.end(), std::greater<>());
        for (Eigen::Index k = 1; k <= degree; ++k) {
            const Scalar radius =
                k < degree ? std::max(std::sqrt(sizes[k - 1] * sizes[k]), sizes[k - 1] / 10) : Scalar(0);
            Scalar sum = 0, largest = 0;
            for (Eigen::Index j = 0; j < points; ++j) {
                const auto unit = [&](Eigen::Index turns) {
                    return std::polar(Scalar(1), 2 * std::numbers::pi_v<Scalar> * static_cast<Scalar>(turns % points) /
                                                     static_cast<Scalar>(points));
                };
                const Complex s = radius * unit(j);
                Eigen::MatrixX<Complex> at = stiffness + s * damping;
                at.diagonal().array() += s * s;
                sum += (at.partialPivLu().determinant() * std::conj(unit(j * (degree - k)))).real();
                largest = std::max(largest, at.rowwise().norm().prod());  // Hadamard's bound of the determinant
            }
            const bool hidden =
                std::abs(sum) <= static_cast<Scalar>(8 * points) * Eigen::NumTraits<Scalar>::epsilon() * largest;
            c[k] = hidden ? Scalar(0) : sum / static_cast<Scalar>(points);
            for (Eigen::Index power = k; !hidden && power < degree; ++power) c[k] /= radius;
        }
        return c;
    }
}

}  // namespace equilibria

#ifdef EQUILIBRIA_COMPILED
namespace equilibria {
extern template struct SecondOrderSystem<Eigen::MatrixXd>;
/// \cond
extern template Eigen::VectorXcd poles(const SecondOrderSystem<Eigen::MatrixXd>&);
extern template Eigen::VectorXd characteristic_polynomial(const SecondOrderSystem<Eigen::MatrixXd>&);
/// \endcond
}  // namespace equilibria
#endif
