// The figures of the holonomic mechanism's study: Figures 3 to 10 of Vesovic and Radulovic, "Modelling and
// stability analysis of the nonlinear system" (2022), and the basins of two stable equilibria.
//
//   mechanism_figures --out figures
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <equilibria/dynamics/basins.hpp>
#include <equilibria/dynamics/lagrange_first_kind.hpp>
#include <equilibria/dynamics/linear_motion.hpp>
#include <equilibria/io/gnuplot.hpp>
#include <equilibria/model/torus.hpp>
#include <exception>
#include <filesystem>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "instances/enumerate/holonomic_enumeration.hpp"
#include "support/command_line.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"

namespace {

using M = equilibria::mechanisms::HolonomicMechanism;
using Points = equilibria::mechanisms::HolonomicMechanismPoints;
using equilibria::MotionState;
using std::numbers::pi;

const std::string index_colors[] = {"#009e73", "#e69f00", "#cc3311"};
const std::string index_names[] = {"index 0 (stable)", "index 1", "index 2"};
const std::string angle_tics = "('−π' -pi, '−π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi)";

std::vector<double> times(double end, int intervals) {
    std::vector<double> y;
    for (int k = 0; k <= intervals; ++k) y.push_back(end * k / intervals);
    return y;
}

struct Figure {
    std::string name, script;
    int width, height;
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
    const std::string data =
        equilibria::gnuplot_block("motion", rows.str()) +
        "set tics out nomirror\nset border 31 lw 0.8\nset xlabel '{/:Italic t} [s]'\nset grid lc rgb '#dddddd'\n";
    const auto curve = [](int column, const std::string& title, const std::string& color) {
        return "$motion using 1:" + std::to_string(column) + " with lines lw 2 lc rgb '" + color +
               "' title '{/:Italic " + title.substr(0, 1) + "}_" + title.substr(1) + "'";
    };
    return {
        {"mechanism_3",
         data + "set ylabel 'coordinates [m]'\nset key outside right center\nplot [0:10] " + curve(2, "x1", "#0072b2") +
             ", " + curve(3, "y1", "#56b4e9") + ", " + curve(4, "x2", "#cc3311") + ", " + curve(5, "y2", "#e69f00") +
             ", " + curve(6, "x3", "#009e73") + ", " + curve(7, "y3", "black") + "\n",
         1000, 520},
        {"mechanism_4",
         data + "set ylabel 'angles [rad]'\nset key outside right center\nplot [0:10] " + curve(8, "q1", "#0072b2") +
             ", " + curve(9, "q2", "#cc3311") + "\n",
         1000, 480},
        {"mechanism_5",
         data + "set ylabel 'momenta [kg m^2/s]'\nset key outside right center\nplot [0:10] " +
             curve(10, "p1", "#0072b2") + ", " + curve(11, "p2", "#cc3311") + "\n",
         1000, 480}};
}

/// The data blocks $index0 to $index2: angles and energies. What lies on an edge of the picture lies on both.
std::string equilibrium_blocks(const equilibria::RootSet<M>& set) {
    std::string blocks;
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
        blocks += equilibria::gnuplot_block("index" + std::to_string(index),
                                            rows.str().empty() ? "nan nan nan\n" : rows.str());
    }
    return blocks;
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
    std::string script =
        equilibria::gnuplot_block("surface", grid(60, [&](const auto& q) { return equilibria::potential<M>(q, p); })) +
        equilibria::gnuplot_block("map", grid(120, [&](const auto& q) { return equilibria::potential<M>(q, p); }));
    for (int k = 0; k < 2; ++k)
        script +=
            equilibria::gnuplot_block("equation" + std::to_string(k + 1),
                                      grid(240, [&](const auto& q) { return equilibria::equations<M>(q, p)[k]; }));
    script += equilibrium_blocks(set);
    std::ostringstream out;
    out << script << "set contour base\nunset surface\nset cntrparam levels discrete 0\n";
    for (int k = 1; k <= 2; ++k)
        out << "set table $zero" << k << "\nsplot $equation" << k << " with lines\nunset table\n";
    out << "unset contour\nset surface\n"
        << "set multiplot title 'Potential energy of the mechanism, {/:Italic F} = " << force << " N'\n"
        << "set palette defined (0 '#253494', 1 '#41b6c4', 2 '#ffffcc')\n"
        << "set xtics " << angle_tics << "\nset ytics " << angle_tics << "\n"
        << "set xlabel '{/:Italic q}_1'\nset ylabel '{/:Italic q}_2'\nset tics out nomirror\n"
        << "unset colorbox\nset origin 0,0.06\nset size 0.5,0.9\nset key at screen 0.25,0.03 center bottom horizontal "
           "maxrows 1 samplen 1\n"
        << "set view 32,335,1.1,1\nset xyplane relative 0.05\nset zlabel '{/:Italic V} [J]' rotate by 90 offset 1,0\n"
        << "set ztics 500\nset border 31 lw 0.5\n"
        << "splot [-pi:pi][-pi:pi] $surface using 1:2:3 with pm3d notitle";
    for (int index = 0; index < 3; ++index)
        out << ", $index" << index << " using 1:2:3 with points pt 7 ps 1.3 lc rgb '" << index_colors[index]
            << "' title '" << index_names[index] << "'";
    out << "\nset border 31 lw 0.8\nset ylabel '{/:Italic q}_2' rotate by 0\nset origin 0.5,0.06\nset size 0.5,0.9\n"
        << "set key at screen 0.75,0.03 center bottom horizontal maxrows 1 samplen 2\n"
        << "set colorbox\nset cblabel '{/:Italic V} [J]'\nset size ratio 1\n"
        << "plot [-pi:pi][-pi:pi] $map using 1:2:3 with image notitle, "
        << "$zero1 using 1:2 with lines lw 2 lc rgb '#000000' title '∂{/:Italic V}/∂{/:Italic q}_1 = 0', "
        << "$zero2 using 1:2 with lines lw 2 lc rgb '#d55ebc' title '∂{/:Italic V}/∂{/:Italic q}_2 = 0'";
    for (int index = 0; index < 3; ++index)
        out << ", $index" << index << " using 1:2 with points pt 7 ps 1.6 lc rgb 'white' notitle, $index" << index
            << " using 1:2 with points pt 7 ps 1.1 lc rgb '" << index_colors[index] << "' notitle";
    out << "\nunset multiplot\n";
    return {name, out.str(), 1300, 600};
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
    std::ostringstream out;
    out << equilibria::gnuplot_block(
               "motion", rows(equilibria::integrate_motion(equilibria::LagrangeSecondKind<M>(p), start, at)))
        << equilibria::gnuplot_block("linear",
                                     rows(equilibria::integrate_motion(equilibria::LinearMotion<M>(p, e.q), start, at)))
        << "set multiplot layout 1,2 title '" << title << "' margins 0.08,0.98,0.22,0.88 spacing 0.1\n"
        << "set tics out nomirror\nset border 31 lw 0.8\nset grid lc rgb '#dddddd'\nset xlabel '{/:Italic t} [s]'\n"
        << "set key at screen 0.5,0.03 center bottom horizontal maxrows 1 samplen 2\n";
    for (int k = 0; k < 2; ++k)
        out << "set ylabel 'deviation of {/:Italic q}_" << k + 1 << " [rad]'\nplot [0:" << end << "][" << -span << ":"
            << span << "] $motion using 1:" << k + 2
            << " with lines lw 2.4 lc rgb '#0072b2' title 'equations of motion', $linear using 1:" << k + 2
            << " with lines lw 1.6 dt 2 lc rgb '#cc3311' title 'linearised'\nunset key\n";
    out << "unset multiplot\n";
    return {name, out.str(), 1100, 480};
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
    std::ostringstream out;
    out << equilibria::gnuplot_block("basins", rows.str());
    out << equilibrium_blocks(set);
    out << "set title 'Where motions from rest end: {/:Italic F} = 0, {/:Italic c}_2 = 50 N/m'\nset size ratio "
           "1\nunset colorbox\n"
        << "set palette defined (-1 '#888888', 0 '#fdd49e', 1 '#9ecae1')\nset cbrange [-1:1]\n"
        << "set xtics " << angle_tics << "\nset ytics " << angle_tics
        << "\nset tics out nomirror\nset border 31 lw 0.8\n"
        << "set xlabel '{/:Italic q}_1'\nset ylabel '{/:Italic q}_2' rotate by 0\nset key below horizontal samplen 1\n"
        << "plot [-pi:pi][-pi:pi] $basins using 1:2:3 with image notitle";
    for (int index = 0; index < 3; ++index)
        out << ", $index" << index << " with points pt 7 ps 1.4 lc rgb '" << index_colors[index] << "' title '"
            << index_names[index] << "'";
    out << '\n';
    return {"mechanism_basins", out.str(), 700, 740};
}

}  // namespace

int main(int argc, char** argv) {
    std::string folder = ".", cells_text = "121", threads_text = "0";
    CLI::App app{
        "The figures of the holonomic mechanism's study as SVG and PNG (needs gnuplot): its motion, its potential with "
        "the "
        "equilibria, disturbed motions beside the linearised ones, and basins of attraction."};
    app.add_option("--out", folder, "the folder to write them to (default: this one)");
    app.add_option("--basin-cells", cells_text, "the basins' grid, cells a side, 2 to 1000 (default 121)");
    app.add_option("--threads", threads_text, "for the basins, 1 to 1024, 0 for one each core (default 0)");
    support::parse(app, "mechanism_figures", argc, argv);
    try {
        const int cells = support::integer("--basin-cells", cells_text, 2, 1000);
        const auto threads = support::integer<unsigned>("--threads", threads_text, 0, 1024);
        if (!std::filesystem::is_directory(folder)) support::fail("--out", support::shown(folder), "must be a folder");
        auto figures = motion_figures();
        figures.push_back(potential_figure("mechanism_6", 100));
        figures.push_back(potential_figure("mechanism_7", 0));
        figures.push_back(disturbed_figure("mechanism_8",
                                           "Disturbed motion about the second equilibrium, {/:Italic F} = 100 N", 100,
                                           {1.465, -0.256}, 20, 0.25));
        figures.push_back(disturbed_figure("mechanism_9",
                                           "Disturbed motion about the third equilibrium, {/:Italic F} = 100 N", 100,
                                           {-1.422, -2.545}, 10, 8));
        figures.push_back(disturbed_figure("mechanism_10",
                                           "Disturbed motion about the stable equilibrium, {/:Italic F} = 0", 0,
                                           {pi / 2, 0}, 20, 0.25));
        figures.push_back(basin_figure(cells, threads));
        for (const auto& figure : figures) {
            const std::string size = std::to_string(figure.width) + "," + std::to_string(figure.height),
                              twice = std::to_string(2 * figure.width) + "," + std::to_string(2 * figure.height);
            const std::string path = folder + "/" + figure.name;
            support::OutputFile("--out", path + ".svg")
                .write(
                    equilibria::gnuplot("svg size " + size + " font 'Helvetica,14' background 'white'", figure.script));
            support::OutputFile("--out", path + ".png")
                .write(equilibria::gnuplot("pngcairo size " + twice + " fontscale 1.8 linewidth 2 pointscale 2",
                                           figure.script));
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
