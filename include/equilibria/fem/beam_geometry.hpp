/// \file
/// Strains of geometrically exact (Simo-Reissner) beams in space, and their first and second derivatives. At each point
/// a section frame A and the axis x, by arc length s:
///
///     Gamma = A^T x' - its initial value,   kappa~ = A^T A' - its initial value
///
/// The nodes' quaternions are interpolated and divided by their length: Q = sum N_i p_i, A = A(Q / |Q|). A rotation of
/// the whole multiplies every p_i from the left, and Q with them: strains are objective whatever the rotation, without
/// a logarithm, and every derivative is rational:
///
///     A^T x' = Im(Q^* x' Q) / |Q|^2,     kappa = 2 Im(Q^* Q') / |Q|^2
///
/// Nodes may turn by up to 2 pi against each other. With a shear centre the strains are those of section.hpp, functions
/// of these.
/// Sources: Simo, A finite strain beam formulation, Comput. Methods Appl. Mech. Engrg. 49 (1985); Simo and Vu-Quoc, A
/// three-dimensional finite-strain rod model. Part II, ibid. 58 (1986); for the interpolation, Zupan, Saje and Zupan,
/// The quaternion-based three-dimensional beam theory, ibid. 198 (2009), and Grohs, Hardering, Sander and Sprecher,
/// Projection-based finite elements for nonlinear function spaces, SIAM J. Numer. Anal. 57 (2019).
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <equilibria/core/error.hpp>
#include <equilibria/core/streamed_text.hpp>
#include <equilibria/fem/frame.hpp>
#include <equilibria/fem/interpolation.hpp>
#include <equilibria/fem/section.hpp>

namespace equilibria::fem {

/// Where a beam's node is without load, and the frame of its cross-section there: axis 1 along the beam.
struct SectionFrame {
    Eigen::Vector3d x;               ///< its place
    Eigen::Quaterniond orientation;  ///< turns the fixed axes to those of the cross-section
};

/// The frame at x with axis 1 along `axis` and axis 2 as near to `second` as that allows. Throws InvalidArgument where
/// they are parallel or not finite.
inline SectionFrame section_frame(const Eigen::Vector3d& x, const Eigen::Vector3d& axis,
                                  const Eigen::Vector3d& second) {
    require(x.allFinite(), "x", streamed(x.transpose()), "must be finite");
    require(axis.allFinite() && axis.norm() > 0, "axis", streamed(axis.transpose()), "must be finite and not 0");
    const Eigen::Vector3d e1 = axis.normalized(), across = second - second.dot(e1) * e1;
    require(second.allFinite() && across.norm() > 1e-8 * second.norm() && second.norm() > 0, "second",
            streamed(second.transpose()), "must be finite and not along the axis");
    Eigen::Matrix3d r;
    r.col(0) = e1;
    r.col(1) = across.normalized();
    r.col(2) = e1.cross(r.col(1));
    return {x, Eigen::Quaterniond(r)};
}

/// The strains (Gamma, kappa) of a beam element of equally spaced nodes at its Gauss points, one less than nodes.
template <int Nodes>
class BeamGeometry {
    static constexpr std::size_t count = static_cast<std::size_t>(Nodes);
    static constexpr std::size_t place(int k) { return static_cast<std::size_t>(k); }
    using Four = Eigen::Vector4d;  // quaternions as (x, y, z, w)

public:
    static constexpr int gauss_points = Nodes - 1;         ///< one less than nodes
    static constexpr int n_strains = 6;                    ///< Gamma in the axes of the cross-section, then kappa
    using Frames = std::array<Frame<double>, count>;       ///< of the nodes, moved
    using InitialFrame = SectionFrame;                     ///< of a node without load
    using Strains = Eigen::Matrix<double, 6, 1>;           ///< (Gamma, kappa)
    using StrainDerivative = Eigen::Matrix<double, 6, 6>;  ///< by a node's dx and dPsi

    /// What the moved nodes are to all Gauss points.
    struct MovedNodes {
        std::array<Eigen::Vector3d, count> x;                 ///< places
        std::array<Four, count> p;                            ///< quaternions of the cross-sections
        std::array<Eigen::Matrix<double, 4, 3>, count> turn;  ///< of p exp(dPsi): dp = turn dPsi - |dPsi|^2 p / 8
    };
    /// A Gauss point of the moved element.
    struct Point {
        Strains strain;                         ///< Gamma and kappa, without their initial values
        std::array<StrainDerivative, count> b;  ///< of the strains, by each node
        double weight = 0;                      ///< of the point: its share of the element's length

        std::array<double, count> n;                   ///< shape functions
        std::array<double, count> d;                   ///< their slopes by arc length
        Four q = Four::Zero();                         ///< Q
        Four dq = Four::Zero();                        ///< Q'
        Eigen::Vector3d dx = Eigen::Vector3d::Zero();  ///< x'
        Strains total;                                 ///< the strains with their initial values
        Eigen::Matrix<double, 6, 4> by_q;              ///< derivative of the strains by Q
        Eigen::Matrix<double, 6, 4> by_dq = Eigen::Matrix<double, 6, 4>::Zero();  ///< by Q'
        Eigen::Matrix3d by_dx;                                                    ///< of Gamma by x': A^T
    };

    /// at: the nodes from one end to the other, equally spaced along the beam. Throws InvalidArgument for nodes at one
    /// place.
    explicit BeamGeometry(const std::array<SectionFrame, count>& at, const ShearCentre& shear_centre = {})
        : line_(initial_places(at)), shear_centre_(shear_centre), centred_(shear_centre.none()) {
        Frames initial;
        for (std::size_t k = 0; k < count; ++k) {
            section_[k] = at[k].orientation.normalized();
            if (k > 0 && section_[k].dot(section_[0]) < 0) section_[k].coeffs() *= -1;
            initial[k].x = at[k].x;
        }
        for (int g = 0; g < gauss_points; ++g) {
            Point y;
            interpolate(nodes(initial), g, y);
            initial_strain_[place(g)] = y.total;
        }
    }

    /// Gamma and kappa at Gauss point g.
    Strains strain(const Frames& at, int g) const {
        Point y;
        interpolate(nodes(at), g, y);
        return about_shear_centre(y.total - initial_strain_[place(g)]);
    }
    const GaussLine<Nodes>& line() const { return line_; }  ///< the nodes' places without load, and the Gauss points

    /// The nodes at these frames.
    MovedNodes nodes(const Frames& at) const {
        MovedNodes y;
        for (std::size_t k = 0; k < count; ++k) {
            y.x[k] = at[k].x;
            y.p[k] = (at[k].q * section_[k]).coeffs();
            for (int c = 0; c < 3; ++c)
                y.turn[k].col(c) = 0.5 * (at[k].q * pure(Eigen::Vector3d::Unit(c)) * section_[k]).coeffs();
        }
        return y;
    }

    /// Strains and their derivatives at Gauss point g.
    Point point(const MovedNodes& at, int g) const {
        Point y;
        interpolate(at, g, y);
        y.strain = y.total - initial_strain_[place(g)];
        y.weight = line_.weight(g);
        const Eigen::Quaterniond q = of(y.q), dq = of(y.dq), dx = pure(y.dx);
        const double s = y.q.squaredNorm();
        for (int c = 0; c < 3; ++c) {
            const Eigen::Quaterniond e = pure(Eigen::Vector3d::Unit(c));
            y.by_q.row(c) = (-2 * ((dx * q * e).coeffs() + y.total(c) * y.q) / s).transpose();
            y.by_q.row(3 + c) = (-2 * ((dq * e).coeffs() + y.total(3 + c) * y.q) / s).transpose();
            y.by_dq.row(3 + c) = (2 * (q * e).coeffs() / s).transpose();
            y.by_dx.row(c) = (q * e * q.conjugate()).vec().transpose() / s;
        }
        for (std::size_t k = 0; k < count; ++k) {
            y.b[k].template topLeftCorner<3, 3>() = y.d[k] * y.by_dx;
            y.b[k].template bottomLeftCorner<3, 3>().setZero();
            y.b[k].template rightCols<3>() = (y.n[k] * y.by_q + y.d[k] * y.by_dq) * at.turn[k];
        }
        if (!centred_) {
            const Strains by_twist = by_twist_of(y.strain(3));
            for (StrainDerivative& b : y.b) b += by_twist * Eigen::RowVector<double, 6>(b.row(3));
            y.strain = about_shear_centre(y.strain);
        }
        return y;
    }

    /// Adds the second derivatives of weight stress . strain to a tangent by the nodes' unknowns.
    void add_geometric(const MovedNodes& nodes, const Point& y, const Strains& stress,
                       Eigen::Matrix<double, 6 * Nodes, 6 * Nodes>& tangent) const {
        if (centred_) return add_centred(nodes, y, stress, tangent);
        Strains centred = stress;
        centred(3) += by_twist_of(y.strain(3)).dot(stress);
        add_centred(nodes, y, centred, tangent);
        Eigen::Vector<double, 6 * Nodes> twist;
        for (std::size_t k = 0; k < count; ++k)
            twist.template segment<6>(static_cast<Eigen::Index>(6 * k)) = y.b[k].row(3).transpose();
        tangent += (y.weight * squares().dot(stress)) * twist * twist.transpose();
    }

private:
    static Eigen::Quaterniond pure(const Eigen::Vector3d& v) { return {0, v(0), v(1), v(2)}; }
    static Eigen::Quaterniond of(const Four& v) { return Eigen::Quaterniond(v); }

    /// What half of the twist's square adds to each strain.
    Strains squares() const {
        const auto& [at, r, w] = shear_centre_;
        return {r * r, 0, 0, 0, w[0], w[1]};
    }
    /// What the twist adds to the derivatives of the other strains by it.
    Strains by_twist_of(double twist) const {
        const auto& [at, r, w] = shear_centre_;
        return Strains{0, -at[1], at[0], 0, 0, 0} + twist * squares();
    }
    Strains about_shear_centre(const Strains& y) const {
        const auto& [at, r, w] = shear_centre_;
        return y + y(3) * Strains{0, -at[1], at[0], 0, 0, 0} + 0.5 * y(3) * y(3) * squares();
    }

    /// As add_geometric, where the shear centre is the centroid.
    void add_centred(const MovedNodes& nodes, const Point& y, const Strains& stress,
                     Eigen::Matrix<double, 6 * Nodes, 6 * Nodes>& tangent) const {
        // f = n . Gamma + m . kappa with f |Q|^2 = <x' Q, Q n> + 2 <Q m, Q'>, quadratic in (Q, Q')
        const Eigen::Vector3d n = stress.template head<3>(), m = stress.template tail<3>();
        const double f = stress.dot(y.total), s = y.q.squaredNorm();
        const Four f_q = y.by_q.transpose() * stress, f_dq = y.by_dq.transpose() * stress;
        const Eigen::Vector3d f_dx = y.by_dx.transpose() * n;
        Eigen::Matrix4d f_qq, f_qdq;
        Eigen::Matrix<double, 4, 3> f_qdx;
        for (int c = 0; c < 4; ++c) {
            const Eigen::Quaterniond e = of(Four::Unit(c));
            f_qq.col(c) = -2 * (pure(y.dx) * e * pure(n)).coeffs();
            f_qdq.col(c) = -2 * (e * pure(m)).coeffs();
        }
        for (int c = 0; c < 3; ++c) f_qdx.col(c) = -2 * (pure(Eigen::Vector3d::Unit(c)) * of(y.q) * pure(n)).coeffs();
        f_qq -= 2 * (f_q * y.q.transpose() + y.q * f_q.transpose()) + 2 * f * Eigen::Matrix4d::Identity();
        f_qdq -= 2 * y.q * f_dq.transpose();
        f_qdx -= 2 * y.q * f_dx.transpose();
        const double w = y.weight / s;
        // of Q and Q' by the nodes' rotations
        Eigen::Matrix<double, 4, 3 * Nodes> q, dq;
        for (std::size_t k = 0; k < count; ++k) {
            const Eigen::Index at = static_cast<Eigen::Index>(3 * k);
            q.template middleCols<3>(at) = y.n[k] * nodes.turn[k];
            dq.template middleCols<3>(at) = y.d[k] * nodes.turn[k];
        }
        const Eigen::Matrix<double, 3 * Nodes, 4> qt = w * q.transpose(), dqt = w * dq.transpose();
        const Eigen::Matrix<double, 4, 3 * Nodes> by_q = f_qq.lazyProduct(q) + f_qdq.lazyProduct(dq),
                                                  by_dq = f_qdq.transpose().lazyProduct(q);
        const Eigen::Matrix<double, 3 * Nodes, 3 * Nodes> rotations = qt.lazyProduct(by_q) + dqt.lazyProduct(by_dq);
        const Eigen::Matrix<double, 3 * Nodes, 3> mixed = qt.lazyProduct(f_qdx);
        for (std::size_t i = 0; i < count; ++i) {
            const Eigen::Index from = static_cast<Eigen::Index>(3 * i);
            for (std::size_t j = 0; j < count; ++j) {
                const Eigen::Index to = static_cast<Eigen::Index>(3 * j);
                tangent.template block<3, 3>(2 * from + 3, 2 * to) += y.d[j] * mixed.template middleRows<3>(from);
                tangent.template block<3, 3>(2 * to, 2 * from + 3) +=
                    y.d[j] * mixed.template middleRows<3>(from).transpose();
                tangent.template block<3, 3>(2 * from + 3, 2 * to + 3) += rotations.template block<3, 3>(from, to);
            }
            tangent.template block<3, 3>(2 * from + 3, 2 * from + 3).diagonal().array() -=
                0.25 * y.weight * (y.n[i] * f_q + y.d[i] * f_dq).dot(nodes.p[i]);
        }
    }

    /// Q, Q', x' and the strains with their initial values.
    void interpolate(const MovedNodes& at, int g, Point& y) const {
        const ShapeFunctions<Nodes> shape = line_.shape(g);
        for (std::size_t k = 0; k < count; ++k) {
            y.n[k] = shape.value[k];
            y.d[k] = shape.slope[k] / line_.jacobian(g);
            y.q += y.n[k] * at.p[k];
            y.dq += y.d[k] * at.p[k];
            y.dx += y.d[k] * at.x[k];
        }
        const Eigen::Quaterniond q = of(y.q);
        y.total << (q.conjugate() * pure(y.dx) * q).vec(), 2 * (q.conjugate() * of(y.dq)).vec();
        y.total /= y.q.squaredNorm();
    }

    std::array<Eigen::Quaterniond, count> section_;  // of each node's cross-section
    GaussLine<Nodes> line_;
    std::array<Strains, count - 1> initial_strain_;
    ShearCentre shear_centre_;
    bool centred_;  // whether it is the centroid
};

}  // namespace equilibria::fem
