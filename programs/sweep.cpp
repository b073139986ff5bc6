// How many equilibria a rotating chain has at many points of its parameter space: a table of counts for people, CSV and
// JSON for programs, a picture for two parameters.
//
//   sweep --grid alpha=0:1:201,omega=0:5:201 --locus --png counts.png
//   sweep --model chain --links 3 --random m3=0.1:2,omega=0.5:5 --points 100000 --csv points.csv --threads 0
//   mpirun -n 16 sweep --grid alpha=0:1:10001,omega=0:5:10001 --checkpoint sweep.ckpt
//
// The last when it is built with MPI (docs/scale.md).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/enumerate/sweep.hpp>
#include <equilibria/io/read_text.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "plots/sweep.hpp"
#include "support/axis_name.hpp"
#include "support/interrupt.hpp"
#include "support/locus_figure.hpp"
#include "support/options.hpp"
#include "support/output_file.hpp"
#include "support/pictures.hpp"
#include "support/progress_bar.hpp"
#include "support/ranks.hpp"
#include "support/sweep_rows.hpp"
#include "sweep/comparison.hpp"

namespace {

using equilibria::Json;
using equilibria::RuntimeArray;
using equilibria::SweptPoint;
using Chain = equilibria::mechanisms::TwoLinkChain;
using Locus = equilibria::Locus<Chain>;

/// Baillieul's two links, whose sizes are those of any model here.
struct TwoLinks {
    int angles() const { return 2; }
    int parameters() const { return Chain::n_parameters; }
    auto potential(const auto& theta, const auto& p) const { return Chain{}.potential(theta, p); }
};

/// What the command line says.
struct Command {
    std::string model = "two-links", fixed, grid, random, list;
    int links = 2;
    std::uint64_t points = 10000, seed = 1;
    unsigned threads = 1;
    bool prove = false, locus = false;
    std::string checkpoint;
    std::optional<support::OutputFile> csv, json;
    support::Pictures pictures;

    std::vector<std::string> names;  // of the parameters
    RuntimeArray<double> values;
    std::vector<equilibria::VariedParameter> axes;
};

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> y;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);) y.push_back(part);
    return y;
}

int number_of(const Command& c, const std::string& option, const std::string& name) {
    const auto at = std::find(c.names.begin(), c.names.end(), name);
    if (at != c.names.end()) return static_cast<int>(at - c.names.begin());
    std::string known;
    for (const auto& n : c.names) known += (known.empty() ? "" : ", ") + n;
    support::fail(option, name, "must name a parameter of the model: " + known);
}

/// "name=low:high" or "name=low:high:count", commas between.
void read_axes(Command& c, const std::string& option, const std::string& text, bool counts) {
    const std::string allowed =
        std::string("must be NAME=LOW:HIGH") + (counts ? ":COUNT" : "") + ", commas between, each parameter once";
    for (const std::string& part : split(text, ',')) {
        const std::size_t equal = part.find('=');
        if (equal == part.npos) support::fail(option, support::shown(part), allowed);
        const auto fields = split(part.substr(equal + 1), ':');
        if (fields.size() != (counts ? 3u : 2u)) support::fail(option, support::shown(part), allowed);
        const auto low = support::parsed(fields[0]), high = support::parsed(fields[1]);
        const auto count = counts ? support::parsed(fields[2]) : std::optional(2.0);
        if (!low || !high || !count || !std::isfinite(*low) || !std::isfinite(*high) || !(*low < *high) ||
            !(*count >= 2 && *count <= 1e9 && *count == std::floor(*count)))
            support::fail(option, support::shown(part), allowed + "; LOW < HIGH, COUNT from 2 to 1e9");
        const int parameter = number_of(c, option, part.substr(0, equal));
        for (const auto& axis : c.axes)
            if (axis.parameter == parameter) support::fail(option, support::shown(part), allowed);
        c.axes.push_back({parameter, *low, *high, static_cast<std::uint64_t>(*count)});
    }
    if (c.axes.empty()) support::fail(option, "''", allowed);
}

Command read(int argc, char** argv) {
    Command c;
    support::CommandLine app{
        "How many equilibria of each index a rotating chain has at the points of a grid, at random points or at those "
        "of "
        "a file, each followed from the roots of one generic chain."};
    app.add_option(
           "--model", c.model,
           "two-links (default): Baillieul's (3.2), parameters alpha, ratio, omega; or chain: l1, l2, .., m1, .., "
           "omega, gravity")
        .transform(support::one_of({"two-links", "chain"}, "must be two-links or chain"));
    app.add_option("--links", c.links, "of the chain, 1 to 8 (default 2)").transform(support::integer(1, 8));
    app.add_option("--set", c.fixed,
                   "NAME=VALUE, commas between: parameters that stay (default: ratio 1.5, omega 2, all "
                   "others 1, alpha 0.5)");
    app.add_option("--grid", c.grid, "NAME=LOW:HIGH:COUNT, commas between: COUNT values of each, the last fastest");
    app.add_option("--random", c.random, "NAME=LOW:HIGH, commas between: --points points, uniform in the box");
    app.add_option("--points", c.points, "of --random, 1 to 1e12 (default 10000)")
        .transform(support::integer(std::uint64_t{1}, std::uint64_t{1000000000000}));
    app.add_option("--list", c.list, "points of this CSV file, whose first line names the parameters");
    support::add_output(app, "--csv", c.csv,
                        "write a line for each point to this file, in their order, as they come; - is stdout");
    support::add_output(app, "--json", c.json, "write the counts to this file, or to stdout for -, instead of a table");
    c.pictures.add_to(app, "the numbers over a grid of two parameters");
    app.add_flag("--locus", c.locus,
                 "trace the folds and pitchforks in the plane of the grid (two-links, alpha and omega), draw them, and "
                 "compare each point's count with that of its region");
    app.add_flag("--prove", c.prove, "prove each root, that it is real or not, and its index");
    app.add_option("--checkpoint", c.checkpoint,
                   "keep what is finished in this file, and go on from it if it is there already; does not change the "
                   "result")
        .transform(support::name_of("a file"));
    app.add_seed(c.seed, "of the generic chain and of random points, an integer (default 1)");
    app.add_threads(c.threads, "1 to 1024, 0 for one each core (default 1); does not change the result");
    app.parse("sweep", argc, argv);

    if (c.model == "two-links") {
        c.names = {"alpha", "ratio", "omega"};
        c.values = RuntimeArray<double>{0.5, 1.5, 2};
    } else {
        for (const char* of : {"l", "m"})
            for (int k = 1; k <= c.links; ++k) c.names.push_back(of + std::to_string(k));
        c.names.insert(c.names.end(), {"omega", "gravity"});
        c.values = RuntimeArray<double>(2 * c.links + 2);
        for (double& value : c.values) value = 1;
        c.values[2 * c.links] = 2;
    }
    for (const std::string& part : split(c.fixed, ',')) {
        const std::size_t equal = part.find('=');
        const auto value = equal == part.npos ? std::nullopt : support::parsed(part.substr(equal + 1));
        if (!value || !std::isfinite(*value))
            support::fail("--set", support::shown(part), "must be NAME=VALUE, commas between, finite");
        c.values[number_of(c, "--set", part.substr(0, equal))] = *value;
    }
    if (static_cast<int>(app.given("--grid")) + app.given("--random") + app.given("--list") != 1)
        support::fail("points", "", "one of --grid, --random and --list must be given");
    if (app.given("--grid")) read_axes(c, "--grid", c.grid, true);
    if (app.given("--random")) read_axes(c, "--random", c.random, false);
    if (c.pictures.asked() && (!app.given("--grid") || c.axes.size() != 2))
        support::fail("--png, --svg", "", "need a --grid of two parameters");
    if (c.locus && (c.model != "two-links" || !app.given("--grid") || c.axes.size() != 2 ||
                    c.axes[0].parameter != Chain::alpha || c.axes[1].parameter != Chain::omega))
        support::fail("--locus", "", "needs --model two-links and --grid alpha=...,omega=...");
    return c;
}

equilibria::ParameterPoints points_of(const Command& c) {
    if (!c.grid.empty()) return equilibria::parameter_grid(c.values, c.axes);
    if (!c.random.empty()) return equilibria::random_parameters(c.values, c.axes, c.points, c.seed);
    return equilibria::listed_parameters(equilibria::read_text(c.list, std::size_t{1} << 32), c.values,
                                         [&](const std::string& name) { return number_of(c, "--list", name); });
}

struct Result {
    equilibria::SweepCounts counts;
    std::optional<Json> locus;
};

template <class T>
Result run(const Command& c, const T& model, const equilibria::Ranks& ranks) {
    const auto points = points_of(c);
    std::optional<Locus> locus;
    if (c.locus)  // at each rank: what goes wrong there goes wrong at all
        locus = equilibria::trace_locus<Chain, Chain::alpha, Chain::omega>(
            {0.5, c.values[Chain::ratio], 1}, {{c.axes[0].low, c.axes[0].high}, {c.axes[1].low, c.axes[1].high}},
            {.seed = c.seed, .executor = equilibria::threads(c.threads)},
            // short chords: points may lie next to a curve
            {.lines = 12, .branch = {.first_step = 1e-4, .largest_step = 1e-3, .largest_angle = 0.02}});
    std::optional<sweeps::Comparison> comparison;
    if (locus) comparison.emplace(*locus);
    std::optional<support::SweepRows> rows;
    if (ranks.first()) rows.emplace(c.csv, c.names, model.angles());
    std::ostringstream drawn;
    support::ProgressBar bar("sweeping");
    Result y;
    y.counts = equilibria::sweep(model, points,
                                 [&](const SweptPoint& p) {
                                     rows->add(p);
                                     if (comparison) comparison->add(p);
                                     if (!c.pictures.asked()) return;
                                     drawn << p.parameters[c.axes[0].parameter] << ' '
                                           << p.parameters[c.axes[1].parameter] << ' '
                                           << (p.vanishing_equation ? -1 : static_cast<int>(p.real)) << '\n';
                                 },
                                 {.seed = c.seed,
                                  .executor = equilibria::threads(c.threads),
                                  .ranks = ranks,
                                  .progress = [&](std::uint64_t done, std::uint64_t all) { bar.update(done, all); },
                                  .checkpoint = c.checkpoint,
                                  .cancel = &support::cancelled_by_signal()},
                                 {.prove = c.prove, .resort = equilibria::more_digits});
    if (!ranks.first()) return y;
    rows->close();
    if (comparison) y.locus = comparison->json();
    if (c.pictures.asked() && !y.counts.cancelled()) {
        equilibria::GnuplotData data;
        const auto half = [&](std::size_t axis) {
            const auto& a = c.axes[axis];
            return 0.5 * (a.high - a.low) / static_cast<double>(a.count - 1);
        };
        data.block("points", drawn.str(), 3);
        data.value("x_low", c.axes[0].low - half(0)).value("x_high", c.axes[0].high + half(0));
        data.value("y_low", c.axes[1].low - half(1)).value("y_high", c.axes[1].high + half(1));
        data.string("x_name", support::axis_name(c.names[static_cast<std::size_t>(c.axes[0].parameter)]));
        data.string("y_name", support::axis_name(c.names[static_cast<std::size_t>(c.axes[1].parameter)]));
        const auto& by_real = y.counts.by_real;
        std::string counts = " ";
        for (const auto& [real, points_there] : by_real) counts += std::to_string(real) + " ";
        data.string("counts", counts);
        data.integer("most", by_real.empty() ? 0 : static_cast<long long>(by_real.rbegin()->first));
        data.integer("least", by_real.empty() ? 0 : static_cast<long long>(by_real.begin()->first));
        if (locus)
            support::add_locus(data, *locus);
        else
            data.block("folds", "").block("pitchforks", "").block("cusps", "");
        c.pictures.draw({940, 680}, data, plots::sweep);
    }
    return y;
}

Json document(const Command& c, const Result& r) {
    Json out{{"model", c.model}, {"seed", c.seed}, {"threads", c.threads}};
    equilibria::add_keys(out, support::sweep_json(r.counts));
    if (r.locus) out["locus"] = *r.locus;
    return out;
}

void print(const Command& c, const Result& r) {
    std::cout << r.counts << '\n';
    if (r.locus)
        std::printf(
            "Regions of the traced locus: %llu points agree, %llu cannot be compared, %llu differ, at most %.1e of the "
            "window from a curve\n",
            (*r.locus)["agree"].get<unsigned long long>(), (*r.locus)["not_compared"].get<unsigned long long>(),
            (*r.locus)["differ"].get<unsigned long long>(), (*r.locus)["farthest_from_a_curve"].get<double>());
    if (c.prove) std::printf("At %llu points all roots are proved\n", static_cast<unsigned long long>(r.counts.proved));
    std::printf("%.3g s, %.0f points a second\n", r.counts.seconds,
                static_cast<double>(r.counts.done) / std::max(r.counts.seconds, 1e-9));
}

}  // namespace

int main(int argc, char** argv) {
    const auto ranks = support::ranks(&argc, &argv);
    const Command c = read(argc, argv);
    try {
        const Result result = c.model == "two-links"
                                  ? run(c, TwoLinks{}, ranks)
                                  : run(c, equilibria::mechanisms::RuntimeRotatingChain{c.links}, ranks);
        if (!ranks.first()) return 0;
        if (result.counts.cancelled()) {
            std::fprintf(stderr, "sweep: interrupted, %llu of %llu points are finished; %s\n",
                         static_cast<unsigned long long>(result.counts.done),
                         static_cast<unsigned long long>(result.counts.points),
                         c.checkpoint.empty() ? "--checkpoint FILE would have kept them"
                                              : ("the same command goes on from " + c.checkpoint).c_str());
            return 130;
        }
        if (c.json) c.json->write(equilibria::json_text(document(c, result)));
        if (!to_stdout(c.json) && !to_stdout(c.csv)) print(c, result);
    } catch (const equilibria::CheckpointError& error) {
        support::fail("--checkpoint", c.checkpoint, error.wrong());
    } catch (const std::exception& error) {
        support::fail("command line", "", error.what());
    }
}

// clang-format off
/* Refused:
--model pendulum
    sweep: --model pendulum: must be two-links or chain
--seed 1
    sweep: points: one of --grid, --random and --list must be given
--grid alpha=0:1:10 --random omega=0:1
    sweep: points: one of --grid, --random and --list must be given
--grid alpha=0:1
    sweep: --grid alpha=0:1: must be NAME=LOW:HIGH:COUNT, commas between, each parameter once
--grid alpha=1:0:10
    sweep: --grid alpha=1:0:10: must be NAME=LOW:HIGH:COUNT, commas between, each parameter once; LOW < HIGH, COUNT from 2 to 1e9
--grid beta=0:1:10
    sweep: --grid beta: must name a parameter of the model: alpha, ratio, omega
--grid alpha=0:1:10 --set ratio=fast
    sweep: --set ratio=fast: must be NAME=VALUE, commas between, finite
--grid alpha=0:1:10 --png picture.png
    sweep: --png, --svg: need a --grid of two parameters
--random alpha=0:1 --points 0
    sweep: --points 0: must be an integer from 1 to 1000000000000
--model chain --links 9 --random omega=1:2
    sweep: --links 9: must be an integer from 1 to 8
--model chain --grid omega=1:2:3,m1=1:2:3 --locus
    sweep: --locus: needs --model two-links and --grid alpha=...,omega=...
*/
