// Discretised differential equations as problems for SparseResidualProblem: Bratu's in one to three dimensions,
// Gelfand's on a ball, the Swift-Hohenberg equation in one and two, Carrier's. What is known of them is said with each;
// the tests of continuation/ use them too. Each has size(), the number of unknowns, and weights by which lengths are
// root mean squares, so that a step means the same on every grid.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/diagrams/deflation.hpp>
#include <equilibria/continuation/sparse_residual_problem.hpp>

namespace support {

/// Lengths are root mean squares.
struct MeanSquare {
    Eigen::VectorXd weights(const Eigen::VectorXd& q) const {
        return Eigen::VectorXd::Constant(q.size(), 1 / static_cast<double>(q.size()));
    }
};

/// The points of a box, `points` along each axis, numbered along the first axis first.
struct Grid {
    std::vector<Eigen::Index> points;

    int dimension() const { return static_cast<int>(points.size()); }
    Eigen::Index size() const {
        Eigen::Index n = 1;
        for (const Eigen::Index m : points) n *= m;
        return n;
    }
    /// Calls call(i, axis, stride, place, number) for each axis of each point: place is the point's along the axis,
    /// which has that number of points, and its neighbours along it are i - stride and i + stride.
    template <class Call>
    void for_each(const Call& call) const {
        Eigen::Index stride = 1;
        for (std::size_t axis = 0; axis < points.size(); ++axis) {
            for (Eigen::Index i = 0; i < size(); ++i) call(i, axis, stride, i / stride % points[axis], points[axis]);
            stride *= points[axis];
        }
    }
};

/// Bratu's problem: laplace(u) + lambda e^u = 0 on the unit interval, square or cube, u = 0 on its boundary; second
/// differences on `intervals` along each edge, error O(1 / intervals^2). One dimension: u = 2 log(cosh t / cosh(t (1 -
/// 2 x))), lambda = 8 t^2 / cosh^2 t, fold where t tanh t = 1, lambda = 3.513830719. Square: fold at 6.808124423
/// (Mohsen, A simple solution of the Bratu problem, Comput. Math. Appl. 67 (2014) 26-33, has both).
struct Bratu : MeanSquare {
    static constexpr bool symmetric = true;
    int dimension, intervals;

    Bratu(int d, int n) : dimension(d), intervals(n) {}

    Grid grid() const { return {std::vector<Eigen::Index>(static_cast<std::size_t>(dimension), intervals - 1)}; }
    Eigen::Index size() const { return grid().size(); }
    template <class T>
    Eigen::VectorX<T> residual(const Eigen::VectorX<T>& u, const T& lambda) const {
        using std::exp;
        const double per_h2 = static_cast<double>(intervals) * intervals;
        Eigen::VectorX<T> g(u.size());
        for (Eigen::Index i = 0; i < u.size(); ++i) g(i) = (2 * dimension * per_h2) * u(i) - lambda * exp(u(i));
        grid().for_each([&](Eigen::Index i, std::size_t, Eigen::Index stride, Eigen::Index place, Eigen::Index number) {
            if (place > 0) g(i) -= per_h2 * u(i - stride);
            if (place + 1 < number) g(i) -= per_h2 * u(i + stride);
        });
        return g;
    }
};

/// Bratu's problem on the unit interval by spectral elements: polynomials of degree 1 to 4, integrals by the
/// Gauss-Lobatto points that carry the unknowns; error of a fold O(1 / elements^(2 degree)). Of degree 1 it is Bratu(1,
/// elements), divided by `elements`.
class BratuElements : public MeanSquare {
public:
    static constexpr bool symmetric = true;

    BratuElements(int elements, int degree)
        : elements_(elements), degree_(degree), x_(degree + 1), weight_(degree + 1) {
        constexpr double inner[] = {0, 0, 0.44721359549995794, 0.65465367070797714};  // 1 / sqrt 5, sqrt(3 / 7)
        x_(0) = -1;
        x_(degree) = 1;
        for (int k = 1; k < degree; ++k) x_(k) = inner[degree - 1] * (2.0 * k / degree - 1 < 0 ? -1 : 1);
        if (degree % 2 == 0) x_(degree / 2) = 0;
        slope_ = Eigen::MatrixXd::Zero(degree + 1, degree + 1);
        const auto legendre = [&](double x) {
            double before = 1, now = x;
            for (int k = 2; k <= degree_; ++k)
                before = std::exchange(now, ((2 * k - 1) * x * now - (k - 1) * before) / k);
            return now;
        };
        for (int i = 0; i <= degree; ++i) {
            weight_(i) = 2 / (degree * (degree + 1.0) * legendre(x_(i)) * legendre(x_(i)));
            for (int j = 0; j <= degree; ++j)
                if (i != j) {
                    slope_(i, j) = legendre(x_(i)) / (legendre(x_(j)) * (x_(i) - x_(j)));
                    slope_(i, i) -= slope_(i, j);
                }
        }
        stiffness_ = 2.0 * elements * slope_.transpose() * weight_.asDiagonal() * slope_;
    }
    Eigen::Index size() const { return elements_ * degree_ - 1; }
    template <class T>
    Eigen::VectorX<T> residual(const Eigen::VectorX<T>& u, const T& lambda) const {
        using std::exp;
        const Eigen::Index n = size();
        Eigen::VectorX<T> source(n), g = Eigen::VectorX<T>::Constant(n, T(0.0));
        for (Eigen::Index i = 0; i < n; ++i) source(i) = lambda * exp(u(i));
        for (Eigen::Index e = 0; e < elements_; ++e)
            for (Eigen::Index a = 0; a <= degree_; ++a) {
                const Eigen::Index i = e * degree_ + a - 1;
                if (i < 0 || i >= n) continue;
                T sum = (-0.5 / static_cast<double>(elements_) * weight_(a)) * source(i);
                for (Eigen::Index b = 0; b <= degree_; ++b) {
                    const Eigen::Index j = e * degree_ + b - 1;
                    if (j >= 0 && j < n) sum += stiffness_(a, b) * u(j);
                }
                g(i) += sum;
            }
        return g;
    }

private:
    Eigen::Index elements_, degree_;
    Eigen::VectorXd x_, weight_;
    Eigen::MatrixXd slope_, stiffness_;
};

/// Gelfand's problem: u'' + (d - 1) / r u' + lambda e^u = 0 on the unit ball of dimension d, u'(0) = 0, u(1) = 0. For 2
/// < d < 10 the branch has infinitely many folds, with lambda -> 2 (d - 2) (Joseph and Lundgren, Quasilinear Dirichlet
/// problems driven by positive sources, Arch. Rational Mech. Anal. 49 (1973) 241-269). Balances of the cells of a grid
/// r = sinh(a x) / sinh(a), fine at the centre, where u grows like a logarithm; error O(1 / intervals^2).
class Gelfand {
public:
    static constexpr bool symmetric = true;

    explicit Gelfand(int intervals, int d = 3, double a = 12)
        : conductance_(intervals), volume_(intervals), weights_(intervals) {
        const auto r = [&](double i) { return std::sinh(a * i / intervals) / std::sinh(a); };
        double inner = 0;
        for (int i = 0; i < intervals; ++i) {
            const double face = r(i + 0.5);
            conductance_(i) = std::pow(face, d - 1) / (r(i + 1) - r(i));
            volume_(i) = (std::pow(face, d) - std::pow(inner, d)) / d;
            weights_(i) = face - inner;
            inner = face;
        }
    }
    Eigen::Index size() const { return volume_.size(); }
    /// Of the integral of u^2 dr, in which the load e^u ~ 2 / r^2 has a size.
    Eigen::VectorXd weights(const Eigen::VectorXd&) const { return weights_; }
    template <class T>
    Eigen::VectorX<T> residual(const Eigen::VectorX<T>& u, const T& lambda) const {
        using std::exp;
        const Eigen::Index n = size();
        Eigen::VectorX<T> g(n);
        for (Eigen::Index i = 0; i < n; ++i) g(i) = conductance_(i) * u(i) - volume_(i) * lambda * exp(u(i));
        for (Eigen::Index i = 0; i + 1 < n; ++i) {
            g(i + 1) += conductance_(i) * (u(i + 1) - u(i));
            g(i) -= conductance_(i) * u(i + 1);
        }
        return g;
    }

private:
    Eigen::VectorXd conductance_, volume_, weights_;  // of the face outside of each point; of its cell
};

/// The Swift-Hohenberg equation at rest: r u - (1 + laplace)^2 u + nu u^2 - u^3 = 0 on an interval or a rectangle with
/// its corner at the origin, normal derivatives of u and laplace(u) 0 on the boundary: an even, periodic pattern. The
/// unknowns are u in the middles of cells; laplace by five points along each axis, error O(h^4). Branches of localised
/// states snake: Burke and Knobloch, Localized states in the generalized Swift-Hohenberg equation, Phys. Rev. E 73
/// (2006) 056211; in the plane: Lloyd, Sandstede, Avitabile and Champneys, Localized hexagon patterns of the planar
/// Swift-Hohenberg equation, SIAM J. Appl. Dyn. Syst. 7 (2008) 1049-1100.
struct SwiftHohenberg : MeanSquare {
    static constexpr bool symmetric = true;
    Grid grid;
    std::vector<double> edges;
    double nu;

    /// One edge a dimension.
    SwiftHohenberg(std::vector<double> lengths, std::vector<Eigen::Index> points, double quadratic)
        : grid{std::move(points)}, edges(std::move(lengths)), nu(quadratic) {}

    Eigen::Index size() const { return grid.size(); }
    template <class T>
    Eigen::VectorX<T> residual(const Eigen::VectorX<T>& u, const T& r) const {
        Eigen::VectorX<T> g = shifted_laplace<T>(shifted_laplace<T>(u));
        for (Eigen::Index i = 0; i < u.size(); ++i) g(i) += u(i) * (u(i) * (u(i) - nu) - r);
        return g;
    }
    /// The middle of a cell along an axis.
    double coordinate(Eigen::Index i, std::size_t axis) const {
        Eigen::Index stride = 1;
        for (std::size_t a = 0; a < axis; ++a) stride *= grid.points[a];
        const Eigen::Index place = i / stride % grid.points[axis];
        return edges[axis] * (static_cast<double>(place) + 0.5) / static_cast<double>(grid.points[axis]);
    }

private:
    /// u + laplace(u), u continued evenly.
    template <class T>
    Eigen::VectorX<T> shifted_laplace(const Eigen::VectorX<T>& u) const {
        Eigen::VectorX<T> y = u;
        grid.for_each(
            [&](Eigen::Index i, std::size_t axis, Eigen::Index stride, Eigen::Index place, Eigen::Index number) {
                const double h = edges[axis] / static_cast<double>(number), per_h2 = 1 / (12 * h * h);
                const auto mirrored = [&](Eigen::Index k) -> const T& {
                    const Eigen::Index inside = k < 0 ? -1 - k : (k < number ? k : 2 * number - 1 - k);
                    return u(i + (inside - place) * stride);
                };
                y(i) += per_h2 * (16 * (mirrored(place - 1) + mirrored(place + 1)) - mirrored(place - 2) -
                                  mirrored(place + 2) - 30 * u(i));
            });
        return y;
    }
};

/// Carrier's problem: eps^2 u'' + 2 (1 - x^2) u + u^2 = 1 on (-1, 1), u = 0 at both ends; the parameter is eps. The
/// number of solutions grows as eps -> 0, and they join in pairs at folds, those without symmetry at pitchforks of
/// the symmetric ones (Chapman and Farrell, Analysis of Carrier's problem, SIAM J. Appl. Math. 77 (2017) 924-950).
struct Carrier : MeanSquare {
    static constexpr bool symmetric = true;
    int intervals;

    explicit Carrier(int n) : intervals(n) {}

    Eigen::Index size() const { return intervals - 1; }
    double coordinate(Eigen::Index i) const { return -1 + 2 * static_cast<double>(i + 1) / intervals; }
    template <class T>
    Eigen::VectorX<T> residual(const Eigen::VectorX<T>& u, const T& eps) const {
        const double per_h2 = 0.25 * intervals * intervals;
        const T stiffness = per_h2 * eps * eps;
        Eigen::VectorX<T> g(u.size());
        for (Eigen::Index i = 0; i < u.size(); ++i) {
            const double x = coordinate(i);
            g(i) = 2 * stiffness * u(i) - (2 * (1 - x * x) + u(i)) * u(i) + 1;
            if (i > 0) g(i) -= stiffness * u(i - 1);
            if (i + 1 < u.size()) g(i) -= stiffness * u(i + 1);
        }
        return g;
    }
    /// Where solutions are to be looked for: near the smooth one, u- = -(1 - x^2) - s, s^2 = (1 - x^2)^2 + 1, which
    /// solves the equation without u'', alone, and with spikes 3 s / cosh^2(sqrt(s / 2) (x - x0) / eps) on it, one or
    /// two, whose places are so many.
    std::vector<Eigen::VectorXd> guesses(double eps, int places) const {
        const auto with_spikes = [&](const std::vector<double>& at) {
            Eigen::VectorXd u(size());
            for (Eigen::Index i = 0; i < size(); ++i) {
                const double x = coordinate(i), s = std::hypot(1 - x * x, 1.0);
                u(i) = x * x - 1 - s;
                for (const double x0 : at) u(i) += 3 * s / std::pow(std::cosh(std::sqrt(s / 2) * (x - x0) / eps), 2);
            }
            return u;
        };
        std::vector<Eigen::VectorXd> y{with_spikes({})};
        for (int k = 0; k < places; ++k) {
            const double x0 = -1 + 2 * (k + 0.5) / places;
            y.push_back(with_spikes({x0}));
            for (int l = 0; l < k; ++l) y.push_back(with_spikes({-1 + 2 * (l + 0.5) / places, x0}));
        }
        return y;
    }
    /// The mirror image.
    std::vector<Eigen::VectorXd> images(const Eigen::VectorXd& u) const { return {u.reverse()}; }
};

/// A field's problem with as many unknowns as it has.
template <class M>
equilibria::SparseResidualProblem<M> sparse(M model) {
    const Eigen::Index n = model.size();
    return {std::move(model), n};
}

/// The solutions at the parameter p that deflated Newton finds from the guesses, and the images of all that are found,
/// where the model has any.
template <class M>
std::vector<Eigen::VectorXd> solutions_at(const equilibria::SparseResidualProblem<M>& problem, double p,
                                          const std::vector<Eigen::VectorXd>& guesses) {
    std::vector<Eigen::VectorXd> known;
    for (bool more = true; more;) {
        const auto found = equilibria::deflated_search(problem, p, guesses, known);
        more = !found.empty();
        for (const Eigen::VectorXd& u : found) {
            known.push_back(u);
            if constexpr (requires { problem.model().images(u); })
                for (const Eigen::VectorXd& image : problem.model().images(u)) {
                    const auto same = [&](const Eigen::VectorXd& v) { return (image - v).norm() < 1e-6 * u.norm(); };
                    if (std::none_of(known.begin(), known.end(), same) &&
                        std::none_of(found.begin(), found.end(), same))
                        known.push_back(image);
                }
        }
    }
    return known;
}

}  // namespace support
