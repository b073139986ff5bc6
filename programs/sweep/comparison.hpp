// Regions of a traced locus against the points of a sweep.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <equilibria/enumerate/sweep.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/locus/regions/regions.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

namespace sweeps {

using Chain = equilibria::mechanisms::TwoLinkChain;
using Locus = equilibria::Locus<Chain>;

/// Counts of a traced locus's regions against those of points.
class Comparison {
public:
    explicit Comparison(const Locus& locus) : locus_(locus), lines_(lines(locus)), plane_(locus.window, lines_) {
        counts_.resize(static_cast<std::size_t>(plane_.regions()), 0);
        for (const auto& r : locus.regions)
            if (const int at = plane_.region_of(r.point.x, r.point.y); at >= 0)
                counts_[static_cast<std::size_t>(at)] = r.count;
    }
    void add(const equilibria::SweptPoint& point) {
        const auto& w = locus_.window;
        const auto inside = [](const equilibria::Interval& axis, double at) {
            const double edge = 1e-9 * axis.width();
            return std::clamp(at, axis.low + edge, axis.high - edge);
        };
        const double x = inside(w.x, point.parameters[Chain::alpha]), y = inside(w.y, point.parameters[Chain::omega]);
        const int region = plane_.region_of(x, y);
        if (region < 0 || point.singular > 0 || point.vanishing_equation) {
            ++not_compared_;
        } else if (counts_[static_cast<std::size_t>(region)] == point.real) {
            ++agree_;
        } else {
            ++differ_;
            farthest_ = std::max(farthest_, distance(x, y));
        }
    }
    equilibria::Json json() const {
        return {{"agree", agree_},
                {"not_compared", not_compared_},
                {"differ", differ_},
                {"farthest_from_a_curve", farthest_}};
    }

private:
    static std::vector<std::vector<equilibria::PlanePoint>> lines(const Locus& locus) {
        std::vector<std::vector<equilibria::PlanePoint>> y;
        for (const auto& curve : locus.curves) {
            y.emplace_back();
            for (const auto& p : curve.points) y.back().push_back({p.x(), p.y()});
        }
        return y;
    }
    /// To the next curve, in units of the window.
    double distance(double x, double y) const {
        double least = std::numeric_limits<double>::infinity();
        const auto& w = locus_.window;
        for (const auto& curve : lines_)
            for (std::size_t k = 1; k < curve.size(); ++k) {
                const double ax = (curve[k - 1].x - x) / w.width(), ay = (curve[k - 1].y - y) / w.height();
                const double dx = (curve[k].x - x) / w.width() - ax, dy = (curve[k].y - y) / w.height() - ay;
                const double length2 = dx * dx + dy * dy;
                const double t = length2 > 0 ? std::clamp(-(ax * dx + ay * dy) / length2, 0.0, 1.0) : 0;
                least = std::min(least, std::hypot(ax + t * dx, ay + t * dy));
            }
        return least;
    }

    const Locus& locus_;
    std::vector<std::vector<equilibria::PlanePoint>> lines_;
    equilibria::PlaneDecomposition plane_;
    std::vector<std::uint64_t> counts_;
    std::uint64_t agree_ = 0, not_compared_ = 0, differ_ = 0;
    double farthest_ = 0;
};

}  // namespace sweeps
