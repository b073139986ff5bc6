// What single precision costs and saves: each system solved with it and in double alone, in turns, on one thread.
//
//   single_precision [--only REGEX] [--runs N] [--seed S] [--json]
//
// A line a system: paths tracked; with single precision the share that went on in double; with it/in double alone the
// paths that crossed, were tracked again, failed, and the steps a path; the times of tracking and of the whole solution
// with it over those in double, the least of N runs (7) or more, until a fifth of a second has gone; distinct roots;
// and `same` where each kind of end has as many paths and each root of the one is a root of the other, or what differs.
// Small systems have too few paths for lanes of floats: there both ways are one. The seed draws starts and random
// systems. Exits with 1 where a system differs.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <regex>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/core/lanes.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/start/linear_product.hpp>
#include <equilibria/start/solved_instance.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_either_strain.hpp>
#include <equilibria/system/critical_system.hpp>
#include <nlohmann/json.hpp>

#include "../support.hpp"

using namespace equilibria;
using json = nlohmann::ordered_json;

namespace {

/// A system that is solved for all its roots.
struct Solution {
    PathCounts paths;
    std::vector<Root<RuntimeUnknowns>> roots;
    double tracking_seconds = 0;
};
struct System {
    std::string name;
    int angles;  ///< of its unknowns; the others are plain coordinates
    std::function<Solution(const RunOptions&, const TrackerOptions&)> solve;
};

// --- the systems -----------------------------------------------------------------------------------------------------

template <class M>
Solution solution(const RootSet<M>& set) {
    Solution y{set.paths, {}, set.tracking_seconds};
    for (const auto& root : set.roots) {
        Root<RuntimeUnknowns> r{};
        r.q = RuntimeArray<std::complex<double>>(root.q.size());
        std::copy(root.q.begin(), root.q.end(), r.q.begin());
        r.path = root.path;
        r.status = root.status;
        y.roots.push_back(std::move(r));
    }
    return y;
}

template <RuntimeModel T>
System enumerated(std::string name, const T& model, RuntimeArray<double> p) {
    return {std::move(name), model.angles(), [=](const RunOptions& run, const TrackerOptions& tracker) {
                return solution(enumerate(model, p, run, tracker));
            }};
}
template <Model M, class Start = NaturalStart<M>>
System enumerated(std::string name, const Parameters<M>& p) {
    return {std::move(name), n_angles<M>, [=](const RunOptions& run, const TrackerOptions& tracker) {
                return solution(enumerate<M, Start>(p, run, tracker));
            }};
}
/// By a parameter homotopy from the roots at p0.
template <Model M, class Start = NaturalStart<M>>
System followed(std::string name, const Parameters<M>& p0, const Parameters<M>& p) {
    return {std::move(name), n_angles<M>,
            [=, solved = RootSet<M>{}](const RunOptions& run, const TrackerOptions& tracker) mutable {
                if (solved.roots.empty()) solved = enumerate<M, Start>(p0, run, {.single_precision = false});
                return solution(enumerate<M>(solved, p, run, tracker));
            }};
}

template <class Start>
Solution tracked(const SparseSystem& system, const Start& start, const RunOptions& run, const TrackerOptions& tracker) {
    const PolynomialHomotopy homotopy(system, start);
    PathSet paths = track(homotopy, start, run, tracker);
    const double seconds = paths.effort.tracking_seconds;
    auto found = complex_roots(std::move(paths));
    return {found.paths, std::move(found.roots), seconds};
}
/// From a linear product, as solve_multihomogeneous does, which gives no time of tracking.
Solution multihomogeneous(const SparseSystem& system, const std::vector<int>& grouping, const RunOptions& run,
                          const TrackerOptions& tracker) {
    Generator generator(run.seed), forms(run.seed);
    return tracked(system, LinearProduct(system, grouping, unit_complex(generator), forms), run, tracker);
}

RuntimeArray<double> numbers(const std::vector<double>& values) {
    RuntimeArray<double> y(static_cast<int>(values.size()));
    std::copy(values.begin(), values.end(), y.begin());
    return y;
}

System chain(int links) {
    const mechanisms::RuntimeRotatingChain model{links};
    std::vector<double> p;
    for (int i = 1; i <= links; ++i) p.push_back(1 + i / 10.0);
    for (int i = 1; i <= links; ++i) p.push_back(1 + i * i / 20.0);
    p.insert(p.end(), {1.7, 1});
    return enumerated("chain " + std::to_string(links), model, numbers(p));
}

/// Lengths, masses and speed at random, as the tests draw them.
System random_chain(int links, std::uint64_t seed) {
    Generator generator(seed);
    std::vector<double> p;
    for (int i = 0; i < links; ++i) p.push_back(uniform(generator, 0.4, 2.5));
    for (int i = 0; i < links; ++i) p.push_back(uniform(generator, 0.1, 2));
    p.insert(p.end(), {uniform(generator, 0.2, 4), 1});
    return enumerated("random chain " + std::to_string(links), mechanisms::RuntimeRotatingChain{links}, numbers(p));
}

/// Angles with couplings p[n i + j] and loads on cosines and sines, as CoupledAngles of the tests: most paths go to
/// infinity.
struct CoupledAngles {
    int n;
    int angles() const { return n; }
    int parameters() const { return n * n + 2 * n; }
    auto equations(const auto& theta, const auto& p) const {
        std::vector<scalar_of<decltype(theta)>> f(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) {
            auto& sum = f[static_cast<std::size_t>(i)];
            sum = p[n * n + 2 * i] * cos(theta[i]) + p[n * n + 2 * i + 1] * sin(theta[i]);
            for (int j = 0; j < n; ++j)
                if (j != i) sum += p[n * i + j] * sin(theta[i] - theta[j]);
        }
        return f;
    }
};
System coupled_angles(int n, bool neighbours, std::uint64_t seed) {
    Generator generator(seed);
    const CoupledAngles model{n};
    RuntimeArray<double> p(model.parameters());
    for (double& x : p) x = uniform(generator, 0.3, 1.3);
    for (int i = 0; neighbours && i < n; ++i)
        for (int j = 0; j < n; ++j)
            if (std::abs(i - j) > 1) p[n * i + j] = 0;
    return enumerated("coupled angles " + std::to_string(n) + (neighbours ? ", neighbours" : ""), model, p);
}

/// Equal angles, all coupled alike, with a load: most of their equilibria lie on families.
struct EqualAngles {
    int n;
    int angles() const { return n; }
    int parameters() const { return 2; }
    auto potential(const auto& theta, const auto& p) const {
        scalar_of<decltype(theta)> v{};
        for (int i = 0; i < n; ++i) {
            v -= p[1] * cos(theta[i]);
            for (int j = 0; j < i; ++j) v -= p[0] * cos(theta[i] - theta[j]);
        }
        return v;
    }
};

/// Phase-locked states of Kuramoto's oscillators, all coupled alike, against the last one: p_i = (K/n) sum_j
/// sin(theta_i - theta_j).
struct Kuramoto {
    int n;
    int angles() const { return n - 1; }
    int parameters() const { return n; }
    auto equations(const auto& theta, const auto& p) const {
        std::vector<scalar_of<decltype(theta)>> f(static_cast<std::size_t>(n - 1));
        for (int i = 0; i < n - 1; ++i) {
            auto& sum = f[static_cast<std::size_t>(i)];
            sum = p[i] - p[n - 1] / n * sin(theta[i]);
            for (int j = 0; j < n - 1; ++j)
                if (j != i) sum -= p[n - 1] / n * sin(theta[i] - theta[j]);
        }
        return f;
    }
};
System kuramoto(int oscillators) {
    RuntimeArray<double> p(oscillators);
    for (int i = 0; i < oscillators - 1; ++i) p[i] = 0.3 * std::sin(2.0 * i + 1);
    p[oscillators - 1] = 1.5;
    return enumerated("Kuramoto " + std::to_string(oscillators), Kuramoto{oscillators}, p);
}

/// Systems in coordinates alone.
struct Polynomials {
    int n;
    int angles() const { return 0; }
    int coordinates() const { return n; }
    int parameters() const { return 0; }
};
/// Katsura's field of a spin glass, as in bench/compile/katsura.cpp: 2^(n-1) solutions in n unknowns.
struct Katsura : Polynomials {
    auto equations(const auto&, const auto& u, const auto&) const {
        std::vector<scalar_of<decltype(u)>> f(static_cast<std::size_t>(n));
        const auto term = [&](int k) { return u[k < 0 ? -k : k]; };
        for (int m = 0; m < n - 1; ++m) {
            auto& sum = f[static_cast<std::size_t>(m)];
            sum = -1.0 * u[m];
            for (int i = 1 - n; i < n; ++i)
                if (std::abs(m - i) < n) sum += term(i) * term(m - i);
        }
        f.back() = u[0] - 1.0;
        for (int i = 1; i < n; ++i) f.back() += 2.0 * u[i];
        return f;
    }
};
/// Cyclic n-roots (Bjoerck, Froeberg 1991): sums of products of k neighbours vanish, the product of all is 1.
struct Cyclic : Polynomials {
    auto equations(const auto&, const auto& x, const auto&) const {
        std::vector<scalar_of<decltype(x)>> f(static_cast<std::size_t>(n));
        for (int k = 1; k <= n; ++k)
            for (int i = 0; i < (k < n ? n : 1); ++i) {
                auto product = 1.0 * x[i];
                for (int j = 1; j < k; ++j) product *= x[(i + j) % n];
                f[static_cast<std::size_t>(k - 1)] += product;
            }
        f.back() -= 1.0;
        return f;
    }
};
/// An economic model (Morgan, Solving polynomial systems using continuation, 1987, problem 5.5): 2^(n-2) solutions of
/// 2 3^(n-2) paths.
struct Economy : Polynomials {
    auto equations(const auto&, const auto& x, const auto&) const {
        std::vector<scalar_of<decltype(x)>> f(static_cast<std::size_t>(n));
        for (int k = 1; k < n; ++k) {
            auto sum = 1.0 * x[k - 1];
            for (int i = 1; i < n - k; ++i) sum += x[i - 1] * x[i + k - 1];
            f[static_cast<std::size_t>(k - 1)] = sum * x[n - 1] - double(k);
            f.back() += x[k - 1];
        }
        f.back() += 1.0;
        return f;
    }
};
template <class T>
System polynomials(const std::string& name, int unknowns) {
    return enumerated(name, T{{unknowns}}, RuntimeArray<double>(0));
}

using Beam = mechanisms::BodyBeamEitherStrain<1, mechanisms::BeamControl::speed>;
/// Of tests/studies/body_beam_solver_test.cpp. BodyBeamSolver hands no TrackerOptions on: here are the systems that it
/// solves, without more digits.
Parameters<Beam> body_beam(double speed) {
    Beam::Values p{2, 1.2, 1.3, 0.8, 0, 0, 0, 1, 1, 1.2, 100, speed};
    p[Beam::Base::coupling] = 1;
    p = Beam::units(p).scaled;
    p[Beam::Base::second_axis] = 1;
    return p;
}
Parameters<Beam> generic_body_beam(std::uint64_t seed) {
    Generator generator(seed);
    return Beam::generic(body_beam(6), generator);
}

/// The system of folds, cusps or extremal points of a model. find_events and trace_locus hand no TrackerOptions on:
/// here are the systems that they solve.
template <Model M>
class Critical {
public:
    Critical(std::string name, const Parameters<M>& p, std::vector<int> active, std::vector<double> scales,
             std::uint64_t seed)
        : name_(std::move(name)), system_(polynomials_of<M>(), active), p_(runtime_array(p)),
          scales_(std::move(scales)), seed_(seed) {}

    /// weigh(numbers): sets the weights of the last equation.
    System solved_for(const std::string& what, const auto& weigh) const {
        return {name_ + what, n_angles<M>,
                [system = system(weigh), grouping = system_.grouping()](const RunOptions& run,
                                                                        const TrackerOptions& tracker) {
                    return multihomogeneous(system, grouping, run, tracker);
                }};
    }
    System events() const {
        return solved_for("", [](auto&) {});
    }
    System line(double value) const { return solved_for(", line", slice(value)); }
    System cusps() const {
        return solved_for(", cusps", [](auto& numbers) { numbers.cusp = 1; });
    }
    System extremal(int which) const {
        return solved_for(which == 0 ? ", extremal x" : ", extremal y",
                          [which](auto& numbers) { numbers.extremal[which == 0 ? 1 : 0] = 1; });
    }
    /// The line at the value `to` from the folds of that at `from`.
    System next_line(double from, double to) const {
        return {
            name_ + ", next line", n_angles<M>,
            [from = system(slice(from)), to = system(slice(to)), grouping = system_.grouping(),
             points = SolvedInstance::Points()](const RunOptions& run, const TrackerOptions& tracker) mutable {
                if (points.empty())
                    for (const auto& root : multihomogeneous(from, grouping, run, {.single_precision = false}).roots)
                        if (root.status == PathStatus::finite && root.paths == 1) points.push_back(root.q);
                Generator generator(run.seed);
                return tracked(to, SolvedInstance(from, to, unit_complex(generator), points), run, tracker);
            }};
    }

private:
    static auto slice(double value) {
        return [value](auto& numbers) { numbers.slice = {1, 0, -value}; };
    }
    SparseSystem system(const auto& weigh) const {
        Generator generator(seed_);
        auto numbers = system_.numbers(p_, scales_, generator);
        weigh(numbers);
        return system_.system(numbers);
    }

    std::string name_;
    CriticalSystem system_;
    RuntimeArray<double> p_;
    std::vector<double> scales_;
    std::uint64_t seed_;
};

std::vector<System> systems(std::uint64_t seed) {
    using Two = mechanisms::TwoLinkChain;
    using Three = mechanisms::RotatingChain<3>;
    using Mechanism = mechanisms::HolonomicMechanism;
    std::vector<System> y;
    for (int n = 2; n <= 9; ++n) y.push_back(chain(n));
    for (int n = 4; n <= 7; ++n) y.push_back(random_chain(n, seed));
    for (const int links : {4, 6}) {
        auto p = [&]<int N>(std::integral_constant<int, N>) {
            auto moved = benchmark_chain<N>();
            moved[Chain<N>::omega] = 2.1;
            y.push_back(followed<Chain<N>>("chain " + std::to_string(N) + ", followed", benchmark_chain<N>(), moved));
        };
        links == 4 ? p(std::integral_constant<int, 4>()) : p(std::integral_constant<int, 6>());
    }
    for (const bool neighbours : {false, true})
        for (int n = 3; n <= 5; ++n) y.push_back(coupled_angles(n, neighbours, seed));
    for (int n = 3; n <= 4; ++n)
        y.push_back(enumerated("equal angles " + std::to_string(n), EqualAngles{n}, numbers({1, 0.7})));
    for (int n = 3; n <= 6; ++n) y.push_back(kuramoto(n));
    y.push_back(enumerated<Mechanism>("mechanism", Mechanism::paper_parameters(100)));
    for (int n = 5; n <= 8; ++n) y.push_back(polynomials<Katsura>("katsura-" + std::to_string(n), n + 1));
    for (int n = 5; n <= 6; ++n) y.push_back(polynomials<Cyclic>("cyclic-" + std::to_string(n), n));
    for (int n = 6; n <= 8; ++n) y.push_back(polynomials<Economy>("eco-" + std::to_string(n), n));
    y.push_back(enumerated<Beam, TotalDegree<Beam>>("body and beam, generic", generic_body_beam(seed)));
    y.push_back(followed<Beam, TotalDegree<Beam>>("body and beam, followed", generic_body_beam(seed), body_beam(6)));

    // those of bench/locus
    const Parameters<Three> three{1, 1.1, 1.2, 1, 1.05, 1.2, 1, 1};
    y.push_back(Critical<Two>("events of 2 links", {0.33, 1.5, 1}, {Two::omega}, {10}, seed).events());
    y.push_back(Critical<Three>("events of 3 links", three, {Three::omega}, {10}, seed).events());
    const auto plane = [&](const auto& critical) {
        for (auto system : {critical.line(0.4), critical.next_line(0.4, 0.7), critical.cusps(), critical.extremal(0),
                            critical.extremal(1)})
            y.push_back(std::move(system));
    };
    plane(Critical<Two>("plane of 2 links", {0.5, 1.5, 1}, {Two::alpha, Two::omega}, {1, 5}, seed));
    plane(Critical<Mechanism>("plane of the mechanism", Mechanism::paper_parameters(0),
                              {Mechanism::stiffness_2, Mechanism::force}, {600, 300}, seed));
    plane(Critical<Three>("plane of 3 links", three, {Three::mass + 2, Three::omega}, {2, 5}, seed));
    return y;
}

// --- the comparison --------------------------------------------------------------------------------------------------

/// Whether two roots are one, relative to 1 + |q|, angles modulo 2 pi.
bool same(const Root<RuntimeUnknowns>& a, const Root<RuntimeUnknowns>& b, int angles, double tolerance) {
    if (a.status != b.status) return false;
    for (int u = 0; u < a.q.size(); ++u) {
        std::complex<double> d = a.q[u] - b.q[u];
        if (u < angles) d.real(wrap(d.real()));
        if (!(std::abs(d) <= tolerance * (1 + std::abs(a.q[u])))) return false;
    }
    return true;
}
/// How many roots of `a` are none of `b`. A root is looked for where its path ended first, then everywhere.
std::size_t missing(const Solution& a, const Solution& b, int angles) {
    std::size_t count = 0;
    for (const auto& root : a.roots) {
        // a root of multiplicity m is known to the m-th root of rounding
        const double tolerance = root.status == PathStatus::finite ? 1e-8 : 1e-4;
        const auto is_root = [&](const auto& other) { return same(root, other, angles, tolerance); };
        const auto first = std::lower_bound(b.roots.begin(), b.roots.end(), root.path,
                                            [](const auto& other, std::uint64_t path) { return other.path < path; });
        if (first != b.roots.end() && is_root(*first)) continue;
        count += std::none_of(b.roots.begin(), b.roots.end(), is_root);
    }
    return count;
}
std::string difference(const Solution& single, const Solution& twofold, int angles) {
    std::string y;
    const auto count = [&](const char* what, std::uint64_t a, std::uint64_t b) {
        if (a == b) return;
        y += (y.empty() ? "" : ", ") + std::string(what) + " " + std::to_string(a) + "/" + std::to_string(b);
    };
    const PathCounts &a = single.paths, &b = twofold.paths;
    count("finite", a.finite, b.finite);
    count("at infinity", a.at_infinity, b.at_infinity);
    count("singular", a.singular, b.singular);
    count("failed", a.failed, b.failed);
    count("roots of one alone", missing(single, twofold, angles), 0);
    count("roots of the other alone", missing(twofold, single, angles), 0);
    return y.empty() ? "same" : y;
}

struct Least {
    double tracking = std::numeric_limits<double>::infinity(), whole = tracking;
};
Solution timed(const System& system, const RunOptions& run, const TrackerOptions& tracker, Least& least) {
    const equilibria::detail::Stopwatch watch;
    Solution found = system.solve(run, tracker);
    least.whole = std::min(least.whole, watch.seconds());
    least.tracking = std::min(least.tracking, found.tracking_seconds);
    return found;
}

json compared(const System& system, const RunOptions& run, int runs) {
    constexpr TrackerOptions with{}, without{.single_precision = false};
    const Solution single = system.solve(run, with), twofold = system.solve(run, without);
    Least of_single, of_double;
    const equilibria::detail::Stopwatch watch;
    for (int k = 0; k < runs || watch.seconds() < 0.2; ++k) {
        if (k % 2 == 0) timed(system, run, with, of_single);
        timed(system, run, without, of_double);
        if (k % 2 == 1) timed(system, run, with, of_single);
    }
    const PathCounts &a = single.paths, &b = twofold.paths;
    const auto per_path = [&](std::uint64_t n) { return static_cast<double>(n) / static_cast<double>(a.tracked); };
    const auto of = [&](std::uint64_t PathCounts::* count) { return json{{"single", a.*count}, {"double", b.*count}}; };
    return {{"system", system.name},
            {"paths", a.tracked},
            {"in_double", per_path(a.in_double)},
            {"crossed", of(&PathCounts::crossed)},
            {"retracked", of(&PathCounts::retracked)},
            {"failed", of(&PathCounts::failed)},
            {"steps_per_path", {{"single", per_path(a.steps)}, {"double", per_path(b.steps)}}},
            {"tracking_seconds", {{"single", of_single.tracking}, {"double", of_double.tracking}}},
            {"seconds", {{"single", of_single.whole}, {"double", of_double.whole}}},
            {"roots", {{"single", single.roots.size()}, {"double", twofold.roots.size()}}},
            {"verdict", difference(single, twofold, system.angles)}};
}

/// Single precision's number and double's, with so many digits after the point.
std::string both(const json& pair, int digits) {
    const auto text = [digits](double x) {
        char y[32];
        std::snprintf(y, sizeof y, "%.*f", digits, x);
        return std::string(y);
    };
    return text(pair["single"]) + "/" + text(pair["double"]);
}
void print(const json& row) {
    const auto milliseconds = [&](const char* key) { return 1e3 * row[key]["double"].get<double>(); };
    const auto ratio = [&](const char* key) {
        return row[key]["single"].get<double>() / row[key]["double"].get<double>();
    };
    std::printf("%-34s %6llu %9.4f %7s %9s %7s %13s %9.3f %9.3f %8.2f %6.2f %13s  %s\n",
                row["system"].get<std::string>().c_str(), row["paths"].get<unsigned long long>(),
                row["in_double"].get<double>(), both(row["crossed"], 0).c_str(), both(row["retracked"], 0).c_str(),
                both(row["failed"], 0).c_str(), both(row["steps_per_path"], 1).c_str(),
                milliseconds("tracking_seconds"), milliseconds("seconds"), ratio("tracking_seconds"), ratio("seconds"),
                both(row["roots"], 0).c_str(), row["verdict"].get<std::string>().c_str());
    std::fflush(stdout);
}
void print_head() {
    std::printf("%d doubles a register\n", native_lanes);
    std::printf("%-34s %6s %9s %7s %9s %7s %13s %19s %15s %13s\n", "", "", "", "", "", "", "", "ms in double",
                "single/double", "");
    std::printf("%-34s %6s %9s %7s %9s %7s %13s %9s %9s %8s %6s %13s\n", "system", "paths", "in_double", "crossed",
                "retracked", "failed", "steps a path", "tracking", "whole", "tracking", "whole", "roots");
}

int usage(const char* message) {
    std::fprintf(stderr, "single_precision: %s\nsingle_precision [--only REGEX] [--runs N] [--seed S] [--json]\n",
                 message);
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    std::regex only(".*");
    int runs = 7;
    RunOptions run;
    bool as_json = false;
    for (int k = 1; k < argc; ++k) {
        const std::string_view option = argv[k];
        if (option == "--json")
            as_json = true;
        else if (option == "--only" && k + 1 < argc)
            only = argv[++k];
        else if (option == "--runs" && k + 1 < argc && std::atoi(argv[k + 1]) > 0)
            runs = std::atoi(argv[++k]);
        else if (option == "--seed" && k + 1 < argc && std::atoi(argv[k + 1]) > 0)
            run.seed = static_cast<std::uint64_t>(std::atoi(argv[++k]));
        else
            return usage("needs known options with their values");
    }
    if (!as_json) print_head();
    json rows = json::array();
    bool all_same = true;
    for (const auto& system : systems(run.seed)) {
        if (!std::regex_search(system.name, only)) continue;
        rows.push_back(compared(system, run, runs));
        all_same = all_same && rows.back()["verdict"] == "same";
        if (!as_json) print(rows.back());
    }
    if (as_json)
        std::puts(json{{"doubles_a_register", native_lanes}, {"seed", run.seed}, {"systems", rows}}.dump(2).c_str());
    return all_same ? EXIT_SUCCESS : EXIT_FAILURE;
}
