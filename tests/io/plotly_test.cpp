// Pages as text; where node is installed, also what their script hands to Plotly.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

#include <equilibria/io/plotly.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

const std::string library = "window.Plotly = {};";

PlotlyView a_view() {
    return {.title = "Folds of <i>V</i>",
            .subtitle = "all of them",
            .x = {"<i>c</i><sub>2</sub> (N/m)"},
            .y = {"<i>F</i> (N)"},
            .z = {"θ", true},
            .traces = R"([{"type": "scatter3d", "x": [1, 2], "y": [3, null], "z": [-3.1, 3.1], "name": "a < b"}])"};
}

int count(const std::string& text, const std::string& part) {
    int n = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
    return n;
}

}  // namespace

TEST_CASE("a page holds the library, the titles and the traces") {
    const std::string page = plotly_page(a_view(), library);
    CHECK(page == plotly_page(a_view(), library));
    CHECK(page.starts_with("<!DOCTYPE html>"));
    CHECK(page.ends_with("</html>\n"));
    CHECK(count(page, "<script>" + library + "</script>") == 1);
    CHECK(count(page, "<title>Folds of V</title>") == 1);
    CHECK(count(page, R"("title":"Folds of \u003ci>V\u003c/i>")") == 1);
    CHECK(count(page, R"("z":{"title":"θ","angle":true})") == 1);
    CHECK(count(page, R"_("x":{"title":"\u003ci>c\u003c/i>\u003csub>2\u003c/sub> (N/m)","angle":false})_") == 1);
    CHECK(count(page, R"("name": "a \u003c b")") == 1);
    for (const auto colour : okabe_ito) CHECK(count(page, "\"" + std::string(colour) + "\"") >= 1);
}

TEST_CASE("a page reaches no network") {
    const std::string page = plotly_page(a_view(), library);
    for (const char* way : {"src=", "href=", "://", "@import", "url("}) CHECK(count(page, way) == 0);
    CHECK(count(page, "Content-Security-Policy\" content=\"default-src 'none';") == 1);
}

TEST_CASE("neither titles nor traces can end a script element") {
    auto view = a_view();
    const std::string bad = "</script><script>alert(1)</script><!--<script>";
    view.title = view.subtitle = view.x.title = view.y.title = view.z.title = bad;
    view.traces = "[{\"name\": \"" + bad + "\"}]";
    const std::string page = plotly_page(view, library), plain = plotly_page(a_view(), library);
    for (const char* tag : {"<script", "</script", "<!--"}) CHECK(count(page, tag) == count(plain, tag));
    // the library's, the data's and the drawing's
    CHECK(count(page, "</script>") == 3);
}

TEST_CASE("text as JSON") {
    CHECK(detail::json_string("θ\"\\\n\t\x01<b>") == "\"θ\\\"\\\\\\u000a\\u0009\\u0001\\u003cb>\"");
    CHECK(detail::json_string("") == "\"\"");
}

TEST_CASE("markup as plain text") {
    CHECK(detail::plain_title("<i>c</i><sub>2</sub> &lt; 3") == "c2 &lt; 3");
    CHECK(detail::plain_title("1 < 2 > 0") == "1 &lt; 2 > 0");
    CHECK(detail::plain_title("no end <i") == "no end &lt;i");
    CHECK(detail::plain_title("<") == "&lt;");
    CHECK(detail::plain_title("").empty());
}

TEST_CASE("a library that cannot stand in a script element, and traces that are no array, are refused") {
    CHECK_THROWS_WITH(plotly_page(a_view(), ""), "library = '': must be the text of plotly.min.js");
    CHECK_THROWS_WITH(
        plotly_page(a_view(), "abc</Script>"),
        "library = </Script at byte 3: must have neither </script nor <!--: it stands inside a script element");
    CHECK_THROWS_AS(plotly_page(a_view(), "x <!-- y"), InvalidArgument);
    CHECK_NOTHROW(plotly_page(a_view(), "a</scrip b<!-"));
    for (const char* traces : {"", " ", "{}", "[", "]", "[1", "1]", "{\"x\": []}"}) {
        auto view = a_view();
        view.traces = traces;
        CAPTURE(traces);
        CHECK_THROWS_AS(plotly_page(view, library), InvalidArgument);
    }
    auto view = a_view();
    view.traces = "\n [] \n";
    CHECK_NOTHROW(plotly_page(view, library));
}

TEST_CASE("what the page's script hands to Plotly") {
    if (std::system("command -v node > /dev/null") != 0) {
        WARN("not run: node is not installed");
        return;
    }
    std::string folder = (std::filesystem::temp_directory_path() / "equilibria_plotly_XXXXXX").string();
    REQUIRE(mkdtemp(folder.data()) != nullptr);
    /// What the script, run with `data` and with fakes for the browser, prints: the expression `shown` of the arguments
    /// (id, traces, layout, config), or the message in the page.
    const auto run = [&](const std::string& data, const std::string& shown) {
        {
            std::ofstream file(folder + "/page.js");
            file << "const innerWidth = 1600, innerHeight = 900, element = {textContent: " << detail::json_string(data)
                 << ", replaceChildren: (p) => console.log(p.textContent)};\n"
                 << "const document = {title: '', getElementById: () => element, createElement: () => ({})};\n"
                 << "const Plotly = {newPlot: async (id, traces, layout, config) => console.log(JSON.stringify("
                 << shown << "))};\n"
                 << detail::plotly_script;
        }
        REQUIRE(std::system(("node '" + folder + "/page.js' > '" + folder + "/out'").c_str()) == 0);
        std::ostringstream out;
        out << std::ifstream(folder + "/out").rdbuf();
        return out.str();
    };
    const auto data = [](const std::string& z, const std::string& traces) {
        return R"({"title":"t","subtitle":"","x":{"title":"a","angle":false},"y":{"title":"b","angle":false},"z":)" +
               z + R"(,"colours":["#000"],"traces":)" + traces + "}";
    };
    const std::string angle = R"({"title":"c","angle":true})", number = R"({"title":"c","angle":false})";
    const std::string text = "layout.scene.zaxis.ticktext";
    CHECK(run(data(angle, R"([{"z": [-3.1, null, 3.1]}])"), text) == "[\"−π\",\"−π/2\",\"0\",\"π/2\",\"π\"]\n");
    CHECK(run(data(angle, R"([{"z": [[0.1, 0.7], [0.2, 0.8]]}])"), text) ==
          "[\"0\",\"π/16\",\"π/8\",\"3π/16\",\"π/4\",\"5π/16\"]\n");
    CHECK(run(data(angle, R"([{"z": [0, 70]}])"), text) ==
          "[\"0\",\"2π\",\"4π\",\"6π\",\"8π\",\"10π\",\"12π\",\"14π\",\"16π\",\"18π\",\"20π\",\"22π\",\"24π\"]\n");
    CHECK(run(data(angle, R"([{"z": [-3.1, 3.1]}])"), "layout.scene.zaxis.tickvals[1] + Math.PI / 2") == "0\n");
    for (const std::string traces : {"[]", "[{\"z\": [1]}]", "[{\"z\": {\"bdata\": \"\"}}]"})
        CHECK(run(data(angle, traces), text + " ?? 0") == "0\n");
    CHECK(run(data(number, R"([{"z": [-3.1, 3.1]}])"), text + " ?? 0") == "0\n");
    CHECK(run(data(number, R"([{"type": "mesh3d", "name": "n"}, {"hovertemplate": "h"}])"),
              "[traces[0].lighting.ambient, traces[0].hovertemplate, traces[1]]") ==
          "[0.75,\"a = %{x:.6g}<br>b = %{y:.6g}<br>c = %{z:.6g}<extra>n</extra>\",{\"hovertemplate\":\"h\"}]\n");
    CHECK(run(data(number, "[nan]"), "0").starts_with("This view cannot be drawn: "));
    std::filesystem::remove_all(folder);
}
