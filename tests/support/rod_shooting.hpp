// Geometrically exact (Simo-Reissner) rods by shooting: reference solutions for fem/, of which they use nothing.
//
//     r' = A (e1 + F_n A^T n)     A' = A kappa~, kappa = kappa0 + F_m A^T m     n' = -p load     m' = n x r'
//
// r and the section's rotation A (a quaternion), the force n and the moment m that the part ahead exerts, in fixed
// axes; axis 1 along the rod; flexibilities F_n and F_m, 0 where the section is rigid. As many conditions at the end as
// unknowns at the start determine the rod: 6 in space, 3 in the plane. Runge-Kutta-Fehlberg 7(8) in equal steps carries
// duals along, so that Newton's method has the derivatives of the very map that it solves. Critical points are regular
// roots of bordered systems (Govaerts 2000, chapters 3 and 4):
//
//     [J  b] [v]   [0]     [J  b] [w]   [-F_p]     F the conditions, J = F_u
//     [c' 0] [s] = [1]     [c' 0] [t] = [  0 ]     fold: F = 0, s = 0.  bifurcation: F + unfolding b = 0, s = 0, t = 0
//
// s_x = -psi' (J v)_x and t_x = -psi' (J w + F_p)_x, with psi the solution of the transposed system.
#pragma once

#include <array>
#include <bit>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <equilibria/core/dual.hpp>

namespace rods {

using Eigen::MatrixXd, Eigen::VectorXd;

/// With derivatives by up to 6 unknowns and the load, and the derivatives of these along one direction.
using Number = equilibria::Dual<equilibria::Dual<double, 7>, 1>;
using Numbers = std::vector<Number>;

inline constexpr double rigid = std::numeric_limits<double>::infinity();

struct Section {
    double ea, ga2, ga3, gj, ei2, ei3;  ///< any of them may be rigid; ei2 bends about axis 2
};

/// The rotation by an angle about a unit vector.
template <class T>
Eigen::Quaternion<T> rotation(const Eigen::Vector3d& axis, const T& angle) {
    using std::cos, std::sin;
    const T half = 0.5 * angle, s = sin(half);
    return {cos(half), axis(0) * s, axis(1) * s, axis(2) * s};
}

/// A piece of rod, joined rigidly to the one before.
struct Leg {
    double length;
    Section section;
    Eigen::Vector3d curvature = Eigen::Vector3d::Zero();         ///< kappa0, in the section's axes
    Eigen::Quaterniond corner = Eigen::Quaterniond::Identity();  ///< the section's turn at the leg's start
    Eigen::Vector3d force = Eigen::Vector3d::Zero();             ///< at the leg's start, times p, fixed axes
    Eigen::Vector3d load = Eigen::Vector3d::Zero();              ///< per unit length, times p, fixed axes
    int steps = 32;                                              ///< 11 digits for a turn by 2 pi
};

template <class T>
struct State {
    using Vector = Eigen::Matrix<T, 3, 1>;
    Vector r{T(0.0), T(0.0), T(0.0)};
    Eigen::Quaternion<T> q{T(1.0), T(0.0), T(0.0), T(0.0)};
    Vector n{T(0.0), T(0.0), T(0.0)}, m{T(0.0), T(0.0), T(0.0)};
};

using Start = std::function<State<Number>(const Numbers& u, const Number& p)>;
/// What vanishes at the rod's end.
using Conditions = std::function<Numbers(const State<Number>& end, const Number& p)>;
/// A function of the states at the rod's start and at the ends of its legs, and of the load.
using Measure = std::function<Number(const std::vector<State<Number>>& states, const Number& p)>;

inline Measure load() {
    return [](const auto&, const Number& p) { return p; };
}
/// The position's component (0 to 2) at the end of leg number `leg` (from 0).
inline Measure position(int component, std::size_t leg) {
    return [=](const auto& states, const Number&) { return states.at(leg + 1).r(component); };
}

/// The unknowns at the start, and the load.
struct Point {
    VectorXd x;
    double p() const { return x(Eigen::last); }
};

/// A guess for a critical point, and the border: b = dJ v and c = dJ' b, with dJ along the path and J v = 0 nearly.
struct Crossing {
    Point at;
    VectorXd b, c;
};

struct Critical {
    Point at;
    VectorXd null_vector;
    double unfolding = 0;  ///< of a bifurcation: 0 within rounding, or it is none
};

namespace detail {

/// The state at the end of a leg.
inline State<Number> integrate(const Leg& leg, const State<Number>& start, const Number& p) {
    using Vector = State<Number>::Vector;
    using Scalars = std::array<Number, 10>;  // r, q, m
    using Row = std::array<double, sizeof(Scalars) / sizeof(double)>;
    const Section& c = leg.section;
    const Vector kappa0 = leg.curvature.cast<Number>(), load = p * leg.load.cast<Number>(),
                 n0 = start.n - p * leg.force.cast<Number>();
    const auto pack = [](const auto& r, const auto& q, const auto& m) {
        return std::bit_cast<Row>(Scalars{r(0), r(1), r(2), q(0), q(1), q(2), q(3), m(0), m(1), m(2)});
    };
    const auto unpack = [](const Row& row) {
        const auto y = std::bit_cast<Scalars>(row);
        return State<Number>{{y[0], y[1], y[2]}, {y[6], y[3], y[4], y[5]}, {}, {y[7], y[8], y[9]}};
    };
    const auto slope = [&](const Row& row, Row& out, double s) {
        const State<Number> at = unpack(row);
        const Eigen::Matrix<Number, 3, 3> a = at.q.toRotationMatrix();
        const Vector n = n0 - Number(s) * load, force = a.transpose() * n, moment = a.transpose() * at.m,
                     gamma(1.0 + force(0) / c.ea, force(1) / c.ga2, force(2) / c.ga3),
                     half(0.5 * (kappa0(0) + moment(0) / c.gj), 0.5 * (kappa0(1) + moment(1) / c.ei2),
                          0.5 * (kappa0(2) + moment(2) / c.ei3)),
                     dr = a * gamma;
        const Eigen::Quaternion<Number> dq = at.q * Eigen::Quaternion<Number>(Number(0.0), half(0), half(1), half(2));
        out = pack(dr, dq.coeffs(), n.cross(dr));
    };
    Row row = pack(start.r, (start.q * leg.corner.cast<Number>()).coeffs(), start.m);
    boost::numeric::odeint::runge_kutta_fehlberg78<Row> stepper;
    const double h = leg.length / leg.steps;
    for (int k = 0; k < leg.steps; ++k) stepper.do_step(slope, row, k * h, h);
    State<Number> end = unpack(row);
    end.n = n0 - Number(leg.length) * load;
    return end;
}

/// Factors of a matrix whose rows and columns are scaled first, whatever their units.
class ScaledLU {
public:
    explicit ScaledLU(const MatrixXd& a) {
        const auto inverse = [](double x) { return x > 0 ? 1 / x : 1; };
        row_ = a.rowwise().lpNorm<Eigen::Infinity>().unaryExpr(inverse);
        const MatrixXd rows = row_.asDiagonal() * a;
        column_ = rows.colwise().lpNorm<Eigen::Infinity>().transpose().unaryExpr(inverse);
        lu_.compute(rows * column_.asDiagonal());
    }
    VectorXd solve(const VectorXd& y) const { return column_.cwiseProduct(lu_.solve(row_.cwiseProduct(y)).eval()); }
    /// The length of a vector of unknowns in their scales.
    double length(const VectorXd& x) const { return x.cwiseQuotient(column_).norm(); }

private:
    VectorXd row_, column_;
    Eigen::PartialPivLU<MatrixXd> lu_;
};

/// Newton's method; system(x): a pair of the residual and its derivative.
inline VectorXd newton(VectorXd x, const std::function<std::pair<VectorXd, MatrixXd>(const VectorXd&)>& system) {
    bool last = false;
    for (int k = 0; k < 30; ++k) {
        const auto [f, j] = system(x);
        const ScaledLU lu(j);
        const VectorXd step = lu.solve(f);
        if (!step.allFinite()) break;
        x -= step;
        if (last) return x;
        last = lu.length(step) <= 1e-8 * lu.length(x);
    }
    throw std::runtime_error("rods: Newton's method does not converge");
}

}  // namespace detail

/// A rod with its supports.
class Shooting {
public:
    Shooting(int unknowns, std::vector<Leg> legs, Start start, Conditions conditions)
        : n_(unknowns), legs_(std::move(legs)), start_(std::move(start)), conditions_(std::move(conditions)) {}

    Point unloaded() const { return {VectorXd::Zero(n_ + 1)}; }

    /// At the start and at the end of each leg.
    std::vector<State<double>> states(const Point& at) const {
        std::vector<State<double>> y;
        const auto value = [](const Number& a) { return a.value.value; };
        for (const auto& [r, q, n, m] : evaluate(at.x).states) {
            const Eigen::Vector4d rotation = q.coeffs().unaryExpr(value);
            y.push_back({r.unaryExpr(value), Eigen::Quaterniond(rotation), n.unaryExpr(value), m.unaryExpr(value)});
        }
        return y;
    }
    double measure(const Point& at, const Measure& measure) const {
        const Evaluation y = evaluate(at.x);
        return measure(y.states, y.p).value.value;
    }

    /// The equilibrium near a guess at which the measure has the given value.
    Point solve(const Point& guess, const Measure& measure, double value) const {
        return {detail::newton(guess.x, [&](const VectorXd& x) {
            Evaluation y = evaluate(x);
            y.rows.push_back(measure(y.states, y.p) - Number(value));
            return std::pair(values(y.rows), derivatives(y.rows));
        })};
    }

    /// Equilibria from one on, the measure in equal steps to the given value.
    std::vector<Point> follow(const Point& from, const Measure& measure, double to, int steps) const {
        std::vector<Point> path{from};
        const double first = this->measure(from, measure);
        VectorXd guess = from.x;
        for (int k = 1; k <= steps; ++k) {
            path.push_back(solve({guess}, measure, first + (to - first) * k / steps));
            guess = 2 * path.back().x - path[path.size() - 2].x;
        }
        return path;
    }

    /// Where det J changes its sign along a path, with J linear between its points.
    std::vector<Crossing> crossings(const std::vector<Point>& path) const {
        std::vector<Crossing> y;
        MatrixXd before;
        for (std::size_t k = 0; k < path.size(); ++k) {
            const MatrixXd now = derivatives(evaluate(path[k].x).rows).leftCols(n_);
            if (k > 0 && now.determinant() * before.determinant() < 0) {
                const MatrixXd slope = now - before;
                double low = 0, high = 1;
                for (int bisection = 0; bisection < 40; ++bisection) {
                    const double middle = (low + high) / 2;
                    const MatrixXd j = before + middle * slope;
                    (j.determinant() * before.determinant() > 0 ? low : high) = middle;
                }
                const detail::ScaledLU lu(before + low * slope);
                VectorXd v = VectorXd::Ones(n_);
                for (int iteration = 0; iteration < 3; ++iteration) v = lu.solve(slope * v).normalized();
                const VectorXd b = slope * v;
                y.push_back({{(1 - low) * path[k - 1].x + low * path[k].x}, b, slope.transpose() * b});
            }
            before = now;
        }
        return y;
    }

    /// The first under loads from 0 to a value.
    Critical first_bifurcation(double most, int steps) const {
        const auto y = crossings(follow(unloaded(), load(), most, steps));
        if (y.empty()) throw std::runtime_error("rods: no bifurcation up to this load");
        return bifurcation(y[0]);
    }
    Critical fold(const Crossing& guess) const { return critical(guess, n_ + 1); }
    /// At a fold it fails, or finds a point with an unfolding that is not 0.
    Critical bifurcation(const Crossing& guess) const { return critical(guess, n_ + 2); }

    /// On the branch that leaves a bifurcation along its null vector, where the measure, which must change along it,
    /// has the given value.
    Point leave(const Critical& from, const Measure& measure, double value) const {
        const Evaluation y = evaluate(from.at.x);
        const Number m = measure(y.states, y.p);
        const double slope = derivatives({m}).row(0).head(n_).dot(from.null_vector);
        Point guess = from.at;
        guess.x.head(n_) += (value - m.value.value) / slope * from.null_vector;
        return solve(guess, measure, value);
    }

private:
    struct Evaluation {
        std::vector<State<Number>> states;
        Number p;
        Numbers rows;
    };

    Evaluation evaluate(const VectorXd& x) const { return evaluate(x, VectorXd::Zero(n_ + 1)); }
    Evaluation evaluate(const VectorXd& x, const VectorXd& direction) const {
        Numbers u;
        for (int k = 0; k <= n_; ++k) {
            u.push_back(equilibria::Dual<double, 7>::variable(x(k), k));
            u.back().derivative[0] = direction(k);
        }
        Evaluation y{{}, u.back(), {}};
        u.pop_back();
        y.states.push_back(start_(u, y.p));
        for (const Leg& leg : legs_) y.states.push_back(detail::integrate(leg, y.states.back(), y.p));
        y.rows = conditions_(y.states.back(), y.p);
        return y;
    }

    /// The fold's system is the bifurcation's without its last row and column.
    Critical critical(const Crossing& guess, int size) const {
        VectorXd x = VectorXd::Zero(n_ + 2), v;
        x.head(n_ + 1) = guess.at.x;
        x.head(size) = detail::newton(x.head(size), [&](const VectorXd& at) {
            x.head(size) = at;
            const Numbers rows = evaluate(x).rows;
            const MatrixXd f_x = derivatives(rows);
            MatrixXd bordered(n_ + 1, n_ + 1), j(n_ + 2, n_ + 2);
            bordered << f_x.leftCols(n_), guess.b, guess.c.transpose(), 0;
            VectorXd load_column(n_ + 1), f(n_ + 2);
            load_column << -f_x.col(n_), 0;
            const VectorXd unit = VectorXd::Unit(n_ + 1, n_);
            const Eigen::RowVectorXd psi = detail::ScaledLU(bordered.transpose()).solve(unit).head(n_);
            const detail::ScaledLU lu(bordered);
            v = lu.solve(unit);
            VectorXd w = lu.solve(load_column);
            const double s = std::exchange(v(n_), 0), t = std::exchange(w(n_), 1);
            f << values(rows) + x(n_ + 1) * guess.b, s, t;
            j << f_x, guess.b, -psi * derivatives(evaluate(x, v).rows, true), 0,
                -psi * derivatives(evaluate(x, w).rows, true), 0;
            return std::pair<VectorXd, MatrixXd>(f.head(size), j.topLeftCorner(size, size));
        });
        return {{x.head(n_ + 1)}, v.head(n_), x(n_ + 1)};
    }

    static VectorXd values(const Numbers& f) {
        VectorXd y(static_cast<Eigen::Index>(f.size()));
        for (std::size_t i = 0; i < f.size(); ++i) y(i) = f[i].value.value;
        return y;
    }
    /// By the unknowns and the load: of the numbers, or of their derivatives along the direction.
    MatrixXd derivatives(const Numbers& f, bool of_derivative = false) const {
        MatrixXd y(static_cast<Eigen::Index>(f.size()), n_ + 1);
        for (std::size_t i = 0; i < f.size(); ++i)
            for (int k = 0; k <= n_; ++k) y(i, k) = (of_derivative ? f[i].derivative[0] : f[i].value).derivative[k];
        return y;
    }

    int n_;
    std::vector<Leg> legs_;
    Start start_;
    Conditions conditions_;
};

/// Clamped at the origin with the section's axes along the fixed ones; the dead load p force at the tip.
inline Shooting cantilever(std::vector<Leg> legs, const Eigen::Vector3d& force) {
    return {6, std::move(legs),
            [](const Numbers& u, const Number&) {
                return State<Number>{{}, {1, 0, 0, 0}, {u[0], u[1], u[2]}, {u[3], u[4], u[5]}};
            },
            [=](const State<Number>& end, const Number& p) -> Numbers {
                const State<Number>::Vector n = end.n - p * force.cast<Number>();
                return {n(0), n(1), n(2), end.m(0), end.m(1), end.m(2)};
            }};
}

/// The right-angle frame of Argyris: section 30 x 0.6, legs of 240.
inline std::vector<Leg> right_angle_frame(int steps = 32) {
    const double e = 71240, g = e / 2.62;
    Leg first{240, {e * 18, g * 18, g * 18, g * 2.16, e * 0.54, e * 1350}};
    first.steps = steps;
    Leg second = first;
    second.corner = rotation<double>(Eigen::Vector3d::UnitZ(), -std::numbers::pi / 2);
    return {first, second};
}

enum class Support { clamped, hinged };

/// In the xy-plane, from the origin at an angle to x: 3 unknowns.
inline Start planar_start(Support support, double angle) {
    return [=](const Numbers& u, const Number&) {
        State<Number> y;
        y.n << u[0], u[1], 0;
        y.q = rotation<Number>(Eigen::Vector3d::UnitZ(), support == Support::hinged ? angle + u[2] : angle);
        if (support == Support::clamped) y.m(2) = u[2];
        return y;
    };
}

/// In the xy-plane; both supports stay where the rod is without load.
inline Shooting planar_rod(std::vector<Leg> legs, double angle, Support first, Support last) {
    const Start start = planar_start(first, angle);
    State<Number> end = start(Numbers(3), 0);
    for (const Leg& leg : legs) end = detail::integrate(leg, end, 0);
    return {3, std::move(legs), start, [=](const State<Number>& y, const Number&) -> Numbers {
                const Number turn = y.q.z() * end.q.w() - y.q.w() * end.q.z();
                return {y.r(0) - end.r(0), y.r(1) - end.r(1), last == Support::clamped ? turn : y.m(2)};
            }};
}

/// A circular arch in the xy-plane, with the dead load p downwards at its crown, the end of leg 0.
inline Shooting arch(const Section& section, double radius, double opening, Support first, Support last) {
    Leg half{opening / 2 * radius, section, {0, 0, -1 / radius}}, second = half;
    second.force = {0, -1, 0};
    return planar_rod({half, second}, opening / 2, first, last);
}

}  // namespace rods
