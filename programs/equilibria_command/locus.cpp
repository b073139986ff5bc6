// equilibria locus
#include <cstdio>
#include <string>

#include <equilibria/io/results/singular_point_output.hpp>

#include "command.hpp"
#include "plots/bifurcation_locus.hpp"
#include "support/axis_name.hpp"
#include "support/joined.hpp"
#include "support/locus_figure.hpp"
#include "support/pictures.hpp"

namespace commands {

int locus(int argc, char** argv) {
    Command c;
    std::string x, y;
    equilibria::LocusOptions options;
    options.lines = locus_lines;
    support::Pictures pictures;
    support::CommandLine app{
        "Folds, pitchforks and cusps of a model in the plane of two of its parameters, and the regions between them "
        "with "
        "their equilibria by index."};
    c.add_to(app);
    app.add_option("--x", x, "NAME=LOW:HIGH, the first parameter and its range");
    app.add_option("--y", y, "NAME=LOW:HIGH, the second parameter and its range");
    app.add_option("--lines", options.lines,
                   "lines in each direction that are solved for seeds, 2 to 1000 (default 12)")
        .transform(support::integer(2, 1000));
    pictures.add_to(app, "the locus");
    app.parse("equilibria locus", argc, argv);
    const Input input = read(c);
    const Varied across = varied(input, "--x", x), up = varied(input, "--y", y);
    if (across.parameter == up.parameter) support::fail("--y", y, "must be another parameter than that of --x");

    StoppableRun run(c, "tracing", StoppableRun::By::progress);
    const auto found = equilibria::trace_locus(input.model, input.p, {across.parameter, up.parameter},
                                               {{across.low, across.high}, {up.low, up.high}}, run.options(), options);
    run.end();
    if (pictures.asked())
        pictures.draw({1000, 760},
                      support::locus_figure(
                          found, {.heading = input.model.name.empty() ? "Bifurcation locus"
                                                                      : "Bifurcation locus: " + input.model.name,
                                  .x = support::axis_name(across.name),
                                  .y = support::axis_name(up.name)}),
                      plots::bifurcation_locus);
    if (c.json) c.json->write(document(input, across, up, found));
    if (to_stdout(c.json)) return 0;
    std::printf("%s\n\n", in_words(input).c_str());
    const auto point = [&](const char* kind, const auto& at) {
        std::printf("%-20s  %s %.14g  %s %.14g ", kind, across.name.c_str(), at.x(), up.name.c_str(), at.y());
        print_unknowns(input.model, at.q);
        std::printf("\n");
    };
    for (const auto& at : found.of(equilibria::SingularityKind::cusp)) point("cusp", at);
    for (const auto& at : found.of(equilibria::SingularityKind::tricritical_pitchfork))
        point("degenerate pitchfork", at);
    for (const auto& curve : found.curves)
        std::printf("%-20s  %4zu points  (%.6f, %.6f) to (%.6f, %.6f)\n",
                    std::string(equilibria::kind_name(curve.kind)).c_str(), curve.points.size(),
                    curve.points.front().x(), curve.points.front().y(), curve.points.back().x(),
                    curve.points.back().y());
    for (const auto& curve : found.from_infinity)
        std::printf("%-20s  %4zu points  (%.6f, %.6f) to (%.6f, %.6f)\n", "from infinity", curve.points.size(),
                    curve.points.front().x, curve.points.front().y, curve.points.back().x, curve.points.back().y);
    for (const auto& r : found.regions)
        std::printf("region  %2llu equilibria, by index %s  around (%.4f, %.4f)%s\n",
                    static_cast<unsigned long long>(r.count), support::joined(r.by_index).c_str(), r.point.x, r.point.y,
                    r.clean && r.confirmed ? "" : "  NOT CONFIRMED");
    std::printf("%s\nargument: %s\n%.2f s\n", found.evidence.complete() ? "all explained" : "NOT ALL EXPLAINED",
                found.evidence.argument().c_str(), found.evidence.seconds);
    return 0;
}

}  // namespace commands
