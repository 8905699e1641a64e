// SPDX-License-Identifier: Apache-2.0
// See value_plot.hpp.
#include "app/report/value_plot.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "simulation/report/line_plot.hpp"

namespace robochart::app {
namespace {

/// An answer for some values of the constants.
struct PlottedAnswer {
    std::string name;  ///< name of its line, with the values of the other constants
    NamedValues constants;
    const prism::Result* result;
};

/// Parses the value of a constant: a whole number, a decimal or a fraction.
std::optional<double> constant_number(const std::string& text) {
    const auto decimal = [](std::string_view part) -> std::optional<double> {
        double value = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        if (error != std::errc() || end != part.data() + part.size()) return std::nullopt;
        return value;
    };
    const std::size_t slash = text.find('/');
    const auto above = decimal(std::string_view(text).substr(0, slash));
    const std::optional<double> below =
        slash == std::string::npos ? 1 : decimal(std::string_view(text).substr(slash + 1));
    if (!above || !below || !std::isfinite(*above / *below)) return std::nullopt;
    return *above / *below;
}

using ValuesByName = std::map<std::string, std::set<std::string>>;

/// Returns the constant with the most values among the constants whose values are all numbers; "" if none of them has
/// two or more values.
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

std::optional<simulation::PlotPoint> point_of(const prism::Result& result) {
    if (result.kind != prism::Result::Kind::number) return std::nullopt;
    const prism::Enclosure bounds = interval_of(result);
    const double value = result.estimate ? result.estimate->mean : result.low.bounds().middle();
    if (!std::isfinite(value) || !std::isfinite(bounds.low) || !std::isfinite(bounds.high)) return std::nullopt;
    return simulation::PlotPoint{0, value, bounds.low, bounds.high};
}

std::string plot_of_answers(const std::string& title, const std::vector<PlottedAnswer>& answers) {
    ValuesByName values;
    for (const PlottedAnswer& answer : answers)
        for (const auto& [name, value] : answer.constants) values[name].insert(value);
    const std::string parameter = parameter_of(values);
    if (parameter.empty()) return "";
    std::vector<simulation::PlotLine> lines;
    for (const PlottedAnswer& answer : answers) {
        std::optional<simulation::PlotPoint> point = point_of(*answer.result);
        if (!point) continue;
        std::string line_name = answer.name;
        for (const auto& [name, value] : answer.constants)
            if (name == parameter)
                point->x = *constant_number(value);
            else if (values[name].size() > 1)
                line_name += ", " + name + "=" + value;
        auto line = std::ranges::find(lines, line_name, &simulation::PlotLine::name);
        if (line == lines.end()) line = lines.insert(line, {line_name, {}});
        line->points.push_back(*point);
    }
    if (lines.empty()) return "";
    for (simulation::PlotLine& line : lines) std::ranges::stable_sort(line.points, {}, &simulation::PlotPoint::x);
    return simulation::line_plot_svg(title, parameter, lines);
}

}  // namespace

std::string value_plot(const PrismReport& report) {
    std::vector<PlottedAnswer> answers;
    for (const PrismRun& run : report.runs)
        for (const PrismAnswer& answer : run.answers) {
            const PrismProperty& property = report.properties[answer.property];
            NamedValues constants = run.constants;
            constants.insert(constants.end(), answer.constants.begin(), answer.constants.end());
            if (answer.error.empty())
                answers.push_back(
                    {property.name.empty() ? property.text : property.name, std::move(constants), &answer.result});
        }
    return plot_of_answers(report.model, answers);
}

std::string value_plot(const std::string& title, const driver::ProbabilityReport& report) {
    std::vector<PlottedAnswer> answers;
    for (const probability::Row& row : report.rows)
        for (const prism::Result& result : row.results) {
            const char* const bound = &result == &row.results.front() ? "least" : "greatest";
            answers.push_back({row.results.size() == 1 ? "value" : bound, row.constants, &result});
        }
    return plot_of_answers(title, answers);
}

}  // namespace robochart::app
