// Every equilibrium of the holonomic mechanism, real and complex, proved, with its stability by three criteria: Tables
// 1 to 5 of Vesovic and Radulovic, "Modelling and stability analysis of the nonlinear system" (2022).
//
//   mechanism --force 100 --json mechanism.json
//   mechanism --data appendix --force 0
//   mechanism --force 0 --sweep-c2 0:400
#include <cmath>
#include <complex>
#include <cstdio>
#include <equilibria/stability/lagrange_dirichlet.hpp>
#include <equilibria/stability/linearise.hpp>
#include <equilibria/stability/pole_count.hpp>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "instances/locus/holonomic_events.hpp"
#include "support/command_line.hpp"
#include "support/mechanism_options.hpp"
#include "support/output_file.hpp"

namespace {

using M = equilibria::mechanisms::HolonomicMechanism;
using Json = nlohmann::ordered_json;

const char* const parameter_names[] = {"mass_1",      "mass_2",      "mass_3",  "gravity", "length",
                                       "stiffness_1", "stiffness_2", "damping", "force",   "decay"};

/// An equilibrium with all that the paper's tables say of one.
struct Row {
    equilibria::Equilibrium<M> at;
    equilibria::Certificate certificate;
    equilibria::LagrangeDirichlet<equilibria::UnknownMatrix<M>> energy;
    equilibria::PoleCount<equilibria::UnknownMatrix<M>> motion;
};

struct Study {
    std::string data;
    equilibria::RootSet<M> set;
    equilibria::Proof<M> proof;
    std::vector<Row> rows;
    std::optional<equilibria::LineEvents<M>> sweep;
};

Study study(const std::string& data, const equilibria::Parameters<M>& p, const equilibria::RunOptions& options) {
    Study y{data, equilibria::enumerate<M>(p, options), {}, {}, {}};
    y.proof = equilibria::prove(y.set);
    for (const auto& e : y.set.equilibria) {
        const auto system = equilibria::linearise<M>(e.q, p);
        equilibria::Certificate own;
        for (const auto& certificate : y.proof.certificates)
            if (certificate.path == e.path) own = certificate;
        y.rows.push_back({e, own, equilibria::lagrange_dirichlet(system.stiffness), equilibria::count_poles(system)});
    }
    return y;
}

Json rows_of(const auto& matrix) {
    Json y = Json::array();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        Json row = Json::array();
        for (Eigen::Index k = 0; k < matrix.cols(); ++k) row.push_back(matrix(i, k));
        y.push_back(std::move(row));
    }
    return y;
}
Json list_of(const auto& values) {
    Json y = Json::array();
    for (const auto& value : values) y.push_back(value);
    return y;
}
Json pair_of(std::complex<double> z) { return {z.real(), z.imag()}; }

Json json_of(const Row& r) {
    Json special = Json::array(), poles = Json::array();
    for (const auto& s : r.motion.routh.special) special.push_back({{"row", s.row}, {"kind", to_string(s.kind)}});
    for (const auto& pole : r.motion.poles) poles.push_back(pair_of(pole));
    Json y{
        {"angles", list_of(r.at.q)},
        {"index", r.at.index},
        {"hessian", rows_of(r.energy.hessian)},
        {"minors", list_of(r.energy.minors)},
        {"characteristic_polynomial", list_of(r.motion.polynomial)},
        {"routh_first_column", list_of(r.motion.routh.first_column().eval())},
        {"hurwitz_minors", list_of(r.motion.hurwitz.minors)},
        {"poles_right_half_plane", nullptr},
        {"poles", std::move(poles)},
        {"stable", r.at.stable()},
        {"verdict", to_string(r.motion.verdict())},
        {"poles_on_axis", r.motion.on_axis},
        {"routh_table", rows_of(r.motion.routh.rows)},
        {"routh_special_cases", std::move(special)},
        {"hurwitz_matrix", rows_of(r.motion.hurwitz.matrix)},
        {"energy", r.at.energy},
        {"residual", r.at.residual},
        {"condition", r.at.condition},
        {"certificate",
         {{"exists", r.certificate.exists},
          {"distinct", r.certificate.distinct},
          {"reality", name(r.certificate.reality)},
          {"index_proved", r.certificate.index_proved},
          {"radius", r.certificate.radius}}},
    };
    if (const auto count = r.motion.right_half_plane()) y["poles_right_half_plane"] = *count;
    return y;
}

std::string json(const Study& s) {
    const auto& paths = s.set.paths;
    Json out{
        {"data", s.data},
        {"parameters", Json::object()},
        {"seed", s.set.seed},
        {"bound", paths.total},
        {"finite", paths.finite},
        {"at_infinity", paths.at_infinity},
        {"singular", paths.singular},
        {"failed", paths.failed},
        {"complex_equilibria", s.set.distinct()},
        {"real", s.set.real()},
        {"by_index", s.set.by_index()},
        {"clean", s.set.clean()},
        {"morse", s.set.morse()},
        {"complete", s.proof.complete},
        {"reason", s.proof.reason},
        {"proved_bound", nullptr},
        {"proved_distinct", s.proof.distinct},
        {"proved_real", s.proof.real},
        {"equilibria", Json::array()},
        {"roots", Json::array()},
    };
    for (int k = 0; k < M::n_parameters; ++k) out["parameters"][parameter_names[k]] = s.set.parameters[k];
    if (s.proof.bound) out["proved_bound"] = s.proof.bound->value;
    for (const auto& row : s.rows) out["equilibria"].push_back(json_of(row));
    for (const auto& root : s.set.roots) out["roots"].push_back({pair_of(root.q[0]), pair_of(root.q[1])});
    if (s.sweep) {
        Json sweep{{"low", s.sweep->low},
                   {"high", s.sweep->high},
                   {"complete", s.sweep->complete()},
                   {"argument", s.sweep->argument()},
                   {"events", Json::array()},
                   {"intervals", Json::array()}};
        for (const auto& e : s.sweep->events)
            sweep["events"].push_back({{"c2", e.value},
                                       {"kind", to_string(e.kind)},
                                       {"angles", list_of(e.q)},
                                       {"null_vector", list_of(e.v)},
                                       {"change_by_index", e.change},
                                       {"residual", e.residual}});
        for (const auto& i : s.sweep->intervals)
            sweep["intervals"].push_back(
                {{"low", i.low}, {"high", i.high}, {"count", i.count}, {"by_index", i.by_index}, {"clean", i.clean}});
        out["sweep_c2"] = std::move(sweep);
    }
    return out.dump(2) + "\n";
}

/// Without a sign where twelve digits say 0.
double shown(double x) { return std::abs(x) < 5e-13 ? 0 : x; }

void print(const Study& s) {
    const auto& p = s.set.parameters;
    std::printf(
        "Holonomic mechanism, data of the %s: masses %g, %g, %g kg, g %g m/s^2, length %g m, c1 %g, c2 %.10g N/m, "
        "damping %g N s/m, force %g N\n\n",
        s.data.c_str(), p[M::mass_1], p[M::mass_2], p[M::mass_3], p[M::gravity], p[M::length], p[M::stiffness_1],
        p[M::stiffness_2], p[M::damping], p[M::force]);
    std::printf("Equilibria and their energy's Hessian C (Tables 1 and 2)\n");
    std::printf("        q1 [rad]        q2 [rad]         C11         C12         C22      det C  index\n");
    for (const auto& r : s.rows)
        std::printf("%16.12f%16.12f%12.6f%12.6f%12.6f%11.6g  %d, %s\n", shown(r.at.q[0]), shown(r.at.q[1]),
                    r.energy.hessian(0, 0), r.energy.hessian(0, 1), r.energy.hessian(1, 1), r.energy.minors[1],
                    r.at.index,
                    r.at.stable()    ? "stable"
                    : r.at.index > 0 ? "unstable"
                                     : "undecided");
    std::printf(
        "\nMotion about each: s^4 + a1 s^3 + a2 s^2 + a3 s + a4, Routh's first column, Hurwitz's minors, poles (Tables "
        "3 "
        "to 5)\n");
    for (const auto& r : s.rows) {
        const auto& m = r.motion;
        std::printf("(%.6f, %.6f)\n  a       %14.9g %14.9g %14.9g %14.9g\n", shown(r.at.q[0]), shown(r.at.q[1]),
                    m.polynomial[1], m.polynomial[2], m.polynomial[3], m.polynomial[4]);
        const auto column = m.routh.first_column().eval();
        std::printf("  Routh   %14.9g %14.9g %14.9g %14.9g\n", column[1], column[2], column[3], column[4]);
        for (const auto& special : m.routh.special)
            std::printf("          row %d: %s\n", special.row, to_string(special.kind));
        std::printf("  Hurwitz %14.9g %14.9g %14.9g %14.9g\n  poles  ", m.hurwitz.minors[0], m.hurwitz.minors[1],
                    m.hurwitz.minors[2], m.hurwitz.minors[3]);
        for (const auto& pole : m.poles)
            if (pole.imag() == 0)
                std::printf(" %.9g", pole.real());
            else if (pole.imag() > 0)
                std::printf(" %.9g +- %.9gi", pole.real(), pole.imag());
        const auto count = m.right_half_plane();
        std::printf("\n  %s of 4 on the right by poles, Routh and Hurwitz: %s\n",
                    count ? std::to_string(*count).c_str() : "THE CRITERIA DISAGREE: an unknown number",
                    to_string(m.verdict()));
    }
    std::printf("\n");
    const auto count = [](auto value) { return static_cast<unsigned long long>(value); };
    std::printf(
        "%llu paths: %llu finite, %llu at infinity, %llu singular, %llu failed; %llu complex equilibria, %llu real\n",
        count(s.set.paths.total), count(s.set.paths.finite), count(s.set.paths.at_infinity),
        count(s.set.paths.singular), count(s.set.paths.failed), count(s.set.distinct()), count(s.set.real()));
    for (const auto& root : s.set.roots)
        std::printf("  %.12f %+.12fi, %.12f %+.12fi\n", shown(root.q[0].real()), shown(root.q[0].imag()),
                    shown(root.q[1].real()), shown(root.q[1].imag()));
    std::printf("%s: %s.\n", s.proof.complete ? "PROVED COMPLETE" : "Not proved complete", s.proof.reason.c_str());
    if (!s.set.clean()) std::printf("NOT CLEAN: equilibria coincide, or some are missing.\n");
    if (!s.sweep) return;
    std::printf("\nEquilibria as c2 grows from %g to %g N/m\n", s.sweep->low, s.sweep->high);
    for (std::size_t k = 0; k < s.sweep->intervals.size(); ++k) {
        const auto& interval = s.sweep->intervals[k];
        std::printf("%18.12f to %18.12f: %llu equilibria, by index", interval.low, interval.high,
                    count(interval.count));
        for (const auto n : interval.by_index) std::printf(" %lld", static_cast<long long>(n));
        std::printf("\n");
        for (const auto& e : s.sweep->events)
            if (e.interval == k + 1)
                std::printf("%18.12f: %s at (%.9f, %.9f)\n", e.value, to_string(e.kind), shown(e.q[0]), shown(e.q[1]));
    }
    std::printf("%s: %s.\n", s.sweep->complete() ? "Complete" : "NOT COMPLETE", s.sweep->argument().c_str());
}

}  // namespace

int main(int argc, char** argv) {
    std::string seed_text = "1", sweep_text, json_name;
    CLI::App app{
        "Every equilibrium of the holonomic mechanism under a constant force, proved, with its stability by the "
        "theorem of "
        "Lagrange and Dirichlet, by Routh's and by Hurwitz's criterion, and by the poles of the linearised motion."};
    const support::MechanismOptions mechanism(app, "100", false);
    app.add_option("--seed", seed_text, "of the random start system, an integer (default 1)");
    app.add_option("--sweep-c2", sweep_text, "LOW:HIGH in N/m: also where the equilibria change as c2 grows");
    app.add_option("--json", json_name, "write JSON to this file, or to stdout for -, instead of tables");
    support::parse(app, "mechanism", argc, argv);
    try {
        const auto p = mechanism.parameters();
        equilibria::RunOptions options;
        options.seed = support::integer<std::uint64_t>("--seed", seed_text, 0, UINT64_MAX);
        std::optional<support::Range> sweep;
        if (app.count("--sweep-c2") > 0)
            sweep = support::range("--sweep-c2", sweep_text, "must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e9);
        std::optional<support::OutputFile> file;
        if (app.count("--json") > 0) file.emplace("--json", json_name);
        Study result = study(mechanism.data(), p, options);
        if (sweep) result.sweep = equilibria::find_events<M, M::stiffness_2>(p, sweep->low, sweep->high, options);
        if (file) file->write(json(result));
        if (!file || !file->to_stdout()) print(result);
    } catch (const std::exception& error) {
        support::fail("command line", "", error.what());
    }
}

// clang-format off
/* Refused:
--data seed
    mechanism: --data seed: must be paper or appendix
--masses 10,0,10
    mechanism: --masses 10,0,10: must be 3 positive numbers, with commas between
--masses 10,10
    mechanism: --masses 10,10: must be 3 positive numbers, with commas between
--length -1
    mechanism: --length -1: must be a positive number
--length 0
    mechanism: --length 0: must be a positive number
--c1 -1
    mechanism: --c1 -1: must be a number, 0 or more
--c2 nan
    mechanism: --c2 nan: must be a number, 0 or more
--damping -121
    mechanism: --damping -121: must be a number, 0 or more
--force strong
    mechanism: --force strong: must be a finite number
--gravity inf
    mechanism: --gravity inf: must be a finite number
--seed -1
    mechanism: --seed -1: must be an integer from 0 to 18446744073709551615
--sweep-c2 400:0
    mechanism: --sweep-c2 400:0: must be LOW:HIGH, finite, with 0 <= LOW < HIGH
--json missing/folder.json
    mechanism: --json missing/folder.json: cannot be written (No such file or directory); must be a file that can, or -
--decay 1
    mechanism: --decay: is not an option; --help lists them
*/
