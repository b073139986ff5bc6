#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <equilibria/polyhedral/detail/circuit_table.hpp>
#include <equilibria/polyhedral/detail/regeneration_plan.hpp>
#include <equilibria/polyhedral/detail/regeneration_walk.hpp>
#include <memory>
#include <vector>

#include "support/catch.hpp"
#include "support/support_families.hpp"

using namespace equilibria;

namespace {

using Fraction = boost::multiprecision::cpp_rational;

/// volume D^-1 columns, solved for in fractions: the entries of the first point of each edge.
std::vector<std::vector<Fraction>> table_from_scratch(const std::vector<Supports::Point>& points,
                                                      const detail::ColumnLayout& layout,
                                                      const std::vector<std::array<int, 2>>& edges, Fraction& volume) {
    const auto n = edges.size();
    const std::size_t columns = points.size();
    // unknown t: sum of t_j (a_j - b_j) = point - b_i
    std::vector<std::vector<Fraction>> a(n, std::vector<Fraction>(n + columns));
    for (std::size_t r = 0; r < n; ++r) {
        for (std::size_t j = 0; j < n; ++j)
            a[r][j] =
                points[static_cast<std::size_t>(edges[j][0])][r] - points[static_cast<std::size_t>(edges[j][1])][r];
        for (std::size_t k = 0; k < columns; ++k) {
            const auto i = static_cast<std::size_t>(layout.configuration[k]);
            a[r][n + k] = points[k][r] - points[static_cast<std::size_t>(edges[i][1])][r];
        }
    }
    volume = 1;
    for (std::size_t c = 0; c < n; ++c) {
        std::size_t p = c;
        while (p < n && a[p][c] == 0) ++p;
        REQUIRE(p < n);
        std::swap(a[p], a[c]);
        volume *= a[c][c];
        const Fraction pivot = a[c][c];
        for (auto& x : a[c]) x /= pivot;
        for (std::size_t r = 0; r < n; ++r)
            if (r != c && a[r][c] != 0) {
                const Fraction f = a[r][c];
                for (std::size_t k = 0; k < n + columns; ++k) a[r][k] -= f * a[c][k];
            }
    }
    volume = abs(volume);
    std::vector<std::vector<Fraction>> y(n, std::vector<Fraction>(columns));
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t k = 0; k < columns; ++k) y[j][k] = volume * a[j][n + k];
    return y;
}

/// The points of a stage's columns.
std::vector<Supports::Point> points_of_stage(const detail::RegenerationPlan& plan, int stage) {
    std::vector<Supports::Point> y;
    const int n = plan.unknowns;
    for (int i = 0; i < n; ++i) {
        const int scale = i == stage ? static_cast<int>(plan.degree[static_cast<std::size_t>(i)]) : 1;
        if (i >= stage)
            for (int l = 0; l <= n; ++l) {
                y.emplace_back(static_cast<std::size_t>(n));
                if (l > 0) y.back()[static_cast<std::size_t>(l - 1)] = scale;
            }
        if (i <= stage)
            for (const auto& point : plan.points[static_cast<std::size_t>(i)])
                y.emplace_back(point.begin(), point.end());
    }
    return y;
}

template <class Integer>
void check_table(const std::vector<Supports::Point>& points, const detail::ColumnLayout& layout,
                 const detail::CircuitTable<Integer>& table) {
    Fraction volume;
    const auto expected = table_from_scratch(points, layout, table.edges, volume);
    REQUIRE(volume == Fraction(table.volume));
    bool same = true;
    for (int j = 0; j < table.rows(); ++j)
        for (int k = 0; k < table.columns(); ++k)
            same =
                same && expected[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] == Fraction(table.at(j, k));
    REQUIRE(same);
}

/// Every column that can enter a table, for each point: the new table from scratch, and back.
template <class Integer>
void check_exchanges(const std::vector<Supports::Point>& points, const detail::ColumnLayout& layout,
                     const detail::CircuitTable<Integer>& table, const Integer& limit) {
    check_table(points, layout, table);
    for (int column = 0; column < table.columns(); column += 3)
        for (const int leaving : {0, 1}) {
            const auto i = static_cast<std::size_t>(layout.configuration[static_cast<std::size_t>(column)]);
            if (table.entry(layout, static_cast<int>(i), leaving, column) == 0) continue;
            if (column == table.edges[i][0] || column == table.edges[i][1]) continue;
            auto next = table;
            REQUIRE(next.exchange(layout, column, leaving, limit));
            check_table(points, layout, next);
            REQUIRE(next.edges[i] == std::array<int, 2>{table.edges[i][leaving == 0 ? 1 : 0], column});
            REQUIRE(next.exchange(layout, table.edges[i][static_cast<std::size_t>(leaving)], 1, limit));
            if (next.edges[i] != table.edges[i]) REQUIRE(next.swap_ends(layout, static_cast<int>(i), limit));
            REQUIRE(next.edges == table.edges);
            REQUIRE(next.volume == table.volume);
            for (int j = 0; j < table.rows(); ++j)
                for (int k = 0; k < table.columns(); ++k) REQUIRE(next.at(j, k) == table.at(j, k));
        }
}

}  // namespace

TEST_CASE("an example of a circuit table") {
    const auto layout = detail::ColumnLayout::of({4, 4}, -1, 0);
    const std::vector<Supports::Point> points{{0, 0}, {0, 2}, {1, 0}, {1, 1}, {0, 0}, {0, 1}, {1, 1}, {2, 0}};
    detail::CircuitTable<std::int32_t> table(layout);
    table.volume = 3;
    table.edges = {{1, 2}, {4, 6}};
    const std::int32_t rows[2][8] = {{1, 3, 0, 1, 0, 1, 0, -2}, {2, 0, 0, -1, 3, 2, 0, -1}};
    for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 8; ++k) table.row(j)[k] = rows[j][k];
    check_exchanges<std::int32_t>(points, layout, table, 1000);
}

TEST_CASE("every table of a walk is the one from scratch, and its exchanges go back") {
    const auto supports = support_families::cyclic(5);
    for (const std::int32_t largest : {1 << 30, 30}) {
        detail::RegenerationPlan plan(supports, {4, 0, 1, 2, 3});
        plan.largest_narrow = largest;
        std::vector<std::int64_t> lifting;
        for (int k = 0; k < supports.columns(); ++k) lifting.push_back(k * k * 7919 % 1009);
        plan.go_to(supports, lifting);
        detail::RegenerationWalk walk(plan);
        std::vector<std::unique_ptr<detail::RegenerationNode>> stack;
        stack.push_back(std::make_unique<detail::RegenerationNode>(walk.root()));
        int nodes = 0, cells = 0;
        while (!stack.empty()) {
            auto& node = *stack.back();
            auto child = std::make_unique<detail::RegenerationNode>();
            const auto event = walk.advance(node, *child);
            ++nodes;
            const auto check = [&](detail::RegenerationNode& at) {
                const auto& layout = plan.layouts[static_cast<std::size_t>(at.stage)];
                const auto points = points_of_stage(plan, at.stage);
                if (at.width == 0)
                    check_exchanges<std::int32_t>(points, layout, at.narrow, 1 << 30);
                else
                    check_exchanges<std::int64_t>(points, layout, at.wide, std::int64_t{1} << 60);
            };
            if (event == detail::RegenerationWalk::Event::divided) {
                check(node);
                check(*child);
                stack.push_back(std::move(child));
            } else {
                if (event == detail::RegenerationWalk::Event::cell) {
                    ++cells;
                    check(node);
                }
                stack.pop_back();
            }
        }
        CHECK(nodes > 40);
        CHECK(cells > 10);
    }
}

TEST_CASE("rows are combined and divided exactly for every kind of divisor") {
    const auto check = [](auto one, std::int64_t size) {
        using Integer = decltype(one);
        std::uint64_t state = 7;
        const auto draw = [&](std::int64_t range) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            return static_cast<std::int64_t>((state >> 20) % static_cast<std::uint64_t>(2 * range + 1)) - range;
        };
        for (int turn = 0; turn < 2000; ++turn) {
            const std::int64_t divisor = 1 + (draw(size) + size) % 48;
            const std::int64_t p = turn % 3 == 0 ? divisor : 1 + (draw(size) + size) % 60;
            const std::int64_t c = turn % 5 == 0 ? divisor * (turn % 2 == 0 ? 1 : -1) : draw(60);
            if (c == 0) continue;
            std::vector<Integer> row, other, expected;
            for (int k = 0; k < 40; ++k) {
                const std::int64_t x = draw(size), y = draw(size);
                for (std::int64_t a = 0; a < divisor; ++a) {  // the next one for which it is divisible
                    const auto sum = static_cast<detail::Int128>(p) * (x + a) + static_cast<detail::Int128>(c) * y;
                    if (sum % divisor != 0 || (turn % 3 == 0 && (static_cast<detail::Int128>(c) * y) % divisor != 0))
                        continue;
                    const auto quotient = sum / divisor;
                    if (quotient > 1'000'000'000 * std::int64_t{size > 1'000'000'000 ? 1'000'000'000 : 1} ||
                        quotient < -1'000'000'000 * std::int64_t{size > 1'000'000'000 ? 1'000'000'000 : 1})
                        continue;
                    row.push_back(static_cast<Integer>(x + a));
                    other.push_back(static_cast<Integer>(y));
                    expected.push_back(static_cast<Integer>(static_cast<std::int64_t>(quotient)));
                    break;
                }
            }
            detail::combine_rows<Integer>(row.data(), other.data(), row.size(), static_cast<Integer>(p),
                                          static_cast<Integer>(c), static_cast<Integer>(divisor));
            REQUIRE(row == expected);
        }
    };
    check(std::int32_t{1}, 10'000'000);
    check(std::int64_t{1}, std::int64_t{1} << 52);
    check(detail::UnlimitedInteger(1), std::int64_t{1} << 52);
}
