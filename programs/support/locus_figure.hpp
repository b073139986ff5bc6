// What figures of loci share: their data, and where numbers can stand.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include <equilibria/io/gnuplot.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>

namespace support {

/// The data blocks $folds, $pitchforks and $cusps, each name followed by `suffix`.
template <equilibria::Model M>
std::string locus_blocks(const equilibria::Locus<M>& locus, const std::string& suffix = "") {
    std::ostringstream folds, pitchforks, cusps;
    for (auto* s : {&folds, &pitchforks, &cusps}) s->precision(12);
    for (const auto& curve : locus.curves) {
        auto& rows = curve.kind == equilibria::SingularityKind::fold ? folds : pitchforks;
        for (const auto& p : curve.points) rows << p.x() << ' ' << p.y() << '\n';
        rows << "\n\n";
    }
    for (const auto& c : locus.of(equilibria::SingularityKind::cusp)) cusps << c.x() << ' ' << c.y() << '\n';
    std::string out;
    for (const auto& [name, rows] :
         {std::pair{"folds", folds.str()}, std::pair{"pitchforks", pitchforks.str()}, std::pair{"cusps", cusps.str()}})
        out += equilibria::gnuplot_block(name + suffix, rows.empty() ? "nan nan\n" : rows);
    return out;
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
