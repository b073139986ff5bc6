// What a parameter is called in a picture.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace support {

/// As gnuplot writes it: italic, and in Greek where the name says a letter; what follows _ or is a number at its end is
/// a subscript.
inline std::string axis_name(const std::string& name) {
    using Letter = std::pair<std::string_view, std::string_view>;
    constexpr std::array<Letter, 22> greek{
        {{"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"}, {"delta", "δ"},  {"epsilon", "ε"}, {"zeta", "ζ"},
         {"eta", "η"},   {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"},      {"nu", "ν"},
         {"xi", "ξ"},    {"rho", "ρ"},   {"sigma", "σ"}, {"tau", "τ"},    {"phi", "φ"},     {"chi", "χ"},
         {"psi", "ψ"},   {"omega", "ω"}, {"Omega", "Ω"}, {"Delta", "Δ"}}};
    const std::size_t line = std::min(name.find('_'), name.find_last_not_of("0123456789") + 1);
    std::string stem = name.substr(0, line), below = name.substr(std::min(line, name.size()));
    if (below.starts_with("_")) below.erase(0, 1);
    for (const auto& [word, letter] : greek)
        if (stem == word) stem = letter;
    std::replace(below.begin(), below.end(), '_', ' ');
    return "{/:Italic " + stem + "}" + (below.empty() ? "" : "_{" + below + "}");
}

}  // namespace support
