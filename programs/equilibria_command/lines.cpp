// equilibria events, equilibria diagram
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>

#include <equilibria/io/results/diagram_output.hpp>
#include <equilibria/studies/formula_model/formula_searches.hpp>

#include "command.hpp"
#include "plots/model_diagram.hpp"
#include "support/axis_name.hpp"
#include "support/joined.hpp"
#include "support/pictures.hpp"

namespace commands {

namespace {

using Diagram = equilibria::BifurcationDiagram<equilibria::RuntimeUnknowns>;
using Event = equilibria::LineEvent<equilibria::RuntimeUnknowns>;

/// "2 come, 1 goes: +2 of index 0, -1 of index 1".
std::string comings(const Event& e) {
    std::ostringstream out;
    const auto number = [&](std::uint64_t n, const char* one, const char* more) {
        if (n > 0) out << (out.tellp() > 0 ? ", " : "") << n << ' ' << (n == 1 ? one : more);
    };
    number(e.at_infinity[1], "comes", "come");
    number(e.at_infinity[0], "goes", "go");
    const char* before = ": ";
    for (std::size_t k = 0; k < e.change.size(); ++k)
        if (e.change[k] != 0) {
            out << before << (e.change[k] > 0 ? "+" : "") << e.change[k] << " of index " << k;
            before = ", ";
        }
    return out.str();
}

void print(const FormulaModel& model, const Event& e) {
    std::printf("%-18.14g  %-24s", e.value + 0.0, std::string(equilibria::kind_name(e.kind)).c_str());
    if (e.kind == equilibria::CriticalKind::continuum)
        std::printf("  an equation vanishes identically");
    else if (e.kind == equilibria::CriticalKind::unexplained)
        std::printf("  the equilibria change, and it is not known how");
    else if (!e.has_equilibrium())
        std::printf("  %s", comings(e).c_str());
    else
        print_unknowns(model, e.q);
    std::printf("\n");
}

/// An angle's branch is turned as a whole into (-pi, pi], so that one at pi does not flicker between the edges.
double turned(const FormulaModel& model, int unknown, double middle) {
    if (unknown >= static_cast<int>(model.angles.size())) return 0;
    double turn = middle - std::remainder(middle, 2 * std::numbers::pi);
    if (std::abs(middle - turn + std::numbers::pi) < 1e-6) turn -= 2 * std::numbers::pi;
    return turn;
}

equilibria::GnuplotData plotted(const Input& input, const Varied& by, const Diagram& diagram) {
    equilibria::GnuplotData data;
    const auto names = unknowns(input.model);
    std::vector<std::string> labels;
    for (const std::string& name : names) labels.push_back(support::axis_name(name));
    data.string("heading", input.model.name.empty() ? "Equilibria" : "Equilibria: " + input.model.name);
    data.string("x_label", support::axis_name(by.name)).value("low", by.low).value("high", by.high);
    data.integer("unknowns", static_cast<long long>(names.size())).strings("labels", labels);
    data.integer("angles", static_cast<long long>(input.model.angles.size()));
    std::ostringstream stable, unstable, folds, others;
    for (auto* s : {&stable, &unstable, &folds, &others}) s->precision(10);
    for (const auto& piece : diagram.pieces) {
        std::ostringstream& rows = piece.index == 0 ? stable : unstable;
        const auto& middle = piece.points[piece.points.size() / 2].q;
        for (const auto& point : piece.points) {
            rows << point.parameter;
            for (int u = 0; u < middle.size(); ++u) rows << ' ' << point.q[u] - turned(input.model, u, middle[u]);
            rows << '\n';
        }
        rows << "\n\n";
    }
    for (const Event& e : diagram.events) {
        if (!e.has_equilibrium()) continue;
        std::ostringstream& rows = e.kind == equilibria::CriticalKind::fold ? folds : others;
        rows << e.value;
        for (int u = 0; u < e.q.size(); ++u)
            rows << ' '
                 << (u >= static_cast<int>(input.model.angles.size()) || e.q[u] > 3.1415
                         ? e.q[u]
                         : std::remainder(e.q[u], 2 * std::numbers::pi));
        rows << '\n';
    }
    const int columns = 1 + static_cast<int>(names.size());
    data.block("stable", stable.str(), columns).block("unstable", unstable.str(), columns);
    data.block("folds", folds.str(), columns).block("others", others.str(), columns);
    return data;
}

}  // namespace

int events(int argc, char** argv) {
    Command c;
    std::string vary;
    support::CommandLine app{
        "Every value of one parameter in a range at which equilibria are born, merge or change their index, and the "
        "numbers of equilibria by index between them."};
    c.add_to(app);
    app.add_option("--vary", vary, "NAME=LOW:HIGH, the parameter and its range");
    app.parse("equilibria events", argc, argv);
    const Input input = read(c);
    const Varied by = varied(input, "--vary", vary);

    StoppableRun run(c, "searching", StoppableRun::By::progress);
    const auto found = equilibria::find_events(input.model, input.p, by.parameter, {by.low, by.high}, run.options());
    run.end();
    if (c.json) c.json->write(document(input, by, found));
    if (!to_stdout(c.json)) {
        std::printf("%s; %s from %g to %g\n\n%-18s  %-24s", in_words(input).c_str(), by.name.c_str(), by.low, by.high,
                    by.name.c_str(), "event");
        print_names(input.model);
        std::printf("\n");
        std::size_t next = 0;
        for (std::size_t k = 0; k <= found.intervals.size(); ++k) {
            for (; next < found.events.size() && found.events[next].interval == k; ++next)
                print(input.model, found.events[next]);
            if (k == found.intervals.size()) break;
            const auto& gap = found.intervals[k];
            std::printf("    %llu equilibria, by index %s%s%s\n", static_cast<unsigned long long>(gap.count),
                        support::joined(gap.by_index).c_str(), gap.clean ? "" : ", NOT CLEAN",
                        gap.confirmed ? "" : ", NOT CONFIRMED: another table elsewhere in the interval");
        }
        std::printf("\n%s: %s.\n%.3g s\n", found.complete() ? "All events" : "NOT COMPLETE", found.argument().c_str(),
                    found.seconds);
    }
    return 0;
}

int diagram(int argc, char** argv) {
    Command c;
    std::string vary;
    std::optional<support::OutputFile> csv;
    support::Pictures pictures;
    support::CommandLine app{
        "All equilibria against one parameter: branches by their index, with every fold and "
        "bifurcation."};
    c.add_to(app);
    app.add_option("--vary", vary, "NAME=LOW:HIGH, the parameter and its range");
    support::add_output(app, "--csv", csv, "write a line for each point of a branch to this file, or to stdout for -");
    pictures.add_to(app, "the diagram");
    app.parse("equilibria diagram", argc, argv);
    const Input input = read(c);
    const Varied by = varied(input, "--vary", vary);

    StoppableRun run(c, "tracing", StoppableRun::By::progress);
    const Diagram found =
        equilibria::trace_diagram(input.model, input.p, by.parameter, {by.low, by.high}, run.options());
    run.end();
    if (pictures.asked()) {
        const int across = static_cast<int>(std::min<std::size_t>(3, unknowns(input.model).size())),
                  down = (static_cast<int>(unknowns(input.model).size()) + across - 1) / across;
        pictures.draw({120 + 430 * across, 130 + 400 * down}, plotted(input, by, found), plots::model_diagram);
    }
    if (csv) csv->write(equilibria::diagram_csv(found, by.name, sizes(input.model)).text());
    if (c.json) c.json->write(document(input, by, found));
    if (!to_stdout(c.json) && !to_stdout(csv)) {
        std::printf("%s; %s from %g to %g\n\n%-18s  %-24s", in_words(input).c_str(), by.name.c_str(), by.low, by.high,
                    by.name.c_str(), "event");
        print_names(input.model);
        std::printf("\n");
        for (const Event& e : found.events) print(input.model, e);
        for (const auto& piece : found.pieces)
            for (const int end : {0, 1})
                if (piece.ends[static_cast<std::size_t>(end)] == equilibria::PieceEnd::stopped) {
                    const auto& last = end == 0 ? piece.points.front() : piece.points.back();
                    std::printf("%-18.14g  %-24s", last.parameter, "NOT FOLLOWED FURTHER");
                    print_unknowns(input.model, last.q);
                    std::printf("\n");
                }
        std::printf("\n%s: %s.\n", found.complete() ? "All branches" : "NOT COMPLETE", found.argument().c_str());
    }
    return 0;
}

}  // namespace commands
