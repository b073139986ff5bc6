// The planes side by side: a panel for each, with the number of equilibria in each region that has room for it.
#pragma once

#include <array>
#include <cstddef>
#include <equilibria/io/gnuplot.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "fold_surface/sheets.hpp"
#include "support/locus_figure.hpp"
#include "support/pictures.hpp"

namespace fold_surface {

/// How the panels of a figure lie, in pixels of the SVG.
struct Layout {
    static constexpr double panel_width = 300, panel_height = 250, across = 26, down = 48;
    static constexpr double left = 74, right = 22, top = 86, bottom = 134;
    std::size_t columns, rows;

    explicit Layout(std::size_t count)
        : columns(count <= 3   ? count
                  : count == 4 ? 2
                  : count <= 9 ? 3
                               : 4),
          rows((count + columns - 1) / columns) {}
    double width() const { return left + right + static_cast<double>(columns) * (panel_width + across) - across; }
    double height() const { return top + bottom + static_cast<double>(rows) * (panel_height + down) - down; }
    support::PictureSize size() const { return {static_cast<int>(width()), static_cast<int>(height())}; }
    /// Left, right, top and bottom of a panel, as parts of the picture.
    std::array<double, 4> margins(std::size_t column, std::size_t row) const {
        const double x = left + static_cast<double>(column) * (panel_width + across);
        const double y = height() - top - static_cast<double>(row) * (panel_height + down);
        return {x / width(), (x + panel_width) / width(), y / height(), (y - panel_height) / height()};
    }
};

inline std::string cusp_count(const Locus& locus) {
    const std::size_t n = locus.of(equilibria::SingularityKind::cusp).size();
    return n == 0 ? "no cusp" : n == 1 ? "1 cusp" : std::to_string(n) + " cusps";
}

/// Where the panels lie and what stands above them.
inline void add_panels(equilibria::GnuplotData& data, const std::vector<const Plane*>& planes) {
    const Layout layout(planes.size());
    std::vector<std::string> titles;
    std::vector<double> margins[4], lowest, leftmost;
    for (std::size_t k = 0; k < planes.size(); ++k) {
        const auto& locus = planes[k]->locus;
        std::ostringstream title;
        title.precision(10);
        title << "{/:Italic r} = " << planes[k]->ratio << ", " << cusp_count(locus)
              << (locus.evidence.complete() ? "" : ", NOT COMPLETE");
        titles.push_back(title.str());
        const auto sides = layout.margins(k % layout.columns, k / layout.columns);
        for (std::size_t side = 0; side < 4; ++side) margins[side].push_back(sides[side]);
        lowest.push_back(k + layout.columns >= planes.size());
        leftmost.push_back(k % layout.columns == 0);
    }
    data.integer("planes", static_cast<long long>(planes.size())).value("height", layout.height());
    data.strings("panel_title", titles).values("lowest", lowest).values("leftmost", leftmost);
    data.values("panel_left", margins[0]).values("panel_right", margins[1]);
    data.values("panel_top", margins[2]).values("panel_bottom", margins[3]);
}

/// The numbers of equilibria, where there is room.
inline void add_labels(equilibria::GnuplotData& data, const std::vector<const Plane*>& planes) {
    std::vector<std::string> texts;
    std::vector<double> panels, x, y;
    for (std::size_t k = 0; k < planes.size(); ++k) {
        const auto& locus = planes[k]->locus;
        for (const auto& r : locus.regions) {
            const std::string text = std::to_string(r.count);
            const double width = 0.01 + 0.012 * static_cast<double>(text.size());
            if (r.area <= 0.01 * locus.window.width() * locus.window.height() ||
                support::crowded(r.point, locus, width, 0.027))
                continue;
            texts.push_back(text);
            panels.push_back(static_cast<double>(k + 1));
            x.push_back(r.point.x);
            y.push_back(r.point.y);
        }
    }
    data.integer("labels", static_cast<long long>(texts.size())).strings("label_text", texts);
    data.values("label_plane", panels).values("label_x", x).values("label_y", y);
}

/// For plots/fold_surface.gp; there is at least one plane.
inline equilibria::GnuplotData plotted(const std::vector<const Plane*>& planes) {
    equilibria::GnuplotData data;
    for (std::size_t k = 0; k < planes.size(); ++k) support::add_locus(data, planes[k]->locus, std::to_string(k));
    support::add_window(data, planes.front()->locus.window);
    add_panels(data, planes);
    add_labels(data, planes);
    return data;
}

}  // namespace fold_surface
