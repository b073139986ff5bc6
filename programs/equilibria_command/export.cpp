// equilibria export
#include <cstdio>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>

#include <equilibria/io/polynomial_formats.hpp>
#include <equilibria/studies/formula_model/formula_searches.hpp>

#include "command.hpp"

namespace commands {

int export_polynomials(int argc, char** argv) {
    Command c;
    std::string format = "phcpack";
    std::optional<support::OutputFile> output;
    support::CommandLine app{
        "A model's equations as polynomials, for other solvers: c1, s1, c2, .. are the cosines and sines of the "
        "angles, "
        "with c1^2 + s1^2 - 1 and so on as further equations, x1, .. the coordinates."};
    app.add_option("FILE", c.file, "the model, as JSON").transform(support::name_of("a file"));
    app.add_option("--set", c.fixed, "NAME=VALUE, commas between: parameters other than as the file has them");
    app.add_option("--format", format, "phcpack (default), bertini, julia (HomotopyContinuation.jl) or macaulay2")
        .transform(support::one_of({"phcpack", "bertini", "julia", "macaulay2"},
                                   "must be phcpack, bertini, julia or macaulay2"));
    support::add_output(app, "--output", output, "write to this file, or to stdout for - (default)");
    app.parse("equilibria export", argc, argv);
    const Input input = read(c);
    const auto system = equilibria::polynomials_of(input.model, input.p);
    std::ostringstream text;
    if (format == "phcpack")
        equilibria::write_phcpack(text, system);
    else if (format == "bertini")
        equilibria::write_bertini(text, system);
    else if (format == "julia")
        equilibria::write_homotopy_continuation(text, system);
    else
        equilibria::write_macaulay2(text, system);
    if (output)
        output->write(text.str());
    else
        std::cout << text.str();
    return 0;
}

}  // namespace commands
