// Paths along segments of the complex t-plane: in lanes each for itself, and there and back to where it was.
#include <vector>

#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/detail/segments.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/start/total_degree.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using detail::Progress;

namespace {

using M = mechanisms::TwoLinkChain;
using H = PolynomialHomotopy;
using Segment = detail::Segment<double>;

struct Chain {
    Generator generator{1};
    ModelSystem<M> target{Parameters<M>{.3, 1.5, 2}};
    TotalDegree<M> start{target, generator};
    H h = model_homotopy(target, start);
    detail::SegmentLanes<H, double> lanes{h, TrackerOptions{}, 1e-9};

    /// From the starts of the first paths.
    std::vector<Segment> segments(std::uint64_t paths, Complex<double> to) const {
        std::vector<Segment> y(paths);
        for (std::uint64_t k = 0; k < paths; ++k) {
            y[k].q = runtime_point(start.point(k));
            y[k].from = {0, 0};
            y[k].to = to;
        }
        return y;
    }
};

/// There and back again, twice.
struct ThereAndBack : Segment {
    int segment = 0, taken = 0;

    bool advance() {
        if (++segment == 4) return false;
        std::swap(from, to);
        return true;
    }
    bool take(const RuntimePoint<double>& at) {
        q = at;
        return ++taken < 4;
    }
};

}  // namespace

TEST_CASE("a path's result does not depend on its neighbours") {
    Chain chain;
    auto together = chain.segments(11, {0.5, 0.2});
    chain.lanes.follow(std::span(together));
    for (std::size_t k = 0; k < together.size(); ++k) {
        auto alone = chain.segments(11, {0.5, 0.2})[k];
        chain.lanes.follow(std::span(&alone, 1));
        CHECK(alone.progress == Progress::arrived);
        CHECK(alone.reached == 1);
        CHECK(alone.steps == together[k].steps);
        CHECK(detail::distance(alone.q, together[k].q) == 0);
    }
}

TEST_CASE("there and back: a path comes to where it was") {
    Chain chain;
    auto there = chain.segments(5, {0.5, 0.2});
    chain.lanes.follow(std::span(there));
    std::vector<ThereAndBack> paths;
    for (const Segment& segment : there) {
        ThereAndBack path;
        static_cast<Segment&>(path) = segment;
        path.from = segment.to;
        path.to = {0.7, -0.1};
        paths.push_back(path);
    }
    chain.lanes.follow(std::span(paths));
    for (std::size_t k = 0; k < paths.size(); ++k) {
        CHECK(paths[k].progress == Progress::arrived);
        CHECK(paths[k].taken == 4);
        CHECK(detail::distance(paths[k].q, there[k].q) < 1e-10);
    }
}

TEST_CASE("a path without steps left is stuck where it is") {
    Chain chain;
    TrackerOptions few;
    few.most_steps = 3;
    detail::SegmentLanes<H, double> lanes(chain.h, few, 1e-9);
    auto paths = chain.segments(3, {0.9, 0});
    lanes.follow(std::span(paths));
    for (const Segment& path : paths) {
        CHECK(path.progress == Progress::stuck);
        CHECK(path.reached > 0);
        CHECK(path.reached < 1);
    }
}

TEST_CASE("an expansion: corrected, with the speed of the path in units of the radius") {
    Chain chain;
    auto paths = chain.segments(3, {0.5, 0});
    chain.lanes.follow(std::span(paths));
    std::vector<detail::Expansion<double>> points;
    for (const Segment& path : paths)
        points.push_back({.q = path.q, .r = 0.5, .noise = 0, .nu = SizedArray<double, at_run_time>(2)});
    chain.lanes.expand(std::span(points));
    // a step of h towards t = 1 moves an angle by h q', r q' = nu
    const double h = 1e-6;
    auto moved = paths;
    for (Segment& path : moved) path.from = {0.5, 0}, path.to = {0.5 + h, 0};
    chain.lanes.follow(std::span(moved));
    for (std::size_t k = 0; k < paths.size(); ++k) {
        CHECK(detail::distance(points[k].q, paths[k].q) < 1e-12);
        CHECK(points[k].noise < 1e-13);
        for (int u = 0; u < 2; ++u) {
            // |d(c, s)| in the norm |dc|^2 + |ds|^2 = |dtheta|^2 (|c|^2 + |s|^2)
            const auto &a = moved[k].q, &b = points[k].q;
            const double change2 = norm2(a.c[u] - b.c[u]) + norm2(a.s[u] - b.s[u]);
            const double speed2 = change2 / (h * h * unknown_size2(b, u));
            CHECK(std::sqrt(speed2) * 0.5 == Approx(points[k].nu[u]).epsilon(1e-4));
        }
    }
}
