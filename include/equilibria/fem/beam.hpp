/// \file
/// Beam elements, in space and in the plane, from their strains (beam_geometry.hpp, planar_geometry.hpp):
///
///     energy = integral of strain^T C strain / 2
///
/// with one Gauss point less than nodes: 2 nodes make an element of order 2, 3 of order 4 and 4 of order 6 in critical
/// loads and in displacements of nodes, and none locks. Beams may be curved and twisted without load, and have a shear
/// centre beside their nodes' line.
///
/// MixedBeam has the forces and moments n = C strain at its Gauss points as unknowns of their own, multipliers:
///
///     integral of n^T strain - n^T F n / 2 + (strain - F n)^T rho (strain - F n) / 2,     F = C^(-1)
///
/// (Hellinger and Reissner; the term with rho keeps the nodes' block of K regular and is 0 at every solution). Its
/// equilibria are those of Beam, but stiffnesses may be infinite (fem::rigid), and where some are far above others
/// Newton's method takes steps many times as long: a turned element's linear prediction has strains of second order,
/// which throw forces off that follow from them, and leave forces that are unknowns where they are. (Magisano, Leonetti
/// and Garcea, How to improve efficiency and robustness of the Newton method in geometrically non-linear structural
/// problem discretized via displacement-based finite elements, Comput. Methods Appl. Mech. Engrg. 313, 2017.)
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <equilibria/fem/beam_geometry.hpp>
#include <equilibria/fem/element.hpp>
#include <equilibria/fem/planar_geometry.hpp>
#include <equilibria/fem/section.hpp>

namespace equilibria::fem {

namespace detail {

/// By the unknowns of all nodes.
template <class Geometry>
using NodeMatrix = Eigen::Matrix<double, Geometry::n_strains*(Geometry::gauss_points + 1),
                                 Geometry::n_strains*(Geometry::gauss_points + 1)>;

/// Adds b^T c b of a Gauss point times its weight, c a diagonal matrix.
template <class Geometry>
void add_material(const typename Geometry::Point& y, const typename Geometry::Strains& c,
                  NodeMatrix<Geometry>& tangent) {
    constexpr int n = Geometry::n_strains, unknowns = NodeMatrix<Geometry>::RowsAtCompileTime;
    Eigen::Matrix<double, unknowns, n> b;
    for (std::size_t k = 0; k < y.b.size(); ++k)
        b.template middleRows<n>(static_cast<Eigen::Index>(n * k)) = y.b[k].transpose();
    const Eigen::Matrix<double, n, unknowns> cb = y.weight * (c.asDiagonal() * b.transpose());
    tangent += b.lazyProduct(cb);
}

/// The geometry of nodes, with the section's shear centre where it has one.
template <class Geometry, class S>
Geometry geometry_of(const std::array<typename Geometry::InitialFrame, Geometry::gauss_points + 1>& at,
                     const S& section) {
    section.validate();
    if constexpr (requires { section.shear_centre; })
        return Geometry(at, section.shear_centre);
    else
        return Geometry(at);
}

/// Names of the forces and moments of a cross-section: of a planar beam 3, in space 6.
template <int Strains>
constexpr auto section_force_names() {
    if constexpr (Strains == 6)
        return std::array{"N", "Q2", "Q3", "M1", "M2", "M3"};
    else
        return std::array{"N", "Q", "M"};
}
/// stress(g) at the deformed place of each Gauss point.
template <class Geometry>
std::vector<InternalForce> section_forces(const Geometry& geometry, const typename Geometry::Frames& at,
                                          const auto& stress) {
    std::vector<InternalForce> y;
    for (int g = 0; g < Geometry::gauss_points; ++g) {
        const auto shape = geometry.line().shape(g);
        InternalForce force{Eigen::Vector3d::Zero(), {}};
        for (std::size_t k = 0; k < at.size(); ++k) force.place += shape.value[k] * at[k].x;
        const typename Geometry::Strains values = stress(g);
        force.values.assign(values.begin(), values.end());
        y.push_back(std::move(force));
    }
    return y;
}

template <class Geometry, class S>
class BeamElement {
public:
    static constexpr int n_nodes = Geometry::gauss_points + 1;
    static constexpr auto components = motion_components<Geometry::n_strains == 6 ? 3 : 2>();
    static constexpr bool depends_on_parameter = false;
    static constexpr int gauss_points = Geometry::gauss_points;
    static constexpr auto force_names = section_force_names<Geometry::n_strains>();
    using Frames = typename Geometry::Frames;
    using Strains = typename Geometry::Strains;
    using InitialFrames = std::array<typename Geometry::InitialFrame, static_cast<std::size_t>(n_nodes)>;

    /// at: the nodes from one end to the other, equally spaced along the beam. Throws InvalidArgument for a section out
    /// of range and for nodes at one place.
    BeamElement(const S& section, const InitialFrames& at)
        : geometry_(geometry_of<Geometry>(at, section)), stiffness_(section.stiffness()) {
        require(stiffness_.allFinite(), "section", "infinite", "MixedBeam takes infinite stiffnesses");
    }

    const Geometry& geometry() const { return geometry_; }
    /// At Gauss point g.
    Strains strain(const Frames& at, int g) const { return geometry_.strain(at, g); }
    /// Forces and moments of the cross-section, in its axes.
    Strains stress(const Frames& at, int g) const { return stiffness_.cwiseProduct(strain(at, g)); }
    /// Forces and moments of the cross-section at each Gauss point, in its axes.
    std::vector<InternalForce> forces(const Frames& at, const ElementQuery&) const {
        return section_forces(geometry_, at, [&](int g) { return stress(at, g); });
    }
    double energy(const Frames& at) const {
        double y = 0;
        for (int g = 0; g < gauss_points; ++g) y += 0.5 * geometry_.line().weight(g) * strain(at, g).dot(stress(at, g));
        return y;
    }

    void evaluate(const Frames& at, double, Need need, ElementValues& out) const {
        if (need == Need::residual) out.residual.setZero();
        NodeMatrix<Geometry> tangent = NodeMatrix<Geometry>::Zero();
        const auto nodes = geometry_.nodes(at);
        for (int g = 0; g < gauss_points; ++g) {
            const auto y = geometry_.point(nodes, g);
            const Strains stress = stiffness_.cwiseProduct(y.strain);
            if (need == Need::residual) {
                for (int k = 0; k < n_nodes; ++k)
                    out.residual.template segment<n>(n * k) += y.weight * y.b[place(k)].transpose() * stress;
                continue;
            }
            add_material<Geometry>(y, stiffness_, tangent);
            geometry_.add_geometric(nodes, y, stress, tangent);
        }
        if (need == Need::tangent) out.tangent = tangent;
    }

private:
    static constexpr int n = Geometry::n_strains;  // as many as unknowns of a node
    static constexpr std::size_t place(int k) { return static_cast<std::size_t>(k); }

    Geometry geometry_;
    Strains stiffness_;
};

template <class Geometry, class S>
class MixedBeamElement {
public:
    static constexpr int n_nodes = Geometry::gauss_points + 1;
    static constexpr auto components = BeamElement<Geometry, S>::components;
    static constexpr bool depends_on_parameter = false;
    static constexpr int gauss_points = Geometry::gauss_points;
    static constexpr int n_multipliers = Geometry::n_strains * gauss_points;
    static constexpr auto force_names = section_force_names<Geometry::n_strains>();
    using Frames = typename Geometry::Frames;
    using Strains = typename Geometry::Strains;
    using InitialFrames = typename BeamElement<Geometry, S>::InitialFrames;

    MixedBeamElement(const S& section, const InitialFrames& at) : geometry_(geometry_of<Geometry>(at, section)) {
        const Strains stiffness = section.stiffness();
        flexibility_ = stiffness.cwiseInverse();
        // as stiff as the softest bending over the element, and half of the stiffness at most: then n keeps its part
        const double length = geometry_.line().length(),
                     softest = stiffness.template tail<n - S::n_forces>().minCoeff();
        for (int c = 0; c < n; ++c)
            penalty_(c) = std::min(c < S::n_forces ? softest / (length * length) : softest, 0.5 * stiffness(c));
    }

    const Geometry& geometry() const { return geometry_; }
    Strains strain(const Frames& at, int g) const { return geometry_.strain(at, g); }
    /// Forces and moments of the cross-section at each Gauss point, in its axes.
    std::vector<InternalForce> forces(const Frames& at, const ElementQuery& query) const {
        const Strains share = Strains::Ones() - penalty_.cwiseProduct(flexibility_);
        return section_forces(geometry_, at, [&](int g) {
            const Strains force = query.scale.multiplier * Eigen::Map<const Strains>(query.multipliers + n * g);
            return Strains(penalty_.cwiseProduct(strain(at, g)) + share.cwiseProduct(force));
        });
    }

    void evaluate(const Frames& at, const double* multipliers, double, const ConstraintScale& scale, Need need,
                  ElementValues& out) const {
        if (need == Need::residual) out.residual.setZero();
        if (need == Need::tangent) out.tangent.template bottomRightCorner<n_multipliers, n_multipliers>().setZero();
        NodeMatrix<Geometry> tangent = NodeMatrix<Geometry>::Zero();
        const Strains share = Strains::Ones() - penalty_.cwiseProduct(flexibility_);
        const auto nodes = geometry_.nodes(at);
        for (int g = 0; g < gauss_points; ++g) {
            const auto y = geometry_.point(nodes, g);
            const Strains force = scale.multiplier * Eigen::Map<const Strains>(multipliers + n * g),
                          stress = penalty_.cwiseProduct(y.strain) + share.cwiseProduct(force);
            const int row = n * (n_nodes + g);
            const double k = scale.multiplier * y.weight;
            if (need == Need::residual) {
                for (int i = 0; i < n_nodes; ++i)
                    out.residual.template segment<n>(n * i) += y.weight * y.b[place(i)].transpose() * stress;
                out.residual.template segment<n>(row) =
                    k * share.cwiseProduct(y.strain - flexibility_.cwiseProduct(force));
                continue;
            }
            for (int i = 0; i < n_nodes; ++i) {
                const Matrix coupling = k * share.asDiagonal() * y.b[place(i)];
                out.tangent.template block<n, n>(row, n * i) = coupling;
                out.tangent.template block<n, n>(n * i, row) = coupling.transpose();
            }
            out.tangent.template block<n, n>(row, row).diagonal() =
                -scale.multiplier * k * flexibility_.cwiseProduct(share);
            add_material<Geometry>(y, penalty_, tangent);
            geometry_.add_geometric(nodes, y, stress, tangent);
        }
        if (need == Need::tangent) out.tangent.template topLeftCorner<n * n_nodes, n * n_nodes>() = tangent;
    }

private:
    static constexpr int n = Geometry::n_strains;  // as many as unknowns of a node
    using Matrix = typename Geometry::StrainDerivative;
    static constexpr std::size_t place(int k) { return static_cast<std::size_t>(k); }

    Geometry geometry_;
    Strains flexibility_, penalty_;
};

}  // namespace detail

/// A beam in space, of 2, 3 or 4 nodes.
template <int Nodes>
using Beam = detail::BeamElement<BeamGeometry<Nodes>, Section>;
/// A beam in the x-y plane, of 2, 3 or 4 nodes.
template <int Nodes>
using PlanarBeam = detail::BeamElement<PlanarGeometry<Nodes>, PlanarSection>;
/// A beam in space with forces and moments as unknowns.
template <int Nodes>
using MixedBeam = detail::MixedBeamElement<BeamGeometry<Nodes>, Section>;
/// A beam in the x-y plane with forces and moment as unknowns.
template <int Nodes>
using PlanarMixedBeam = detail::MixedBeamElement<PlanarGeometry<Nodes>, PlanarSection>;

#ifdef EQUILIBRIA_COMPILED
extern template class ElementGroupOf<Beam<2>>;
extern template class ElementGroupOf<Beam<3>>;
extern template class ElementGroupOf<Beam<4>>;
extern template class ElementGroupOf<PlanarBeam<2>>;
extern template class ElementGroupOf<PlanarBeam<3>>;
extern template class ElementGroupOf<PlanarBeam<4>>;
extern template class ElementGroupOf<MixedBeam<2>>;
extern template class ElementGroupOf<MixedBeam<3>>;
extern template class ElementGroupOf<MixedBeam<4>>;
extern template class ElementGroupOf<PlanarMixedBeam<2>>;
extern template class ElementGroupOf<PlanarMixedBeam<3>>;
extern template class ElementGroupOf<PlanarMixedBeam<4>>;
#endif

}  // namespace equilibria::fem
