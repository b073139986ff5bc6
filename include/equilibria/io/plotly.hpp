/// \file
/// Interactive views in three dimensions: one HTML file that holds the data and the library Plotly, which draws them.
/// It needs a browser with WebGL and no network; a content security policy forbids it to reach one. scripts/plotly
/// fetches the library.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <equilibria/core/error.hpp>

namespace equilibria {

/// The colours of Okabe and Ito, Color universal design (2008), told apart by colour-blind readers too: blue,
/// vermilion, bluish green, reddish purple, orange, sky blue, yellow, black. Traces without a colour get them in this
/// order.
inline constexpr std::array<std::string_view, 8> okabe_ito{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                           "#e69f00", "#56b4e9", "#f0e442", "#000000"};

/// An axis of a view.
struct PlotlyAxis {
    std::string title;   ///< in Plotly's markup
    bool angle = false;  ///< whether the values are in radians: ticks at multiples of pi, or of pi over a power of two
};

/// What a view shows. Titles are in UTF-8 and in Plotly's markup: `<i>`, `<b>`, `<sub>`, `<sup>`, `<br>`, and `&lt;`
/// for a `<`. Those of axes are drawn upright whatever the markup, and a long line is cut where the window ends.
struct PlotlyView {
    std::string title;          ///< above the view
    std::string subtitle = {};  ///< below it, smaller
    PlotlyAxis x;               ///< first axis
    PlotlyAxis y;               ///< second axis
    PlotlyAxis z;               ///< third axis, upwards
    /// A JSON array of Plotly's traces (scatter3d, surface, mesh3d, ...); null is a gap. Each may set its "name", and
    /// "showlegend" for a surface to be in the legend. Light, and what is shown under the pointer, are set where a
    /// trace does not.
    std::string traces;
};

namespace detail {

/// JSON for a script element: `<`, which legal JSON has inside strings alone, is spelled so that no tag can end the
/// element or open a comment.
inline std::string without_tags(std::string_view json) {
    std::string out;
    for (const char c : json) c == '<' ? out += "\\u003c" : out += c;
    return out;
}

inline std::string json_string(std::string_view text) {
    constexpr char digits[] = "0123456789abcdef";
    std::string out = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20)
            out += std::string("\\u00") + digits[code / 16] + digits[code % 16];
        else if (c == '"' || c == '\\')
            out += {'\\', c};
        else
            out += c;
    }
    return without_tags(out + '"');
}

/// Plotly's markup as the text of an HTML title: no tags.
inline std::string plain_title(std::string_view markup) {
    const auto letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '/'; };
    std::string out;
    for (std::size_t at = 0; at < markup.size(); ++at) {
        const bool tag = markup[at] == '<' && at + 1 < markup.size() && letter(markup[at + 1]);
        if (const auto end = markup.find('>', at); tag && end != markup.npos)
            at = end;
        else if (markup[at] == '<')
            out += "&lt;";
        else
            out += markup[at];
    }
    return out;
}

inline constexpr std::string_view plotly_script = R"js(
const show = (message) => {
    const paragraph = document.createElement("p");
    paragraph.textContent = message;
    document.getElementById("view").replaceChildren(paragraph);
};
// "3π/2" for 1.5 in units of π
const label = (multiple, denominator) => {
    let n = Math.abs(multiple), d = denominator;
    while (n % 2 === 0 && d > 1) n /= 2, d /= 2;
    if (n === 0) return "0";
    return (multiple < 0 ? "−" : "") + (n === 1 ? "" : n) + "π" + (d === 1 ? "" : "/" + d);
};
const angleTicks = (traces, name) => {
    let low = Infinity, high = -Infinity;
    for (const trace of traces)
        for (const value of Array.isArray(trace[name]) ? trace[name].flat() : [])
            if (Number.isFinite(value)) low = Math.min(low, value), high = Math.max(high, value);
    if (!(low < high)) return {};
    let denominator = 1;
    while ((high - low) * denominator / Math.PI < 3.5 && denominator < 1024) denominator *= 2;
    while ((high - low) * denominator / Math.PI > 16) denominator /= 2;
    const step = Math.PI / denominator, ticks = {tickmode: "array", tickvals: [], ticktext: []};
    for (let k = Math.floor(low / step); k <= Math.ceil(high / step); ++k) {
        ticks.tickvals.push(k * step);
        ticks.ticktext.push(label(denominator < 1 ? k / denominator : k, Math.max(denominator, 1)));
    }
    return ticks;
};
const draw = async () => {
    const view = JSON.parse(document.getElementById("data").textContent), scene = {};
    for (const name of ["x", "y", "z"])
        scene[name + "axis"] = {
            title: {text: view[name].title, font: {size: 20}}, tickfont: {size: 13},
            backgroundcolor: "#ffffff", showbackground: true, gridcolor: "#d9d9d9", zeroline: false,
            linecolor: "#404040", showline: true, mirror: true, showspikes: false, ticks: "outside",
            tickcolor: "#404040", ...(view[name].angle ? angleTicks(view.traces, name) : {})
        };
    for (const trace of view.traces) {
        trace.hovertemplate ??= ["x", "y", "z"].map((name) => `${view[name].title} = %{${name}:.6g}`).join("<br>") +
            `<extra>${trace.name ?? ""}</extra>`;
        if (trace.type === "surface" || trace.type === "mesh3d") {
            trace.lighting ??= {ambient: 0.75, diffuse: 0.45, specular: 0.05, roughness: 0.9, fresnel: 0.05};
            trace.lightposition ??= {x: 3e4, y: -6e4, z: 1e5};
        }
    }
    const far = Math.max(1, innerHeight / innerWidth);  // in a narrow window
    const font = {family: "Helvetica Neue, Helvetica, Arial, Liberation Sans, sans-serif", color: "#202020"};
    await Plotly.newPlot("view", view.traces, {
        title: {text: view.title, subtitle: {text: view.subtitle, font: {size: 15, color: "#505050"}},
                font: {size: 22}, x: 0, xref: "paper", xanchor: "left", y: 1, yref: "container", yanchor: "top",
                pad: {t: 22}},
        font, colorway: view.colours, paper_bgcolor: "#ffffff",
        margin: {l: 24, r: 24, t: view.subtitle ? 84 : 60, b: 28},
        scene: {...scene, aspectmode: "cube", dragmode: "turntable",
                camera: {eye: {x: 1.08 * far, y: -1.6 * far, z: 0.8 * far}, center: {x: 0, y: 0, z: -0.13}}},
        showlegend: true, legend: {x: 0, y: 1, xanchor: "left", yanchor: "top", itemsizing: "constant",
                                   bgcolor: "rgba(255,255,255,0.8)", font: {size: 15}},
        hoverlabel: {bgcolor: "#ffffff", bordercolor: "#808080", font: {...font, size: 14}},
        annotations: [{text: "Drag to turn, scroll to zoom, click in the legend to hide or show", showarrow: false,
                       xref: "paper", yref: "paper", x: 0, y: 0, xanchor: "left", yanchor: "top", yshift: -4,
                       font: {size: 12, color: "#707070"}}]
    }, {responsive: true, displaylogo: false,
        toImageButtonOptions: {format: "png", scale: 3, filename: document.title}});
};
draw().catch((error) => show("This view cannot be drawn: " + error.message));
)js";

}  // namespace detail

/// The HTML page of a view, complete in itself; `library` is the text of a minified Plotly 3 with three-dimensional
/// traces. Throws InvalidArgument for a library that is empty or that could not stand inside a script element, and for
/// traces that are no JSON array. (What is wrong inside them, the page says.)
inline std::string plotly_page(const PlotlyView& view, const std::string& library) {
    require(!library.empty(), "library", "''", "must be the text of plotly.min.js");
    std::string lower = library;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const std::string tag : {"</script", "<!--"})
        if (const auto at = lower.find(tag); at != lower.npos)
            require(false, "library", library.substr(at, tag.size()) + " at byte " + std::to_string(at),
                    "must have neither </script nor <!--: it stands inside a script element");
    constexpr std::string_view spaces = " \t\r\n";
    const auto first = view.traces.find_first_not_of(spaces), last = view.traces.find_last_not_of(spaces);
    require(first != last && view.traces[first] == '[' && view.traces[last] == ']', "traces",
            view.traces.empty() ? "''" : view.traces.substr(0, 40), "must be a JSON array");

    const auto axis = [](const PlotlyAxis& a) {
        return "{\"title\":" + detail::json_string(a.title) + ",\"angle\":" + (a.angle ? "true" : "false") + "}";
    };
    std::string colours;
    for (const auto colour : okabe_ito) colours += (colours.empty() ? "" : ",") + detail::json_string(colour);
    std::string page = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src
'unsafe-inline'; img-src data: blob:">
<title>)html";
    page += detail::plain_title(view.title);
    page += R"html(</title>
<style>
html, body, #view { height: 100%; margin: 0; background: #fff; overflow: hidden; }
p { font: 16px sans-serif; margin: 2em; }
</style>
</head>
<body>
<noscript><p>This view is drawn by JavaScript, which is switched off here.</p></noscript>
<div id="view"></div>
<script>)html";
    page += library;
    page += "</script>\n<script id=\"data\" type=\"application/json\">\n{\"title\":" + detail::json_string(view.title) +
            ",\"subtitle\":" + detail::json_string(view.subtitle) + ",\"x\":" + axis(view.x) +
            ",\"y\":" + axis(view.y) + ",\"z\":" + axis(view.z) + ",\"colours\":[" + colours +
            "],\n\"traces\":" + detail::without_tags(view.traces) + "}\n</script>\n<script>";
    page += detail::plotly_script;
    page += "</script>\n</body>\n</html>\n";
    return page;
}

}  // namespace equilibria
