// SPDX-License-Identifier: Apache-2.0
// See value_plot.hpp.
#include "app/pages/value_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "app/report/prism_report.hpp"
#include "app/report/probability_report.hpp"
#include "base/diagnostics/escape.hpp"

namespace robochart::app {
namespace {

struct Point {
    double x = 0, low = 0, high = 0;
};

std::optional<double> to_number(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<Point> point_of_row(const driver::ProbabilityReport& report, const probability::Row& row) {
    const auto constants = varying_constants(report, row);
    if (constants.size() != 1 || row.results.empty()) return std::nullopt;
    const auto x = to_number(constants.front().second);
    const bool numbers = std::ranges::all_of(row.results, [](const prism::Result& result) {
        return result.kind == prism::Result::Kind::number && std::isfinite(result.low.bounds().high);
    });
    if (!x || !numbers) return std::nullopt;
    return Point{*x, interval_of(row.results.front()).low, interval_of(row.results.back()).high};
}

std::vector<Point> points_of_report(const driver::ProbabilityReport& report) {
    std::vector<Point> result;
    for (const probability::Row& row : report.rows) {
        const auto one = point_of_row(report, row);
        if (!one) return {};
        result.push_back(*one);
    }
    std::ranges::sort(result, [](const Point& a, const Point& b) { return a.x < b.x; });
    return result;
}

}  // namespace

std::string value_plot(const driver::ProbabilityReport& report) {
    constexpr double left = 60, top = 10, width = 320, height = 120;
    const std::vector<Point> all = points_of_report(report);
    if (all.size() < 2 || all.front().x == all.back().x) return "";
    double least = all.front().low;
    double most = all.front().high;
    for (const Point& point : all) {
        least = std::min(least, point.low);
        most = std::max(most, point.high);
    }
    if (least == most) most = least + 1;
    const auto at = [&](double x, double y) {
        return fmt::format("{:.2f},{:.2f} ", left + width * (x - all.front().x) / (all.back().x - all.front().x),
                           top + height * (most - y) / (most - least));
    };
    std::string line;
    for (const Point& point : all) line += at(point.x, point.high);
    const bool band =
        std::ranges::any_of(report.rows, [](const probability::Row& row) { return row.results.size() > 1; });
    for (auto point = all.rbegin(); band && point != all.rend(); ++point) line += at(point->x, point->low);
    const auto label = [](double x, double y, const char* anchor, const std::string& text) {
        return fmt::format(
            "<text x=\"{}\" y=\"{}\" font-size=\"11\" text-anchor=\"{}\" fill=\"currentColor\">{}</text>", x, y, anchor,
            diagnostics::xml_text(text));
    };
    const std::string name = varying_constants(report, report.rows.front()).front().first;
    return fmt::format(
               "<svg role=\"img\" aria-label=\"values over {}\" viewBox=\"0 0 400 170\" width=\"400\" height=\"170\">"
               "<path d=\"M{} {}V{}H{}\" fill=\"none\" stroke=\"currentColor\"/>"
               "<{} points=\"{}\" fill=\"{}\" fill-opacity=\"0.2\" stroke=\"currentColor\"/>",
               diagnostics::xml_text(name), left, top, top + height, left + width, band ? "polygon" : "polyline", line,
               band ? "currentColor" : "none") +
           label(left - 4, top + 9, "end", fmt::format("{:.4g}", most)) +
           label(left - 4, top + height, "end", fmt::format("{:.4g}", least)) +
           label(left, top + height + 16, "middle", fmt::format("{:.4g}", all.front().x)) +
           label(left + width, top + height + 16, "middle", fmt::format("{:.4g}", all.back().x)) +
           label(left + width / 2, top + height + 32, "middle", name) + "</svg>";
}

}  // namespace robochart::app
