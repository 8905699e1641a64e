// SPDX-License-Identifier: Apache-2.0
// See sweep_plot.hpp.
#include "simulation/sweep/sweep_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/escape.hpp"
#include "base/statistics/survival.hpp"
#include "simulation/report/drawing.hpp"
#include "simulation/report/percent.hpp"

namespace robochart::simulation {

namespace {

using diagnostics::xml_text;

constexpr double plot_width = 640;
constexpr double left_edge = 62;
constexpr double area_width = 550;
constexpr double area_height = 260;
constexpr std::size_t most_curves = 8;

/// A plot area with axes; the vertical axis shows fractions, from 0 to 100 %.
class ShareFrame {
public:
    ShareFrame(std::string title, std::vector<LegendEntry> entries, double low, double high)
        : title_(std::move(title)), legend_(std::move(entries), area_width, 1), low_(low), high_(high) {
        top_ = 30 + legend_.height() + 14;
    }

    [[nodiscard]] double x(double value) const { return left_edge + area_width * (value - low_) / (high_ - low_); }
    [[nodiscard]] double y(double share) const { return top_ + area_height * (1 - share); }
    void add(const std::string& text) { body_ += text; }

    /// Writes the plot. `names` are labels at values of the horizontal axis.
    [[nodiscard]] std::string svg(const std::vector<std::pair<double, std::string>>& names,
                                  const std::string& axis) const {
        const double bottom = top_ + area_height;
        const double height = bottom + 48;
        std::string out = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" "
            "role=\"img\" font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"12\">\n<title>{2}</title>\n"
            "<style>{3}</style>\n<rect class=\"sim-paper\" width=\"{0:g}\" height=\"{1:g}\"/>\n"
            "<text class=\"sim-text\" x=\"12\" y=\"20\" font-size=\"{4:.3g}\" font-weight=\"bold\">{2}</text>\n",
            plot_width, height, xml_text(title_), picture_style(), title_size());
        out += legend_.svg(left_edge, 30);
        for (const double share : axis_ticks(0, 1, 6))
            out += fmt::format(
                "<path class=\"sim-grid\" d=\"M{:g} {:.1f}h{:g}\"/><text class=\"sim-soft\" x=\"{:g}\" y=\"{:.1f}\" "
                "text-anchor=\"end\">{}</text>\n",
                left_edge, y(share), area_width, left_edge - 6, y(share) + 4, percent_text(share));
        for (const auto& [value, name] : names)
            out += fmt::format(
                "<path class=\"sim-axis\" d=\"M{0:.1f} {1:g}v5\"/><text class=\"sim-soft\" x=\"{0:.1f}\" y=\"{2:g}\" "
                "text-anchor=\"middle\">{3}</text>\n",
                x(value), bottom, bottom + 18, xml_text(name));
        out +=
            fmt::format("<path class=\"sim-axis\" d=\"M{:g} {:g}V{:g}h{:g}\"/>\n", left_edge, top_, bottom, area_width);
        out += fmt::format("<text class=\"sim-soft\" x=\"{:g}\" y=\"{:g}\" text-anchor=\"middle\">{}</text>\n",
                           left_edge + area_width / 2, bottom + 38, xml_text(axis));
        return out + body_ + "</svg>\n";
    }

private:
    /// A long title gets a smaller font, so that it fits.
    [[nodiscard]] double title_size() const {
        constexpr std::size_t letters = 76;
        return 13 * std::min(1.0, static_cast<double>(letters) / static_cast<double>(std::max(title_.size(), letters)));
    }

    std::string title_;
    Legend legend_;
    double low_, high_;
    double top_ = 0;
    std::string body_;
};

/// The mark of a verdict; its shape also distinguishes it without colour.
std::string verdict_mark(const std::string& word, double x, double y, const char* hue) {
    if (word == "proved" || word == "estimated")
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\" fill=\"{}\"/>", x, y, hue);
    if (word == "refuted")
        return fmt::format("<path d=\"M{:.1f} {:.1f}l8 8m0 -8l-8 8\" stroke=\"{}\" stroke-width=\"2.2\"/>", x - 4,
                           y - 4, hue);
    return fmt::format(
        "<circle class=\"sim-paper\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\" stroke=\"{}\" stroke-width=\"2\"/>", x, y,
        hue);
}

std::vector<LegendEntry> verdict_entries(const Claim& claim) {
    std::vector<LegendEntry> entries;
    for (const char* const word : {"estimated", "proved", "refuted", "open"})
        if (claim.estimate == (word == std::string_view("estimated")))
            entries.push_back({verdict_mark(word, 0, 0, "#777777"), word});
    entries.push_back(
        {"<path class=\"sim-target\" stroke-width=\"1\" d=\"M0 -6V6M-4 -6h8M-4 6h8\"/>", "joint interval"});
    entries.push_back(
        {"<path stroke=\"#777777\" stroke-width=\"4\" stroke-opacity=\"0.5\" d=\"M0 -6V6\"/>", "of one point"});
    return entries;
}

double share_of(const ClaimResult& found) {
    return found.trial_count() == 0 ? 0
                                    : static_cast<double>(found.successes) / static_cast<double>(found.trial_count());
}

class SweepPlotter {
public:
    SweepPlotter(const Scenario& scenario, const SweepResult& result) : scenario_(scenario), result_(result) {}

    [[nodiscard]] std::string draw_success(std::size_t claim) const {
        const Variation& first = scenario_.variations.front();
        const double low = first.values.front();
        const double edge = std::max(1e-9, 0.04 * (first.values.back() - low));
        std::vector<LegendEntry> entries = verdict_entries(scenario_.claims[claim]);
        for (std::size_t s = 0; scenario_.variations.size() > 1 && s < second_values().size() && s < most_curves; ++s)
            entries.push_back(
                {fmt::format("<rect x=\"-6\" y=\"-5\" width=\"12\" height=\"10\" fill=\"{}\"/>", series_colour(s)),
                 name_of(scenario_.variations[1]) + " " + value_text(scenario_.variations[1], second_values()[s])});
        ShareFrame frame(scenario_.claims[claim].text, entries, low - edge, first.values.back() + edge);
        if (!scenario_.claims[claim].estimate)
            frame.add(fmt::format(
                "<path class=\"sim-target\" stroke-width=\"1.4\" stroke-dasharray=\"6 3\" d=\"M{:g} {:.1f}h{:g}\"/>\n",
                left_edge, frame.y(scenario_.claims[claim].probability), area_width));
        for (const PointResult& point : result_.points) point_of(frame, point, claim);
        return frame.svg(axis_names(first), name_of(first));
    }

    /// The fraction of trials without success so far, over time.
    [[nodiscard]] std::string draw_survival(std::size_t claim) const {
        const std::vector<const PointResult*> points = drawn_points();
        std::vector<LegendEntry> entries;
        for (std::size_t p = 0; p < points.size(); ++p)
            entries.push_back({fmt::format("<path d=\"M-7 0H7\" stroke=\"{}\" stroke-width=\"2\"/>", series_colour(p)),
                               point_text(scenario_, points[p]->point)});
        ShareFrame frame("trials in which it has not come: " + scenario_.claims[claim].text, entries, 0,
                         scenario_.duration);
        for (std::size_t p = 0; p < points.size(); ++p) draw_curve(frame, points[p]->claims[claim], series_colour(p));
        std::vector<std::pair<double, std::string>> names;
        for (const double time : axis_ticks(0, scenario_.duration, 8)) names.emplace_back(time, number_text(time));
        return frame.svg(names, "time [s]");
    }

    /// A cell for each point, with darkness by the fraction of trials; the tooltip shows the interval.
    [[nodiscard]] std::string draw_map(std::size_t claim) const {
        const Variation& first = scenario_.variations[0];
        const Variation& second = scenario_.variations[1];
        const auto columns = static_cast<double>(first.values.size());
        const auto rows = static_cast<double>(second.values.size());
        ShareFrame frame(scenario_.claims[claim].text, verdict_entries(scenario_.claims[claim]), 0, columns);
        for (std::size_t p = 0; p < result_.points.size(); ++p) {
            const PointResult& point = result_.points[p];
            if (point.claims.empty()) continue;
            const ClaimResult& found = point.claims[claim];
            const auto column = static_cast<double>(p % first.values.size());
            const auto row = static_cast<double>(p / first.values.size());
            const double top = frame.y((row + 1) / rows);
            frame.add(fmt::format(
                "<g><title>{}: {}</title><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                "fill=\"#0072b2\" "
                "fill-opacity=\"{:.3f}\" stroke=\"#777777\"/>{}</g>\n",
                xml_text(point_text(scenario_, point.point)), xml_text(evidence_text(scenario_.claims[claim], found)),
                frame.x(column), top, area_width / columns, area_height / rows, share_of(found),
                verdict_mark(point_word(point, claim), frame.x(column + 0.5), top + area_height / rows / 2,
                             "#d55e00")));
            if (column == 0)
                frame.add(fmt::format("<text class=\"sim-text\" x=\"{:g}\" y=\"{:.1f}\">{}</text>\n",
                                      left_edge + area_width + 2, top + area_height / rows / 2 + 4,
                                      value_text(second, point.point[1])));
        }
        std::vector<std::pair<double, std::string>> names;
        for (std::size_t i = 0; i < first.values.size(); i += 1 + first.values.size() / 16)
            names.emplace_back(static_cast<double>(i) + 0.5, value_text(first, first.values[i]));
        return frame.svg(names, name_of(first) + " (right: " + name_of(second) + ")");
    }

private:
    [[nodiscard]] const std::vector<double>& second_values() const { return scenario_.variations[1].values; }

    static std::vector<std::pair<double, std::string>> axis_names(const Variation& variation) {
        std::vector<std::pair<double, std::string>> names;
        const std::size_t every = 1 + variation.values.size() / 16;
        for (std::size_t i = 0; i < variation.values.size(); i += every)
            names.emplace_back(variation.values[i], value_text(variation, variation.values[i]));
        return names;
    }

    void point_of(ShareFrame& frame, const PointResult& point, std::size_t claim) const {
        if (point.claims.empty()) return;
        const ClaimResult& found = point.claims[claim];
        std::size_t hue = 0;
        if (point.point.size() > 1)
            hue = static_cast<std::size_t>(std::find(second_values().begin(), second_values().end(), point.point[1]) -
                                           second_values().begin());
        const double x =
            frame.x(point.point[0]) + (point.point.size() > 1 ? 3.0 * static_cast<double>(hue % most_curves) : 0);
        std::string bars;
        if (const auto alone = pointwise_interval(scenario_.claims[claim], found))
            bars += fmt::format(
                "<path stroke=\"{}\" stroke-width=\"4\" stroke-opacity=\"0.5\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>",
                series_colour(hue), x, frame.y(alone->low), frame.y(alone->high));
        if (found.looked > 0)
            bars += fmt::format(
                "<path class=\"sim-target\" d=\"M{0:.1f} {1:.1f}V{2:.1f}M{3:.1f} {1:.1f}h6M{3:.1f} {2:.1f}h6\"/>", x,
                frame.y(found.interval.low), frame.y(found.interval.high), x - 3);
        frame.add(fmt::format("<g><title>{}: {}</title>{}{}</g>\n", xml_text(point_text(scenario_, point.point)),
                              xml_text(evidence_text(scenario_.claims[claim], found)), bars,
                              verdict_mark(point_word(point, claim), x, frame.y(share_of(found)), series_colour(hue))));
    }

    /// Selects at most eight of the computed points, spread evenly.
    [[nodiscard]] std::vector<const PointResult*> drawn_points() const {
        std::vector<const PointResult*> known;
        for (const PointResult& point : result_.points)
            if (!point.claims.empty()) known.push_back(&point);
        if (known.size() <= most_curves) return known;
        std::vector<const PointResult*> some;
        for (std::size_t i = 0; i < most_curves; ++i) some.push_back(known[i * (known.size() - 1) / (most_curves - 1)]);
        return some;
    }

    void draw_curve(ShareFrame& frame, const ClaimResult& found, const char* hue) const {
        const auto steps = statistics::survival_curve(durations_of(found), 0.05);
        std::string line = fmt::format("M{:.1f} {:.1f}", frame.x(0), frame.y(1));
        std::string above = line;
        std::string below;
        double low = 1;
        for (const statistics::SurvivalStep& step : steps) {
            line += fmt::format("H{:.1f}V{:.1f}", frame.x(step.time), frame.y(step.share));
            above += fmt::format("H{:.1f}V{:.1f}", frame.x(step.time), frame.y(step.band.high));
            below = fmt::format("V{:.1f}H{:.1f}", frame.y(low), frame.x(step.time)) + below;
            low = step.band.low;
        }
        double end = 0;
        double last = 0;
        std::string lost;
        for (const ClaimOutcome& outcome : found.outcomes) {
            end = std::max(end, outcome.time);
            if (!outcome.holds || outcome.stopped) last = std::max(last, outcome.time);
        }
        if (last > 0) {
            const double share = steps.empty() ? 1 : steps.back().share;
            lost = fmt::format("M{:.1f} {:.1f}v8", frame.x(last), frame.y(share) - 4);
        }
        frame.add(fmt::format("<path d=\"{}H{:.1f}V{:.1f}{}Z\" fill=\"{}\" fill-opacity=\"0.14\"/>\n", above,
                              frame.x(end), frame.y(low), below, hue));
        frame.add(fmt::format("<path d=\"{}H{:.1f}{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n", line,
                              frame.x(end), lost, hue));
    }

    const Scenario& scenario_;
    const SweepResult& result_;
};

}  // namespace

std::vector<SweepPlot> sweep_plots(const Scenario& scenario, const SweepResult& result) {
    const SweepPlotter plotter(scenario, result);
    std::vector<SweepPlot> plots;
    for (std::size_t c = 0; c < scenario.claims.size(); ++c) {
        const std::string number = scenario.claims.size() > 1 ? fmt::format("-{}", c + 1) : "";
        plots.push_back({"success" + number, plotter.draw_success(c)});
        if (scenario.claims[c].property.kind == Formula::Kind::within)
            plots.push_back({"times" + number, plotter.draw_survival(c)});
        if (scenario.variations.size() > 1) plots.push_back({"map" + number, plotter.draw_map(c)});
    }
    return plots;
}

}  // namespace robochart::simulation
