/// \file
/// Joints between two nodes, and prescribed motions, as constraints of the augmented Lagrangian. Axes and offsets are
/// those without load, in the fixed axes. A joint to the ground is one to a node whose components are all fixed. Forces
/// and moments of a joint are its multipliers times fem::ConstraintScale::multiplier.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include <equilibria/core/error.hpp>
#include <equilibria/core/streamed_text.hpp>
#include <equilibria/fem/element.hpp>

namespace equilibria::fem {

namespace detail {

/// Two unit vectors that make a right-handed orthogonal frame with `axis`. Throws InvalidArgument unless the axis is
/// finite and not 0.
inline std::array<Eigen::Vector3d, 3> frame_along(const Eigen::Vector3d& axis) {
    require(axis.allFinite() && axis.norm() > 0, "axis", streamed(axis.transpose()), "must be finite and not 0");
    Eigen::Index least = 0;
    const Eigen::Vector3d n = axis.normalized();
    n.cwiseAbs().minCoeff(&least);
    const Eigen::Vector3d t = n.cross(Eigen::Vector3d::Unit(least)).normalized();
    return {n, t, n.cross(t)};
}

template <class T>
Vector3<T> turned(const Frame<T>& at, const Eigen::Vector3d& v) {
    return at.q * Vector3<T>(v.cast<T>());
}

}  // namespace detail

/// A point of each body is the same: x_A + R_A a = x_B + R_B b.
struct SphericalJoint {
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2, n_constraints = 3;
    static constexpr auto components = spatial;
    static constexpr bool depends_on_parameter = false;
    static constexpr std::array force_names{"F1", "F2", "F3"};
    /// \}
    Eigen::Vector3d a = Eigen::Vector3d::Zero();  ///< from node A to the joint
    Eigen::Vector3d b = Eigen::Vector3d::Zero();  ///< from node B to it

    /// The gap between the two points.
    template <class T>
    Vector3<T> constraints(const std::array<Frame<T>, 2>& at, const T&) const {
        return at[0].x + detail::turned(at[0], a) - at[1].x - detail::turned(at[1], b);
    }
};

/// The same in the x-y plane, a hinge about z.
struct PlanarHinge {
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2, n_constraints = 2;
    static constexpr auto components = planar;
    static constexpr bool depends_on_parameter = false;
    static constexpr std::array force_names{"F1", "F2"};
    /// \}
    Eigen::Vector3d a = Eigen::Vector3d::Zero();  ///< from node A to the joint
    Eigen::Vector3d b = Eigen::Vector3d::Zero();  ///< from node B to it

    /// The gap between the two points, in x and y.
    template <class T>
    Eigen::Matrix<T, 2, 1> constraints(const std::array<Frame<T>, 2>& at, const T& p) const {
        return SphericalJoint{a, b}.constraints(at, p).template head<2>();
    }
};

/// A spherical joint whose bodies also share an axis.
class RevoluteJoint {
public:
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2, n_constraints = 5;
    static constexpr auto components = spatial;
    static constexpr bool depends_on_parameter = false;
    /// \}

    /// a and b: from the nodes to the joint. Throws InvalidArgument unless the axis is finite and not 0.
    explicit RevoluteJoint(const Eigen::Vector3d& axis, const Eigen::Vector3d& a = Eigen::Vector3d::Zero(),
                           const Eigen::Vector3d& b = Eigen::Vector3d::Zero())
        : point_{a, b}, frame_(detail::frame_along(axis)) {}

    /// The gap between the two points, and what A's axis has along two vectors of B that were normal to it.
    template <class T>
    Eigen::Matrix<T, 5, 1> constraints(const std::array<Frame<T>, 2>& at, const T& p) const {
        const Vector3<T> axis = detail::turned(at[0], frame_[0]);
        Eigen::Matrix<T, 5, 1> y;
        y << point_.constraints(at, p), axis.dot(detail::turned(at[1], frame_[1])),
            axis.dot(detail::turned(at[1], frame_[2]));
        return y;
    }

private:
    SphericalJoint point_;
    std::array<Eigen::Vector3d, 3> frame_;
};

/// Node B slides along an axis of node A, and turns as A does.
class PrismaticJoint {
public:
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2, n_constraints = 5;
    static constexpr auto components = spatial;
    static constexpr bool depends_on_parameter = false;
    /// \}

    /// offset: from A to B without load. Throws InvalidArgument unless the axis is finite and not 0.
    PrismaticJoint(const Eigen::Vector3d& axis, const Eigen::Vector3d& offset)
        : frame_(detail::frame_along(axis)), offset_(offset) {}

    /// B's distances from the axis in two directions, and its rotation against A.
    template <class T>
    Eigen::Matrix<T, 5, 1> constraints(const std::array<Frame<T>, 2>& at, const T&) const {
        const Vector3<T> d = at[1].x - at[0].x, n = detail::turned(at[0], frame_[0]),
                         s = detail::turned(at[0], frame_[1]), t = detail::turned(at[0], frame_[2]);
        Eigen::Matrix<T, 5, 1> y;
        y << s.dot(d) - T(frame_[1].dot(offset_)), t.dot(d) - T(frame_[2].dot(offset_)),
            n.dot(detail::turned(at[1], frame_[1])), s.dot(detail::turned(at[1], frame_[2])),
            t.dot(detail::turned(at[1], frame_[0]));
        return y;
    }

private:
    std::array<Eigen::Vector3d, 3> frame_;
    Eigen::Vector3d offset_;
};

/// A fork that holds a beam's end against twist alone: what was upright in the cross-section stays in the plane of the
/// beam's axis and the upright direction, as between two plates, whatever the end's slopes are. Its multiplier is the
/// moment, times the cosine of the slope.
class ForkSupport {
public:
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 1, n_constraints = 1;
    static constexpr std::array components{rx, ry, rz};
    static constexpr bool depends_on_parameter = false;
    static constexpr std::array force_names{"M"};
    /// \}

    /// axis: along the beam, upright: in its cross-section, both without load. Throws InvalidArgument unless the axis
    /// is finite and not 0, and the upright direction not along it.
    ForkSupport(const Eigen::Vector3d& axis, const Eigen::Vector3d& upright) {
        const Eigen::Vector3d n = detail::frame_along(axis)[0], across = n.cross(upright);
        require(upright.allFinite() && across.norm() > 1e-9 * upright.norm(), "upright", streamed(upright.transpose()),
                "must be finite and not along the axis");
        sideways_ = across.normalized();
        upright_ = sideways_.cross(n);
    }

    /// What the turned upright vector has sideways.
    template <class T>
    Eigen::Matrix<T, 1, 1> constraints(const std::array<Frame<T>, 1>& at, const T&) const {
        const Vector3<T> sideways = sideways_.cast<T>();
        return Eigen::Matrix<T, 1, 1>(sideways.dot(detail::turned(at[0], upright_)));
    }

private:
    Eigen::Vector3d upright_, sideways_;
};

/// The node moves along a fixed direction: direction . (x - origin) = rate p + offset. Its multiplier is minus the
/// force.
struct PrescribedDisplacement {
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 1, n_constraints = 1;
    static constexpr auto components = positions;
    static constexpr std::array force_names{"F"};
    /// \}
    Eigen::Vector3d direction;  ///< in fixed axes, of length 1 where p is a distance
    Eigen::Vector3d origin;     ///< from which x is measured
    double rate = 1;            ///< of the displacement by p
    double offset = 0;          ///< at p = 0

    /// direction . (x - origin) - rate p - offset.
    template <class T>
    Eigen::Matrix<T, 1, 1> constraints(const std::array<Frame<T>, 1>& at, const T& p) const {
        const Vector3<T> d = direction.cast<T>();
        return Eigen::Matrix<T, 1, 1>(d.dot(at[0].x) - T(direction.dot(origin) + offset) - rate * p);
    }
};

/// The node turns about a fixed axis by the angle rate p, radians, through any number of turns; its multipliers are
/// minus the moment, in the axes of the node.
class PrescribedRotation {
public:
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 1, n_constraints = 3;
    static constexpr std::array components{rx, ry, rz};
    static constexpr std::array force_names{"M1", "M2", "M3"};
    /// \}

    /// rate: by p, radians. Throws InvalidArgument unless the axis is finite and not 0.
    explicit PrescribedRotation(const Eigen::Vector3d& axis, double rate = 1)
        : axis_(detail::frame_along(axis)[0]), rate_(rate) {}

    /// Twice the vector of the quaternion that is left of the rotation.
    template <class T>
    Vector3<T> constraints(const std::array<Frame<T>, 1>& at, const T& p) const {
        using std::cos, std::sin;
        const T half = 0.5 * rate_ * p;
        const Vector3<T> v = sin(half) * axis_.cast<T>();
        const Vector3<T> error = (Eigen::Quaternion<T>(cos(half), -v(0), -v(1), -v(2)) * at[0].q).vec();
        return T(2.0) * error;
    }

private:
    Eigen::Vector3d axis_;
    double rate_;
};

/// Node B turns against node A about an axis of both by the angle rate p + offset, radians: the drive of a revolute
/// joint. Its multiplier is minus the moment.
class RotationDrive {
public:
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2, n_constraints = 1;
    static constexpr std::array components{rx, ry, rz};
    static constexpr std::array force_names{"M"};
    /// \}

    /// rate: by p, radians; offset: at p = 0. Throws InvalidArgument unless the axis is finite and not 0.
    explicit RotationDrive(const Eigen::Vector3d& axis, double rate = 1, double offset = 0)
        : axis_(detail::frame_along(axis)[0]), rate_(rate), offset_(offset) {}

    /// Twice the sine of half the angle by which B has turned too far.
    template <class T>
    Eigen::Matrix<T, 1, 1> constraints(const std::array<Frame<T>, 2>& at, const T& p) const {
        using std::cos, std::sin;
        const T half = 0.5 * (rate_ * p + T(offset_));
        const Eigen::Quaternion<T> between = at[0].q.conjugate() * at[1].q;
        const Vector3<T> n = axis_.cast<T>();
        // the part along the axis of exp(-angle n) between, twice
        return Eigen::Matrix<T, 1, 1>(T(2.0) * (cos(half) * n.dot(between.vec()) - sin(half) * between.w()));
    }

private:
    Eigen::Vector3d axis_;
    double rate_, offset_;
};

/// The same in the x-y plane, about z.
class PlanarRotationDrive {
public:
    /// What every element has, see element.hpp.
    /// \{
    static constexpr int n_nodes = 2, n_constraints = 1;
    static constexpr std::array components{rz};
    static constexpr std::array force_names{"M"};
    /// \}

    /// rate: by p, radians; offset: at p = 0.
    explicit PlanarRotationDrive(double rate = 1, double offset = 0) : drive_(Eigen::Vector3d::UnitZ(), rate, offset) {}

    /// Twice the sine of half the angle by which B has turned too far.
    template <class T>
    Eigen::Matrix<T, 1, 1> constraints(const std::array<Frame<T>, 2>& at, const T& p) const {
        return drive_.constraints(at, p);
    }

private:
    RotationDrive drive_;
};

#ifdef EQUILIBRIA_COMPILED
extern template class ElementGroupOf<SphericalJoint>;
extern template class ElementGroupOf<PlanarHinge>;
extern template class ElementGroupOf<RevoluteJoint>;
extern template class ElementGroupOf<PrismaticJoint>;
extern template class ElementGroupOf<ForkSupport>;
extern template class ElementGroupOf<PrescribedDisplacement>;
extern template class ElementGroupOf<PrescribedRotation>;
extern template class ElementGroupOf<RotationDrive>;
extern template class ElementGroupOf<PlanarRotationDrive>;
#endif

}  // namespace equilibria::fem
