// What figures of loci share: their data, and where numbers can stand.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include <equilibria/io/gnuplot.hpp>
#include <equilibria/locus/plane/locus_result.hpp>

namespace support {

/// The data blocks $folds, $pitchforks and $cusps, each name followed by `suffix`.
template <equilibria::Model M>
void add_locus(equilibria::GnuplotData& data, const equilibria::Locus<M>& locus, const std::string& suffix = "") {
    std::ostringstream folds, pitchforks, cusps;
    for (auto* s : {&folds, &pitchforks, &cusps}) s->precision(12);
    for (const auto& curve : locus.curves) {
        auto& rows = curve.kind == equilibria::SingularityKind::fold ? folds : pitchforks;
        for (const auto& p : curve.points) rows << p.x() << ' ' << p.y() << '\n';
        rows << "\n\n";
    }
    for (const auto& c : locus.of(equilibria::SingularityKind::cusp)) cusps << c.x() << ' ' << c.y() << '\n';
    data.block("folds" + suffix, folds.str())
        .block("pitchforks" + suffix, pitchforks.str())
        .block("cusps" + suffix, cusps.str());
}

/// The window as x_low, x_high, y_low, y_high.
inline void add_window(equilibria::GnuplotData& data, const equilibria::Window& w) {
    data.value("x_low", w.x.low).value("x_high", w.x.high).value("y_low", w.y.low).value("y_high", w.y.high);
}

/// Whether a curve passes within these parts of the window of the place of a number.
template <equilibria::Model M>
bool crowded(const equilibria::PlanePoint& at, const equilibria::Locus<M>& locus, double width, double height) {
    for (const auto& curve : locus.curves)
        for (const auto& p : curve.points)
            if (std::abs(p.x() - at.x) < width * locus.window.width() &&
                std::abs(p.y() - at.y) < height * locus.window.height())
                return true;
    return false;
}

}  // namespace support
