// The scalar path: the same tracker over 50 digits.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include <equilibria/enumerate/enumerate.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

TEST_CASE("paths tracked with 50 digits arrive where those of double do") {
    using M = models::Pendulum;
    constexpr auto kind = StartKind::general;
    const Parameters<M> p{0.5};
    Generator generator(1);
    const auto target = coefficients<M, double>(p);
    const TotalDegreeStart<M> start(kind, detail::equation_scales<M, double>(target), generator);
    const auto h = Homotopy<M, kind, double>::total_degree(target, start);
    const detail::StartPoints<M> points(start);
    const std::vector<std::uint64_t> paths{0, 1};
    std::vector<Endpoint<M>> ends(2), exact(2);
    track_lanes<double, true>(h, TrackerOptions{}, std::span(paths), points, std::span(ends));
    track_lanes<Digits50, true>(h, TrackerOptions{}, std::span(paths), points, std::span(exact));
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(exact[k].arrival == Arrival::end);
        CHECK(std::abs(exact[k].q.s[0].re - 0.5) < 1e-9);
        CHECK(std::abs(exact[k].q.c[0].re - ends[k].q.c[0].re) < 1e-9);
    }
}
