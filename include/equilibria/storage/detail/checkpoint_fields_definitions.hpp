/// \file
/// See storage/checkpoint_fields.hpp.
#pragma once

#include <algorithm>

#include <equilibria/core/error.hpp>
#include <equilibria/storage/checkpoint_fields.hpp>
#include <equilibria/storage/fingerprint.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE std::string text_of(const CheckpointFields& fields) {
    std::string y;
    for (const CheckpointField& f : fields) {
        y += f.name;
        y += ": ";
        y += f.value;
        y += '\n';
    }
    return y;
}

EQUILIBRIA_INLINE CheckpointFields fields_of(const std::string& text) {
    CheckpointFields found;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        const std::size_t colon = std::min(line.find(": "), line.size());
        found.push_back({line.substr(0, colon), line.substr(std::min(colon + 2, line.size()))});
        at = end + 1;
    }
    return found;
}

EQUILIBRIA_INLINE std::string differences(const CheckpointFields& theirs, const CheckpointFields& here,
                                          const std::string& ours) {
    const auto value = [](const CheckpointFields& of, const std::string& name) -> std::string {
        for (const CheckpointField& f : of)
            if (f.name == name) return f.value;
        return "nothing";
    };
    std::string text;
    int number = 0;
    const auto compare = [&](const std::string& name) {
        const std::string a = value(theirs, name), b = value(here, name);
        if (a == b || ++number > 3) return;
        text += (text.empty() ? "its " : "; its ") + name + " is " + a + ", " + ours + " is " + b;
    };
    for (const CheckpointField& f : here) compare(f.name);
    for (const CheckpointField& f : theirs)
        if (std::none_of(here.begin(), here.end(), [&](const CheckpointField& g) { return g.name == f.name; }))
            compare(f.name);
    if (number > 3) text += "; " + std::to_string(number - 3) + " more differ";
    return text;
}

EQUILIBRIA_INLINE CheckpointFields model_fields(const std::string& name, const RuntimeSizes& sizes, int terms,
                                                const std::vector<std::uint64_t>& support,
                                                std::span<const double> parameters, const std::string& build) {
    Fingerprint sum;
    for (const std::uint64_t word : support) sum(word);
    CheckpointFields fields{
        {"model", name + " (" + std::to_string(sizes.angles) + " angles, " + std::to_string(sizes.coordinates) +
                      " coordinates, " + std::to_string(terms) + " terms, support " + sum.text() + ")"},
        {"model's build", build}};
    int k = 0;
    for (const double value : parameters) fields.push_back({"parameters[" + std::to_string(k++) + "]", to_text(value)});
    return fields;
}

}  // namespace equilibria::detail
