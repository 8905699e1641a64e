// SPDX-License-Identifier: Apache-2.0
// See prism_plot.hpp.
#include "app/prism/prism_plot.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "simulation/report/line_plot.hpp"

namespace robochart::app {
namespace {

/// The value of a constant: a whole number, a decimal or a fraction.
std::optional<double> constant_number(const std::string& text) {
    const auto decimal = [](std::string_view part) -> std::optional<double> {
        double value = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        if (error != std::errc() || end != part.data() + part.size()) return std::nullopt;
        return value;
    };
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return decimal(text);
    const auto above = decimal(std::string_view(text).substr(0, slash));
    const auto below = decimal(std::string_view(text).substr(slash + 1));
    if (!above || !below) return std::nullopt;
    return *above / *below;
}

NamedValues constants_of(const PrismRun& run, const PrismAnswer& answer) {
    NamedValues all = run.constants;
    all.insert(all.end(), answer.constants.begin(), answer.constants.end());
    return all;
}

using ValuesByName = std::map<std::string, std::set<std::string>>;

/// The constant with the most values among those whose values are all numbers; "" if none has at least two.
std::string parameter_of(const ValuesByName& values) {
    std::string result;
    std::size_t most = 1;
    for (const auto& [name, all] : values) {
        const bool numeric =
            std::ranges::all_of(all, [](const std::string& text) { return constant_number(text).has_value(); });
        if (!numeric || all.size() <= most) continue;
        result = name;
        most = all.size();
    }
    return result;
}

std::optional<simulation::PlotPoint> point_of(const PrismAnswer& answer) {
    const prism::Result& result = answer.result;
    if (!answer.error.empty() || result.kind != prism::Result::Kind::number) return std::nullopt;
    const prism::Enclosure bounds = interval_of(result);
    const double value = result.estimate ? result.estimate->mean : result.low.bounds().middle();
    if (!std::isfinite(value) || !std::isfinite(bounds.low) || !std::isfinite(bounds.high)) return std::nullopt;
    return simulation::PlotPoint{0, value, bounds.low, bounds.high};
}

}  // namespace

std::string prism_plot(const PrismReport& report) {
    ValuesByName values;
    for (const PrismRun& run : report.runs)
        for (const PrismAnswer& answer : run.answers)
            for (const auto& [name, value] : constants_of(run, answer)) values[name].insert(value);
    const std::string parameter = parameter_of(values);
    if (parameter.empty()) return "";
    std::map<std::pair<std::size_t, std::string>, std::vector<simulation::PlotPoint>> lines;
    for (const PrismRun& run : report.runs)
        for (const PrismAnswer& answer : run.answers) {
            std::optional<simulation::PlotPoint> point = point_of(answer);
            if (!point) continue;
            std::string others;
            for (const auto& [name, value] : constants_of(run, answer))
                if (name == parameter)
                    point->x = *constant_number(value);
                else if (values[name].size() > 1)
                    others += ", " + name + "=" + value;
            lines[{answer.property, others}].push_back(*point);
        }
    if (lines.empty()) return "";
    std::vector<simulation::PlotLine> drawn;
    for (auto& [key, points] : lines) {
        std::ranges::stable_sort(points, [](const auto& a, const auto& b) { return a.x < b.x; });
        const PrismProperty& property = report.properties[key.first];
        drawn.push_back({(property.name.empty() ? property.text : property.name) + key.second, points});
    }
    return simulation::line_plot_svg(report.model, parameter, drawn);
}

}  // namespace robochart::app
