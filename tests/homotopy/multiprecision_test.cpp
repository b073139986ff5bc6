// The scalar path: the same tracker over 50 digits.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/endgame.hpp>
#include <equilibria/homotopy/lane_tracker.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/start/total_degree.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

TEST_CASE("paths tracked with 50 digits arrive where those of double do") {
    using M = models::Pendulum;
    const Parameters<M> p{0.5};
    Generator generator(1);
    const ModelSystem<M> target(p);
    const TotalDegree<M> start(target, generator);
    const PolynomialHomotopy h = model_homotopy(target, start);
    const auto points = [&](std::uint64_t k) { return runtime_point(start.point(k)); };
    const std::vector<std::uint64_t> paths{0, 1};
    std::vector<Endpoint> ends(2), exact(2);
    track_lanes<double, true>(h, TrackerOptions{}, std::span(paths), points, std::span(ends));
    track_lanes<Digits50, true>(h, TrackerOptions{}, std::span(paths), points, std::span(exact));
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(exact[k].arrival == Arrival::end);
        CHECK(std::abs(exact[k].q.s[0].re - 0.5) < 1e-9);
        CHECK(std::abs(exact[k].q.c[0].re - ends[k].q.c[0].re) < 1e-9);
    }
}

namespace {

/// x^3 - a x - b = 0.
struct Cubic {
    static constexpr int n_angles = 0, n_coordinates = 1;
    enum Parameter { a, b, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        return std::array{pow(x[0], 3) - p[a] * x[0] - p[b]};
    }
};

/// The ends of all paths, endgame included, with 50 digits.
template <class M>
std::vector<Endpoint> ends(const Parameters<M>& p, std::uint64_t seed) {
    Generator generator(seed);
    const ModelSystem<M> target(p);
    const TotalDegree<M> start(target, generator);
    const PolynomialHomotopy h = model_homotopy(target, start);
    const detail::Polisher polisher(h);
    std::vector<Endpoint> y;
    for (std::uint64_t path = 0; path < static_cast<std::uint64_t>(total_degree<M>()); ++path)
        y.push_back(detail::Endgame<PolynomialHomotopy, Digits50>(h, polisher, TrackerOptions{})
                        .from_start(runtime_point(start.point(path))));
    return y;
}

}  // namespace

TEST_CASE("the endgame with 50 digits: regular, fold, cusp, one of each") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        for (const auto& end : ends<models::Pendulum>({0.5}, seed)) {
            CHECK(end.status == PathStatus::finite);
            CHECK(std::abs(end.q.s[0].re - 0.5) < 1e-14);
        }
        for (const auto& end : ends<models::Pendulum>({1}, seed)) {
            CHECK(end.status == PathStatus::singular);
            CHECK(end.winding_number == 2);
        }
        for (const auto& end : ends<Cubic>({0, 0}, seed)) {
            CHECK(end.status == PathStatus::singular);
            CHECK(end.winding_number == 3);
            CHECK(std::abs(end.q.x[0].re) + std::abs(end.q.x[0].im) < 1e-7);
        }
        int doubled = 0;
        for (const auto& end : ends<Cubic>({3, 2}, seed)) doubled += end.winding_number == 2;
        CHECK(doubled == 2);
    }
}
