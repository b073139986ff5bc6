/// \file
/// The relative equilibria of a body with a beam against the angular momentum: branches with their index, folds and
/// pitchforks, and curves of these in a second parameter.
///
/// \code
/// BodyBeamSolver<1, BeamControl::momentum>::Values p{2, 1.2, 1.3, 0.8, 0, 0, 0, 1, 1, 1.2, 100, 0, 6};
/// const BodyBeamSolver<1, BeamControl::momentum> solver(p);
/// const auto diagram = body_beam_diagram(solver, p, {3, 8});
/// for (const auto& point : diagram.critical_points) std::cout << to_string(point.kind) << point.at.momentum << '\n';
/// \endcode
///
/// At a few momenta, the slices, all relative equilibria are enumerated; the branches through them are followed from
/// bifurcation to bifurcation, and each equilibrium of a slice lies on one. What is born and gone between two slices,
/// and joined to nothing else, is not seen: more slices see more. Of the curves the same holds for values of the second
/// parameter. Everything is in the units of the body. The equilibria are (2.6) and (2.7) of Baillieul, "Parametric
/// dependence in the equilibrium dynamics of rotating structures".
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/critical_kind.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_equilibria.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_solver.hpp>

namespace equilibria::mechanisms {

/// A piece of a branch between critical points, along which the index does not change.
struct BodyBeamBranch {
    int index = 0;  ///< of momentum_hessian(): at fixed momentum
    /// Critical points at its ends among them. `residual`: the largest entry of the equations, without units;
    /// `condition` and `proved` are an enumeration's, and not set.
    std::vector<BodyBeamEquilibrium> points;
};

/// A point at which branches turn back or meet.
struct BodyBeamCriticalPoint {
    CriticalKind kind = CriticalKind::fold;  ///< what it is
    BodyBeamEquilibrium at;                  ///< where it is
};

/// Relative equilibria against the momentum. A body with planes of symmetry has mirror images of branches and critical
/// points: each is there.
struct BodyBeamDiagram {
    std::vector<BodyBeamBranch> branches;                ///< by their index
    std::vector<BodyBeamCriticalPoint> critical_points;  ///< by their momentum
    std::vector<double> slices;                          ///< momenta at which all equilibria were enumerated
    std::size_t on_no_branch = 0;                        ///< equilibria of the slices
    /// Each branch was followed to its end, with every change of index accounted for, and so was every path of the
    /// slices.
    bool followed = true;

    bool complete() const { return followed && on_no_branch == 0; }  ///< nothing that a slice sees is missing
};

/// Folds, or bifurcations of one kind, in the plane of a second parameter and the momentum.
struct BodyBeamCurve {
    CriticalKind kind = CriticalKind::fold;     ///< as of the critical point that it was followed from
    std::vector<std::array<double, 2>> points;  ///< second parameter, momentum
    double residual = 0;  ///< of the equations of critical points, the largest entry over the points, without units
};

/// Where relative equilibria are born and gone in the plane of a second parameter and the momentum.
struct BodyBeamCurves {
    std::vector<BodyBeamCurve> curves;         ///< those of mirror images once
    std::vector<std::array<double, 2>> cusps;  ///< second parameter, momentum
    std::vector<double> slices;                ///< values of the second parameter whose diagrams they are followed from
    std::size_t on_no_curve = 0;               ///< critical points of the slices that no curve could be followed from
    bool followed = true;                      ///< the slices' diagrams are complete

    bool complete() const { return followed && on_no_curve == 0; }  ///< nothing that a slice sees is missing
};

/// How branches and curves are followed.
struct BodyBeamDiagramOptions {
    int slices = 4;  ///< momenta at which equilibria are enumerated; a curve's diagrams: values of its parameter
    /// Its range is not read. Steps are in the units of BodyBeamEitherStrain::units(): length 1, stiffnesses near
    /// 0.055.
    ContinuationOptions continuation{.branch = {.first_step = 0.01, .largest_step = 0.05}, .most_steps = 400};

    /// Throws InvalidArgument for an option out of range.
    void validate() const {
        require(slices >= 1, "slices", slices, "must be at least 1");
        continuation.validate();
    }
};

/// The branches of the body p in a range of positive momenta. Throws InvalidArgument where the range is none, where the
/// solver refuses p, and where turning about the third axis changes nothing: such a body has circles of equilibria.
template <int K>
BodyBeamDiagram body_beam_diagram(const BodyBeamSolver<K, BeamControl::momentum>& solver,
                                  const typename BodyBeamSolver<K, BeamControl::momentum>::Values& p,
                                  const Interval& momenta, const BodyBeamDiagramOptions& options = {});

/// The curves in the plane of the parameter number `second` of RotatingBodyBeamBase (a mass, a moment, a place of the
/// centre, the length or a stiffness) and the momentum. They are followed as far as the first point outside of the
/// window. Throws InvalidArgument as body_beam_diagram does, and for another parameter.
template <int K>
BodyBeamCurves body_beam_curves(const BodyBeamSolver<K, BeamControl::momentum>& solver,
                                const typename BodyBeamSolver<K, BeamControl::momentum>::Values& p, int second,
                                const Window& window, const BodyBeamDiagramOptions& options = {});

}  // namespace equilibria::mechanisms

#include <equilibria/studies/rotating_body_beam/detail/body_beam_diagram_definitions.hpp>
