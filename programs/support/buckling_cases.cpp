#include "support/buckling_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <equilibria/fem/joints.hpp>
#include <equilibria/fem/loads.hpp>
#include <equilibria/fem/mesh.hpp>
#include <equilibria/fem/rigid_link.hpp>
#include <equilibria/fem/springs.hpp>
#include <equilibria/fem/truss.hpp>
#include <initializer_list>
#include <numbers>
#include <utility>

namespace support {

using namespace equilibria::fem;
using Eigen::Vector3d;

namespace {

const double pi = std::numbers::pi;

/// The tip's rotation in the plane, radians.
double planar_angle(const StructureState& q, int node) {
    const auto& turned = q.frames[static_cast<std::size_t>(node)].q;
    return 2 * std::atan2(turned.z(), turned.w());
}

/// The elements of a member that makes a share of the structure's length.
int elements_of(const CaseData& data, double share) {
    return std::max(1, static_cast<int>(std::lround(share * data.elements)));
}

/// A case's own cross-section, changed by the data.
PlanarSection section_of(const CaseData& data, PlanarSection own = {rigid, rigid, 1}) {
    own.ea = data.ea.value_or(own.ea);
    own.ga = data.ga.value_or(own.ga);
    own.ei = data.ei2.value_or(own.ei);
    return own;
}
Section section_of(const CaseData& data, Section own) {
    own.ea = data.ea.value_or(own.ea);
    own.ga2 = own.ga3 = data.ga.value_or(own.ga2);
    own.gj = data.gj.value_or(own.gj);
    own.ei2 = data.ei2.value_or(own.ei2);
    own.ei3 = data.ei3.value_or(own.ei3);
    return own;
}
/// Of Argyris' frames: 30 x 0.6, E = 71240, Poisson's ratio 0.31.
Section argyris_section(const CaseData& data) {
    const double e = 71240, g = e / (2 * 1.31);
    return section_of(data, Section{18 * e, 18 * g, 18 * g, 2.16 * g, .54 * e, 1350 * e});
}

/// What a case is followed by.
struct Load {
    const char* name;  ///< of the parameter, with its unit
    equilibria::Interval range;
    double first_step;
};

/// A straight planar beam that makes a share of the structure's length; all nodes.
std::vector<int> planar_beam(Model& model, const PlanarSection& section, int first, int last, const CaseData& data,
                             double share = 1) {
    return with_beam_nodes(data.nodes, [&](auto n) {
        return add_straight_planar_beam<n>(model, section, first, last, elements_of(data, share));
    });
}
/// The same in space.
std::vector<int> beam(Model& model, const Section& section, std::array<int, 2> ends, const Vector3d& second,
                      const CaseData& data, double share = 1) {
    return with_beam_nodes(data.nodes, [&](auto n) {
        return add_straight_beam<n>(model, section, ends[0], ends[1], second, elements_of(data, share));
    });
}
/// Around the origin, angles in radians.
struct ArcLine {
    double radius, from, to;
};
/// A planar arc.
std::vector<int> arc(Model& model, const PlanarSection& section, const ArcLine& line, const CaseData& data,
                     int elements) {
    const double r = line.radius, from = line.from, to = line.to;
    const auto frame = [=](double t) {
        const double angle = from + (to - from) * t;
        return PlanarSectionFrame{{r * std::cos(angle), r * std::sin(angle), 0}, angle + (to > from ? pi : -pi) / 2};
    };
    return with_beam_nodes(data.nodes, [&](auto n) { return add_planar_beam<n>(model, section, frame, elements); });
}

CasePoint at_coordinate(int node, int c, double x) {
    return {std::string("xyz").substr(static_cast<std::size_t>(c), 1) + " of the tip = " + equilibria::to_text(x),
            [=](const StructureState& q, double) { return q.frames[static_cast<std::size_t>(node)].x(c) - x; }};
}
CasePoint at_parameter(double at) {
    return {"at " + equilibria::to_text(at), [=](const StructureState&, double p) { return p - at; }};
}

BucklingCase make(Model model, const CaseData& data, int tip, const Load& load) {
    BucklingCase y{.structure = Structure(std::move(model),
                                          {.executor = equilibria::threads(data.threads), .symmetric_images = true}),
                   .tip = tip,
                   .parameter = load.name,
                   .options = {.range = load.range, .most_steps = 2000}};
    y.options.branch.first_step = load.first_step;
    y.options.branch.largest_step = 0.1;
    return y;
}

/// A circular arch with a load on its crown, its ends held by these components.
struct Arch {
    double radius, degrees, ei;
    std::initializer_list<Component> left, right;
};
BucklingCase crown_loaded_arch(const CaseData& data, const Arch& arch, const Load& load) {
    const double half = data.angle.value_or(arch.degrees) * pi / 360;
    Model model;
    const auto nodes = arc(model, section_of(data, PlanarSection{rigid, rigid, arch.ei}),
                           {arch.radius, pi / 2 + half, pi / 2 - half}, data, 2 * ((data.elements + 1) / 2));
    const int crown = nodes[nodes.size() / 2];
    model.fix(nodes.front(), arch.left);
    model.fix(nodes.back(), arch.right);
    model.load(crown, {0, -1, 0});
    return make(std::move(model), data, crown, load);
}

/// The energy of a shallow arch of two modes, A1 and A2 being the coordinates of a node: an element of its own.
struct TwoModeArch {
    static constexpr int n_nodes = 1;
    static constexpr auto components = planar_positions;
    double l;
    template <class T>
    T energy(const std::array<Frame<T>, 1>& at, const T& q) const {
        const T a1 = at[0].x(0), a2 = at[0].x(1), bend = a1 - T(l), stretch = a1 * a1 + 4 * a2 * a2 - T(l * l);
        return 0.5 * bend * bend + 8 * a2 * a2 + 0.25 * stretch * stretch + q * a1;
    }
};

}  // namespace

BucklingCase euler_column(const CaseData& data) {
    Model model;
    const int a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0});
    const auto nodes = planar_beam(model, section_of(data), a, b, data);
    model.load(b, {-1, 0, 0});
    const bool cantilever = data.ends == "cantilever", clamped = data.ends == "clamped";
    model.fix(a, {ux, uy});
    if (data.ends != "hinged") model.fix(a, {rz});
    if (!cantilever) model.fix(b, {uy});
    if (clamped) model.fix(b, {rz});
    const int watched = cantilever ? b : nodes[nodes.size() / 2];
    // the first three critical loads of the chosen ends
    const double most = cantilever ? 25 : clamped ? 90 : 45;
    BucklingCase y = make(std::move(model), data, watched, {"P L^2 / EI", {-1, most}, 0.05});
    y.options.branch.parameter_weight = 0.1;
    if (cantilever)
        for (const double degrees : {20, 60, 120})
            y.points.push_back(
                {"angle of the tip = " + equilibria::to_text(degrees) + " degrees",
                 [=](const StructureState& q, double) { return std::abs(planar_angle(q, b)) - degrees * pi / 180; }});
    return y;
}

BucklingCase roll_up(const CaseData& data) {
    Model model;
    const int a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0});
    const PlanarSection section = section_of(data);
    planar_beam(model, section, a, b, data);
    model.fix(a, planar);
    model.load(b, {0, 0, 0}, {0, 0, 2 * pi * section.ei});
    BucklingCase y = make(std::move(model), data, b, {"M L / (2 pi EI)", {-0.01, 4.2}, 0.02});
    for (const int n : {1, 2, 3, 4}) y.points.push_back(at_parameter(n));
    return y;
}

BucklingCase lateral_cantilever(const CaseData& data) {
    Model model;
    const int a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0});
    beam(model, section_of(data, Section{rigid, rigid, rigid, 1.343, 1, 25}), {a, b}, Vector3d::UnitY(), data);
    model.fix(a, spatial);
    model.load(b, {0, -1, 0});
    BucklingCase y = make(std::move(model), data, b, {"P L^2 (EI2 = 1)", {-0.1, 7}, 0.02});
    for (const double z : {.1, .2, .4}) y.points.push_back(at_coordinate(b, 2, z));
    return y;
}

BucklingCase lateral_strip(const CaseData& data) {
    Model model;
    const int a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0}), fork_a = model.add_node({0, 0, 0}),
              fork_b = model.add_node({1, 0, 0});
    const Section section = section_of(data, Section{rigid, rigid, rigid, 1.343, 1, 25});
    const auto nodes = beam(model, section, {a, b}, Vector3d::UnitY(), data);
    model.fix(fork_a, {ux, uy, uz, rx, ry});
    model.fix(fork_b, {uy, uz, rx, ry});
    model.add(RevoluteJoint(Vector3d::UnitY()), {fork_a, a});
    model.add(RevoluteJoint(Vector3d::UnitY()), {fork_b, b});
    model.load(fork_a, {0, 0, 0}, {0, 0, -1});
    model.load(fork_b, {0, 0, 0}, {0, 0, 1});
    return make(std::move(model), data, nodes[nodes.size() / 2], {"M L (EI2 = 1)", {-0.1, 8}, 0.02});
}

BucklingCase right_angle_frame(const CaseData& data) {
    const Section section = argyris_section(data);
    Model model;
    const int a = model.add_node({0, 0, 0}), b = model.add_node({240, 0, 0}), c = model.add_node({240, -240, 0});
    beam(model, section, {a, b}, Vector3d::UnitY(), data, 0.5);
    beam(model, section, {b, c}, Vector3d::UnitX(), data, 0.5);
    model.fix(a, spatial);
    const double sign = data.load_direction[0] == '-' ? -1 : 1;
    model.load(c, data.load_direction[1] == 'x' ? Vector3d(sign, 0, 0) : Vector3d(0, sign, 0));
    BucklingCase y = make(std::move(model), data, c, {"P", {-0.05, 2}, 0.005});
    for (const double z : {10, 20, 40, 60}) y.points.push_back(at_coordinate(c, 2, z));
    return y;
}

BucklingCase hinged_frame(const CaseData& data) {
    const Section section = argyris_section(data);
    const double h = 240 / std::sqrt(2.0);
    Model model;
    const int a = model.add_node({-h, 0, 0}), b = model.add_node({0, h, 0}), c = model.add_node({h, 0, 0});
    beam(model, section, {a, b}, Vector3d(-1, 1, 0), data, 0.5);
    beam(model, section, {b, c}, Vector3d(1, 1, 0), data, 0.5);
    model.fix(a, {ux, uy, uz, rx, ry});
    model.fix(c, {uy, uz, rx, ry});
    model.load(a, {0, 0, 0}, {0, 0, 1});
    model.load(c, {0, 0, 0}, {0, 0, -1});
    BucklingCase y = make(std::move(model), data, b, {"M", {-700, 700}, 0.002});
    y.both_ways = true;
    return y;
}

BucklingCase deep_arch(const CaseData& data) {
    return crown_loaded_arch(data, {100, 215, 1e6, {ux, uy, rz}, {ux, uy}}, {"P", {-200, 2000}, 0.01});
}

BucklingCase hinged_arch(const CaseData& data) {
    return crown_loaded_arch(data, {1, 180, 1, {ux, uy}, {ux, uy}}, {"P R^2 / EI", {-2, 20}, 0.01});
}

BucklingCase lee_frame(const CaseData& data) {
    const PlanarSection section = section_of(data, PlanarSection{720 * 6, rigid, 720 * 2});
    Model model;
    const int foot = model.add_node({0, 0, 0}), corner = model.add_node({0, 120, 0}),
              loaded = model.add_node({24, 120, 0}), end = model.add_node({120, 120, 0});
    planar_beam(model, section, foot, corner, data, 0.5);
    planar_beam(model, section, corner, loaded, data, 0.1);
    planar_beam(model, section, loaded, end, data, 0.4);
    model.fix(foot, {ux, uy});
    model.fix(end, {ux, uy});
    model.load(loaded, {0, -1, 0});
    return make(std::move(model), data, loaded, {"P", {-1.5, 5}, 0.01});
}

BucklingCase williams_toggle(const CaseData& data) {
    const PlanarSection section = section_of(data, PlanarSection{1.885e6, rigid, 9.27e3});
    Model model;
    const int a = model.add_node({-12.943, 0, 0}), apex = model.add_node({0, data.rise.value_or(.386), 0}),
              b = model.add_node({12.943, 0, 0});
    planar_beam(model, section, a, apex, data, 0.5);
    planar_beam(model, section, apex, b, data, 0.5);
    model.fix(a, planar);
    model.fix(b, planar);
    model.load(apex, {0, -1, 0});
    BucklingCase y = make(std::move(model), data, apex, {"P", {-5, 80}, 0.001});
    y.options.branch.largest_step = 0.01;
    return y;
}

BucklingCase von_mises_truss(const CaseData& data) {
    Model model;
    const double ea = data.ea.value_or(1);
    const int a = model.add_node({-1, 0, 0}), apex = model.add_node({0, data.rise.value_or(2), 0}),
              b = model.add_node({1, 0, 0});
    model.add(Truss<2>(ea, model.at(a), model.at(apex)), {a, apex});
    model.add(Truss<2>(ea, model.at(apex), model.at(b)), {apex, b});
    model.fix(a, planar_positions);
    model.fix(b, planar_positions);
    model.load(apex, {0, -ea, 0});
    return make(std::move(model), data, apex, {"P / EA", {-1, 1}, 0.01});
}

BucklingCase star_dome(const CaseData& data) {
    Model model;
    const double ea = data.ea.value_or(1);
    const int apex = model.add_node({0, 0, 8.216});
    const auto ring = [&](double radius, double z, double turn) {
        for (int k = 0; k < 6; ++k)
            model.add_node({radius * std::cos(k * pi / 3 + turn), radius * std::sin(k * pi / 3 + turn), z});
    };
    ring(25, 6.216, 0);
    ring(50, 0, pi / 6);
    const auto bar = [&](int a, int b) { model.add(Truss<3>(ea, model.at(a), model.at(b)), {a, b}); };
    for (int k = 0; k < 6; ++k) {
        bar(apex, 1 + k);
        bar(1 + k, 1 + (k + 1) % 6);
        bar(1 + k, 7 + k);
        bar(1 + k, 7 + (k + 5) % 6);
        model.fix(7 + k, positions);
    }
    const bool all = data.load != "apex";
    model.load(apex, {0, 0, all ? -0.5 * ea : -ea});
    for (int k = 1; all && k < 7; ++k) model.load(k, {0, 0, -ea});
    BucklingCase y = make(std::move(model), data, apex, {"P / EA", {-1e-3, all ? 2e-3 : 1e-3}, 0.001});
    y.options.branch.largest_step = 0.005;
    y.amplitude = 0.003;
    return y;
}

BucklingCase pressed_ring(const CaseData& data) {
    Model model;
    const auto nodes = arc(model, section_of(data), {1, 0, pi / 2}, data, data.elements);
    model.fix(nodes.front(), {uy, rz});
    model.fix(nodes.back(), {ux, rz});
    const int each = data.nodes - 1;
    for (int e = 0; e < data.elements; ++e) {
        const auto node = [&](int k) { return nodes[static_cast<std::size_t>(e * each + k)]; };
        if (data.load == "fixed" || data.load == "central") {
            // Newton-Cotes weights: trapezoidal, Simpson's and 3/8 rule
            const double length = pi / 2 / data.elements;
            static const double weights[3][4] = {
                {1 / 2., 1 / 2.}, {1 / 6., 4 / 6., 1 / 6.}, {1 / 8., 3 / 8., 3 / 8., 1 / 8.}};
            for (int k = 0; k <= each; ++k) {
                const double force = length * weights[each - 1][k];
                if (data.load == "fixed")
                    model.load(node(k), -force * model.at(node(k)));
                else
                    model.add(CentralLoad<2>{force, {0, 0, 0}}, {node(k)});
            }
        } else {
            with_beam_nodes(data.nodes, [&](auto n) {
                std::array<int, static_cast<std::size_t>(n())> own;
                std::copy_n(nodes.begin() + e * each, n(), own.begin());
                model.add(PlanarPressure<n>{1}, own);
            });
        }
    }
    BucklingCase y = make(std::move(model), data, nodes.front(), {"q R^3 / EI", {-0.5, 10}, 0.05});
    y.options.branch.parameter_weight = 0.2;
    return y;
}

BucklingCase twisted_rod(const CaseData& data) {
    Model model;
    const int a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0});
    const double ei = data.ei2.value_or(1);
    const Section section = section_of(data, Section{rigid, rigid, rigid, 1, ei, ei});
    const auto nodes = beam(model, section, {a, b}, Vector3d::UnitY(), data);
    model.fix(a, spatial);
    model.fix(b, {uy, uz});
    model.add(PrescribedRotation(Vector3d::UnitX()), {b});
    if (data.tension) model.load(b, {*data.tension, 0, 0}, {0, 0, 0}, LoadKind::constant);
    BucklingCase y =
        make(std::move(model), data, nodes[nodes.size() / 2], {"M L / EI2", {-0.2, 20 / section.gj}, 0.05});
    // the last element added is the drive: its moment about x
    const double k = y.structure.scale().multiplier;
    const int drive = y.structure.multipliers() - 3;
    y.value = [=](const StructureState& q, double) { return -k * q.multipliers(drive) / ei; };
    y.options.branch.largest_step = 0.2;
    return y;
}

BucklingCase bend(const CaseData& data) {
    const double ei = 1e7 / 12, r = 100;
    const Section section = section_of(data, Section{1e7, 5e6, 5e6, ei, ei, ei});
    const auto frame = [&](double t) {
        const double angle = t * pi / 4, c = std::cos(angle), s = std::sin(angle);
        return section_frame({r * s, r * (1 - c), 0}, {c, s, 0}, Vector3d::UnitZ());
    };
    Model model;
    const auto nodes =
        with_beam_nodes(data.nodes, [&](auto n) { return add_beam<n>(model, section, frame, data.elements); });
    model.fix(nodes.front(), spatial);
    model.load(nodes.back(), {0, 0, 1});
    BucklingCase y = make(std::move(model), data, nodes.back(), {"P", {-1, 620}, 0.1});
    y.options.branch.largest_step = 0.4;
    for (const double p : {300, 450, 600}) y.points.push_back(at_parameter(p));
    return y;
}

BucklingCase rigid_link_chain(const CaseData& data) {
    Model model;
    const int ground = model.add_node({0, 0, 0});
    model.fix(ground, planar);
    int before = ground, joint = model.add_node({0, 0, 0});
    model.fix(joint, {ux, uy});
    for (int k = 0; k < data.links; ++k) {
        model.add(PlanarRotationSpring{1}, {before, joint});
        const int next = model.add_node({0, k + 1.0, 0});
        model.add(RigidLink<2>{{0, 1, 0}}, {joint, next});
        before = joint;
        joint = next;
    }
    model.share_rotation(joint, before);
    model.load(joint, {0, -1, 0});
    BucklingCase y = make(std::move(model), data, joint, {"P l / c", {-0.5, 4.5}, 0.05});
    y.options.branch.parameter_weight = 1;
    return y;
}

BucklingCase shallow_arch(const CaseData& data) {
    const double l = data.rise.value_or(2.5);
    Model model;
    const int node = model.add_node({l, 0, 0});
    model.add(TwoModeArch{l}, {node});
    const double fold = l + (l > 1 ? 2 * std::pow(l * l - 1, 1.5) / (3 * std::sqrt(3.0)) : 0);
    return make(std::move(model), data, node, {"q", {2 * l - fold - 3, fold + 3}, 0.02});
}

const std::vector<CaseEntry>& buckling_cases() {
    static const std::vector<CaseEntry> cases{
        {1, "euler_column", euler_column, {"--ei2", "--ea", "--ga", "--ends"}},
        {2, "roll_up", roll_up, {"--ei2", "--ea", "--ga"}},
        {3, "lateral_cantilever", lateral_cantilever, {"--ei2", "--ei3", "--gj", "--ea", "--ga"}},
        {4, "lateral_strip", lateral_strip, {"--ei2", "--ei3", "--gj", "--ea", "--ga"}},
        {5, "right_angle_frame", right_angle_frame, {"--ei2", "--ei3", "--gj", "--ea", "--ga", "--load-direction"}},
        {6, "hinged_frame", hinged_frame, {"--ei2", "--ei3", "--gj", "--ea", "--ga"}},
        {7, "deep_arch", deep_arch, {"--ei2", "--ea", "--ga", "--angle"}},
        {8, "hinged_arch", hinged_arch, {"--ei2", "--ea", "--ga", "--angle"}},
        {10, "lee_frame", lee_frame, {"--ei2", "--ea", "--ga"}},
        {11, "williams_toggle", williams_toggle, {"--ei2", "--ea", "--ga", "--rise"}},
        {12, "von_mises_truss", von_mises_truss, {"--ea", "--rise"}},
        {13, "star_dome", star_dome, {"--ea", "--load"}},
        {14, "ring", pressed_ring, {"--ei2", "--ea", "--ga", "--load"}},
        {15, "twisted_rod", twisted_rod, {"--ei2", "--ei3", "--gj", "--ea", "--ga", "--tension"}},
        {18, "bend", bend, {"--ei2", "--ei3", "--gj", "--ea", "--ga"}},
        {19, "rigid_link_chain", rigid_link_chain, {"--links"}},
        {20, "shallow_arch", shallow_arch, {"--rise"}},
    };
    return cases;
}

}  // namespace support
