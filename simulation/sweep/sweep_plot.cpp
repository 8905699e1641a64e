// SPDX-License-Identifier: Apache-2.0
// See sweep_plot.hpp.
#include "simulation/sweep/sweep_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/escape.hpp"
#include "base/statistics/survival.hpp"
#include "simulation/report/chart_frame.hpp"
#include "simulation/report/percent.hpp"

namespace robochart::simulation {

namespace {

using diagnostics::xml_text;

constexpr std::size_t most_curves = 8;

/// Returns an axis from 0 to 100 %.
Axis share_axis() {
    Axis axis = number_axis("", 0, 1, 6);
    for (Axis::Tick& tick : axis.ticks) tick.text = percent_text(tick.value);
    return axis;
}

/// Returns an axis with at most 16 values of a variation. `place_of(index)` returns the position of a value on the
/// axis.
template <class Place>
Axis axis_of(const Variation& variation, double low, double high, Place place_of) {
    Axis axis{name_of(variation), low, high, {}};
    for (std::size_t i = 0; i < variation.values.size(); i += 1 + variation.values.size() / 16)
        axis.ticks.push_back({place_of(i), value_text(variation, variation.values[i])});
    return axis;
}

/// Returns an axis with a cell of width 1 for each value.
Axis cell_axis(const Variation& variation) {
    return axis_of(variation, 0, static_cast<double>(variation.values.size()),
                   [](std::size_t i) { return static_cast<double>(i) + 0.5; });
}

/// Draws the mark of a verdict. Its shape distinguishes verdicts even without colour.
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
        const Claim& asked = scenario_.claims[claim];
        const Variation& first = scenario_.variations.front();
        const double low = first.values.front();
        const double high = first.values.back();
        const double edge = high > low ? 0.04 * (high - low) : 1;
        std::vector<LegendEntry> entries = verdict_entries(asked);
        entries.push_back(
            {"<path class=\"sim-target\" stroke-width=\"1\" d=\"M0 -6V6M-4 -6h8M-4 6h8\"/>", "joint interval"});
        entries.push_back(
            {"<path stroke=\"#777777\" stroke-width=\"4\" stroke-opacity=\"0.5\" d=\"M0 -6V6\"/>", "of one point"});
        for (std::size_t s = 0; scenario_.variations.size() > 1 && s < second_values().size() && s < most_curves; ++s)
            entries.push_back(area_entry(
                s, 1,
                name_of(scenario_.variations[1]) + " " + value_text(scenario_.variations[1], second_values()[s])));
        ChartFrame frame(asked.text, std::move(entries),
                         axis_of(first, low - edge, high + edge, [&](std::size_t i) { return first.values[i]; }),
                         share_axis());
        if (!asked.estimate)
            frame.add(fmt::format(
                "<path class=\"sim-target\" stroke-width=\"1.4\" stroke-dasharray=\"6 3\" d=\"M{:g} {:.1f}h{:g}\"/>\n",
                frame.area().left, frame.y(asked.probability), frame.area().width));
        for (const PointResult& point : result_.points) point_of(frame, point, claim);
        return frame.svg();
    }

    /// Draws the fraction of trials without success so far, over time.
    [[nodiscard]] std::string draw_survival(std::size_t claim) const {
        const std::vector<const PointResult*> points = drawn_points();
        std::vector<LegendEntry> entries;
        for (std::size_t p = 0; p < points.size(); ++p)
            entries.push_back(line_entry(p, point_text(scenario_, points[p]->point)));
        ChartFrame frame("trials in which it has not come: " + scenario_.claims[claim].text, std::move(entries),
                         number_axis("time [s]", 0, scenario_.duration, 8), share_axis());
        for (std::size_t p = 0; p < points.size(); ++p) draw_curve(frame, points[p]->claims[claim], p);
        return frame.svg();
    }

    /// Draws a cell for each point. The darkness shows the fraction of trials, and the tooltip the interval.
    [[nodiscard]] std::string draw_map(std::size_t claim) const {
        const Claim& asked = scenario_.claims[claim];
        const std::size_t columns = scenario_.variations[0].values.size();
        ChartFrame frame(asked.text, verdict_entries(asked), cell_axis(scenario_.variations[0]),
                         cell_axis(scenario_.variations[1]));
        const double width = frame.x(1) - frame.x(0);
        const double height = frame.y(0) - frame.y(1);
        for (std::size_t p = 0; p < result_.points.size(); ++p) {
            const PointResult& point = result_.points[p];
            if (point.claims.empty()) continue;
            const ClaimResult& found = point.claims[claim];
            const double left = frame.x(static_cast<double>(p % columns));
            const double top = frame.y(static_cast<double>(p / columns + 1));
            const std::string cell =
                fmt::format("x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"", left, top, width, height);
            frame.add(
                fmt::format("<g><title>{0}: {1}</title><rect class=\"sim-paper\" {2}/><rect {2} fill=\"#0072b2\" "
                            "fill-opacity=\"{3:.3f}\" stroke=\"#777777\"/>{4}</g>\n",
                            xml_text(point_text(scenario_, point.point)), xml_text(evidence_text(asked, found)), cell,
                            share_of(found),
                            verdict_mark(point_word(point, claim), left + width / 2, top + height / 2, "#d55e00")));
        }
        return frame.svg();
    }

private:
    [[nodiscard]] const std::vector<double>& second_values() const { return scenario_.variations[1].values; }

    void point_of(ChartFrame& frame, const PointResult& point, std::size_t claim) const {
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

    void draw_curve(ChartFrame& frame, const ClaimResult& found, std::size_t number) const {
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
                              frame.x(end), frame.y(low), below, series_colour(number)));
        frame.add(fmt::format("<path d=\"{}H{:.1f}{}\" {}/>\n", line, frame.x(end), lost, line_style(number)));
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
