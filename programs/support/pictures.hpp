// Pictures as files: the options --svg and --png, drawn by gnuplot from the scripts of plots/.
#pragma once

#include <equilibria/io/gnuplot.hpp>
#include <optional>
#include <string>

#include "output_file.hpp"

namespace support {

/// The size of a picture in pixels of the SVG; the PNG has twice as many.
struct PictureSize {
    int width, height;
};

inline std::string svg_terminal(PictureSize size) {
    return "svg size " + std::to_string(size.width) + "," + std::to_string(size.height) +
           " font 'Helvetica,14' background 'white'";
}
inline std::string png_terminal(PictureSize size) {
    return "pngcairo size " + std::to_string(2 * size.width) + "," + std::to_string(2 * size.height) +
           " fontscale 1.8 linewidth 2 pointscale 2";
}

struct Pictures {
    std::optional<OutputFile> svg, png;

    /// `what`: "the figure".
    void add_to(CommandLine& app, const std::string& what) {
        add_output(app, "--svg", svg, "draw " + what + " to this SVG file (needs gnuplot)");
        add_output(app, "--png", png, "draw " + what + " to this PNG file (needs gnuplot)");
    }
    bool asked() const { return svg || png; }
    /// Throws std::runtime_error where gnuplot is missing or refuses the script.
    void draw(PictureSize size, const equilibria::GnuplotData& data, const std::string& script) const {
        if (svg) svg->write(equilibria::gnuplot(svg_terminal(size), data.text() + script));
        if (png) png->write(equilibria::gnuplot(png_terminal(size), data.text() + script));
    }
};

}  // namespace support
