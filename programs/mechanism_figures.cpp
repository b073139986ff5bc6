// The figures of the holonomic mechanism's study (docs/mechanism.md), and the basins of two stable equilibria.
//
//   mechanism_figures --out figures
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <equilibria/dynamics/basins.hpp>
#include <equilibria/dynamics/lagrange_first_kind.hpp>
#include <equilibria/dynamics/linear_motion.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <exception>
#include <filesystem>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "plots/mechanism_basins.hpp"
#include "plots/mechanism_disturbed.hpp"
#include "plots/mechanism_motion.hpp"
#include "plots/mechanism_potential.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/pictures.hpp"

namespace {

using M = equilibria::mechanisms::HolonomicMechanism;
using Points = equilibria::mechanisms::HolonomicMechanismPoints;
using equilibria::MotionState;
using std::numbers::pi;

std::vector<double> times(double end, int intervals) {
    std::vector<double> y;
    for (int k = 0; k <= intervals; ++k) y.push_back(end * k / intervals);
    return y;
}

struct Figure {
    std::string name;
    equilibria::GnuplotData data;
    const char* script;
    support::PictureSize size;
};

/// Figures 3 to 5: the motion from (4 pi / 13, pi / 7) at rest under F = 100 exp(-0.7 t).
std::vector<Figure> motion_figures() {
    const auto p = M::paper_parameters(100, 0.7);
    const MotionState<M> start{{4 * pi / 13, pi / 7}, {}};
    const auto motion = equilibria::integrate_motion(equilibria::LagrangeFirstKind<Points>(p),
                                                     equilibria::mechanisms::points_of(start, p), times(10, 1000));
    if (motion.status != equilibria::MotionStatus::finished) throw std::runtime_error(to_string(motion.status));
    std::ostringstream rows;
    rows.precision(10);
    for (const auto& x : motion.points) {
        const auto angles = equilibria::mechanisms::angles_of({x.q, x.velocity});
        rows << x.time;
        for (const double value : x.q) rows << ' ' << value;
        for (const double value : angles.q) rows << ' ' << value;
        for (const double value : equilibria::momenta<M>(angles.q, angles.velocity, p)) rows << ' ' << value;
        rows << '\n';
    }
    const auto figure = [&](const char* name, const char* what, int first, const char* names, const char* colours,
                            int height) {
        equilibria::GnuplotData data;
        data.block("motion", rows.str()).string("what", what).integer("first", first);
        data.string("names", names).string("colours", colours);
        return Figure{name, data, plots::mechanism_motion, {1000, height}};
    };
    return {figure("mechanism_3", "coordinates [m]", 2, "x1 y1 x2 y2 x3 y3",
                   "#0072b2 #56b4e9 #cc3311 #e69f00 #009e73 black", 520),
            figure("mechanism_4", "angles [rad]", 8, "q1 q2", "#0072b2 #cc3311", 480),
            figure("mechanism_5", "momenta [kg m^2/s]", 10, "p1 p2", "#0072b2 #cc3311", 480)};
}

/// The data blocks $index0 to $index2: angles and energies. What lies on an edge of the picture lies on both.
void add_equilibria(equilibria::GnuplotData& data, const equilibria::RootSet<M>& set) {
    for (int index = 0; index < 3; ++index) {
        std::ostringstream rows;
        for (const auto& e : set.equilibria) {
            if (e.index != index) continue;
            std::vector<double> places[2];
            for (int k = 0; k < 2; ++k)
                if (std::abs(e.q[k]) > pi - 1e-6)
                    places[k] = {-3.14159, 3.14159};
                else
                    places[k] = {e.q[k]};
            for (const double q1 : places[0])
                for (const double q2 : places[1]) rows << q1 << ' ' << q2 << ' ' << e.energy << '\n';
        }
        data.block("index" + std::to_string(index), rows.str(), 3);
    }
}

/// Figures 6 and 7: the potential over both angles, the curves on which each equation holds, and the equilibria.
Figure potential_figure(const std::string& name, double force) {
    const auto p = M::paper_parameters(force);
    const auto set = equilibria::enumerate<M>(p);
    const auto grid = [&](int cells, const auto& value) {
        std::ostringstream rows;
        rows.precision(7);
        for (int i = 0; i <= cells; ++i) {
            for (int k = 0; k <= cells; ++k) {
                const equilibria::Unknowns<M> q{-pi + 2 * pi * i / cells, -pi + 2 * pi * k / cells};
                rows << q[0] << ' ' << q[1] << ' ' << value(q) << '\n';
            }
            rows << '\n';
        }
        return rows.str();
    };
    equilibria::GnuplotData data;
    data.block("surface", grid(60, [&](const auto& q) { return equilibria::potential<M>(q, p); }));
    data.block("map", grid(120, [&](const auto& q) { return equilibria::potential<M>(q, p); }));
    for (int k = 0; k < 2; ++k)
        data.block("equation" + std::to_string(k + 1),
                   grid(240, [&](const auto& q) { return equilibria::equations<M>(q, p)[k]; }));
    add_equilibria(data, set);
    data.value("force", force);
    return {name, data, plots::mechanism_potential, {1300, 600}};
}

/// Figures 8 to 10: motions disturbed by (0.2, 0) and rates (0.3, 0), the true one beside the linearised one.
Figure disturbed_figure(const std::string& name, const std::string& title, double force,
                        const equilibria::Unknowns<M>& near, double end, double span) {
    const auto p = M::paper_parameters(force);
    const auto set = equilibria::enumerate<M>(p);
    const auto& e = *std::min_element(set.equilibria.begin(), set.equilibria.end(), [&](const auto& a, const auto& b) {
        return equilibria::distance<M>(a.q, near) < equilibria::distance<M>(b.q, near);
    });
    const MotionState<M> start{{e.q[0] + 0.2, e.q[1]}, {0.3, 0}};
    const auto at = times(end, 1200);
    const auto rows = [&](const auto& motion) {
        std::ostringstream out;
        out.precision(8);
        for (const auto& x : motion.points) out << x.time << ' ' << x.q[0] - e.q[0] << ' ' << x.q[1] - e.q[1] << '\n';
        return out.str();
    };
    equilibria::GnuplotData data;
    data.block("motion", rows(equilibria::integrate_motion(equilibria::LagrangeSecondKind<M>(p), start, at)));
    data.block("linear", rows(equilibria::integrate_motion(equilibria::LinearMotion<M>(p, e.q), start, at)));
    data.string("heading", title).value("end", end).value("span", span);
    return {name, data, plots::mechanism_disturbed, {1100, 480}};
}

/// Where damped motions from rest end, without a force and with a soft spring: two stable equilibria, mirror images.
Figure basin_figure(int cells, unsigned threads) {
    auto p = M::paper_parameters(0);
    p[M::stiffness_2] = 50;
    const auto set = equilibria::enumerate<M>(p);
    std::vector<MotionState<M>> starts;
    for (int i = 0; i < cells; ++i)
        for (int k = 0; k < cells; ++k)
            starts.push_back({{-pi + 2 * pi * (i + 0.5) / cells, -pi + 2 * pi * (k + 0.5) / cells}, {}});
    equilibria::BasinOptions options;
    options.motion.relative_tolerance = options.motion.absolute_tolerance = 1e-7;
    options.settled_share = 0.1;
    options.executor = equilibria::threads(threads);
    const auto settled = equilibria::find_basins<M>(p, set.equilibria, starts, options);
    std::ostringstream rows;
    std::size_t open = 0;
    for (std::size_t k = 0; k < starts.size(); ++k) {
        open += !settled[k].equilibrium;
        rows << starts[k].q[0] << ' ' << starts[k].q[1] << ' '
             << (settled[k].equilibrium ? set.equilibria[*settled[k].equilibrium].q[1] > 0 ? 1 : 0 : -1) << '\n';
    }
    if (open > 0) std::fprintf(stderr, "mechanism_figures: %zu of %zu motions did not settle\n", open, starts.size());
    equilibria::GnuplotData data;
    data.block("basins", rows.str());
    add_equilibria(data, set);
    return {"mechanism_basins", data, plots::mechanism_basins, {700, 740}};
}

std::vector<Figure> figures(int cells, unsigned threads) {
    auto y = motion_figures();
    y.push_back(potential_figure("mechanism_6", 100));
    y.push_back(potential_figure("mechanism_7", 0));
    y.push_back(disturbed_figure("mechanism_8", "Disturbed motion about the second equilibrium, {/:Italic F} = 100 N",
                                 100, {1.465, -0.256}, 20, 0.25));
    y.push_back(disturbed_figure("mechanism_9", "Disturbed motion about the third equilibrium, {/:Italic F} = 100 N",
                                 100, {-1.422, -2.545}, 10, 8));
    y.push_back(disturbed_figure("mechanism_10", "Disturbed motion about the stable equilibrium, {/:Italic F} = 0", 0,
                                 {pi / 2, 0}, 20, 0.25));
    y.push_back(basin_figure(cells, threads));
    return y;
}

}  // namespace

int main(int argc, char** argv) {
    std::string folder = ".";
    int cells = 121;
    unsigned threads = 0;
    support::CommandLine app{
        "The figures of the holonomic mechanism's study as SVG and PNG (needs gnuplot): its motion, its potential with "
        "the "
        "equilibria, disturbed motions beside the linearised ones, and basins of attraction."};
    app.add_option("--out", folder, "the folder to write them to (default: this one)").transform(support::a_folder());
    app.add_option("--basin-cells", cells, "the basins' grid, cells a side, 2 to 1000 (default 121)")
        .transform(support::integer(2, 1000));
    app.add_threads(threads, "for the basins, 1 to 1024, 0 for one each core (default 0)");
    app.parse("mechanism_figures", argc, argv);
    try {
        for (const auto& figure : figures(cells, threads)) {
            const std::string path = folder + "/" + figure.name;
            support::Pictures pictures;
            pictures.svg.emplace("--out", path + ".svg");
            pictures.png.emplace("--out", path + ".png");
            pictures.draw(figure.size, figure.data, figure.script);
            std::printf("%s.svg, .png\n", path.c_str());
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "mechanism_figures: %s\n", error.what());
        return 1;
    }
}

// clang-format off
/* Refused:
--out missing/folder
    mechanism_figures: --out missing/folder: must be a folder
--basin-cells 1
    mechanism_figures: --basin-cells 1: must be an integer from 2 to 1000
--threads many
    mechanism_figures: --threads many: must be an integer from 0 to 1024
*/
