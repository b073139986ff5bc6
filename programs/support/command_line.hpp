// CLI11 with this project's manners: --help ends with status 0, any mistake with one line and status 2. Options come as
// text, so that numbers.hpp can quote them as they were written.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "fail.hpp"

namespace support {

inline void parse(CLI::App& app, const std::string& name, int argc, char** argv) {
    program = name;
    app.name(name);
    app.allow_extras();
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        std::exit(0);
    } catch (const CLI::ArgumentMismatch& error) {
        // CLI11's texts begin with the option's name
        const std::string text = error.what(), option = text.substr(0, text.find(':'));
        const bool known = option.starts_with("--") && app.get_option_no_throw(option) != nullptr;
        if (!known) fail("command line", "", text);
        if (app.get_option(option)->count() > 1) fail(option, "", "must be given once only");
        fail(option, "", "must be followed by a value");
    } catch (const CLI::ParseError& error) {
        fail("command line", "", error.what());
    }
    if (const auto rest = app.remaining(); !rest.empty()) fail(rest.front(), "", "is not an option; --help lists them");
}

}  // namespace support
