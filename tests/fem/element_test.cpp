// Laws of every element, in random states with rotations up to 3 radians: K = dR/dq, symmetry, no strain in rigid
// motions.
#include <equilibria/fem/beam.hpp>
#include <equilibria/fem/joints.hpp>
#include <equilibria/fem/loads.hpp>
#include <equilibria/fem/rigid_link.hpp>
#include <equilibria/fem/springs.hpp>
#include <equilibria/fem/truss.hpp>

#include "fem/charted_structure.hpp"
#include "fem/random_states.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using namespace equilibria::fem;
using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

const Section section{40, 30, 20, 3, 2, 5};
const ShearCentre beside{.place = {0.3, -0.2}, .polar_radius = 0.6, .wagner = {0.4, -0.3}};
const Section channel{40, 30, 20, 3, 2, 5, beside};
const PlanarSection planar_section{40, 30, 2};

/// Nodes along a helix, with frames along it, twisted.
template <int Nodes>
std::array<SectionFrame, static_cast<std::size_t>(Nodes)> helix() {
    std::array<SectionFrame, static_cast<std::size_t>(Nodes)> at;
    for (int k = 0; k < Nodes; ++k) {
        const double t = 0.4 * k;
        at[static_cast<std::size_t>(k)] =
            section_frame({std::cos(t), std::sin(t), 0.3 * t}, {-std::sin(t), std::cos(t), 0.3}, {0.2 * t, 0.1, 1});
    }
    return at;
}
template <int Nodes>
std::array<PlanarSectionFrame, static_cast<std::size_t>(Nodes)> arc() {
    std::array<PlanarSectionFrame, static_cast<std::size_t>(Nodes)> at;
    for (int k = 0; k < Nodes; ++k)
        at[static_cast<std::size_t>(k)] = {{std::sin(0.4 * k), 1 - std::cos(0.4 * k), 0}, 0.4 * k};
    return at;
}
template <class Initial>
std::vector<Vector3d> places(const Initial& at) {
    std::vector<Vector3d> y;
    for (const auto& a : at) y.push_back(a.x);
    return y;
}

/// A structure of one element, between the first of the nodes.
template <class E>
NonconservativeStructure structure_of(E element, const std::vector<Vector3d>& x) {
    Model model;
    std::array<int, static_cast<std::size_t>(E::n_nodes)> nodes;
    for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] = model.add_node(x[k]);
    model.add(std::move(element), nodes);
    return NonconservativeStructure(std::move(model), {.scale = {3, 5}});
}
bool is_planar(const NonconservativeStructure& structure) {
    return structure.unknown(0, uz) < 0 && structure.unknown(0, rx) < 0;
}
template <int Nodes>
auto as_array(const std::vector<Frame<double>>& frames) {
    std::array<Frame<double>, static_cast<std::size_t>(Nodes)> y;
    std::copy_n(frames.begin(), Nodes, y.begin());
    return y;
}

void check_random_states(const char* name, const NonconservativeStructure& structure, bool symmetric, double apart) {
    std::mt19937 draw(17);
    const auto x = places(structure.initial().frames);
    for (int k = 0; k < 20; ++k) {
        INFO(name << ", state " << k);
        const StructureState at{states::random_frames(draw, x, is_planar(structure), 0.1, apart),
                                states::random_vector(draw, structure.multipliers(), 1)};
        const VectorXd v = states::random_vector(draw, structure.size(), 1);
        const auto errors = states::derivative_errors(structure, at, 0.7, v, 2e-3);
        CHECK(errors.tangent < 1e-9);
        CHECK(errors.parameter < 1e-9);
        if (symmetric) CHECK(errors.symmetry < 1e-14);
    }
}
template <class E>
void check(const char* name, const E& element, const std::vector<Vector3d>& x, double apart = 0.5) {
    check_random_states(name, structure_of(element, x), is_conservative<E>, apart);
}

template <class E>
void check_rigid_motion(const char* name, const E& element, const std::vector<Vector3d>& x) {
    std::mt19937 draw(19);
    const auto structure = structure_of(element, x);
    for (int k = 0; k < 20; ++k) {
        INFO(name);
        StructureState at = structure.initial();
        Vector3d psi = states::random_rotation(draw), shift = states::random_vector(draw, 10);
        if (is_planar(structure)) psi(0) = psi(1) = shift(2) = 0;
        const auto q = quaternion<double>(psi);
        for (auto& frame : at.frames) frame = {shift + q * frame.x, q};
        CHECK(structure.residual(at, 0).norm() < 1e-12 * (1 + structure.tangent(at, 0).norm()));
        const auto frames = as_array<E::n_nodes>(at.frames);
        if constexpr (requires { element.geometry(); })
            for (int g = 0; g < E::gauss_points; ++g) CHECK(element.strain(frames, g).norm() < 1e-13);
        if constexpr (requires { element.energy(frames); }) CHECK(element.energy(frames) < 1e-24);
    }
}

/// The rigid link by its constraints alone.
template <int Dimension>
struct PlainLink {
    static constexpr int n_nodes = 2, n_constraints = Dimension;
    static constexpr auto components = RigidLink<Dimension>::components;
    RigidLink<Dimension> link;

    template <class T>
    Eigen::Matrix<T, Dimension, 1> constraints(const std::array<Frame<T>, 2>& at, const T& p) const {
        return link.constraints(at, p);
    }
};
template <int Dimension>
void check_link(const Vector3d& offset) {
    std::mt19937 draw(23);
    const RigidLink<Dimension> link{offset};
    const auto closed = structure_of(link, {{0, 0, 0}, offset}),
               plain = structure_of(PlainLink<Dimension>{link}, {{0, 0, 0}, offset});
    for (int k = 0; k < 20; ++k) {
        const StructureState at{states::random_frames(draw, places(closed.initial().frames), Dimension == 2, 0.1, 3),
                                states::random_vector(draw, closed.multipliers(), 1)};
        CHECK((closed.residual(at, 0) - plain.residual(at, 0)).norm() < 1e-13 * (1 + plain.residual(at, 0).norm()));
        const Eigen::MatrixXd tangent = plain.tangent(at, 0);
        CHECK((Eigen::MatrixXd(closed.tangent(at, 0)) - tangent).norm() < 1e-13 * (1 + tangent.norm()));
    }
}

/// The beam's energy once more, from its definition: quaternions of any scalar.
template <int Nodes>
struct PlainBeam {
    static constexpr int n_nodes = Nodes;
    static constexpr auto components = spatial;
    std::array<SectionFrame, static_cast<std::size_t>(Nodes)> initial;
    Section of = section;

    template <class T>
    std::array<Eigen::Matrix<T, 6, 1>, static_cast<std::size_t>(Nodes - 1)> strains(
        const std::array<Frame<T>, static_cast<std::size_t>(Nodes)>& at, std::vector<double>& weights) const {
        std::array<Eigen::Matrix<T, 6, 1>, static_cast<std::size_t>(Nodes - 1)> y;
        weights.clear();
        for (std::size_t g = 0; g < y.size(); ++g) {
            const ShapeFunctions<Nodes> n(gauss_rule<Nodes - 1>().point[g]);
            Vector3d slope = Vector3d::Zero();
            for (std::size_t k = 0; k < at.size(); ++k) slope += n.slope[k] * initial[k].x;
            const double j = slope.norm();
            weights.push_back(j * gauss_rule<Nodes - 1>().weight[g]);
            Eigen::Matrix<T, 4, 1> q, dq;
            Vector3<T> dx;
            for (int c = 0; c < 4; ++c) q(c) = dq(c) = T(0.0);
            for (int c = 0; c < 3; ++c) dx(c) = T(0.0);
            for (std::size_t k = 0; k < at.size(); ++k) {
                const auto& c = initial[k].orientation;
                const Eigen::Quaternion<T> p = at[k].q * Eigen::Quaternion<T>(T(c.w()), T(c.x()), T(c.y()), T(c.z()));
                q += n.value[k] * p.coeffs();
                dq += n.slope[k] / j * p.coeffs();
                dx += n.slope[k] / j * at[k].x;
            }
            using std::sqrt;
            const Eigen::Quaternion<T> whole(q), slope_q(dq);
            const T s = q.dot(q);
            y[g] << Vector3<T>((whole.conjugate() * Eigen::Quaternion<T>(T(0.0), dx(0), dx(1), dx(2)) * whole).vec() /
                               s),
                Vector3<T>(T(2.0) * (whole.conjugate() * slope_q).vec() / s);
        }
        return y;
    }
    template <class T>
    T energy(const std::array<Frame<T>, static_cast<std::size_t>(Nodes)>& at, const T&) const {
        std::array<Frame<double>, static_cast<std::size_t>(Nodes)> without;
        for (std::size_t k = 0; k < without.size(); ++k) without[k].x = initial[k].x;
        std::vector<double> weights;
        const auto before = strains(without, weights);
        const auto now = strains(at, weights);
        T y(0.0);
        const auto c = of.stiffness();
        const auto& [s, r, w] = of.shear_centre;
        for (std::size_t g = 0; g < now.size(); ++g) {
            const T a = now[g](3) - T(before[g](3));
            const std::array<T, 6> twist{0.5 * r * r * a * a, -s[1] * a,         s[0] * a, T(0.0),
                                         0.5 * w[0] * a * a,  0.5 * w[1] * a * a};
            for (int k = 0; k < 6; ++k) {
                const T e = now[g](k) - T(before[g](k)) + twist[static_cast<std::size_t>(k)];
                y = y + 0.5 * weights[g] * c(k) * e * e;
            }
        }
        return y;
    }
};

}  // namespace

TEST_CASE("K is the derivative of the residual and symmetric: beams") {
    check("beam of 2 nodes", Beam<2>(section, helix<2>()), places(helix<2>()));
    check("beam of 3 nodes", Beam<3>(section, helix<3>()), places(helix<3>()));
    check("beam of 4 nodes", Beam<4>(section, helix<4>()), places(helix<4>()));
    check("beam of 3 nodes with a shear centre", Beam<3>(channel, helix<3>()), places(helix<3>()));
    check("mixed beam with a shear centre", MixedBeam<3>({rigid, rigid, 3, 3, 2, 5, beside}, helix<3>()),
          places(helix<3>()));
    check("mixed beam of 2 nodes", MixedBeam<2>({rigid, rigid, 3, 3, 2, 5}, helix<2>()), places(helix<2>()));
    check("mixed beam of 3 nodes", MixedBeam<3>({rigid, rigid, 3, rigid, 2, 5}, helix<3>()), places(helix<3>()));
    check("planar beam of 2 nodes", PlanarBeam<2>(planar_section, arc<2>()), places(arc<2>()));
    check("planar beam of 3 nodes", PlanarBeam<3>(planar_section, arc<3>()), places(arc<3>()));
    check("planar mixed beam of 3 nodes", PlanarMixedBeam<3>({rigid, 3, 2}, arc<3>()), places(arc<3>()));
}

TEST_CASE("K is the derivative of the residual and symmetric: trusses and springs") {
    const std::vector<Vector3d> x{{0, 0, 0}, {1, 0.5, 0.2}}, flat{{0, 0, 0}, {1, 0.5, 0}};
    check("truss", Truss<3>(3, 1.3), x);
    check("truss, engineering strain", Truss<3>(3, 1.3, Strain::engineering), x);
    check("planar truss", Truss<2>(3, 1.3, Strain::engineering), flat);
    check("rotation spring", RotationSpring{2}, x, 2.5);
    check("planar rotation spring", PlanarRotationSpring{2}, flat, 2.5);
    check("point spring", PointSpring<3>{{1, 2, 3}, {0, 1, 0}}, x);
}

TEST_CASE("K is the derivative of the residual and symmetric: rigid bodies and joints") {
    const std::vector<Vector3d> x{{0, 0, 0}, {1, 0.5, 0.2}}, flat{{0, 0, 0}, {1, 0.5, 0}};
    check("rigid link", RigidLink<3>{{1, 0.5, 0.2}}, x);
    check("planar rigid link", RigidLink<2>{{1, 0.5, 0}}, flat);
    check("planar hinge", PlanarHinge{{0.5, 0, 0}, {-0.5, -0.5, 0}}, flat);
    check("spherical joint", SphericalJoint{{0.5, 0, 0}, {-0.5, -0.5, -0.2}}, x);
    check("revolute joint", RevoluteJoint({0, 1, 2}, {0.5, 0, 0}, {-0.5, -0.5, -0.2}), x);
    check("prismatic joint", PrismaticJoint({0, 1, 2}, {1, 0.5, 0.2}), x);
    check("prescribed displacement", PrescribedDisplacement{{0, 0.6, 0.8}, {0, 0, 0}, 2, 0.1}, x);
    check("prescribed rotation", PrescribedRotation({0, 1, 2}, 3), x);
    check("planar rotation drive", PlanarRotationDrive(3, 0.2), flat);
    check("rotation drive", RotationDrive({0, 1, 2}, 3, 0.2), x);
}

TEST_CASE("The rigid link in closed form is the one of its constraints") {
    check_link<3>({1, 0.5, 0.2});
    check_link<2>({1, 0.5, 0});
}

TEST_CASE("K is the derivative of the residual: loads") {
    const std::vector<Vector3d> x{{0, 0, 0}, {1, 0.5, 0}, {2, 0.7, 0}};
    check("follower load", FollowerLoad{{1, 2, 3}, {4, 5, 6}}, x);
    check("central load", CentralLoad<3>{2, {0, 3, 4}}, x);
    check("pressure on 2 nodes", PlanarPressure<2>{2}, x);
    check("pressure on 3 nodes", PlanarPressure<3>{2}, x);
}

TEST_CASE("Rigid motions give no strain, no force and no energy") {
    check_rigid_motion("beam of 2 nodes", Beam<2>(section, helix<2>()), places(helix<2>()));
    check_rigid_motion("beam of 3 nodes", Beam<3>(section, helix<3>()), places(helix<3>()));
    check_rigid_motion("beam of 4 nodes", Beam<4>(section, helix<4>()), places(helix<4>()));
    check_rigid_motion("beam with a shear centre", Beam<3>(channel, helix<3>()), places(helix<3>()));
    check_rigid_motion("mixed beam", MixedBeam<3>({rigid, rigid, 3, 3, 2, 5}, helix<3>()), places(helix<3>()));
    check_rigid_motion("planar beam", PlanarBeam<3>(planar_section, arc<3>()), places(arc<3>()));
    check_rigid_motion("truss", Truss<3>(3, {0, 0, 0}, {1, 0.5, 0.2}), {{0, 0, 0}, {1, 0.5, 0.2}});
    check_rigid_motion("rigid link", RigidLink<3>{{1, 0.5, 0.2}}, {{0, 0, 0}, {1, 0.5, 0.2}});
    check_rigid_motion("spherical joint", SphericalJoint{{1, 0.5, 0.2}, {0, 0, 0}}, {{0, 0, 0}, {1, 0.5, 0.2}});
    check_rigid_motion("revolute joint", RevoluteJoint({0, 1, 2}, {1, 0.5, 0.2}), {{0, 0, 0}, {1, 0.5, 0.2}});
    check_rigid_motion("prismatic joint", PrismaticJoint({0, 1, 2}, {1, 0.5, 0.2}), {{0, 0, 0}, {1, 0.5, 0.2}});
}

TEST_CASE("Beams derived by hand agree with dual numbers on their definition") {
    std::mt19937 draw(23);
    const auto compare = [&]<int Nodes>(std::integral_constant<int, Nodes>, const Section& of) {
        const Beam<Nodes> beam(of, helix<Nodes>());
        const PlainBeam<Nodes> plain{helix<Nodes>(), of};
        const auto x = places(helix<Nodes>());
        const auto a = structure_of(beam, x), b = structure_of(plain, x);
        for (int k = 0; k < 5; ++k) {
            const StructureState at{states::random_frames(draw, x, false, 0.1, 0.8), {}};
            const auto frames = as_array<Nodes>(at.frames);
            const MatrixXd tangent = a.tangent(at, 0);
            CHECK(beam.energy(frames) == Approx(plain.energy(frames, 0.0)).epsilon(1e-12));
            CHECK((a.residual(at, 0) - b.residual(at, 0)).norm() < 1e-13 * tangent.norm());
            CHECK((tangent - b.tangent(at, 0)).norm() < 1e-13 * tangent.norm());
        }
    };
    for (const Section& of : {section, channel}) {
        compare(std::integral_constant<int, 2>(), of);
        compare(std::integral_constant<int, 3>(), of);
    }
}

TEST_CASE("Strains are objective: a rotation of the whole changes none") {
    std::mt19937 draw(29);
    const Beam<3> beam(channel, helix<3>());
    for (int k = 0; k < 20; ++k) {
        auto at = as_array<3>(states::random_frames(draw, places(helix<3>()), false, 0.1, 0.8));
        const auto before = beam.strain(at, 1);
        const auto q = quaternion<double>(states::random_rotation(draw));
        for (auto& frame : at) frame = {q * frame.x, q * frame.q};
        CHECK((beam.strain(at, 1) - before).norm() < 1e-13);
    }
}

TEST_CASE("The mixed beam's equilibrium forces are those of the beam") {
    std::mt19937 draw(31);
    const Beam<3> beam(channel, helix<3>());
    const auto x = places(helix<3>());
    const auto plain = structure_of(beam, x), mixed = structure_of(MixedBeam<3>(channel, helix<3>()), x);
    for (int k = 0; k < 5; ++k) {
        StructureState at{states::random_frames(draw, x, false, 0.1, 0.5), {}};
        const VectorXd residual = plain.residual(at, 0);
        const MatrixXd tangent = plain.tangent(at, 0);
        at.multipliers.resize(12);
        for (int g = 0; g < 2; ++g)
            at.multipliers.segment<6>(6 * g) = beam.stress(as_array<3>(at.frames), g) / mixed.scale().multiplier;
        const VectorXd mixed_residual = mixed.residual(at, 0);
        CHECK((residual - mixed_residual.head(18)).norm() < 1e-13 * tangent.norm());
        CHECK(mixed_residual.tail(12).norm() < 1e-13 * tangent.norm());
        // condensed, K is the same; its block of the forces is diagonal
        MatrixXd condensed = mixed.tangent(at, 0);
        for (int m = 18; m < 30; ++m) {
            const VectorXd column = condensed.col(m).head(18);
            CHECK(condensed.col(m).tail(12).cwiseAbs().sum() == std::abs(condensed(m, m)));
            condensed.topLeftCorner(18, 18) -= column / condensed(m, m) * column.transpose();
        }
        CHECK((condensed.topLeftCorner(18, 18) - tangent).norm() < 1e-12 * tangent.norm());
    }
}

TEST_CASE("Bad sections and elements are refused by name") {
    CHECK_THROWS_WITH(Beam<2>({0, 1, 1, 1, 1, 1}, helix<2>()), Catch::Contains("ea = 0"));
    CHECK_THROWS_WITH(Beam<2>({1, 1, 1, 1, 1, 1, {.place = {3, 4}, .polar_radius = 4}}, helix<2>()),
                      Catch::Contains("polar_radius = 4") && Catch::Contains("from the centroid, 5"));
    CHECK_THROWS_WITH(Beam<2>({rigid, 1, 1, 1, 1, 1}, helix<2>()), Catch::Contains("MixedBeam"));
    CHECK_THROWS_WITH(MixedBeam<2>({1, 1, 1, rigid, rigid, rigid}, helix<2>()), Catch::Contains("gj, ei2, ei3 = inf"));
    CHECK_THROWS_WITH(Truss<3>(1, {0, 0, 0}, {0, 0, 0}), Catch::Contains("length = 0"));
    auto at = helix<3>();
    at[1].x = at[2].x = at[0].x;
    CHECK_THROWS_WITH(Beam<3>(section, at), Catch::Contains("length of an element"));
    CHECK_THROWS_WITH(section_frame({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), Catch::Contains("not along the axis"));
    CHECK_THROWS_WITH(RevoluteJoint({0, 0, 0}), Catch::Contains("axis"));
}
