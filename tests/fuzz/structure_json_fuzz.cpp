// Any bytes for a structure: one that can be built as it says, within the limits, or an InvalidArgument that names its
// place. Half of the inputs are changed as JSON, so that they come further than its syntax.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <equilibria/io/structure/structure_json.hpp>

using namespace equilibria;
using namespace equilibria::fem;

namespace {

void require_that(bool holds) {
    if (!holds) std::abort();
}

constexpr int most_elements = 24;

template <bool Conservative>
void check(const BasicStructure<Conservative>& structure) {
    const StructureState start = structure.initial();
    require_that(structure.size() > 0 && structure.residual(start, 0).allFinite());
    require_that(structure.tangent(start, 0).coeffs().allFinite());
}

using equilibria::detail::Json;

void collect(Json& value, std::vector<Json*>& all) {
    all.push_back(&value);
    if (value.is_structured())
        for (Json& part : value) collect(part, all);
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    std::minstd_rand random(seed);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    Json root = Json::parse(data, data + size, nullptr, false);
    if (below(2) == 0 || root.is_discarded()) return LLVMFuzzerMutate(data, size, most);
    std::vector<Json*> all;
    collect(root, all);
    Json& value = *all[below(all.size())];
    const Json other = *all[below(all.size())];
    constexpr double numbers[] = {0,     1,     -1,     2,      0.5,    1e-6,    1e6,        1e-9,
                                  1e100, 1e154, 1e-154, 1e-160, 5e-324, 1.7e308, 3.14159265, 1e-16};
    switch (below(5)) {
        case 0: value = other; break;
        case 1: value = (below(2) == 0 ? 1 : -1) * numbers[below(std::size(numbers))]; break;
        case 2:
            if (value.is_number()) value = value.get<double>() * (1 + numbers[below(std::size(numbers))]);
            break;
        case 3:
            if (value.is_array()) value.push_back(other);
            break;
        default:
            if (value.is_structured() && !value.empty())
                value.erase(std::next(value.begin(), static_cast<std::ptrdiff_t>(below(value.size()))));
    }
    const std::string text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::copy(text.begin(), text.end(), data);
    return text.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const ParseLimits limits{.bytes = 1 << 14, .elements = most_elements, .constraints = 200};
    StructureInput input;
    try {
        input = parse_structure(text, limits);
    } catch (const InvalidArgument& e) {
        const std::string_view what = e.what();
        require_that(what.find(" = ") != what.npos && what.find(": ") != what.npos && what.size() < 2000);
        return 0;
    }
    const Model& model = input.model;
    require_that(!input.nodes.empty() && input.low < input.high);
    require_that(input.measured >= 0 && input.measured < static_cast<int>(input.nodes.size()));
    for (int k = 0; k < model.nodes(); ++k) require_that(model.at(k).allFinite());
    for (const auto& [name, node] : input.nodes) require_that(node >= 0 && node < static_cast<int>(input.nodes.size()));
    std::size_t elements = 0;
    for (const auto& group : model.groups()) elements += group->size();
    require_that(elements >= 1 && elements <= most_elements);
    if (input.conservative)
        check(Structure(model));
    else
        check(NonconservativeStructure(model));
    return 0;
}
