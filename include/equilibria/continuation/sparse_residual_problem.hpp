/// \file
/// Large problems whose residual is generic over the scalar, such as discretised differential equations: one function
/// is written, K is sparse and it and every other derivative exact.
///
///     struct Bratu {                                 // u'' + p e^u = 0 on (0, 1), u = 0 at both ends
///         static constexpr bool symmetric = true;    // a promise; without it K is factored as unsymmetric
///         template <class T>
///         Eigen::VectorX<T> residual(const Eigen::VectorX<T>& u, const T& p) const {
///             using std::exp;
///             const Eigen::Index n = u.size();
///             const double per_h2 = double(n + 1) * double(n + 1);
///             Eigen::VectorX<T> g(n);
///             for (Eigen::Index i = 0; i < n; ++i) {
///                 g(i) = 2 * u(i);
///                 if (i > 0) g(i) -= u(i - 1);
///                 if (i + 1 < n) g(i) -= u(i + 1);
///                 g(i) = per_h2 * g(i) - p * exp(u(i));
///             }
///             return g;
///         }
///     };
///     const SparseResidualProblem problem(Bratu{}, 999);
///     const auto branch = continue_branch(problem, Eigen::VectorXd(Eigen::VectorXd::Zero(999)), 0, 1, options);
///
/// The pattern of K is found once, by a run of the residual with numbers that carry what they depend on
/// (core/dependence.hpp). Its columns are coloured (column_colouring.hpp), and duals carry `Directions` colours at
/// once: K takes colours / Directions evaluations, rounded up, dK along a vector as many with duals nested twice. T is
/// as in generic_problem.hpp, and Dependence once.
///
/// Where it fails to pay: where an equation depends on all unknowns, such as one that prescribes a mean value, there
/// are as many colours as unknowns. weights(q) and multipliers() are passed on where the model has them; see
/// problem.hpp. Source: Griewank and Walther, Evaluating Derivatives, 2nd ed., chapter 8.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <equilibria/continuation/column_colouring.hpp>
#include <equilibria/continuation/generic_problem.hpp>
#include <equilibria/core/dependence.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

/// The solutions of equations without a known potential: g, n entries; K = dg/dq, n x n, sparse. Throws InvalidArgument
/// for a configuration of another size, and where the residual has another number of entries.
template <class M, int Directions = 4>
class SparseResidualProblem : public ResidualProblem<M> {
public:
    using Matrix = Eigen::SparseMatrix<double>;  ///< of K, compressed
    static_assert(Directions >= 1);
    static_assert(
        requires(const M& m, const Eigen::VectorX<Dependence>& q, const Dependence& p) {
            Eigen::VectorX<Dependence>(m.residual(q, p));
        }, "The pattern of K is found by residual(q, p) of Dependence, core/dependence.hpp.");

    /// Finds the pattern of K.
    SparseResidualProblem(M model, Eigen::Index unknowns) : ResidualProblem<M>(std::move(model)), unknowns_(unknowns) {
        require(unknowns >= 1, "unknowns", unknowns, "must be at least 1");
        find_pattern();
        const ColumnColouring found = colour_columns(pattern_);
        colours_ = found.colours;
        groups_.resize(static_cast<std::size_t>((colours_ + Directions - 1) / Directions));
        for (Eigen::Index c = 0; c < unknowns_; ++c) {
            const int colour = found.colour[static_cast<std::size_t>(c)];
            groups_[static_cast<std::size_t>(colour / Directions)].push_back({c, colour % Directions});
        }
    }

    Eigen::Index unknowns() const { return unknowns_; }  ///< n
    /// The entries that K can have, and the whole diagonal; all zeros.
    const Matrix& pattern() const { return pattern_; }
    /// Sets of columns that are found together.
    int colours() const { return colours_; }

    /// A function of a continuation problem (problem.hpp), exact; throws InvalidArgument for vectors of other sizes.
    /// \{
    Eigen::VectorXd residual(const Eigen::VectorXd& q, double p) const {
        check(q);
        Eigen::VectorXd g = this->model_.residual(q, p);
        check_residual(g.size());
        return g;
    }
    Matrix tangent(const Eigen::VectorXd& q, double p) const {
        check(q);
        return jacobian<double>(q, p);
    }
    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& q, double p) const {
        check(q);
        return ResidualProblem<M>::parameter_derivative(q, p);
    }
    Matrix tangent_derivative(const Eigen::VectorXd& q, double p, const Eigen::VectorXd& v) const {
        check(q);
        require(v.size() == unknowns_, "size of v", v.size(), allowed_size());
        Eigen::VectorX<Dual<double, 1>> x(unknowns_);
        for (Eigen::Index i = 0; i < unknowns_; ++i) {
            x(i).value = q(i);
            x(i).derivative[0] = v(i);
        }
        return jacobian<Dual<double, 1>>(x, p);
    }
    Eigen::VectorXd parameter_derivative_along(const Eigen::VectorXd& q, double p, const Eigen::VectorXd& v) const {
        check(q);
        require(v.size() == unknowns_, "size of v", v.size(), allowed_size());
        return ResidualProblem<M>::parameter_derivative_along(q, p, v);
    }
    Eigen::VectorXd second_parameter_derivative(const Eigen::VectorXd& q, double p) const {
        check(q);
        return ResidualProblem<M>::second_parameter_derivative(q, p);
    }
    /// \}

private:
    struct Column {
        Eigen::Index number;
        int direction;
    };

    std::string allowed_size() const { return "must be the number of unknowns, " + std::to_string(unknowns_); }
    void check(const Eigen::VectorXd& q) const {
        if (q.size() != unknowns_) require(false, "size of q", q.size(), allowed_size());
    }
    void check_residual(Eigen::Index size) const {
        if (size != unknowns_) require(false, "size of residual(q, p)", size, allowed_size());
    }

    void find_pattern() {
        Eigen::VectorX<Dependence> q(unknowns_);
        for (Eigen::Index i = 0; i < unknowns_; ++i) q(i) = Dependence::variable(static_cast<int>(i));
        Eigen::VectorX<Dependence> g = this->model_.residual(q, Dependence());
        check_residual(g.size());
        std::vector<Eigen::Index> row_sizes(static_cast<std::size_t>(unknowns_));
        for (Eigen::Index i = 0; i < unknowns_; ++i) {
            g(i) += q(i);
            row_sizes[static_cast<std::size_t>(i)] = static_cast<Eigen::Index>(g(i).on().size());
        }
        Eigen::SparseMatrix<double, Eigen::RowMajor> by_rows(unknowns_, unknowns_);
        by_rows.reserve(row_sizes);
        for (Eigen::Index i = 0; i < unknowns_; ++i)
            for (const int k : g(i).on()) by_rows.insert(i, k) = 0;
        pattern_ = by_rows;
        pattern_.makeCompressed();
    }

    static double entry(double x) { return x; }
    static double entry(const Dual<double, 1>& x) { return x.derivative[0]; }

    /// Number: double for K, duals along a vector for dK.
    template <class Number>
    Matrix jacobian(const Eigen::VectorX<Number>& q, double p) const {
        using T = Dual<Number, Directions>;
        Matrix y = pattern_;
        const auto* starts = y.outerIndexPtr();
        const auto* rows = y.innerIndexPtr();
        Eigen::VectorX<T> x(unknowns_);
        for (const auto& group : groups_) {
            for (Eigen::Index i = 0; i < unknowns_; ++i) x(i) = T(q(i));
            for (const Column& c : group) x(c.number).derivative[c.direction] = Number(1.0);
            const Eigen::VectorX<T> g = this->model_.residual(x, T(Number(p)));
            check_residual(g.size());
            for (const Column& c : group)
                for (auto k = starts[c.number]; k < starts[c.number + 1]; ++k)
                    y.valuePtr()[k] = entry(g(rows[k]).derivative[c.direction]);
        }
        return y;
    }

    Eigen::Index unknowns_;
    Matrix pattern_;
    int colours_ = 0;
    std::vector<std::vector<Column>> groups_;  // what one evaluation finds
};

}  // namespace equilibria
