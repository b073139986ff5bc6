// Every equilibrium of the holonomic mechanism, real and complex, proved, with its stability by three criteria
// (docs/mechanism.md, Tables 1 to 5).
//
//   mechanism --force 100 --json mechanism.json
//   mechanism --data appendix --force 0
//   mechanism --force 0 --sweep-c2 0:400
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/io/results/line_events_output.hpp>
#include <equilibria/io/results/proof_output.hpp>
#include <equilibria/io/results/root_set_output.hpp>
#include <equilibria/io/results/stability_output.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/stability/lagrange_dirichlet.hpp>
#include <equilibria/stability/linearise.hpp>
#include <equilibria/stability/pole_count.hpp>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "support/mechanism_options.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"

namespace {

using M = equilibria::mechanisms::HolonomicMechanism;
using equilibria::Json;

const std::vector<std::string> parameter_names{"mass_1",      "mass_2",      "mass_3",  "gravity", "length",
                                               "stiffness_1", "stiffness_2", "damping", "force",   "decay"};

/// An equilibrium with all that the tables say of one.
struct Row {
    equilibria::Equilibrium<M> at;
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
        y.rows.push_back({e, equilibria::lagrange_dirichlet(system.stiffness), equilibria::count_poles(system)});
    }
    return y;
}

Json document(const Study& s) {
    Json out{{"data", s.data}};
    equilibria::add_keys(out, equilibria::json_of(s.set, {.parameter_names = parameter_names}));
    equilibria::add_proof(out, s.proof);
    for (std::size_t k = 0; k < s.rows.size(); ++k) {
        equilibria::add_keys(out["equilibria"][k], equilibria::json_of(s.rows[k].energy));
        equilibria::add_keys(out["equilibria"][k], equilibria::json_of(s.rows[k].motion));
    }
    equilibria::add_certificates(out["equilibria"], s.proof);
    // names of before
    out["bound"] = s.set.paths.total;
    out["complex_equilibria"] = s.set.distinct();
    if (s.sweep) out["sweep_c2"] = equilibria::json_of(*s.sweep, "c2");
    return out;
}

/// Without a sign where twelve digits say 0.
double shown(double x) { return std::abs(x) < 5e-13 ? 0 : x; }

unsigned long long count(std::uint64_t value) { return value; }

void print_equilibria(const Study& s) {
    std::printf("Equilibria and their energy's Hessian C (Tables 1 and 2)\n");
    std::printf("        q1 [rad]        q2 [rad]         C11         C12         C22      det C  index\n");
    for (const auto& r : s.rows)
        std::printf("%16.12f%16.12f%12.6f%12.6f%12.6f%11.6g  %d, %s\n", shown(r.at.q[0]), shown(r.at.q[1]),
                    r.energy.hessian(0, 0), r.energy.hessian(0, 1), r.energy.hessian(1, 1), r.energy.minors[1],
                    r.at.index,
                    r.at.stable()    ? "stable"
                    : r.at.index > 0 ? "unstable"
                                     : "undecided");
}

void print_motions(const Study& s) {
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
        const auto right = m.right_half_plane();
        std::printf("\n  %s of 4 on the right by poles, Routh and Hurwitz: %s\n",
                    right ? std::to_string(*right).c_str() : "THE CRITERIA DISAGREE: an unknown number",
                    to_string(m.verdict()));
    }
}

void print_sweep(const equilibria::LineEvents<M>& sweep) {
    std::printf("\nEquilibria as c2 grows from %g to %g N/m\n", sweep.range.low, sweep.range.high);
    for (std::size_t k = 0; k < sweep.intervals.size(); ++k) {
        const auto& interval = sweep.intervals[k];
        std::printf("%18.12f to %18.12f: %llu equilibria, by index", interval.low, interval.high,
                    count(interval.count));
        for (const auto n : interval.by_index) std::printf(" %lld", static_cast<long long>(n));
        std::printf("\n");
        for (const auto& e : sweep.events)
            if (e.interval == k + 1)
                std::printf("%18.12f: %s at (%.9f, %.9f)\n", e.value, to_string(e.kind), shown(e.q[0]), shown(e.q[1]));
    }
    std::printf("%s: %s.\n", sweep.complete() ? "Complete" : "NOT COMPLETE", sweep.argument().c_str());
}

void print(const Study& s) {
    const auto& p = s.set.parameters;
    std::printf(
        "Holonomic mechanism, data of the %s: masses %g, %g, %g kg, g %g m/s^2, length %g m, c1 %g, c2 %.10g N/m, "
        "damping %g N s/m, force %g N\n\n",
        s.data.c_str(), p[M::mass_1], p[M::mass_2], p[M::mass_3], p[M::gravity], p[M::length], p[M::stiffness_1],
        p[M::stiffness_2], p[M::damping], p[M::force]);
    print_equilibria(s);
    print_motions(s);
    std::printf("\n");
    std::printf(
        "%llu paths: %llu finite, %llu at infinity, %llu singular, %llu failed; %llu complex equilibria, %llu real\n",
        count(s.set.paths.total), count(s.set.paths.finite), count(s.set.paths.at_infinity),
        count(s.set.paths.singular), count(s.set.paths.failed), count(s.set.distinct()), count(s.set.real()));
    for (const auto& root : s.set.roots)
        std::printf("  %.12f %+.12fi, %.12f %+.12fi\n", shown(root.q[0].real()), shown(root.q[0].imag()),
                    shown(root.q[1].real()), shown(root.q[1].imag()));
    std::printf("%s: %s.\n", s.proof.complete ? "PROVED COMPLETE" : "Not proved complete", s.proof.reason.c_str());
    if (!s.set.clean()) std::printf("NOT CLEAN: equilibria coincide, or some are missing.\n");
    if (s.sweep) print_sweep(*s.sweep);
}

}  // namespace

int main(int argc, char** argv) {
    equilibria::RunOptions options;
    support::Range c2;
    std::optional<support::OutputFile> json;
    support::CommandLine app{
        "Every equilibrium of the holonomic mechanism under a constant force, proved, with its stability by the "
        "theorem of "
        "Lagrange and Dirichlet, by Routh's and by Hurwitz's criterion, and by the poles of the linearised motion."};
    const support::MechanismOptions mechanism(app, 100, false);
    app.add_seed(options.seed, "of the random start system, an integer (default 1)");
    app.add_option("--sweep-c2", c2, "LOW:HIGH in N/m: also where the equilibria change as c2 grows")
        .transform(support::range("must be LOW:HIGH, finite, with 0 <= LOW < HIGH", 0, 1e9));
    support::add_output(app, "--json", json, "write JSON to this file, or to stdout for -, instead of tables");
    app.parse("mechanism", argc, argv);
    try {
        const auto p = mechanism.parameters();
        Study result = study(mechanism.data(), p, options);
        if (app.given("--sweep-c2"))
            result.sweep = equilibria::find_events<M, M::stiffness_2>(p, {c2.low, c2.high}, options);
        if (json) json->write(equilibria::json_text(document(result)));
        if (!to_stdout(json)) print(result);
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
