/// \file
/// Bars that carry forces along themselves alone.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include <equilibria/core/error.hpp>
#include <equilibria/fem/element.hpp>

namespace equilibria::fem {

/// Of a bar of length l, L without force: green is (l^2 - L^2) / (2 L^2), engineering (l - L) / L.
enum class Strain { green, engineering };

/// A bar with energy EA L strain^2 / 2, in space (Dimension 3) or in the plane (2).
template <int Dimension>
class Truss {
public:
    /// As of every element, see element.hpp.
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

#ifdef EQUILIBRIA_COMPILED
extern template class ElementGroupOf<Truss<2>>;
extern template class ElementGroupOf<Truss<3>>;
#endif

}  // namespace equilibria::fem
