// A shallow gridshell of beams under its nodes' loads, from rest through its first critical point. Arguments: bays
// along an edge, 1e5 degrees of freedom with 129 and 1e6 with 409, threads of assembly, and what factors: 0 SparseLDLT,
// where they are installed 1 MUMPS, 2 SparseLDLT ordered by METIS, 3 CHOLMOD. Counters: unknowns, entries of the
// factors, shares of a step's time, and the peak of the process's memory in GiB, which is that of all that ran before
// as well.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <chrono>
#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>
#ifdef EQUILIBRIA_WITH_MUMPS
#include <equilibria/continuation/factorization/mumps.hpp>
#endif
#ifdef EQUILIBRIA_WITH_METIS
#include <equilibria/continuation/factorization/nested_dissection.hpp>
#endif
#ifdef EQUILIBRIA_WITH_CHOLMOD
#include <equilibria/continuation/factorization/cholmod.hpp>
#endif
#include <equilibria/fem/mesh.hpp>
#include <equilibria/fem/structure.hpp>

using namespace equilibria;
using namespace equilibria::fem;

namespace {

/// Square bays of edge 1 with one diagonal each, on a paraboloid whose rise is an eighth of the span; hinged along its
/// boundary.
Structure gridshell(int bays, unsigned threads, MakeSymmetricFactors factors) {
    Model model;
    const auto height = [&](int i, int j) {
        const double x = 2.0 * i / bays - 1, y = 2.0 * j / bays - 1;
        return bays / 8.0 * (1 - x * x) * (1 - y * y);
    };
    for (int j = 0; j <= bays; ++j)
        for (int i = 0; i <= bays; ++i) {
            const int node = model.add_node({double(i), double(j), height(i, j)});
            if (i == 0 || j == 0 || i == bays || j == bays)
                model.fix(node, positions);
            else
                model.load(node, {0, 0, -1});
        }
    const auto node = [&](int i, int j) { return j * (bays + 1) + i; };
    const Section section{1000, 400, 400, 8, 10, 10};
    const auto beam = [&](int a, int b) {
        const Eigen::Vector3d axis = model.at(b) - model.at(a);
        model.add(Beam<2>(section, {section_frame(model.at(a), axis, Eigen::Vector3d::UnitZ()),
                                    section_frame(model.at(b), axis, Eigen::Vector3d::UnitZ())}),
                  {a, b});
    };
    for (int j = 0; j <= bays; ++j)
        for (int i = 0; i <= bays; ++i) {
            if (i < bays) beam(node(i, j), node(i + 1, j));
            if (j < bays) beam(node(i, j), node(i, j + 1));
            if (i < bays && j < bays) beam(node(i, j), node(i + 1, j + 1));
        }
    return Structure(std::move(model), {.executor = equilibria::threads(threads), .factors = factors});
}

/// Null where it is not installed.
MakeSymmetricFactors back_end(std::int64_t number) {
    if (number == 0) return sparse_ldlt;
#ifdef EQUILIBRIA_WITH_MUMPS
    if (number == 1) return mumps;
#endif
#ifdef EQUILIBRIA_WITH_METIS
    if (number == 2) return sparse_ldlt_by_nested_dissection;
#endif
#ifdef EQUILIBRIA_WITH_CHOLMOD
    if (number == 3) return cholmod;
#endif
    return nullptr;
}

double seconds(const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void first_critical_point(benchmark::State& state) {
    const MakeSymmetricFactors make = back_end(state.range(2));
    if (!make) return state.SkipWithError("built without this library");
    const Structure shell = gridshell(static_cast<int>(state.range(0)), static_cast<unsigned>(state.range(1)), make);
    BranchOptions options;
    options.first_step = 0.002;
    options.largest_step = 0.02;
    options.most_sign_changes = 16;  // of a million unknowns several critical points are next to each other
    std::size_t points = 0;
    double critical = 0, total = 0;
    int kind = -1;
    for (auto _ : state) {
        BranchStepper<Structure> stepper(shell, options);
        EventFinder<Structure> finder(stepper);
        auto at = stepper.start(shell.initial(), 0, 1);
        if (!at) return state.SkipWithError("no start");
        for (points = 0; kind < 0 && points < 200; ++points) {
            std::optional<BranchPoint<Structure>> next;
            total += seconds([&] { next = stepper.advance(*at); });
            if (!next) return state.SkipWithError("the branch was lost");
            const auto events = finder.between(*at, *next);
            if (!events.points.empty()) {
                kind = static_cast<int>(events.points[0].kind);
                critical = events.points[0].p;
            }
            at = std::move(next);
        }
    }
    const auto q = shell.initial();
    Eigen::SparseMatrix<double> k;
    const auto factors = make(0);
    factors->factor(shell.tangent(q, 0));
    const double assembly = seconds([&] { k = shell.tangent(q, 0); }),
                 factorization = seconds([&] { factors->factor(k); });
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["unknowns"] = shell.size();
    state.counters["factor_entries"] = static_cast<double>(factors->fill());
    state.counters["steps"] = static_cast<double>(points);
    state.counters["seconds_a_step"] = total / static_cast<double>(points);
    state.counters["assembly_s"] = assembly;
    state.counters["factorization_s"] = factorization;
    state.counters["critical_load"] = critical;
    state.counters["kind"] = kind;  // of CriticalKind
    state.counters["peak_GiB"] = static_cast<double>(usage.ru_maxrss) / (1 << 20);
}

}  // namespace

BENCHMARK(first_critical_point)
    ->Args({16, 1, 0})
    ->Args({64, 1, 0})
    ->Args({64, 1, 1})
    ->Args({64, 1, 2})
    ->Args({64, 1, 3})
    ->Args({129, 1, 0})
    ->Args({129, 1, 1})
    ->Args({129, 1, 2})
    ->Args({129, 1, 3})
    ->Args({129, 2, 1})
    ->Args({409, 1, 0})
    ->Args({409, 1, 2})
    ->Unit(benchmark::kSecond)
    ->Iterations(1);
