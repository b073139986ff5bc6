// What figures of loci share: their data, and where numbers can stand.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/io/gnuplot.hpp>
#include <equilibria/locus/plane/locus_result.hpp>

namespace support {

/// The data blocks $folds, $pitchforks, $cusps and $infinite (curves on which equilibria come from infinity), each name
/// followed by `suffix`.
template <class M>
void add_locus(equilibria::GnuplotData& data, const equilibria::Locus<M>& locus, const std::string& suffix = "") {
    std::ostringstream folds, pitchforks, cusps, infinite;
    for (auto* s : {&folds, &pitchforks, &cusps, &infinite}) s->precision(12);
    for (const auto& curve : locus.curves) {
        auto& rows = curve.kind == equilibria::SingularityKind::fold ? folds : pitchforks;
        for (const auto& p : curve.points) rows << p.x() << ' ' << p.y() << '\n';
        rows << "\n\n";
    }
    for (const auto& curve : locus.from_infinity) {
        for (const auto& p : curve.points) infinite << p.x << ' ' << p.y << '\n';
        infinite << "\n\n";
    }
    for (const auto& c : locus.of(equilibria::SingularityKind::cusp)) cusps << c.x() << ' ' << c.y() << '\n';
    data.block("folds" + suffix, folds.str())
        .block("pitchforks" + suffix, pitchforks.str())
        .block("cusps" + suffix, cusps.str())
        .block("infinite" + suffix, infinite.str());
}

/// The window as x_low, x_high, y_low, y_high.
inline void add_window(equilibria::GnuplotData& data, const equilibria::Window& w) {
    data.value("x_low", w.x.low).value("x_high", w.x.high).value("y_low", w.y.low).value("y_high", w.y.high);
}

/// Whether a curve passes within these parts of the window of the place of a number.
template <class M>
bool crowded(const equilibria::PlanePoint& at, const equilibria::Locus<M>& locus, double width, double height) {
    for (const auto& curve : locus.curves)
        for (const auto& p : curve.points)
            if (std::abs(p.x() - at.x) < width * locus.window.width() &&
                std::abs(p.y() - at.y) < height * locus.window.height())
                return true;
    for (const auto& curve : locus.from_infinity)
        for (const auto& p : curve.points)
            if (std::abs(p.x - at.x) < width * locus.window.width() &&
                std::abs(p.y - at.y) < height * locus.window.height())
                return true;
    return false;
}

/// What a figure calls things, as gnuplot writes them.
struct LocusNames {
    std::string heading, x, y;
    std::string x_label{};  ///< of the axis, where it says more than x
};

/// A window around a cusp that shows both branches of its fold curve, and no further than the nearest border is.
template <class M>
equilibria::Window around(const equilibria::Singularity<M>& cusp, const equilibria::Locus<M>& locus) {
    const auto& w = locus.window;
    const equilibria::PlanePoint c{cusp.x(), cusp.y()};
    const double x_reach = std::min({0.011 * w.width(), c.x - w.x.low, w.x.high - c.x});
    const double y_reach = std::min({0.055 * w.height(), c.y - w.y.low, w.y.high - c.y});
    equilibria::Window box{{c.x, c.x}, {c.y, c.y}};
    for (const auto& curve : locus.curves) {
        const auto at = std::find_if(curve.points.begin(), curve.points.end(),
                                     [&](const auto& p) { return p.x() == c.x && p.y() == c.y; });
        if (at == curve.points.end()) continue;
        const auto add = [&](const auto& point) {
            const equilibria::PlanePoint p{point.x(), point.y()};
            const bool near = std::abs(p.x - c.x) <= x_reach && std::abs(p.y - c.y) <= y_reach;
            if (near)
                box = {{std::min(box.x.low, p.x), std::max(box.x.high, p.x)},
                       {std::min(box.y.low, p.y), std::max(box.y.high, p.y)}};
            return !near;
        };
        std::find_if(at, curve.points.end(), add);
        std::find_if(std::make_reverse_iterator(at), curve.points.rend(), add);
    }
    const double dx = 0.15 * box.width() + 1e-9 * w.width(), dy = 0.15 * box.height() + 1e-9 * w.height();
    return {{std::max(w.x.low, box.x.low - dx), std::min(w.x.high, box.x.high + dx)},
            {std::max(w.y.low, box.y.low - dy), std::min(w.y.high, box.y.high + dy)}};
}

/// The tics of an axis from `low` to `high`: two to four round numbers, as powers of ten where they are small.
struct Tics {
    std::string format;
    double step;
    bool bare_zero;  ///< 0 without a power of ten
};
inline Tics tics(double low, double high) {
    const double least = (high - low) / 3.5, power = std::pow(10, std::floor(std::log10(least)));
    const double step = power * (least <= 2 * power ? 2 : least <= 5 * power ? 5 : 10);
    const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    if (std::max(std::abs(low), std::abs(high)) < 1e-3) return {"%.0t×10^{%T}", step, true};
    return {"%." + std::to_string(digits) + "f", step, false};
}

/// Where a cusp is, in words.
inline std::string place(const equilibria::PlanePoint& c, const LocusNames& names) {
    std::ostringstream out;
    out.precision(4);
    out << names.x << " = ";
    if (c.x > 0 && c.x < 1e-3) {
        const double power = std::floor(std::log10(c.x));
        out << c.x / std::pow(10, power) << "·10^{" << power << '}';
    } else {
        out << c.x;
    }
    out.precision(6);
    out << ", " << names.y << " = " << c.y;
    return out.str();
}

/// Windows around cusps as arrays.
inline void add_windows(equilibria::GnuplotData& data, const std::string& name,
                        const std::vector<equilibria::Window>& windows) {
    const auto add = [&](const std::string& axis, equilibria::Interval equilibria::Window::* member) {
        std::vector<double> low, high;
        for (const auto& w : windows) low.push_back((w.*member).low), high.push_back((w.*member).high);
        data.values(name + axis + "_low", low);
        data.values(name + axis + "_high", high);
    };
    add("_x", &equilibria::Window::x);
    add("_y", &equilibria::Window::y);
}

/// Insets around the first two cusps.
template <class M>
void add_insets(equilibria::GnuplotData& data, const equilibria::Locus<M>& locus, const LocusNames& names) {
    const auto& w = locus.window;
    std::vector<equilibria::Window> boxes, frames;
    std::vector<std::string> titles, formats[2];
    std::vector<double> steps[2], zeros[2];
    const auto cusps = locus.of(equilibria::SingularityKind::cusp);
    for (std::size_t k = 0; k < std::min<std::size_t>(2, cusps.size()); ++k) {
        const equilibria::PlanePoint c{cusps[k].x(), cusps[k].y()};
        const auto box = around(cusps[k], locus);
        boxes.push_back(box);
        // large enough to be seen
        frames.push_back({{std::max(w.x.low, std::min(box.x.low, c.x - 0.013 * w.width())),
                           std::min(w.x.high, std::max(box.x.high, c.x + 0.013 * w.width()))},
                          {std::max(w.y.low, std::min(box.y.low, c.y - 0.013 * w.height())),
                           std::min(w.y.high, std::max(box.y.high, c.y + 0.013 * w.height()))}});
        titles.push_back(place(c, names));
        const Tics axes[] = {tics(box.x.low, box.x.high), tics(box.y.low, box.y.high)};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            formats[axis].push_back(axes[axis].format);
            steps[axis].push_back(axes[axis].step);
            zeros[axis].push_back(axes[axis].bare_zero ? 1 : 0);
        }
    }
    data.integer("insets", static_cast<long long>(boxes.size())).strings("inset_title", titles);
    add_windows(data, "box", boxes);
    add_windows(data, "frame", frames);
    data.strings("x_format", formats[0]).values("x_step", steps[0]).values("x_zero", zeros[0]);
    data.strings("y_format", formats[1]).values("y_step", steps[1]).values("y_zero", zeros[1]);
}

/// Curves, cusps, regions with their counts, and insets, for plots::bifurcation_locus.
template <class M>
equilibria::GnuplotData locus_figure(const equilibria::Locus<M>& locus, const LocusNames& names) {
    equilibria::GnuplotData data;
    data.string("heading", names.heading);
    data.string("x_label", names.x_label.empty() ? names.x : names.x_label).string("y_label", names.y);
    add_window(data, locus.window);
    add_locus(data, locus);
    data.integer("from_infinity", static_cast<long long>(locus.from_infinity.size()));
    std::vector<std::string> counts;
    std::vector<double> x, y, sizes;
    for (const auto& r : locus.regions)
        if (r.area > 1e-3 * locus.window.width() * locus.window.height()) {
            counts.push_back(std::to_string(r.count));
            x.push_back(r.point.x);
            y.push_back(r.point.y);
            sizes.push_back(crowded(r.point, locus, 0.022, 0.02) ? 12 : 17);
        }
    data.integer("labels", static_cast<long long>(counts.size())).strings("label_text", counts);
    data.values("label_x", x).values("label_y", y).values("label_size", sizes);
    add_insets(data, locus, names);
    return data;
}

}  // namespace support
