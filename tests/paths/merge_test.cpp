// From records of paths to roots: each record is written down by hand, and what becomes of it is known.
#include <cmath>
#include <vector>

#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/paths/merge.hpp>
#include <equilibria/storage/endpoint_store.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

const RuntimeSizes one_angle(1, 0);

Endpoint endpoint(PathStatus status, double theta, int winding = 1) {
    Endpoint end;
    end.q = point_of<RuntimeUnknowns>({std::complex<double>(theta)}, one_angle);
    end.status = status;
    end.reason = status == PathStatus::failed ? FailureReason::too_many_steps : FailureReason::none;
    end.winding_number = static_cast<std::int16_t>(winding);
    end.steps = 10;
    return end;
}

PathSet records(const std::vector<Endpoint>& ends, PathNumbering numbering, std::vector<Endpoint> resting = {}) {
    detail::EndpointStore store(ends.size(), 4, one_angle);
    for (std::size_t first = 0; first < ends.size(); first += 4)
        store.put(first / 4, std::span(ends).subspan(first, std::min<std::size_t>(4, ends.size() - first)), 0);
    return {std::move(numbering), std::move(store), std::move(resting)};
}

}  // namespace

TEST_CASE("every record is counted once, by its status, and failures keep their reasons") {
    auto paths = records({endpoint(PathStatus::finite, 1), endpoint(PathStatus::at_infinity, 0),
                          endpoint(PathStatus::failed, 2), endpoint(PathStatus::singular, 0.5, 2),
                          endpoint(PathStatus::singular, 0.5, 2), endpoint(PathStatus::finite, -1)},
                         PathNumbering::all(6));
    const auto [counts, failures] = account_for(paths);
    CHECK(counts.accounted_for());
    CHECK(counts.total == 6);
    CHECK(counts.finite == 2);
    CHECK(counts.at_infinity == 1);
    CHECK(counts.singular == 2);
    CHECK(counts.failed == 1);
    CHECK(counts.steps == 60);
    REQUIRE(failures.size() == 1);
    CHECK(failures[0].path == 2);
    CHECK(failures[0].reason == FailureReason::too_many_steps);
    CHECK(failures[0].q[0].real() == Approx(2));
    // two singular paths to one point are one root
    const auto roots = merge(paths);
    REQUIRE(roots.size() == 3);
    CHECK(roots[0].path == 0);
    CHECK(roots[1].path == 3);
    CHECK(roots[1].paths == 2);
    CHECK(roots[1].winding_number == 2);
    CHECK(roots[2].path == 5);
}

TEST_CASE("with a mirror symmetry a record stands for two paths, and one that rests for itself") {
    // radix 4: paths 0 and 1 rest, 2 is tracked, 3 is its mirror image
    auto paths = records({endpoint(PathStatus::finite, 0.7)}, PathNumbering::mirrored({4}),
                         {endpoint(PathStatus::finite, 0), endpoint(PathStatus::finite, std::numbers::pi)});
    const auto [counts, failures] = account_for(paths);
    CHECK(counts.total == 4);
    CHECK(counts.finite == 4);
    CHECK(counts.tracked == 1);
    const auto roots = merge(paths);
    REQUIRE(roots.size() == 4);
    for (std::uint64_t k = 0; k < 4; ++k) CHECK(roots[k].path == k);
    CHECK(roots[2].q[0].real() == Approx(0.7));
    CHECK(roots[3].q[0].real() == Approx(-0.7));
}

TEST_CASE("mirror images that end at one point are one root") {
    // singular endpoints within 1e-5 of each other, at a point that is its own mirror image
    auto paths = records({endpoint(PathStatus::singular, 1e-7, 2)}, PathNumbering::mirrored({4}),
                         {endpoint(PathStatus::singular, 0), endpoint(PathStatus::finite, std::numbers::pi)});
    const auto roots = merge(paths);
    REQUIRE(roots.size() == 2);
    CHECK(roots[0].path == 0);
    CHECK(roots[0].paths == 3);
    CHECK(roots[0].winding_number == 2);
}

TEST_CASE("paths of a cancelled run are counted as cancelled, and are no roots") {
    detail::EndpointStore store(8, 4, one_angle);
    const std::vector<Endpoint> ends(4, endpoint(PathStatus::finite, 1));
    store.put(1, ends, 0);
    PathSet paths(PathNumbering::all(8), std::move(store), {});
    const auto [counts, failures] = account_for(paths);
    CHECK(counts.accounted_for());
    CHECK(counts.cancelled == 4);
    CHECK(counts.finite == 4);
    CHECK(merge(paths).size() == 1);
}

TEST_CASE("paths that are known to be apart are not compared again") {
    auto paths = records({endpoint(PathStatus::finite, 1), endpoint(PathStatus::finite, 1 + 1e-11),
                          endpoint(PathStatus::singular, 2), endpoint(PathStatus::singular, 2 + 1e-8)},
                         PathNumbering::all(4));
    CHECK(merge(paths).size() == 2);
    paths.apart = true;
    const auto roots = merge(paths);
    CHECK(roots.size() == 3);
    CHECK(roots[2].paths == 2);
}
