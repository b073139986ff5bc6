// The figures of the rotating body with a beam: its relative equilibria against the angular momentum, their pitchforks
// and folds over the ratio of the stiffnesses, shapes of the beam, and a motion that settles.
//
//   body_beam_figures --out figures
//
// The continuous beam is solved by collocation. Its index at a given momentum is that of the energy's Hessian over six
// modes a direction at the projected shape, taken in the middle between critical points, where no eigenvalue is near 0.
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <equilibria/continuation/curves/critical_curve_trace.hpp>
#include <equilibria/continuation/diagrams/branch_graph.hpp>
#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/stability/inertia.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_either_strain.hpp>
#include <equilibria/studies/rotating_body_beam/momentum_hessian.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_boundary.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam_motion.hpp>
#include <exception>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "plots/body_beam_momentum.hpp"
#include "plots/body_beam_ratio.hpp"
#include "plots/body_beam_settling.hpp"
#include "plots/body_beam_shapes.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/pictures.hpp"

namespace {

using namespace equilibria;
using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;
using mechanisms::BeamControl, mechanisms::BeamStrain, mechanisms::RotatingBodyBeam,
    mechanisms::RotatingBodyBeamBoundary;
using Names = RotatingBodyBeam<1>;
using Values = RotatingBodyBeamBoundary::Values;
using std::numbers::pi;

Values body(double ratio = 1.2) { return {2, 1.2, 1.3, 0.8, 0, 0, 0, 1, 1, ratio, 100}; }

struct Figure {
    std::string name;
    GnuplotData data;
    const char* script;
    support::PictureSize size;
};

/// What the unknowns and the equations of the derivatives at the points are multiplied by. Either way the tangent's
/// singular values are those of one operator, as the tests for bifurcations want it.
enum class Scaling {
    equations,  ///< the equations by the weights
    both,       ///< both by the roots of the weights: entries of null vectors can be compared, as for their border
};

/// The continuous beam at a given momentum, with its symmetries: reflections, and -n for n.
class ContinuousBeam {
public:
    static constexpr bool symmetric = false;
    ContinuousBeam(const Values& p, BeamStrain strain, Scaling scaling = Scaling::equations)
        : beam_(p, strain, 20, BeamControl::momentum), weights_(beam_.weights({})), unknowns_(weights_.cwiseSqrt()) {
        if (scaling == Scaling::equations) unknowns_.setOnes();
        equations_ = weights_.cwiseQuotient(unknowns_);
    }

    VectorXd residual(const VectorXd& q, double p) const { return equations_.cwiseProduct(beam_.residual(own(q), p)); }
    MatrixXd tangent(const VectorXd& q, double p) const {
        return equations_.asDiagonal() * beam_.tangent(own(q), p) * unknowns_.cwiseInverse().asDiagonal();
    }
    VectorXd parameter_derivative(const VectorXd& q, double p) const {
        return equations_.cwiseProduct(beam_.parameter_derivative(own(q), p));
    }
    VectorXd second_parameter_derivative(const VectorXd& q, double p) const {
        return equations_.cwiseProduct(beam_.second_parameter_derivative(own(q), p));
    }
    VectorXd parameter_derivative_along(const VectorXd& q, double p, const VectorXd& v) const {
        return equations_.cwiseProduct(beam_.parameter_derivative_along(own(q), p, own(v)));
    }
    VectorXd weights(const VectorXd&) const { return weights_.cwiseQuotient(unknowns_.cwiseAbs2()); }
    std::vector<VectorXd> images(const VectorXd& q) const {
        std::vector<VectorXd> y;
        const int m = beam_.points();
        for (int signs = 1; signs < 8; ++signs) {
            VectorXd image = q;
            for (int a = 0; a < 2; ++a)
                if ((signs >> a & 1) != 0) {
                    image(a) *= -1;
                    image.segment(3 + a * m, m) *= -1;
                }
            if ((signs & 4) != 0) image.head(3) *= -1;
            y.push_back(image);
        }
        return y;
    }

    const Values& parameters() const { return beam_.parameters(); }
    BeamStrain strain() const { return beam_.strain(); }
    Vector3d axis(const VectorXd& q) const { return beam_.axis(own(q)); }
    double moment(const VectorXd& q) const { return beam_.moment(own(q)); }
    double speed(const VectorXd& q, double p) const { return beam_.speed(own(q), p); }
    Vector3d displacement(const VectorXd& q, double z) const { return beam_.shape(own(q), z).u; }
    /// Of the displacements along the second axis; of a direction too.
    double second_share(const VectorXd& q) const { return q.segment(3 + beam_.points(), beam_.points()).norm(); }
    std::optional<VectorXd> solve(const VectorXd& q, double p) const {
        const auto y = beam_.solve(own(q), p);
        if (!y.converged()) return std::nullopt;
        return scaled(y.q);
    }
    /// A beam without tension, bent in a plane (0 or 1), turning about n.
    VectorXd bent(int plane, double tip, const Vector3d& n) const {
        VectorXd q = beam_.undeformed(n);
        q.segment(3 + plane * beam_.points(), beam_.points()).setConstant(8 * tip);
        q(q.size() - 1) = n.dot(beam_.inertia(q) * n);
        return scaled(q);
    }
    /// The unknowns of RotatingBodyBeamBoundary, and back.
    VectorXd own(const VectorXd& q) const { return q.cwiseQuotient(unknowns_); }
    VectorXd scaled(const VectorXd& q) const { return q.cwiseProduct(unknowns_); }

private:
    RotatingBodyBeamBoundary beam_;
    VectorXd weights_, unknowns_, equations_;
};
using Graph = BranchGraph<ContinuousBeam>;

/// Negative eigenvalues of the energy at the given momentum, over the axis and six modes a direction.
template <BeamStrain Strain>
int index(const ContinuousBeam& beam, const VectorXd& q, double momentum) {
    constexpr int K = 6;
    using M = RotatingBodyBeam<K, Strain>;
    Parameters<M> p;
    std::copy(beam.parameters().begin(), beam.parameters().end(), p.begin());
    Unknowns<M> at{};
    const Vector3d n = beam.axis(q).normalized();
    for (int i = 0; i < 3; ++i) at[i] = n(i);
    M::modes.for_each_node([&](double z, double w) {
        const auto phi = M::modes.bending(z), psi = M::modes.stretching(z);
        const Vector3d u = beam.displacement(q, z);  // of length 1
        for (int i = 0; i < K; ++i) {
            for (int a = 0; a < 2; ++a) at[M::first_mode + a * K + i] += w * phi.value[i] * u(a);
            at[M::first_mode + 2 * K + i] += w * psi.value[i] * u(2);
        }
    });
    const MatrixXd hessian = mechanisms::momentum_hessian<K, Strain>(at, momentum, p);
    return inertia(hessian).negative;
}
int index(const ContinuousBeam& beam, const VectorXd& q, double momentum) {
    return beam.strain() == BeamStrain::linear ? index<BeamStrain::linear>(beam, q, momentum)
                                               : index<BeamStrain::coupled>(beam, q, momentum);
}

constexpr double low = 3.2, high = 7.6;

using Diagram = std::vector<Graph>;

/// At a momentum, images once, by their moment of inertia.
std::vector<VectorXd> equilibria_at(const ContinuousBeam& beam, const Diagram& diagram, double momentum) {
    std::vector<VectorXd> y;
    for (const auto& graph : diagram)
        for (const auto& edge : graph.branches)
            for (std::size_t k = 0; k + 1 < edge.branch.points.size(); ++k) {
                const auto &a = edge.branch.points[k], &b = edge.branch.points[k + 1];
                if ((a.p - momentum) * (b.p - momentum) > 0) continue;
                const auto at = beam.solve(a.q + (momentum - a.p) / (b.p - a.p) * (b.q - a.q), momentum);
                if (at && std::none_of(y.begin(), y.end(), [&](const VectorXd& q) {
                        return std::abs(beam.moment(q) - beam.moment(*at)) < 1e-7;
                    }))
                    y.push_back(*at);
            }
    std::sort(y.begin(), y.end(),
              [&](const VectorXd& a, const VectorXd& b) { return beam.moment(a) < beam.moment(b); });
    return y;
}

/// The branches joined to a spin, or to an equilibrium that Newton's method finds from a beam bent in a plane.
Diagram diagram_of(const ContinuousBeam& beam) {
    DiagramOptions options;
    options.continuation.range.low = low;
    options.continuation.range.high = high;
    options.continuation.branch.parameter_weight = 0.2;
    options.continuation.branch.largest_step = 0.1;
    Diagram y;
    const auto add = [&](const VectorXd& guess, double momentum) {
        const auto q = beam.solve(guess, momentum);
        if (!q || !(beam.moment(*q) > 0 && beam.moment(*q) < 4)) return;
        for (const VectorXd& known : equilibria_at(beam, y, momentum))
            if (std::abs(beam.moment(known) - beam.moment(*q)) < 1e-7) return;
        y.push_back(bifurcation_diagram(beam, *q, momentum, options));
        if (!y.back().complete()) std::fprintf(stderr, "body_beam_figures: a diagram is not complete\n");
    };
    for (const double momentum : {4.4, 5.7, 7.0}) {
        for (const int axis : {2, 1, 0}) add(beam.bent(0, 0, Vector3d::Unit(axis)), momentum);
        for (const int plane : {0, 1})
            for (const double tip : {0.8, 1.4, 2.0, 2.6}) {
                add(beam.bent(plane, tip, Vector3d::Unit(1 - plane)), momentum);
                for (int k = -2; k <= 3; ++k) {
                    Vector3d n = Vector3d::Zero();
                    n(plane) = std::sin(pi * k / 6);
                    n(2) = std::cos(pi * k / 6);
                    add(beam.bent(plane, tip, n), momentum);
                }
            }
    }
    return y;
}

/// A fold, or a pitchfork of the spin, or one of a branch that leaves it. Images count once.
struct Mark {
    double momentum, moment;
    bool fold;
};
std::vector<Mark> marks(const ContinuousBeam& beam, const Diagram& diagram) {
    std::vector<Mark> y;
    for (const auto& graph : diagram)
        for (const auto& node : graph.nodes) {
            const Mark now{node.point.p, beam.moment(node.point.q), node.point.kind == CriticalKind::fold};
            if (std::none_of(y.begin(), y.end(), [&](const Mark& m) {
                    return std::abs(m.momentum - now.momentum) + std::abs(m.moment - now.moment) < 1e-6;
                }))
                y.push_back(now);
        }
    return y;
}

/// Pieces of all branches between critical points, by index: momentum and moment of inertia.
std::map<int, std::string> pieces(const ContinuousBeam& beam, const Diagram& diagram) {
    std::map<int, std::string> y;
    std::set<std::array<long, 5>> drawn;  // the ends of pieces: images go there side by side
    for (const auto& graph : diagram)
        for (const auto& edge : graph.branches) {
            const auto& branch = edge.branch;
            std::vector<std::pair<double, VectorXd>> piece;
            const auto close = [&] {
                if (piece.size() > 1) {
                    auto middle = piece[piece.size() / 2];
                    if (piece.size() == 2) {
                        const double p = 0.5 * (piece[0].first + piece[1].first);
                        if (const auto q = beam.solve(0.5 * (piece[0].second + piece[1].second), p)) middle = {p, *q};
                    }
                    std::array<std::pair<double, double>, 2> ends;
                    for (const std::size_t side : {0, 1}) {
                        const auto& [p, q] = side == 0 ? piece.front() : piece.back();
                        ends[side] = {p, beam.moment(q)};
                    }
                    std::sort(ends.begin(), ends.end());
                    const int negative = std::min(3, index(beam, middle.second, middle.first));
                    const auto rounded = [](double x) { return std::lround(1e5 * x); };
                    if (drawn
                            .insert({rounded(ends[0].first), rounded(ends[0].second), rounded(ends[1].first),
                                     rounded(ends[1].second), negative})
                            .second) {
                        std::ostringstream rows;
                        for (const auto& [p, q] : piece) rows << p << ' ' << beam.moment(q) << '\n';
                        y[negative] += rows.str() + "\n";
                    }
                }
                piece.clear();
            };
            if (edge.parent) {
                const auto& node = graph.nodes[*edge.parent].point;
                piece.emplace_back(node.p, node.q);
            }
            std::size_t next = 0;
            for (std::size_t k = 0; k < branch.points.size(); ++k) {
                piece.emplace_back(branch.points[k].p, branch.points[k].q);
                for (; next < branch.events.size() && branch.events[next].step == k; ++next) {
                    const auto& event = branch.events[next].point;
                    piece.emplace_back(event.p, event.q);
                    close();
                    piece.emplace_back(event.p, event.q);
                }
            }
            close();
        }
    return y;
}

/// The truncated beam's whirling branches.
template <int K>
std::string truncated_branches(BeamStrain strain) {
    using M = mechanisms::BodyBeamEitherStrain<K, BeamControl::momentum>;
    struct Problem : ModelProblem<M, M::momentum> {
        using ModelProblem<M, M::momentum>::ModelProblem;
        VectorXd parameter_derivative_along(const VectorXd& q, double, const VectorXd&) const {
            return VectorXd::Zero(q.size());
        }
    };
    const Values b = body();
    Parameters<M> p;
    std::copy(b.begin(), b.end(), p.begin());
    p[M::coupling] = strain == BeamStrain::coupled ? 1 : 0;
    p[M::second_axis] = 1;
    const Problem problem(p);
    ContinuationOptions options;
    options.range.low = low;
    options.range.high = high;
    std::ostringstream rows;
    for (const int plane : {1, 2}) {
        const double momentum = b[Names::inertia_3] * mechanisms::whirl_speeds<K>(p, plane)[0];
        const auto spin = [&](double a) {
            VectorXd q = VectorXd::Zero(M::n_coordinates);
            q(2) = q(M::omega) = a / b[Names::inertia_3];
            q(M::multiplier) = b[Names::inertia_3];
            return q;
        };
        BranchStepper<Problem> stepper(problem, options.stepping());
        const auto before = stepper.start(spin(momentum - 0.01), momentum - 0.01, 1);
        CriticalPointSolver<Problem> solver(problem);
        const auto point = solver.solve(spin(momentum), momentum);
        if (!before || !point) throw std::runtime_error("no pitchfork of the truncated beam");
        const auto sides = switch_branch(stepper, *point, before->tangent, 0.05);
        if (sides.empty()) throw std::runtime_error("no whirling branch of the truncated beam");
        rows << momentum << ' ' << b[Names::inertia_3] << '\n';
        for (const auto& at : BranchPoints(stepper, sides[0])) {
            rows << at.p << ' ' << at.q(M::multiplier) << '\n';
            if (at.p > high || at.q(M::multiplier) > 4) break;
        }
        rows << '\n';
    }
    return rows.str();
}

Figure momentum_figure(const std::vector<const ContinuousBeam*>& beams, const std::vector<const Diagram*>& diagrams) {
    GnuplotData data;
    data.value("low", low).value("high", high);
    for (std::size_t s = 0; s < 2; ++s) {
        const std::string strain = std::to_string(s);
        auto by_index = pieces(*beams[s], *diagrams[s]);
        for (int k = 0; k < 4; ++k) data.block("b" + strain + std::to_string(k), by_index[k]);
        std::ostringstream folds, pitchforks;
        for (const auto& mark : marks(*beams[s], *diagrams[s]))
            (mark.fold ? folds : pitchforks) << mark.momentum << ' ' << mark.moment << '\n';
        data.block("f" + strain, folds.str()).block("p" + strain, pitchforks.str());
        data.block("t" + strain, truncated_branches<2>(s == 0 ? BeamStrain::linear : BeamStrain::coupled));
    }
    return {"body_beam_momentum", data, plots::body_beam_momentum, {1150, 560}};
}

/// Critical points of the coupled beam over the ratio of the stiffnesses.
Figure ratio_figure(const ContinuousBeam& beam, const Diagram& diagram) {
    constexpr double least = 0.7, most = 1.7;
    // below 0.1 come the correctors' tries alone
    const auto family = [](double ratio) {
        return ContinuousBeam(body(std::max(ratio, 0.1)), BeamStrain::coupled, Scaling::both);
    };
    const double here = beam.parameters()[Names::bending_2];
    std::ostringstream folds, secondary, cusps, first;
    const auto add = [&](std::ostringstream& rows, const auto& curve) {
        if (curve.branch.end != BranchEnd::window && curve.branch.points.back().q.p < 8)
            std::fprintf(stderr, "body_beam_figures: a curve ends early (%s) at mu_2 / mu_1 = %.6f\n",
                         to_string(curve.branch.end), curve.branch.points.back().p);
        for (const auto& at : curve.branch.points) rows << at.q.p << ' ' << at.p << '\n';
        rows << '\n';
        for (const auto& special : curve.special) {
            if (special.kind == CriticalKind::cusp) {
                cusps << special.at.p << ' ' << special.r << '\n';
                std::printf("cusp at |a| = %.6f, mu_2 / mu_1 = %.6f\n", special.at.p, special.r);
            }
        }
    };
    ContinuationOptions options;
    options.range.low = least;
    options.range.high = most;
    options.branch.largest_step = 0.2;
    options.most_steps = 60;
    std::vector<double> done;
    const ContinuousBeam member = family(here);
    CriticalPointSolver<ContinuousBeam> solver(member);
    for (const auto& graph : diagram)
        for (const auto& node : graph.nodes) {
            const auto found = solver.solve(member.scaled(beam.own(node.point.q)), node.point.p);
            if (!found) throw std::runtime_error("a critical point is lost");
            const auto& point = *found;
            if (std::any_of(done.begin(), done.end(), [&](double p) { return std::abs(p - point.p) < 1e-6; })) continue;
            done.push_back(point.p);
            // what does not feel mu_2 has no derivative by it to be followed along
            auto& rows = point.kind == CriticalKind::fold               ? folds
                         : std::abs(member.axis(point.q)(2)) > 1 - 1e-9 ? first
                                                                        : secondary;
            if (member.second_share(point.q) + member.second_share(point.null_vector) < 1e-6) {
                rows << point.p << ' ' << least << '\n' << point.p << ' ' << most << "\n\n";
                continue;
            }
            for (const int direction : {-1, 1})
                if (point.kind == CriticalKind::fold)
                    add(rows, continue_folds(family, point, here, direction, options));
                else
                    add(rows, continue_bifurcations(family, point, here, direction, options));
        }
    // where both planes whirl at the same speed
    const double a1 = mechanisms::whirl_speeds<8>(body(1), 1)[0], a2 = mechanisms::whirl_speeds<8>(body(1), 2)[0];
    std::ostringstream both;
    both << a1 * beam.parameters()[Names::inertia_3] << ' ' << a1 * a1 / (a2 * a2) << '\n';
    GnuplotData data;
    data.value("least", least).value("most", most).integer("cusps", !cusps.str().empty());
    data.block("first", first.str()).block("secondary", secondary.str()).block("folds", folds.str());
    data.block("cusps", cusps.str()).block("double", both.str());
    return {"body_beam_ratio", data, plots::body_beam_ratio, {900, 560}};
}

std::string number(double x) {
    std::ostringstream y;
    y << x;
    return y.str();
}

/// What is drawn of one shape.
struct Shape {
    std::string rows, caption;
    int plane;
    bool across;  ///< the axis of rotation is normal to the plane
    Eigen::Vector2d centre, along;
};

/// In the plane in which the beam is bent; nothing of a straight beam that turns about another axis than its own.
std::optional<Shape> shape_of(const ContinuousBeam& beam, const VectorXd& q, double momentum) {
    const Vector3d tip = beam.displacement(q, 1);
    Vector3d n = beam.axis(q);
    const bool straight = tip.head<2>().norm() < 1e-6;
    if (straight && std::abs(n(2)) < 0.5) return {};
    const int plane = std::abs(tip(1)) > std::abs(tip(0)) ? 1 : 0;
    const double side = tip(plane) < 0 ? -1 : 1;
    if (n(2) < -1e-6) n *= -1;
    n(plane) *= side;
    std::ostringstream rows;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    constexpr int pieces = 80;
    for (int k = 0; k <= pieces; ++k) {
        const double z = static_cast<double>(k) / pieces;
        const Vector3d u = beam.displacement(q, z);
        const Eigen::Vector2d r(side * u(plane), z + u(2));
        rows << r(0) << ' ' << r(1) << '\n';
        sum += (k % pieces == 0 ? 0.5 : 1.0) / pieces * r;
    }
    const Eigen::Vector2d along(n(plane), n(2));
    std::ostringstream caption;
    caption.precision(3);
    caption << "{/:Italic ω} = " << beam.speed(q, momentum) << ", index " << index(beam, q, momentum);
    return Shape{rows.str(), caption.str(), plane, along.norm() < 0.5, sum / (beam.parameters()[Names::body_mass] + 1),
                 along};
}

Figure shape_figure(const std::vector<const ContinuousBeam*>& beams, const std::vector<const Diagram*>& diagrams) {
    constexpr double momenta[] = {7, 4.4};
    constexpr int columns = 5;
    GnuplotData data;
    std::vector<std::string> captions, headings;
    std::vector<double> rows, places, axes, across, centre_x, centre_y, along_x, along_y;
    for (std::size_t s = 0; s < 2; ++s) {
        headings.push_back(std::string(s == 0 ? "(a) linear" : "(b) coupled") +
                           " strain, |{/:Bold a}| = " + number(momenta[s]));
        int drawn = 0;
        for (const VectorXd& q : equilibria_at(*beams[s], *diagrams[s], momenta[s])) {
            const auto shape = drawn < columns ? shape_of(*beams[s], q, momenta[s]) : std::nullopt;
            if (!shape) continue;
            captions.push_back(shape->caption);
            data.block("shape" + std::to_string(captions.size()), shape->rows);
            rows.push_back(static_cast<double>(s));
            places.push_back(drawn++);
            axes.push_back(shape->plane + 1);
            across.push_back(shape->across);
            centre_x.push_back(shape->centre(0));
            centre_y.push_back(shape->centre(1));
            along_x.push_back(shape->along(0));
            along_y.push_back(shape->along(1));
        }
    }
    data.integer("columns", columns).integer("shapes", static_cast<long long>(captions.size()));
    data.strings("heading", headings).strings("caption", captions).values("row", rows).values("column", places);
    data.values("axis", axes).values("across", across).values("centre_x", centre_x).values("centre_y", centre_y);
    data.values("along_x", along_x).values("along_y", along_y);
    return {"body_beam_shapes", data, plots::body_beam_shapes, {1250, 560}};
}

/// From near the spin about the beam's axis, with damping.
template <BeamStrain Strain>
std::string settling_rows(double momentum, double end) {
    constexpr int K = 4;
    using Motion = mechanisms::RotatingBodyBeamMotion<K, Strain>;
    Parameters<typename Motion::Model> p;
    const Values b = body();
    std::copy(b.begin(), b.end(), p.begin());
    const Motion motion(p, {0.3, 0.3, 0.3});
    typename Motion::State start;
    start.momentum = momentum * Vector3d(0.03, 0.04, 1).normalized();
    std::vector<double> times;
    for (int k = 0; k <= 3000; ++k) times.push_back(end * k / 3000);
    MotionOptions options;
    options.relative_tolerance = 1e-9;
    options.absolute_tolerance = 1e-10;
    const auto y = motion.integrate(start, times, options);
    if (y.status != mechanisms::BodyBeamStatus::finished) throw std::runtime_error(to_string(y.status));
    const auto tip = Motion::Base::modes.bending(1).value;
    std::ostringstream rows;
    rows.precision(9);
    for (const auto& x : y.samples) {
        double u1 = 0, u2 = 0;
        for (int i = 0; i < K; ++i) {
            u1 += tip[i] * x.state.modes(i);
            u2 += tip[i] * x.state.modes(K + i);
        }
        rows << x.time << ' ' << x.wobble() * 180 / pi << ' ' << std::hypot(u1, u2) << ' ' << x.energy << ' '
             << std::acos(std::min(1.0, std::abs(x.angular_velocity.normalized()(2)))) * 180 / pi << '\n';
    }
    return rows.str();
}

Figure settling_figure() {
    constexpr double end = 80;
    GnuplotData data;
    data.value("end", end);
    data.block("linear", settling_rows<BeamStrain::linear>(7, end));
    data.block("coupled", settling_rows<BeamStrain::coupled>(7, end));
    return {"body_beam_settling", data, plots::body_beam_settling, {1000, 760}};
}

}  // namespace

int main(int argc, char** argv) {
    std::string folder = ".";
    support::CommandLine app{
        "The figures of the rotating body with a beam as PNG (needs gnuplot): relative equilibria against the angular "
        "momentum, pitchforks and folds over the ratio of the bending stiffnesses, shapes, and motions that settle."};
    app.add_option("--out", folder, "the folder to write them to (default: this one)").transform(support::a_folder());
    app.parse("body_beam_figures", argc, argv);
    try {
        const ContinuousBeam linear(body(), BeamStrain::linear), coupled(body(), BeamStrain::coupled);
        const Diagram of_linear = diagram_of(linear), of_coupled = diagram_of(coupled);
        const Figure figures[] = {momentum_figure({&linear, &coupled}, {&of_linear, &of_coupled}),
                                  ratio_figure(coupled, of_coupled),
                                  shape_figure({&linear, &coupled}, {&of_linear, &of_coupled}), settling_figure()};
        for (const auto& figure : figures) {
            support::Pictures pictures;
            pictures.png.emplace("--out", folder + "/" + figure.name + ".png");
            pictures.draw(figure.size, figure.data, figure.script);
            std::printf("%s/%s.png\n", folder.c_str(), figure.name.c_str());
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "body_beam_figures: %s\n", error.what());
        return 1;
    }
}

// clang-format off
/* Refused:
--out missing/folder
    body_beam_figures: --out missing/folder: must be a folder
*/
