// The surface of folds over alpha, omega and the ratio, as sheets: curves of planes of constant ratio, each joined to
// the one that continues it in the next plane.
//
// The curves of each plane are cut at their cusps (pieces.hpp). Two pieces of neighbouring planes belong together where
// they are of one kind, end alike, are near, the angles of their equilibria included, and every other piece is at least
// twice as far from either. Where some piece finds no partner, the gap between the planes is halved, a few times; what
// remains are gaps at which curves end or join in another way, and they are reported, not bridged. So a wrong surface
// would take two pieces that are near each other, in a plane and in its equilibria, and none of which is the other: it
// fails where planes are farther from each other than their curves. An equilibrium and its mirror image are one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <equilibria/core/grid_value.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fold_surface/pieces.hpp"
#include "support/progress_bar.hpp"

namespace fold_surface {

/// A range of the ratio.
struct Interval {
    double low, high;
};

struct Plane {
    double ratio;
    Locus locus;
    std::vector<Piece> pieces;
};

/// The planes by their ratios, each traced when it is first asked for.
class Planes {
public:
    Planes(const Window& window, const equilibria::RunOptions& run, const equilibria::LocusOptions& options)
        : window_(window), run_(run), options_(options) {}

    void trace(const std::vector<double>& ratios, const std::string& label) {
        support::ProgressBar bar(label);
        for (std::size_t k = 0; k < ratios.size(); ++k) {
            bar.update(k, ratios.size());
            at(ratios[k]);
        }
    }
    const Plane& at(double ratio) {
        const auto known = planes_.find(ratio);
        if (known != planes_.end()) return known->second;
        Locus locus =
            equilibria::trace_locus<Chain, Chain::alpha, Chain::omega>({0.5, ratio, 1}, window_, run_, options_);
        auto own = pieces(locus);
        return planes_.emplace(ratio, Plane{ratio, std::move(locus), std::move(own)}).first->second;
    }
    const Window& window() const { return window_; }
    const std::map<double, Plane>& all() const { return planes_; }

private:
    Window window_;
    equilibria::RunOptions run_;
    equilibria::LocusOptions options_;
    std::map<double, Plane> planes_;
};

/// `b`, turned and, where it is closed, begun so that its points are next to those of `a`; and how far they are at
/// most, which is infinite for pieces of different kinds or ends.
inline std::pair<double, Piece> fitted(const Piece& a, const Piece& b, const Window& window) {
    std::pair<double, Piece> best{std::numeric_limits<double>::infinity(), b};
    if (a.kind != b.kind) return best;
    for (const bool reversed : {false, true}) {
        const Piece turned = reversed ? b.reversed() : b;
        if (!a.ends[0].like(turned.ends[0]) || !a.ends[1].like(turned.ends[1])) continue;
        const std::size_t n = turned.points.size() - 1, begins = a.closed() ? n : 1;
        for (std::size_t begin = 0; begin < begins; ++begin)
            for (const double mirror : {1., -1.}) {
                Piece candidate = turned;
                double most = 0;
                for (std::size_t k = 0; k <= n; ++k) {
                    if (begins > 1) candidate.points[k] = turned.points[(begin + k) % n];
                    most = std::max(most, distance(a.points[k], candidate.points[k], window, mirror));
                }
                if (most < best.first) best = {most, std::move(candidate)};
            }
    }
    return best;
}

/// For each of the pieces below the number of the one above that continues it, or -1. Two pieces belong together where
/// they are near, and every other piece is at least twice as far from either.
inline std::vector<int> matched(const std::vector<const Piece*>& below, const std::vector<Piece>& above,
                                const Window& window) {
    constexpr double largest = 0.25;
    std::vector<std::vector<double>> far(below.size());
    for (std::size_t i = 0; i < below.size(); ++i)
        for (const Piece& piece : above) far[i].push_back(fitted(*below[i], piece, window).first);
    std::vector<int> found(below.size(), -1);
    for (std::size_t i = 0; i < below.size(); ++i)
        for (std::size_t j = 0; j < above.size(); ++j) {
            bool alone = far[i][j] < largest;
            for (std::size_t k = 0; k < below.size(); ++k) alone = alone && (k == i || 2 * far[i][j] <= far[k][j]);
            for (std::size_t k = 0; k < above.size(); ++k) alone = alone && (k == j || 2 * far[i][j] <= far[i][k]);
            if (alone) found[i] = static_cast<int>(j);
        }
    return found;
}

inline std::vector<const Piece*> pointers(const std::vector<Piece>& pieces) {
    std::vector<const Piece*> all;
    for (const Piece& piece : pieces) all.push_back(&piece);
    return all;
}

inline bool all_matched(const Plane& a, const Plane& b, const Window& window) {
    const auto found = matched(pointers(a.pieces), b.pieces, window);
    return a.pieces.size() == b.pieces.size() && std::find(found.begin(), found.end(), -1) == found.end();
}

/// A sheet of the surface: pieces of successive planes.
struct Sheet {
    struct Row {
        double ratio;
        Piece piece;
    };
    std::vector<Row> rows;
    SingularityKind kind() const { return rows.front().piece.kind; }
};

struct Surface {
    std::vector<double> ratios;  ///< of all its planes
    std::vector<double> slices;  ///< of those whose curves are drawn: all but the ones that only make a gap smaller
    std::vector<Sheet> sheets;
    std::vector<Interval> gaps;  ///< between planes some of whose curves do not continue each other
};

/// The neighbouring planes some of whose curves do not continue each other.
inline std::vector<Interval> unmatched(Planes& planes, const std::vector<double>& ratios) {
    std::vector<Interval> found;
    for (std::size_t k = 0; k + 1 < ratios.size(); ++k)
        if (!all_matched(planes.at(ratios[k]), planes.at(ratios[k + 1]), planes.window()))
            found.push_back({ratios[k], ratios[k + 1]});
    return found;
}

/// Joins the pieces of each plane to those of the last; what continues none begins a sheet.
inline std::vector<Sheet> joined(Planes& planes, const std::vector<double>& ratios) {
    std::vector<Sheet> sheets;
    std::vector<std::size_t> open;  // those that the last plane has reached
    for (const double ratio : ratios) {
        const auto& next = planes.at(ratio).pieces;
        std::vector<const Piece*> last;
        for (const std::size_t sheet : open) last.push_back(&sheets[sheet].rows.back().piece);
        const auto found = matched(last, next, planes.window());
        std::vector<std::size_t> reached;
        for (std::size_t j = 0; j < next.size(); ++j) {
            const auto at = std::find(found.begin(), found.end(), static_cast<int>(j));
            if (at == found.end()) {
                reached.push_back(sheets.size());
                sheets.push_back({{{ratio, next[j]}}});
            } else {
                reached.push_back(open[static_cast<std::size_t>(at - found.begin())]);
                auto& rows = sheets[reached.back()].rows;
                rows.push_back({ratio, fitted(rows.back().piece, next[j], planes.window()).second});
            }
        }
        open = std::move(reached);
    }
    return sheets;
}

/// Through planes at equal distances, and through more where two do not match: the one between, `bisections` times.
inline Surface surface(Planes& planes, const Interval& range, int slices, int bisections) {
    Surface y;
    const auto count = static_cast<std::uint64_t>(slices);
    for (std::uint64_t k = 0; k < count; ++k)
        y.slices.push_back(equilibria::grid_value(range.low, range.high, k, count));
    planes.trace(y.slices, "planes");
    y.ratios = y.slices;
    y.gaps = unmatched(planes, y.ratios);
    for (int round = 0; round < bisections && !y.gaps.empty(); ++round) {
        std::vector<double> middle;
        for (const auto& gap : y.gaps) middle.push_back((gap.low + gap.high) / 2);
        planes.trace(middle, "planes in gaps, " + std::to_string(round + 1) + " of " + std::to_string(bisections));
        y.ratios.insert(y.ratios.end(), middle.begin(), middle.end());
        std::sort(y.ratios.begin(), y.ratios.end());
        y.gaps = unmatched(planes, y.ratios);
    }
    for (const auto& gap : y.gaps) y.slices.insert(y.slices.end(), {gap.low, gap.high});
    std::sort(y.slices.begin(), y.slices.end());
    y.slices.erase(std::unique(y.slices.begin(), y.slices.end()), y.slices.end());
    y.sheets = joined(planes, y.ratios);
    return y;
}

}  // namespace fold_surface
