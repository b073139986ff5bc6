// equilibria sweep
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/io/read_text.hpp>
#include <equilibria/io/results/csv.hpp>
#include <equilibria/studies/formula_model/formula_searches.hpp>

#include "command.hpp"
#include "support/sweep_rows.hpp"

namespace commands {

int sweep(int argc, char** argv) {
    Command c;
    std::string grid, random, list, checkpoint;
    std::uint64_t points = 10000;
    bool proved = false;
    std::optional<support::OutputFile> csv;
    support::CommandLine app{
        "How many equilibria of each index a model has at the points of a grid, at random points or "
        "at those of a file, each followed from the roots of one generic member."};
    c.add_to(app);
    app.add_option("--grid", grid, "NAME=LOW:HIGH:COUNT, commas between: COUNT values of each, the last fastest");
    app.add_option("--random", random, "NAME=LOW:HIGH, commas between: --points points, uniform in the box");
    app.add_option("--points", points, "of --random, 1 to 1e12 (default 10000)")
        .transform(support::integer(std::uint64_t{1}, std::uint64_t{1000000000000}));
    app.add_option("--list", list, "points of this CSV file, whose first line names the parameters");
    app.add_flag("--prove", proved, "prove each root, that it is real or not, and its index");
    app.add_option("--checkpoint", checkpoint,
                   "keep what is finished in this file, and go on from it if it is there already");
    support::add_output(app, "--csv", csv,
                        "write a line for each point to this file, in their order, as they come; - is stdout");
    app.parse("equilibria sweep", argc, argv);
    const Input input = read(c);
    if (!grid.empty() + !random.empty() + !list.empty() != 1)
        support::fail("points", "", "one of --grid, --random and --list must be given");

    std::vector<equilibria::VariedParameter> axes;
    for (const std::string& part : split(grid.empty() ? random : grid, ',')) {
        std::string range = part;
        std::uint64_t count = 2;
        if (!grid.empty()) {
            const std::size_t colon = part.rfind(':');
            const auto n = colon == part.npos ? std::nullopt : support::parsed(part.substr(colon + 1));
            if (!n || !(*n >= 2 && *n <= 1e9 && *n == std::floor(*n)))
                support::fail("--grid", support::shown(part), "must be NAME=LOW:HIGH:COUNT, COUNT from 2 to 1e9");
            count = static_cast<std::uint64_t>(*n);
            range.erase(colon);
        }
        const Varied axis = varied(input, grid.empty() ? "--random" : "--grid", range);
        for (const auto& other : axes)
            if (other.parameter == axis.parameter)
                support::fail(grid.empty() ? "--random" : "--grid", axis.name, "must be named once");
        axes.push_back({axis.parameter, axis.low, axis.high, count});
    }
    const auto at = !list.empty() ? equilibria::listed_parameters(
                                        equilibria::read_text(list, std::size_t{1} << 32), input.p,
                                        [&](const std::string& name) {
                                            return equilibria::number_of_name(input.model.parameters, name, "--list");
                                        })
                    : grid.empty() ? equilibria::random_parameters(input.p, axes, points, c.seed)
                                   : equilibria::parameter_grid(input.p, axes);

    support::SweepRows rows(csv, input.model.parameters, input.model.unknowns());
    StoppableRun stoppable(c, "sweeping", StoppableRun::By::flag);
    equilibria::RunOptions run = stoppable.options();
    run.checkpoint = checkpoint;
    const auto counts = equilibria::sweep(input.model, at, [&](const equilibria::SweptPoint& p) { rows.add(p); }, run,
                                          {.prove = proved, .resort = equilibria::more_digits});
    rows.close();
    stoppable.end();
    if (counts.cancelled())
        return support::say_stopped("equilibria sweep", std::to_string(counts.done) + " of " +
                                                            std::to_string(counts.points) + " points are finished");
    if (c.json) {
        Json out = heading(input);
        equilibria::add_keys(out, support::sweep_json(counts));
        c.json->write(equilibria::json_text(out));
    }
    if (!to_stdout(c.json) && !to_stdout(csv)) std::cout << counts << '\n';
    return 0;
}

}  // namespace commands
