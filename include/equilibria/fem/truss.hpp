/// \file
/// Bars that carry forces along themselves alone.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/fem/element.hpp>

namespace equilibria::fem {

/// Of a bar of length l, L without force: green is (l^2 - L^2) / (2 L^2), engineering (l - L) / L.
enum class Strain { green, engineering };

/// A bar with energy EA L strain^2 / 2, in space (Dimension 3) or in the plane (2).
template <int Dimension>
class Truss {
public:
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2;
    static constexpr auto components = position_components<Dimension>();
    static constexpr bool depends_on_parameter = false;
    /// \}

    /// ea: axial stiffness; a and b: its ends, where it has no force.
    Truss(double ea, const Eigen::Vector3d& a, const Eigen::Vector3d& b, Strain strain = Strain::green)
        : Truss(ea, (b - a).norm(), strain) {}
    /// length: without force. Throws InvalidArgument for numbers that are not positive and finite.
    Truss(double ea, double length, Strain strain = Strain::green) : ea_(ea), length_(length), strain_(strain) {
        require(ea > 0 && std::isfinite(ea), "ea", ea, "must be positive and finite");
        require(length > 0 && std::isfinite(length), "length", length, "must be positive and finite");
    }

    /// The strain of the bar between these nodes.
    double strain(const std::array<Frame<double>, 2>& at) const {
        const double l2 = (at[1].x - at[0].x).template head<Dimension>().squaredNorm();
        return strain_ == Strain::green ? (l2 / (length_ * length_) - 1) / 2 : std::sqrt(l2) / length_ - 1;
    }

    static constexpr std::array force_names{"N"};  ///< see element.hpp
    /// Its force, tension positive, at the middle.
    std::vector<InternalForce> forces(const std::array<Frame<double>, 2>& at, const ElementQuery&) const {
        const double now = (at[1].x - at[0].x).template head<Dimension>().norm();
        return {{(at[0].x + at[1].x) / 2, {ea_ * strain(at) * (strain_ == Strain::green ? now / length_ : 1)}}};
    }

    /// By hand, see element.hpp.
    void evaluate(const std::array<Frame<double>, 2>& at, double, Need need, ElementValues& out) const {
        using Vector = Eigen::Matrix<double, Dimension, 1>;
        using Matrix = Eigen::Matrix<double, Dimension, Dimension>;
        const Vector d = (at[1].x - at[0].x).template head<Dimension>();
        // the force over the length, and its derivative by |d|^2 / 2
        const double now = d.norm();
        const bool green = strain_ == Strain::green;
        const double force = green ? ea_ * strain(at) / length_ : ea_ * (1 / length_ - 1 / now);
        const double slope = green ? ea_ / (length_ * length_ * length_) : ea_ / (now * now * now);
        if (need == Need::residual) {
            out.residual << -force * d, force * d;
            return;
        }
        const Matrix k = force * Matrix::Identity() + slope * d * d.transpose();
        out.tangent << k, -k, -k, k;
    }

private:
    double ea_, length_;
    Strain strain_;
};

/// A bar that p shortens or stretches: its length without force goes from the drawn one at p = 0 to `length` at p = 1.
/// A constant one (LoadKind) is prestressed.
template <int Dimension>
class StressedTruss {
public:
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2;
    static constexpr auto components = position_components<Dimension>();
    /// \}

    /// a and b: its ends where it is drawn; length: without force, at p = 1. Throws InvalidArgument for numbers that
    /// are not positive and finite.
    StressedTruss(double ea, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double length,
                  Strain strain = Strain::green)
        : ea_(ea), drawn_((b - a).norm()), length_(length), strain_(strain) {
        require(ea > 0 && std::isfinite(ea), "ea", ea, "must be positive and finite");
        require(drawn_ > 0 && std::isfinite(drawn_), "length drawn", drawn_, "must be positive and finite");
        require(length > 0 && std::isfinite(length), "length", length, "must be positive and finite");
    }

    /// The length without force for which a bar of length `drawn` has this force. Nothing where no length has it: below
    /// -EA, and with Green's strain below -0.19245 EA.
    static std::optional<double> length_of_force(double ea, double drawn, double force, Strain strain) {
        const double share = force / ea;
        if (strain == Strain::engineering) return share > -1 ? std::optional(drawn / (1 + share)) : std::nullopt;
        // force = EA (r^2 - 1) r / 2, r = drawn / length: rises from r = 1 / sqrt(3) on
        if (!(share > -1 / (3 * std::sqrt(3.0)))) return std::nullopt;
        double r = std::max(1.0, std::cbrt(2 * share + 1));
        for (int k = 0; k < 100; ++k) {
            const double step = (r * (r * r - 1) / 2 - share) / ((3 * r * r - 1) / 2);
            r -= step;
            if (std::abs(step) < 1e-15 * r) break;
        }
        return drawn / r;
    }

    static constexpr std::array force_names{"N"};  ///< see element.hpp
    /// Its force, tension positive, at the middle.
    std::vector<InternalForce> forces(const std::array<Frame<double>, 2>& at, const ElementQuery& query) const {
        const double now = (at[1].x - at[0].x).template head<Dimension>().norm(),
                     r = now / (drawn_ + query.p * (length_ - drawn_));
        return {{(at[0].x + at[1].x) / 2, {ea_ * (strain_ == Strain::green ? (r * r - 1) / 2 * r : r - 1)}}};
    }

    /// EA L strain^2 / 2 with L for p.
    template <class T>
    T energy(const std::array<Frame<T>, 2>& at, const T& p) const {
        using std::sqrt;
        const Vector3<T> d = at[1].x - at[0].x;
        const T l2 = d.template head<Dimension>().squaredNorm();
        const T length = T(drawn_) + p * T(length_ - drawn_);
        const T strain =
            strain_ == Strain::green ? 0.5 * (l2 / (length * length) - T(1.0)) : sqrt(l2) / length - T(1.0);
        return T(0.5 * ea_) * length * strain * strain;
    }

private:
    double ea_, drawn_, length_;
    Strain strain_;
};

#ifdef EQUILIBRIA_COMPILED
extern template class ElementGroupOf<StressedTruss<2>>;
extern template class ElementGroupOf<StressedTruss<3>>;
extern template class ElementGroupOf<Truss<2>>;
extern template class ElementGroupOf<Truss<3>>;
#endif

}  // namespace equilibria::fem
