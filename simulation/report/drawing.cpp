// SPDX-License-Identifier: Apache-2.0
#include "simulation/report/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/diagnostics/escape.hpp"

namespace robochart::simulation {

namespace {

constexpr std::array<const char*, 8> palette = {"#009e73", "#0072b2", "#d55e00", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#f0e442", "#999999"};
/// The colours of the marks on the robots' disks, chosen for contrast.
constexpr std::array<const char*, 8> mark_colours = {"#000000", "#ffffff", "#000000", "#000000",
                                                     "#000000", "#000000", "#000000", "#000000"};
/// Marks for a robot of radius 1 that points to the right.
constexpr std::array<const char*, 5> marks = {"M0 0H1", "M.85 0L-.3 .55V-.55Z", "M0 .35H.9M0 -.35H.9",
                                              "M-.2 0H1M.25 -.55V.55", "M.05 -.6L.7 0L.05 .6"};

struct Scheme {
    const char* ink;
    const char* soft;
    const char* paper;
    const char* floor;
    const char* grid;
    const char* frame;
};
constexpr Scheme light{"#1a1a1a", "#555c64", "#ffffff", "#ffffff", "#e3e6ea", "#444444"};
constexpr Scheme dark{"#e8e8e8", "#b0b7bf", "#16181b", "#1e2125", "#363c43", "#9aa1a9"};

std::string rules_of(const Scheme& s) {
    return fmt::format(
        ".sim-text{{fill:{0}}}.sim-soft{{fill:{1}}}.sim-paper{{fill:{2}}}.sim-floor{{fill:{3};stroke:{5}}}"
        ".sim-grid{{stroke:{4};fill:none}}.sim-axis{{stroke:{5};fill:none}}.sim-body{{stroke:{0}}}.sim-between{{fill:{"
        "3}}}"
        ".sim-target{{stroke:{0}}}.sim-now{{stroke:{0}}}.sim-one{{stroke:{0};fill:none}}.sim-mark{{fill:{0}}}",
        s.ink, s.soft, s.paper, s.floor, s.grid, s.frame);
}

/// Returns the part of a name that is displayed. If the name is too long, the tooltip contains all of it.
std::string short_text(const std::string& name) {
    constexpr std::size_t most = 40;
    if (name.size() <= most) return diagnostics::xml_text(name);
    return fmt::format("<title>{}</title>{}…", diagnostics::xml_text(name),
                       diagnostics::xml_text(name.substr(0, most - 1)));
}

}  // namespace

std::string picture_style() {
    return rules_of(light) + "@media screen and (prefers-color-scheme:dark){" + rules_of(dark) + "}";
}

const char* series_colour(std::size_t number) {
    return palette.at(number % palette.size());
}

const char* state_colour(std::size_t state, std::size_t states) {
    return state < states ? series_colour(state) : "#777777";
}

std::vector<double> axis_ticks(double low, double high, std::size_t most) {
    if (!(high > low) || most < 2) return {};
    const double least = (high - low) / static_cast<double>(most - 1);
    const double power = std::pow(10, std::floor(std::log10(least)));
    double step = 10 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        if (factor * power >= least * (1 - 1e-9)) step = factor * power;
    std::vector<double> result;
    for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) result.push_back(i * step);
    return result;
}

std::string number_text(double value) {
    const std::string text = fmt::format("{:.6g}", value);
    return text == "-0" ? "0" : text;
}

Legend::Legend(std::vector<LegendEntry> entries, double width, double unit) : unit_(unit) {
    constexpr double row = 20, letter = 6.8, before = 20, after = 18;
    double left = 0;
    double top = row / 2;
    for (const LegendEntry& entry : entries) {
        const double wide = before + after + letter * static_cast<double>(std::min<std::size_t>(entry.text.size(), 40));
        if (left > 0 && left + wide > width / unit) {
            left = 0;
            top += row;
        }
        text_ += fmt::format(
            "<g transform=\"translate({:.1f} {:.1f})\">{}</g><text class=\"sim-text\" x=\"{:.1f}\" "
            "y=\"{:.1f}\">{}</text>\n",
            left + 8, top, entry.sign, left + before, top + 4.3, short_text(entry.text));
        left += wide;
    }
    height_ = entries.empty() ? 0 : (top + row / 2) * unit;
}

std::string Legend::svg(double left, double top) const {
    return fmt::format("<g transform=\"translate({:.6g} {:.6g}) scale({:.6g})\" font-size=\"12\">\n{}</g>\n", left, top,
                       unit_, text_);
}

std::string robot_symbols(std::size_t states, double radius, double outline, const std::string& prefix) {
    std::string out = "<defs>\n";
    for (std::size_t s = 0; s <= states; ++s) {
        const bool between = s == states;
        const std::string body = between ? "class=\"sim-body sim-between\""
                                         : fmt::format("class=\"sim-body\" fill=\"{}\"", series_colour(s));
        const std::size_t mark = between ? 0 : s % marks.size();
        std::string mark_style = "class=\"sim-one\"";
        if (!between) {
            const char* const colour = mark_colours.at(s % mark_colours.size());
            mark_style = fmt::format("stroke=\"{0}\" fill=\"{1}\"", colour, mark == 1 ? colour : "none");
        }
        out += fmt::format(
            "<g id=\"{}{}\" transform=\"scale({:g})\"><circle r=\"1\" stroke-width=\"{:.3f}\" {}/><path d=\"{}\" "
            "stroke-width=\".22\" {}/></g>\n",
            prefix, s, radius, outline, body, marks.at(mark), mark_style);
    }
    return out + "</defs>\n";
}

std::vector<LegendEntry> state_entries(const MachineStates& machine, double radius, const std::string& prefix) {
    std::vector<LegendEntry> entries;
    for (std::size_t s = 0; s <= machine.states.size(); ++s)
        entries.push_back({fmt::format("<use href=\"#{}{}\" transform=\"scale({:.6g})\"/>", prefix, s, 6.5 / radius),
                           s < machine.states.size() ? machine.states[s] : "between states"});
    return entries;
}

}  // namespace robochart::simulation
