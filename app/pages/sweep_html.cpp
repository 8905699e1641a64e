// SPDX-License-Identifier: Apache-2.0
// See sweep_html.hpp. Foreign text is escaped when it is inserted into the page.
#include "app/pages/sweep_html.hpp"

#include <fmt/format.h>

#include "app/command/options.hpp"
#include "app/pages/page.hpp"
#include "base/diagnostics/escape.hpp"

namespace robochart::app {
namespace {

using diagnostics::xml_text;

const char* answer_class(std::string_view word) {
    if (word == "proved") return "holds";
    return word == "refuted" ? "fails" : "other";
}

std::string sweep_row(const simulation::Scenario& scenario, const simulation::PointResult& point, std::size_t claim) {
    const simulation::ClaimResult& found = point.claims[claim];
    const std::string word = simulation::point_word(point, claim);
    std::string row = "<tr>";
    for (std::size_t v = 0; v < point.point.size(); ++v)
        row +=
            fmt::format("<td class=\"number\">{}</td>", simulation::value_text(scenario.variations[v], point.point[v]));
    return row + fmt::format("<td class=\"answer {}\">{}</td><td>{}</td><td>{}</td></tr>\n", answer_class(word), word,
                             xml_text(simulation::evidence_text(scenario.claims[claim], found)),
                             simulation::median_text(scenario.claims[claim], found));
}

std::string sweep_table(const simulation::Scenario& scenario, const simulation::SweepResult& result,
                        std::size_t claim) {
    std::string out = fmt::format("<h2>{}</h2>\n<div class=\"sim-wide\"><table class=\"sortable\"><thead><tr>",
                                  xml_text(scenario.claims[claim].text));
    for (const simulation::Variation& variation : scenario.variations)
        out += fmt::format("<th scope=\"col\">{}</th>", xml_text(simulation::name_of(variation)));
    out +=
        "<th scope=\"col\">answer</th><th scope=\"col\">rests on (joint interval)</th><th scope=\"col\">median "
        "time</th></tr></thead>\n<tbody>\n";
    for (const simulation::PointResult& point : result.points)
        if (!point.claims.empty()) out += sweep_row(scenario, point, claim);
    return out + "</tbody></table></div>\n";
}

}  // namespace

std::string render_sweep_html(const simulation::Scenario& scenario, const simulation::SweepResult& result,
                              const std::vector<simulation::SweepPlot>& plots, const RunRecord& run) {
    std::string out =
        fmt::format("<style>{}</style>\n<h1>{}</h1>\n", page_part("simulation.css"), xml_text(scenario.name.text));
    for (const std::string& line : simulation::least_lines(scenario, result))
        out += fmt::format("<p class=\"answer\">{}</p>\n", xml_text(line));
    out += fmt::format("<p class=\"sim-small\">robochart-verify {}; {} points, jointly</p>\n", program_version,
                       result.points.size());
    for (std::size_t c = 0; c < scenario.claims.size(); ++c) out += sweep_table(scenario, result, c);
    for (const simulation::SweepPlot& plot : plots) out += fmt::format("<figure>{}</figure>\n", plot.svg);
    out += "<h2>In this world</h2>\n<ul>\n";
    for (const std::string& line : simulation::world_lines(scenario))
        out += fmt::format("<li>{}</li>\n", xml_text(line));
    return page_text({scenario.name.text, "simulation.js", out + "</ul>\n", run});
}

}  // namespace robochart::app
