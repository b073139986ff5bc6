// One of the frames of bench/peers/finite_rotations with OpenSees' classes, as its interpreters would call them:
// elasticBeamColumn with the transformation Corotational, integrators EQPath (4: cylindrical arc length) and
// LoadControl, system BandGeneral. The integrator ArcLength takes the sign of the last load step for the next: it turns
// back at folds, and is not used.
//
//   frames PROBLEM ELEMENTS STEPS SIDE [LAST]
//
// prints a line "point load x y z" for each step, of the loaded node, and "seconds S unknowns N". SIDE: a dead load out
// of the plane, as a part of the load that a step has. LAST: it ends with this one of the STEPS. It ends with 1 where
// OpenSees gives up.
#include <AnalysisModel.h>
#include <BandGenLinLapackSolver.h>
#include <BandGenLinSOE.h>
#include <CTestNormDispIncr.h>
#include <CorotCrdTransf2d.h>
#include <CorotCrdTransf3d.h>
#include <DOF_Numberer.h>
#include <Domain.h>
#include <EQPath.h>
#include <ElasticBeam2d.h>
#include <ElasticBeam3d.h>
#include <LinearSeries.h>
#include <LoadControl.h>
#include <LoadPattern.h>
#include <NewtonRaphson.h>
#include <NodalLoad.h>
#include <Node.h>
#include <OPS_Globals.h>
#include <PlainHandler.h>
#include <RCM.h>
#include <SP_Constraint.h>
#include <StandardStream.h>
#include <StaticAnalysis.h>
#include <elementAPI.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

StandardStream sserr;
OPS_Stream* opserrPtr = &sserr;

// what the interpreters provide and elementAPI_Dummy.cpp lacks; not called here
extern "C" int OPS_GetDoubleListInput(int*, Vector*) { return -1; }
extern "C" int OPS_SetDoubleDictListOutput(std::map<const char*, std::vector<double>>&) { return -1; }
extern "C" const char* OPS_GetStringFromAll(char*, int) { return nullptr; }
extern "C" AnalysisModel** OPS_GetAnalysisModel(void) { return nullptr; }

namespace {

using Place = std::array<double, 3>;

/// Nodes in a row, numbered from 1, clamped or hinged at both ends; which is loaded, and how the load goes on.
struct Frame {
    std::vector<Place> places{};
    double e = 0, g = 0, area = 0, j = 1, out_of_plane = 0, in_plane = 0;
    int loaded = 0;
    Place force{0, -1, 0};
    bool planar = true, hinged = false;
    double arc = 0;   ///< length of a step of the arc-length integrator; 0: load control
    double most = 0;  ///< the last load of load control
    double tolerance = 1e-7;

    int degrees_of_freedom() const { return planar ? 3 : 6; }  ///< of a node
    int last() const { return static_cast<int>(places.size()); }

    /// `count` elements from a to b; the number of the last node.
    int line(const Place& a, const Place& b, int count) {
        for (int k = places.empty() ? 0 : 1; k <= count; ++k) {
            const double t = static_cast<double>(k) / count;
            places.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0});
        }
        return last();
    }
};

/// n elements; no places where the problem is unknown.
Frame frame(const std::string& problem, int n, int steps, double side) {
    Frame y;
    const int half = (n + 1) / 2;
    if (problem == "lee_frame") {
        const int quick = std::max(1, static_cast<int>(std::lround(n / 10.0)));
        y.line({0, 0, 0}, {0, 120, 0}, half);
        y.loaded = y.line({0, 120, 0}, {24, 120, 0}, quick);
        y.line({24, 120, 0}, {120, 120, 0}, n - half - quick);
        y.e = 720, y.area = 6, y.in_plane = 2, y.hinged = true;
        y.arc = 2.2 * std::sqrt(n) * 60 / steps;
    } else if (problem == "williams_toggle") {
        y.loaded = y.line({-12.943, 0, 0}, {0, .386, 0}, half);
        y.line({0, .386, 0}, {12.943, 0, 0}, half);
        y.e = 1.03e7, y.area = 1.885e6 / y.e, y.in_plane = 9.27e3 / y.e;
        y.arc = 0.007 * std::sqrt(n) * 60 / steps;
        y.tolerance = 1e-9;
    } else if (problem == "right_angle_frame") {
        y.line({0, 0, 0}, {240, 0, 0}, half);
        y.loaded = y.line({240, 0, 0}, {240, -240, 0}, half);
        y.e = 71240, y.g = y.e / 2.62, y.area = 18, y.j = 2.16, y.out_of_plane = .54, y.in_plane = 1350;
        y.planar = false, y.most = 1.4;
        y.force = {1, 0, side};
    } else if (problem == "bend") {
        for (int k = 0; k <= n; ++k) {
            const double angle = k * std::acos(-1.0) / 4 / n;
            y.places.push_back({100 * std::sin(angle), 100 * (1 - std::cos(angle)), 0});
        }
        y.loaded = n + 1;
        y.e = 1e7, y.g = 5e6, y.area = 1, y.j = 1 / 6.0, y.out_of_plane = y.in_plane = 1 / 12.0;
        y.planar = false, y.most = 600;
        y.force = {0, 0, 1};
    }
    return y;
}

/// Puts the frame into the domain; returns the number of unknowns.
int build(const Frame& frame, Domain& domain) {
    const int last = frame.last(), each = frame.degrees_of_freedom();
    for (int k = 1; k <= last; ++k) {
        const Place& x = frame.places[static_cast<std::size_t>(k - 1)];
        domain.addNode(frame.planar ? new Node(k, 3, x[0], x[1]) : new Node(k, 6, x[0], x[1], x[2]));
    }
    Vector offset2(2), offset3(3), z(3);
    z(2) = 1;  // in the local x-z plane: local z is out of the plane of the frame
    for (int k = 1; k < last; ++k) {
        if (frame.planar) {
            CorotCrdTransf2d turned(k, offset2, offset2);
            domain.addElement(new ElasticBeam2d(k, frame.area, frame.e, frame.in_plane, k, k + 1, turned));
        } else {
            CorotCrdTransf3d turned(k, z, offset3, offset3);
            domain.addElement(new ElasticBeam3d(k, frame.area, frame.e, frame.g, frame.j, frame.out_of_plane,
                                                frame.in_plane, frame.area, frame.area, k, k + 1, turned));
        }
    }
    int unknowns = each * last;
    for (const int node : {1, last})
        for (int k = 0; k < each - frame.hinged && (node == 1 || frame.planar); ++k, --unknowns)
            domain.addSP_Constraint(new SP_Constraint(node, k, 0.0, true));
    auto* pattern = new LoadPattern(1);
    pattern->setTimeSeries(new LinearSeries());
    domain.addLoadPattern(pattern);
    Vector load(each);
    for (int k = 0; k < (frame.planar ? 2 : 3); ++k) load(k) = frame.force[static_cast<std::size_t>(k)];
    domain.addNodalLoad(new NodalLoad(1, frame.loaded, load), 1);
    return unknowns;
}

void print_point(const Frame& frame, Domain& domain) {
    const Vector& u = domain.getNode(frame.loaded)->getDisp();
    const Place& x = frame.places[static_cast<std::size_t>(frame.loaded - 1)];
    std::printf("point %.15g %.15g %.15g %.15g\n", domain.getCurrentTime(), x[0] + u(0), x[1] + u(1),
                frame.planar ? 0 : x[2] + u(2));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5 && argc != 6) return 2;
    const auto begin = std::chrono::steady_clock::now();
    const int steps = std::atoi(argv[3]), last = argc == 6 ? std::atoi(argv[5]) : steps;
    const Frame frame = ::frame(argv[1], std::atoi(argv[2]), steps, std::atof(argv[4]));
    if (frame.places.empty()) return 2;
    Domain domain;
    const int unknowns = build(frame, domain);

    auto* test = new CTestNormDispIncr(frame.tolerance, 60, 0);
    const double part = frame.most / steps;
    StaticIntegrator* integrator =
        frame.arc > 0 ? static_cast<StaticIntegrator*>(new EQPath(frame.arc, 4)) : new LoadControl(part, 1, part, part);
    auto* numbering = new RCM();
    StaticAnalysis analysis(domain, *new PlainHandler(), *new DOF_Numberer(*numbering), *new AnalysisModel(),
                            *new NewtonRaphson(*test), *new BandGenLinSOE(*new BandGenLinLapackSolver()), *integrator,
                            test);
    print_point(frame, domain);
    for (int k = 0; k < last; ++k) {
        if (analysis.analyze(1) != 0) {
            std::fprintf(stderr, "OpenSees gave up in step %d of %d\n", k + 1, last);
            std::fflush(stdout);
            std::_Exit(1);
        }
        print_point(frame, domain);
    }
    std::printf("seconds %.6g unknowns %d\n",
                std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), unknowns);
    std::fflush(stdout);
    std::_Exit(0);
}
