#include <cstddef>
#include <vector>

#include <equilibria/core/huge_pages.hpp>

#include "support/catch.hpp"

TEST_CASE("an advice about pages changes nothing in the memory") {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1000}, std::size_t{3} << 20}) {
        std::vector<double> numbers;
        numbers.reserve(size);
        equilibria::prefer_huge_pages(numbers.data(), size * sizeof(double));
        for (std::size_t k = 0; k < size; ++k) numbers.push_back(static_cast<double>(k));
        equilibria::prefer_huge_pages(numbers.data(), size * sizeof(double));
        bool same = true;
        for (std::size_t k = 0; k < size; ++k) same = same && numbers[k] == static_cast<double>(k);
        CHECK(same);
    }
}
