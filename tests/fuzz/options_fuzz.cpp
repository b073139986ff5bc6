// Any text for an option: a value that obeys the option's rule, or nothing. Values are read again as they were printed.
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "../../programs/support/numbers.hpp"

namespace {

void require_that(bool holds) {
    if (!holds) std::abort();
}
std::string printed(double value) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value);
    return {text, end.ptr};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const int choice = data[0];
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    if (const auto x = support::parsed_number(text, [](double v) { return v >= 0; })) {
        require_that(std::isfinite(*x) && *x >= 0);
        require_that(support::parsed<double>(printed(*x)) == *x);
    }
    if (const auto k = support::parsed_integer<int>(text, 1, 10)) require_that(*k >= 1 && *k <= 10);
    if (const auto k = support::parsed_integer<std::uint64_t>(text, 0, UINT64_MAX))
        require_that(support::parsed_integer<std::uint64_t>(std::to_string(*k), 0, UINT64_MAX) == *k);
    const int n = choice % 12;
    if (const auto list = support::parsed_positive_list(text, n)) {
        require_that(static_cast<int>(list->size()) == n);
        std::string again;
        for (const double x : *list) {
            require_that(std::isfinite(x) && x > 0);
            again += (again.empty() ? "" : ",") + printed(x);
        }
        require_that(support::parsed_positive_list(again, n) == *list);
    }
    const double least = choice % 2 == 0 ? 0 : -std::numeric_limits<double>::infinity();
    const double most = choice % 3 == 0 ? 1 : std::numeric_limits<double>::infinity();
    if (const auto r = support::parsed_range(text, least, most)) {
        require_that(std::isfinite(r->low) && std::isfinite(r->high) && r->low < r->high);
        require_that(r->low >= least && r->high <= most);
        const auto again = support::parsed_range(printed(r->low) + ":" + printed(r->high), least, most);
        require_that(again && again->low == r->low && again->high == r->high);
    }
    return 0;
}
