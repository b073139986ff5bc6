/// \file
/// The regions into which curves cut a window of the plane: a vertical decomposition. Curves are split into pieces that
/// are monotone in x; between neighbouring critical abscissae (ends and vertical tangents of pieces, crossings, points
/// where pieces touch each other or the window's border) the pieces are ordered and bound cells; cells that share a
/// vertical segment belong to one region. No raster: a sliver beside a cusp is found however thin it is, down to the
/// resolution of the curves' points. A vertical line bounds no cell from below or above; it parts the cells on its two
/// sides.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <boost/pending/disjoint_sets.hpp>

#include <equilibria/core/window.hpp>
#include <equilibria/locus/regions/plane_point.hpp>

namespace equilibria {

/// The regions into which curves cut a window.
class PlaneDecomposition {
public:
    /// A cell: bounded left and right by the interval x, below and above by pieces, or the window.
    struct Cell {
        Interval x;         ///< between neighbouring critical abscissae
        PlanePoint center;  ///< half way up where the cell is high
        double height;      ///< at the centre
        int region;         ///< its number, from 0
        int lower;          ///< piece below; -1: the window's bottom
        int upper;          ///< piece above; -2: the window's top
    };

    /// curves: polygonal lines, each by its points in order.
    PlaneDecomposition(const Window& window, const std::vector<std::vector<PlanePoint>>& curves) : window_(window) {
        for (std::size_t k = 0; k < curves.size(); ++k) {
            split(curves[k], k);
            curve_of_.resize(pieces_.size(), k);
        }
        find_abscissae();
        build_cells();
    }

    int regions() const { return regions_; }                   ///< how many there are
    const std::vector<Cell>& cells() const { return cells_; }  ///< cells of all regions

    /// The region of a point of the window; -1 where it lies on a boundary to within rounding.
    int region_of(double x, double y) const {
        for (const Slab& slab : slabs_) {
            if (x < slab.low || x > slab.high) continue;
            for (const Bounds& b : slab.cells) {
                const double low = height_at(b.lower, x), high = height_at(b.upper, x);
                if (y > low && y < high) return cells_[static_cast<std::size_t>(b.cell)].region;
            }
        }
        return -1;
    }
    /// Which regions lie on both sides of which curves.
    const std::vector<RegionBorder>& borders() const { return borders_; }

    /// A cell as a polygon, counterclockwise, with the curves' points on its upper and lower edges.
    std::vector<PlanePoint> polygon(const Cell& cell) const {
        std::vector<PlanePoint> y;
        const auto edge = [&](int piece, bool forward) {
            std::vector<PlanePoint> points{{cell.x.low, clamped(height_at(piece, cell.x.low))}};
            if (piece >= 0)
                for (const PlanePoint& p : pieces_[static_cast<std::size_t>(piece)])
                    if (p.x > cell.x.low && p.x < cell.x.high) points.push_back({p.x, clamped(p.y)});
            points.push_back({cell.x.high, clamped(height_at(piece, cell.x.high))});
            if (!forward) std::reverse(points.begin(), points.end());
            y.insert(y.end(), points.begin(), points.end());
        };
        edge(cell.lower, true);
        edge(cell.upper, false);
        return y;
    }
    /// The area of a cell's polygon.
    double area(const Cell& cell) const {
        const auto points = polygon(cell);
        double twice = 0;
        for (std::size_t k = 2; k < points.size(); ++k) {
            const PlanePoint &o = points[0], &a = points[k - 1], &b = points[k];
            twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
        }
        return twice / 2;
    }
    /// The distance from a cell's centre to its boundary, in units of the window: the smaller of those along both axes.
    double clearance(const Cell& cell) const {
        return std::min(0.5 * cell.height / window_.height(),
                        std::min(cell.center.x - cell.x.low, cell.x.high - cell.center.x) / window_.width());
    }

private:
    using Piece = std::vector<PlanePoint>;  // x increases
    struct Bounds {
        int lower, upper;  // pieces; -1 the window's bottom, -2 its top
        int cell;
    };
    struct Wall {  // a vertical step of a curve
        double x, low, high;
        std::size_t curve;
    };
    struct Slab {
        double low, high;
        std::vector<Bounds> cells;
    };

    static constexpr std::array shares{0.5, 0.25, 0.75, 0.1, 0.9};  // of a slab's width: where heights are compared

    double same_x() const { return 1e-9 * window_.width(); }
    double closed() const { return 1e-6 * window_.height(); }  // a gap that joins no cells
    double thin() const { return 1e-10 * window_.height(); }   // one that is no cell

    void split(const std::vector<PlanePoint>& curve, std::size_t number) {
        Piece piece;
        int direction = 0;
        const auto flush = [&] {
            if (piece.size() > 1) {
                if (direction < 0) std::reverse(piece.begin(), piece.end());
                pieces_.push_back(piece);
            }
        };
        for (const PlanePoint& p : curve) {
            if (!piece.empty()) {
                const PlanePoint from = piece.back();
                if (std::abs(p.x - from.x) <= same_x() && std::abs(p.y - from.y) > closed()) {
                    flush();
                    walls_.push_back({from.x, std::min(p.y, from.y), std::max(p.y, from.y), number});
                    piece = {p};
                    direction = 0;
                    continue;
                }
                const int now = p.x > from.x ? 1 : p.x < from.x ? -1 : 0;
                if (now == 0) continue;  // no step to speak of
                if (direction != 0 && now != direction) {
                    const PlanePoint last = piece.back();
                    flush();
                    piece = {last};
                }
                direction = now;
            }
            piece.push_back(p);
        }
        flush();
    }

    double clamped(double y) const { return std::clamp(y, window_.y.low, window_.y.high); }
    double height_at(int piece, double x) const {
        if (piece == -1) return window_.y.low;
        if (piece == -2) return window_.y.high;
        const Piece& p = pieces_[static_cast<std::size_t>(piece)];
        auto right = std::upper_bound(p.begin(), p.end(), x, [](double v, const PlanePoint& q) { return v < q.x; });
        if (right == p.begin()) return p.front().y;
        if (right == p.end()) return p.back().y;
        const PlanePoint &a = *(right - 1), &b = *right;
        return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
    }

    void find_abscissae() {
        abscissae_ = {window_.x.low, window_.x.high};
        for (const Piece& p : pieces_) abscissae_.insert(abscissae_.end(), {p.front().x, p.back().x});
        for (const Wall& wall : walls_) abscissae_.push_back(wall.x);
        for (std::size_t a = 0; a < pieces_.size(); ++a) {
            for (std::size_t b = a + 1; b < pieces_.size(); ++b) crossings(static_cast<int>(a), static_cast<int>(b));
            border_touches(static_cast<int>(a));
        }
        std::sort(abscissae_.begin(), abscissae_.end());
        std::vector<double> kept;
        for (const double x : abscissae_)
            if (x >= window_.x.low && x <= window_.x.high && (kept.empty() || x - kept.back() > same_x()))
                kept.push_back(x);
        abscissae_ = kept;
    }

    /// Adds the abscissae at which the difference of two pieces changes sign, or at which they touch.
    void crossings(int a, int b) {
        const Piece &p = pieces_[static_cast<std::size_t>(a)], &q = pieces_[static_cast<std::size_t>(b)];
        const double low = std::max(p.front().x, q.front().x), high = std::min(p.back().x, q.back().x);
        if (!(low < high)) return;
        std::vector<double> xs{low, high};
        for (const Piece* piece : {&p, &q})
            for (const PlanePoint& point : *piece)
                if (point.x > low && point.x < high) xs.push_back(point.x);
        std::sort(xs.begin(), xs.end());
        const std::vector<double> gaps = differences(a, b, xs);
        touches(xs, gaps);
        double before = gaps[0];
        for (std::size_t k = 1; k < xs.size(); ++k) {
            const double now = gaps[k];
            if ((before < 0 && now > 0) || (before > 0 && now < 0))
                abscissae_.push_back(xs[k - 1] + (xs[k] - xs[k - 1]) * before / (before - now));
            if (now != 0) before = now;
        }
    }
    /// Adds the abscissae at which a piece touches the window's bottom or top.
    void border_touches(int piece) {
        std::vector<double> xs;
        for (const PlanePoint& point : pieces_[static_cast<std::size_t>(piece)]) xs.push_back(point.x);
        for (const int border : {-1, -2}) touches(xs, differences(piece, border, xs));
    }
    std::vector<double> differences(int a, int b, const std::vector<double>& xs) const {
        std::vector<double> y;
        for (const double x : xs) y.push_back(height_at(a, x) - height_at(b, x));
        return y;
    }
    /// Adds the ends, among xs, of each part on which pieces are within what counts as closed, and where they are
    /// nearest to each other. A part that reaches an end of the pieces, as at a cusp, counts only if they lie over each
    /// other.
    void touches(const std::vector<double>& xs, const std::vector<double>& gaps) {
        for (const double most : {closed(), thin()})
            for (std::size_t k = 0; k < xs.size(); ++k) {
                if (!(std::abs(gaps[k]) <= most)) continue;
                const std::size_t begin = k;
                std::size_t nearest = k;
                for (; k < xs.size() && std::abs(gaps[k]) <= most; ++k)
                    if (std::abs(gaps[k]) < std::abs(gaps[nearest])) nearest = k;
                if ((begin > 0 && k < xs.size()) || most == thin())
                    abscissae_.insert(abscissae_.end(), {xs[begin], xs[nearest], xs[k - 1]});
            }
    }

    /// The longest part of a vertical segment without a wall.
    double opening(double x, double low, double high) const {
        std::vector<std::pair<double, double>> closed;
        for (const Wall& wall : walls_)
            if (std::abs(wall.x - x) <= 2 * same_x() && wall.high > low && wall.low < high)
                closed.emplace_back(wall.low, wall.high);
        std::sort(closed.begin(), closed.end());
        double longest = 0;
        for (const auto& [from, to] : closed) {
            longest = std::max(longest, from - low);
            low = std::max(low, to);
        }
        return std::max(longest, high - low);
    }
    void add_border(int below, int above, std::size_t curve) {
        const RegionBorder border{cells_[static_cast<std::size_t>(below)].region,
                                  cells_[static_cast<std::size_t>(above)].region, curve};
        if (border.below != border.above && std::find(borders_.begin(), borders_.end(), border) == borders_.end())
            borders_.push_back(border);
    }
    /// Borders along walls: the region on the left is named first.
    void add_wall_borders() {
        for (const Wall& wall : walls_)
            for (std::size_t k = 1; k < slabs_.size(); ++k) {
                if (std::abs(slabs_[k].low - wall.x) > 2 * same_x()) continue;
                for (const Bounds& a : slabs_[k - 1].cells)
                    for (const Bounds& b : slabs_[k].cells) {
                        const double x = slabs_[k].low;
                        const double low = std::max({height_at(a.lower, x), height_at(b.lower, x), wall.low});
                        const double high = std::min({height_at(a.upper, x), height_at(b.upper, x), wall.high});
                        if (high - low > closed()) add_border(a.cell, b.cell, wall.curve);
                    }
            }
    }

    /// A cell of a slab; its centre is in the middle, unless it is more than twice as high elsewhere.
    Cell cell_between(const Slab& slab, int lower, int upper, int number) const {
        Cell y{{slab.low, slab.high}, {}, -1, number, lower, upper};
        for (const double share : shares) {
            const double x = slab.low + share * (slab.high - slab.low);
            const double low = std::max(height_at(lower, x), window_.y.low);
            const double high = std::min(height_at(upper, x), window_.y.high);
            if (high - low > 2 * y.height) y.height = high - low, y.center = {x, 0.5 * (low + high)};
        }
        return y;
    }

    void build_cells() {
        std::vector<std::pair<int, int>> neighbours;  // cells of one region
        for (std::size_t k = 0; k + 1 < abscissae_.size(); ++k) {
            Slab slab{abscissae_[k], abscissae_[k + 1], {}};
            const double middle = 0.5 * (slab.low + slab.high);
            std::vector<std::pair<double, int>> heights;  // pieces that touch in the middle differ elsewhere
            for (std::size_t p = 0; p < pieces_.size(); ++p) {
                if (!(pieces_[p].front().x < middle && pieces_[p].back().x > middle)) continue;
                const int piece = static_cast<int>(p);
                double sum = 0;
                for (const double share : shares) sum += height_at(piece, slab.low + share * (slab.high - slab.low));
                heights.emplace_back(sum, piece);
            }
            std::sort(heights.begin(), heights.end());
            std::vector<int> order{-1};
            for (const auto& [sum, piece] : heights) order.push_back(piece);
            order.push_back(-2);
            for (std::size_t i = 0; i + 1 < order.size(); ++i) {
                const int cell = static_cast<int>(cells_.size());
                const Cell made = cell_between(slab, order[i], order[i + 1], cell);
                if (!(made.height > thin())) continue;
                slab.cells.push_back({order[i], order[i + 1], cell});
                cells_.push_back(made);
            }
            if (!slabs_.empty())
                for (const Bounds& a : slabs_.back().cells)
                    for (const Bounds& b : slab.cells) {
                        const double x = slab.low;
                        const double low = std::max(height_at(a.lower, x), height_at(b.lower, x));
                        const double high = std::min(height_at(a.upper, x), height_at(b.upper, x));
                        if (opening(x, low, high) > closed()) neighbours.push_back({a.cell, b.cell});
                    }
            slabs_.push_back(slab);
        }
        boost::disjoint_sets_with_storage<> regions(cells_.size());
        for (const auto& [a, b] : neighbours) regions.union_set(a, b);
        std::vector<int> number(cells_.size(), -1);
        for (Cell& cell : cells_) {
            int& n = number[regions.find_set(cell.region)];
            if (n < 0) n = regions_++;
            cell.region = n;
        }
        for (const Slab& slab : slabs_)
            for (std::size_t i = 1; i < slab.cells.size(); ++i) {
                const Bounds &below = slab.cells[i - 1], &above = slab.cells[i];
                if (below.upper != above.lower || below.upper < 0) continue;
                add_border(below.cell, above.cell, curve_of_[static_cast<std::size_t>(below.upper)]);
            }
        add_wall_borders();
    }

    Window window_;
    std::vector<Piece> pieces_;
    std::vector<Wall> walls_;
    std::vector<std::size_t> curve_of_;  ///< of each piece
    std::vector<RegionBorder> borders_;
    std::vector<double> abscissae_;
    std::vector<Slab> slabs_;
    std::vector<Cell> cells_;
    int regions_ = 0;
};

}  // namespace equilibria
