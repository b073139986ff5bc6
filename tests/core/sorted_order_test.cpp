// The order by keys: lexicographic, equal keys in their own order, and things put into it.
#include <memory>
#include <string>
#include <vector>

#include <equilibria/core/sorted_order.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("sorted_order is lexicographic and keeps the order of equal keys") {
    const auto order = sorted_order({{1, 0, 0}, {0, 5, 1}, {0, 5, 0}, {1, 0, 0}, {-1, 9, 9}, {0, 4, 7}});
    CHECK(order == std::vector<std::size_t>{4, 5, 2, 1, 0, 3});
    CHECK(sorted_order({}).empty());
    std::vector<std::unique_ptr<std::string>> things;
    for (const char* name : {"a", "b", "c", "d", "e", "f"}) things.push_back(std::make_unique<std::string>(name));
    std::string text;
    for (const auto& thing : in_order(order, std::move(things))) text += *thing;
    CHECK(text == "efcbad");
}
