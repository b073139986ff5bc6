// One of the frames of bench/peers/finite_rotations with OpenSees' classes, as its interpreters would call them:
// elasticBeamColumn with the transformation Corotational, integrators EQPath (4: cylindrical arc length) and
// LoadControl, system BandGeneral. The integrator ArcLength takes the sign of the last load step for the next: it turns
// back at folds, and is not used.
//
//   frames PROBLEM ELEMENTS STEPS SIDE
//
// prints a line "point load x y z" for each step, of the loaded node, and "seconds S unknowns N". SIDE: a dead load out
// of the plane, as a part of the load that a step has. It ends with 1 where OpenSees gives up.
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

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

StandardStream sserr;
OPS_Stream* opserrPtr = &sserr;

// what the interpreters provide and elementAPI_Dummy.cpp lacks; not called here
extern "C" int OPS_GetDoubleListInput(int*, Vector*) { return -1; }
extern "C" int OPS_SetDoubleDictListOutput(std::map<const char*, std::vector<double>>&) { return -1; }
extern "C" const char* OPS_GetStringFromAll(char*, int) { return nullptr; }
extern "C" AnalysisModel** OPS_GetAnalysisModel(void) { return nullptr; }

int main(int argc, char** argv) {
    if (argc != 5) return 2;
    const auto begin = std::chrono::steady_clock::now();
    const std::string problem = argv[1];
    const int n = std::atoi(argv[2]), steps = std::atoi(argv[3]), half = (n + 1) / 2;
    const double side = std::atof(argv[4]), pi = std::acos(-1.0);

    using Place = std::array<double, 3>;
    std::vector<Place> places;
    const auto line = [&](const Place& a, const Place& b, int count) {
        for (int k = places.empty() ? 0 : 1; k <= count; ++k) {
            const double t = static_cast<double>(k) / count;
            places.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0});
        }
        return static_cast<int>(places.size());
    };
    double e = 0, g = 0, area = 0, j = 1, out_of_plane = 0, in_plane = 0, arc = 0, most = 0;
    int loaded = 0;
    Place force{0, -1, 0};
    bool planar = true, hinged = false;
    if (problem == "lee_frame") {
        const int quick = std::max(1, static_cast<int>(std::lround(n / 10.0)));
        line({0, 0, 0}, {0, 120, 0}, half);
        loaded = line({0, 120, 0}, {24, 120, 0}, quick);
        line({24, 120, 0}, {120, 120, 0}, n - half - quick);
        e = 720, area = 6, in_plane = 2, hinged = true;
        arc = 2.2 * std::sqrt(n) * 60 / steps;
    } else if (problem == "williams_toggle") {
        loaded = line({-12.943, 0, 0}, {0, .386, 0}, half);
        line({0, .386, 0}, {12.943, 0, 0}, half);
        e = 1.03e7, area = 1.885e6 / e, in_plane = 9.27e3 / e;
        arc = 0.007 * std::sqrt(n) * 60 / steps;
    } else if (problem == "right_angle_frame") {
        line({0, 0, 0}, {240, 0, 0}, half);
        loaded = line({240, 0, 0}, {240, -240, 0}, half);
        e = 71240, g = e / 2.62, area = 18, j = 2.16, out_of_plane = .54, in_plane = 1350, planar = false, most = 1.4;
        force = {1, 0, side};
    } else if (problem == "bend") {
        for (int k = 0; k <= n; ++k) {
            const double angle = k * pi / 4 / n;
            places.push_back({100 * std::sin(angle), 100 * (1 - std::cos(angle)), 0});
        }
        loaded = n + 1;
        e = 1e7, g = 5e6, area = 1, j = 1 / 6.0, out_of_plane = in_plane = 1 / 12.0, planar = false, most = 600;
        force = {0, 0, 1};
    } else {
        return 2;
    }

    Domain domain;
    const int last = static_cast<int>(places.size()), each = planar ? 3 : 6;
    for (int k = 1; k <= last; ++k) {
        const Place& x = places[static_cast<std::size_t>(k - 1)];
        domain.addNode(planar ? new Node(k, 3, x[0], x[1]) : new Node(k, 6, x[0], x[1], x[2]));
    }
    Vector offset2(2), offset3(3), z(3);
    z(2) = 1;  // in the local x-z plane: local z is out of the plane of the frame
    int unknowns = each * last;
    for (int k = 1; k < last; ++k) {
        if (planar) {
            CorotCrdTransf2d turned(k, offset2, offset2);
            domain.addElement(new ElasticBeam2d(k, area, e, in_plane, k, k + 1, turned));
        } else {
            CorotCrdTransf3d turned(k, z, offset3, offset3);
            domain.addElement(
                new ElasticBeam3d(k, area, e, g, j, out_of_plane, in_plane, area, area, k, k + 1, turned));
        }
    }
    for (const int node : {1, last})
        for (int k = 0; k < each - hinged && (node == 1 || planar); ++k, --unknowns)
            domain.addSP_Constraint(new SP_Constraint(node, k, 0.0, true));
    auto* pattern = new LoadPattern(1);
    pattern->setTimeSeries(new LinearSeries());
    domain.addLoadPattern(pattern);
    Vector load(each);
    for (int k = 0; k < (planar ? 2 : 3); ++k) load(k) = force[static_cast<std::size_t>(k)];
    domain.addNodalLoad(new NodalLoad(1, loaded, load), 1);

    auto* test = new CTestNormDispIncr(problem == "williams_toggle" ? 1e-9 : 1e-7, 60, 0);
    StaticIntegrator* integrator = arc > 0 ? static_cast<StaticIntegrator*>(new EQPath(arc, 4))
                                           : new LoadControl(most / steps, 1, most / steps, most / steps);
    auto* numbering = new RCM();
    StaticAnalysis analysis(domain, *new PlainHandler(), *new DOF_Numberer(*numbering), *new AnalysisModel(),
                            *new NewtonRaphson(*test), *new BandGenLinSOE(*new BandGenLinLapackSolver()), *integrator,
                            test);
    const auto print = [&] {
        const Vector& u = domain.getNode(loaded)->getDisp();
        const Place& x = places[static_cast<std::size_t>(loaded - 1)];
        std::printf("point %.15g %.15g %.15g %.15g\n", domain.getCurrentTime(), x[0] + u(0), x[1] + u(1),
                    planar ? 0 : x[2] + u(2));
    };
    print();
    for (int k = 0; k < steps; ++k) {
        if (analysis.analyze(1) != 0) {
            std::fprintf(stderr, "OpenSees gave up in step %d of %d\n", k + 1, steps);
            std::fflush(stdout);
            std::_Exit(1);
        }
        print();
    }
    std::printf("seconds %.6g unknowns %d\n",
                std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), unknowns);
    std::fflush(stdout);
    std::_Exit(0);
}
