#pragma once

#include <string>

#include <equilibria/io/results/json.hpp>

namespace tests {

/// A document from its text; Json's own parser, compiled once for all tests.
equilibria::Json read_json(const std::string& text);

}  // namespace tests
