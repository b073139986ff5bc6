// What several commands of the engine read of a request.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <equilibria/formula/formula_model.hpp>
#include <equilibria/io/strict_json.hpp>
#include <equilibria/run/run_options.hpp>

#include "equilibria_command/documents.hpp"

namespace explorer {

using equilibria::detail::JsonPlace;

/// The parameter that the request varies under this key, of those named, and its range.
inline commands::Varied varied(const std::vector<std::string>& names, const JsonPlace& request, const char* key) {
    const JsonPlace range = request.at(key);
    range.keys("a range", {"name", "low", "high"});
    const std::string& name = range.at("name").string();
    const commands::Varied y{equilibria::number_of_name(names, name, key), name, range.at("low").number(),
                             range.at("high").number()};
    if (!(y.low < y.high)) range.refuse("must have low < high");
    return y;
}

/// Values by name that the request has under this key, put into values of all names.
template <class Values>
void set_values(const std::vector<std::string>& names, const JsonPlace& request, const char* key, Values& values) {
    if (const auto given = request.find(key))
        for (const auto& [name, value] : given->object().items())
            values[equilibria::number_of_name(names, name, key)] = given->at(name).number();
}

inline equilibria::RunOptions run_of(const JsonPlace& request) {
    equilibria::RunOptions run;
    if (const auto seed = request.find("seed")) {
        if (!seed->json().is_number_unsigned()) seed->refuse("must be an integer, 0 or more");
        run.seed = seed->json().get<std::uint64_t>();
    }
    return run;
}

}  // namespace explorer
