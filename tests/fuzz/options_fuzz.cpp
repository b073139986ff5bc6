// Any text for an option: a value that obeys the option's rule, or one line that says what is allowed. What CLI11 reads
// is the value that the text has, bit by bit, and values are read again as they were printed.
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include <CLI/CLI.hpp>

#include "../../programs/support/options.hpp"

namespace {

void require_that(bool holds) {
    if (!holds) std::abort();
}
std::string printed(double value) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value);
    return {text, end.ptr};
}
/// What CLI11 makes of an option's text, or nothing where the option refuses it, in one sentence about that text.
template <class T>
std::optional<T> read(const support::Rule& rule, const std::string& text) {
    std::string changed = text;
    const std::string said = rule(changed);
    T value{};
    if (!said.empty()) {
        require_that(said.starts_with(support::shown(text) + ": "));
        require_that(changed == text);
        return {};
    }
    using CLI::detail::lexical_cast;
    require_that(lexical_cast(changed, value));
    return value;
}

void numbers(const std::string& text) {
    if (const auto x = read<double>(support::not_negative(), text)) {
        require_that(std::isfinite(*x) && *x >= 0);
        require_that(std::bit_cast<std::uint64_t>(*x) == std::bit_cast<std::uint64_t>(*support::parsed(text)));
        require_that(read<double>(support::not_negative(), printed(*x)) == *x);
    }
    if (const auto k = read<int>(support::integer(1, 10), text)) require_that(*k >= 1 && *k <= 10);
    if (const auto k = read<std::uint64_t>(support::integer(std::uint64_t{0}, UINT64_MAX), text))
        require_that(read<std::uint64_t>(support::integer(std::uint64_t{0}, UINT64_MAX), std::to_string(*k)) == *k);
}

void lists(const std::string& text, int n) {
    const auto rule = support::positive_list([n] { return n; });
    const auto list = read<support::List>(rule, text);
    if (!list) return;
    require_that(static_cast<int>(list->values.size()) == n);
    std::string again;
    for (const double x : list->values) {
        require_that(std::isfinite(x) && x > 0);
        again += (again.empty() ? "" : ",") + printed(x);
    }
    require_that(read<support::List>(rule, again)->values == list->values);
}

void ranges(const std::string& text, double least, double most) {
    const auto rule = support::range("must be LOW:HIGH", least, most);
    const auto r = read<support::Range>(rule, text);
    if (!r) return;
    require_that(std::isfinite(r->low) && std::isfinite(r->high) && r->low < r->high);
    require_that(r->low >= least && r->high <= most);
    const auto again = read<support::Range>(rule, printed(r->low) + ":" + printed(r->high));
    require_that(again && again->low == r->low && again->high == r->high);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const int choice = data[0];
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    numbers(text);
    lists(text, choice % 12);
    ranges(text, choice % 2 == 0 ? 0 : -std::numeric_limits<double>::infinity(),
           choice % 3 == 0 ? 1 : std::numeric_limits<double>::infinity());
    return 0;
}
