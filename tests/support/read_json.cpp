#include "support/read_json.hpp"

equilibria::Json tests::read_json(const std::string& text) { return equilibria::Json::parse(text); }
