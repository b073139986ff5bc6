// A sweep counts what enumerations count, in the order of the points, whatever the threads, and goes on from its file.
#include <atomic>
#include <sstream>
#include <vector>

#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/enumerate/sweep.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/families.hpp"
#include "support/scratch_file.hpp"

using namespace equilibria;

namespace {

using Chain = mechanisms::TwoLinkChain;
using Values = RuntimeArray<double>;

const ParameterPoints grid =
    parameter_grid(Values{0.5, 1.5, 2.0}, {{Chain::alpha, 0.05, 0.95, 13}, {Chain::omega, 0.3, 4.7, 17}});

struct Swept {
    std::vector<SweptPoint> points;
    SweepCounts counts;
};
Swept swept(const ParameterPoints& points, const RunOptions& run = {}, const SweepOptions& options = {}) {
    Swept y;
    y.counts = sweep<Chain>(points, [&](const SweptPoint& p) { y.points.push_back(p); }, run, options);
    return y;
}
bool same(const std::vector<SweptPoint>& a, const std::vector<SweptPoint>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t k = 0; k < a.size(); ++k)
        if (a[k].number != b[k].number || a[k].real != b[k].real || a[k].by_index != b[k].by_index ||
            a[k].distinct != b[k].distinct || a[k].proved != b[k].proved || a[k].instances != b[k].instances)
            return false;
    return true;
}

}  // namespace

TEST_CASE("each point of a sweep has the equilibria that enumerate finds there") {
    const auto y = swept(grid);
    CHECK(y.counts.done == 13 * 17);
    CHECK(y.counts.mixed_volume == 16);
    CHECK(y.counts.failed == 0);
    CHECK(y.counts.alarms == 0);
    for (const SweptPoint& point : y.points) {
        const auto p = grid.at(point.number);
        const auto found = enumerate<Chain>({p[0], p[1], p[2]});
        CHECK(point.real == found.real());
        CHECK(point.by_index == found.by_index());
        CHECK(point.distinct == found.distinct());
        CHECK(point.finite + point.at_infinity + point.singular + point.failed == point.paths);
    }
}

TEST_CASE("points come in their order and are the same for any number of threads, with proofs as well") {
    const auto whole = swept(grid, {}, {.prove = true});
    for (std::size_t k = 0; k < whole.points.size(); ++k) {
        CHECK(whole.points[k].number == k);
        CHECK(whole.points[k].proved == whole.points[k].distinct);
        CHECK(whole.points[k].proved_real == whole.points[k].real);
    }
    CHECK(whole.counts.proved == grid.size);
    CHECK(same(swept(grid, {.executor = threads(3)}, {.prove = true}).points, whole.points));
}

TEST_CASE("cancelled and resumed, a sweep is that which was never interrupted") {
    const auto whole = swept(grid);
    const tests::ScratchFile scratch("sweep.ckpt");
    std::atomic<bool> cancel = false;
    std::vector<SweptPoint> first;
    const auto cut = sweep<Chain>(grid,
                                  [&](const SweptPoint& p) {
                                      first.push_back(p);
                                      if (p.number == 70) cancel = true;
                                  },
                                  {.checkpoint = scratch.name(), .cancel = &cancel});
    CHECK(cut.cancelled());
    CHECK(first.size() == 128);
    CHECK(same(swept(grid, {.executor = threads(2), .checkpoint = scratch.name()}).points, whole.points));
    CHECK(same(swept(grid, {.checkpoint = scratch.name()}).points, whole.points));
    CHECK_THROWS_AS(swept(grid, {.checkpoint = scratch.name()}, {.resort = more_digits}), CheckpointError);
    const auto other = parameter_grid(Values{0.5, 1.5, 2.0}, {{Chain::omega, 0.3, 4.7, 17}});
    CHECK_THROWS_AS(swept(other, {.checkpoint = scratch.name()}), CheckpointError);
}

TEST_CASE("the file of another model of the same type is refused, whose points are the same") {
    const families::Edges first{{0, 1}, {1, 2}, {2, 3}}, second{{0, 1}, {1, 2}, {1, 3}};
    const auto p = families::generic(6, 1);
    const ParameterPoints points{3, [&](std::uint64_t) { return p; }};
    const tests::ScratchFile scratch("models.ckpt");
    const auto run = [&](const families::Edges& edges) {
        return sweep(families::Oscillators{3, edges}, points, [](const SweptPoint&) {}, {.checkpoint = scratch.name()});
    };
    CHECK(run(first).done == 3);
    CHECK(run(first).done == 3);
    CHECK_THROWS_AS(run(second), CheckpointError);
}

TEST_CASE("a point at which an equation vanishes, or roots are multiple, is told") {
    const Values nowhere{0, 1.5, 2};  // no mass at the second link
    const auto y =
        swept({3, [&](std::uint64_t k) { return k == 1 ? nowhere : Values{0.3, 1.5, 1.0 + static_cast<double>(k)}; }});
    CHECK(y.points[1].vanishing_equation);
    CHECK(y.points[1].paths == 0);
    CHECK(y.counts.vanishing == 1);
    CHECK(y.points[0].real > 0);
    std::ostringstream text;
    text << y.counts;
    CHECK_THAT(text.str(), Catch::Contains("at 1 an equation vanishes"));
}

TEST_CASE("grids, random points and lists") {
    const Values fixed{1, 2, 3};
    const auto box = parameter_grid(fixed, {{0, 0, 1, 3}, {2, -1, 1, 2}});
    CHECK(box.size == 6);
    CHECK(box.at(0)[0] == 0.0);
    CHECK(box.at(1)[2] == 1.0);
    CHECK(box.at(2)[0] == 0.5);
    CHECK(box.at(5)[0] == 1.0);
    CHECK(box.at(5)[1] == 2.0);
    const auto random = random_parameters(fixed, {{1, 5, 6}}, 1000, 7);
    double mean = 0;
    for (std::uint64_t k = 0; k < random.size; ++k) {
        const auto p = random.at(k);
        CHECK((p[1] >= 5 && p[1] < 6 && p[0] == 1.0));
        mean += p[1] / 1000;
    }
    CHECK(mean == Approx(5.5).margin(0.05));  // five standard deviations
    CHECK(random.at(17)[1] == random.at(17)[1]);
    const auto parameter_of = [](const std::string& name) { return name == "a" ? 0 : name == "c" ? 2 : -1; };
    const auto list = listed_parameters("c, a\n1,2\n\n 3e1 ,4\r\n", fixed, parameter_of);
    CHECK(list.size == 2);
    CHECK(list.at(1)[2] == 30.0);
    CHECK(list.at(1)[0] == 4.0);
    CHECK(list.at(0)[1] == 2.0);
    const auto said = [&](const std::string& csv) -> std::string {
        try {
            listed_parameters(csv, fixed, parameter_of);
        } catch (const InvalidArgument& error) {
            return error.what();
        }
        return "";
    };
    CHECK_THAT(said("a,b\n"), Catch::Contains("line 1, column 2"));
    CHECK_THAT(said("a,a\n"), Catch::Contains("once"));
    CHECK_THAT(said("a,c\n1\n"), Catch::Contains("line 2"));
    CHECK_THAT(said("a,c\n1,x\n"), Catch::Contains("line 2, column 2"));
    CHECK_THAT(said("a\ninf\n"), Catch::Contains("finite"));
    CHECK_THAT(said(""), Catch::Contains("names of parameters"));
    const auto round = parameter_grid(fixed, {{0, -3, 3, 7}, {2, 0.1, 0.7, 7}});
    CHECK(round.at(4 * 7 + 2)[0] == 1);
    CHECK(round.at(4 * 7 + 2)[2] == 0.3);
    CHECK_THROWS_AS(parameter_grid(fixed, {{3, 0, 1, 2}}), InvalidArgument);
    CHECK_THROWS_AS(parameter_grid(fixed, {{0, 0, 1, 0}}), InvalidArgument);
    CHECK_THROWS_AS(parameter_grid(fixed, {{0, 0, 1, 2}, {0, 0, 1, 2}}), InvalidArgument);
}
