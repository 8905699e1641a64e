// SPDX-License-Identifier: Apache-2.0
#include "simulation/report/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/diagnostics/escape.hpp"
#include "simulation/report/drawing.hpp"

namespace robochart::simulation {

namespace {

using diagnostics::xml_text;

constexpr std::array<const char*, 3> dashes = {"", " stroke-dasharray=\"7 3\"", " stroke-dasharray=\"2 2.5\""};

/// The ends of an axis.
struct Range {
    double low = 0;
    double high = 1;
};

class Plotter {
public:
    Plotter(const Chart& chart, const std::vector<double>& times, const PlotOptions& options)
        : chart_(chart), times_(times), options_(options), legend_(legend_entries(), area_.width, 1) {
        area_.top = 24 + legend_.height() + 12;
        end_ = times.empty() || times.back() <= 0 ? 1 : times.back();
        range_ = value_range();
    }

    Plot draw() {
        out_ = fmt::format(
            "<text class=\"sim-text\" x=\"{:g}\" y=\"16\" font-size=\"14\" font-weight=\"bold\">{}</text>\n",
            area_.left, xml_text(chart_.title));
        out_ += legend_.svg(area_.left, 24);
        draw_axes();
        for (std::size_t s = 0; s < chart_.series.size(); ++s) draw_bands(s);
        for (const Target& target : chart_.targets) mark_target(target);
        for (std::size_t s = 0; s < chart_.series.size(); ++s) draw_lines(s);
        if (options_.now)
            out_ += fmt::format("<line class=\"sim-now\" x1=\"{0:g}\" x2=\"{0:g}\" y1=\"{1:g}\" y2=\"{2:g}\"/>\n",
                                x(end_), area_.top, area_.top + area_.height);
        return {out_, 520, area_.top + area_.height + 44, area_};
    }

private:
    [[nodiscard]] std::size_t trial_count() const {
        return chart_.series.empty() ? 0 : chart_.series.front().trials.size();
    }

    /// The band of all trials is drawn only for a single series, because several bands would hide each other.
    [[nodiscard]] bool shows_full_band() const { return chart_.series.size() == 1; }

    [[nodiscard]] std::vector<LegendEntry> legend_entries() const {
        std::vector<LegendEntry> list;
        const bool several = trial_count() > 1;
        for (std::size_t s = 0; s < chart_.series.size(); ++s) {
            const std::string name = chart_.series[s].name;
            std::string label = several ? "median of the trials" : "the trial";
            if (!name.empty()) label = several ? name + ", median" : name;
            list.push_back({fmt::format("<path d=\"M-7 0H7\" stroke=\"{}\" stroke-width=\"2\"{}/>", series_colour(s),
                                        dashes.at(s % dashes.size())),
                            label});
        }
        if (several) {
            list.push_back({swatch(0.36), "the middle half"});
            if (shows_full_band()) list.push_back({swatch(0.16), "all trials"});
        }
        if (options_.trials && several)
            list.push_back({"<path class=\"sim-one\" d=\"M-7 0H7\" stroke-width=\"1.2\"/>", "the trial shown"});
        if (std::ranges::any_of(chart_.targets, [](const Target& t) { return !t.mean; }))
            list.push_back(
                {"<path class=\"sim-target\" d=\"M-6 0H6M-6 -4V4M6 -4V4\" stroke-width=\"1.5\"/>", "accepted of each"});
        if (std::ranges::any_of(chart_.targets, [](const Target& t) { return t.mean; }))
            list.push_back(
                {"<path class=\"sim-target\" d=\"M-6 0H6M-6 -4V4M6 -4V4\" stroke-width=\"1.5\" "
                 "stroke-dasharray=\"2 1.5\"/>",
                 "accepted of the mean"});
        return list;
    }

    static std::string swatch(double opacity) {
        return fmt::format("<rect x=\"-7\" y=\"-5\" width=\"14\" height=\"10\" fill=\"{}\" fill-opacity=\"{:g}\"/>",
                           series_colour(0), opacity);
    }

    /// Returns the range from 0 (or the least value, if that is negative) to the greatest value, including targets that
    /// are near.
    [[nodiscard]] Range value_range() const {
        Range found{0, 0};
        for (const Series& series : chart_.series)
            for (const Quartiles& at : series.all) {
                found.low = std::min(found.low, at.least);
                found.high = std::max(found.high, at.most);
            }
        if (chart_.most) found.high = *chart_.most;
        for (const Target& target : chart_.targets)
            for (const double value : {target.low, target.high})
                if (std::isfinite(value) && value <= 2 * found.high) found.high = std::max(found.high, value);
        if (!(found.high > found.low)) found.high = found.low + 1;
        if (!chart_.most) found.high += 0.05 * (found.high - found.low);
        return found;
    }

    [[nodiscard]] double x(double time) const { return area_.left + area_.width * time / end_; }
    [[nodiscard]] double y(double value) const {
        const double share = (std::clamp(value, range_.low, range_.high) - range_.low) / (range_.high - range_.low);
        return area_.top + area_.height * (1 - share);
    }

    void draw_axes() {
        const double bottom = area_.top + area_.height;
        const double right = area_.left + area_.width;
        for (const double value : axis_ticks(range_.low, range_.high, 6)) {
            if (chart_.whole && value != std::floor(value)) continue;
            out_ += fmt::format(
                "<path class=\"sim-grid\" d=\"M{:g} {:.1f}H{:g}\"/><text class=\"sim-soft\" x=\"{:g}\" "
                "y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
                area_.left, y(value), right, area_.left - 6, y(value) + 4, number_text(value));
        }
        for (const double time : axis_ticks(0, end_, 8))
            out_ += fmt::format(
                "<path class=\"sim-axis\" d=\"M{0:.1f} {1:g}v5\"/><text class=\"sim-soft\" x=\"{0:.1f}\" "
                "y=\"{2:g}\" text-anchor=\"middle\">{3}</text>\n",
                x(time), bottom, bottom + 18, number_text(time));
        out_ += fmt::format("<path class=\"sim-axis\" d=\"M{0:g} {1:g}V{2:g}H{3:g}\"/>\n", area_.left, area_.top,
                            bottom, right);
        out_ += fmt::format("<text class=\"sim-soft\" x=\"{:g}\" y=\"{:g}\" text-anchor=\"middle\">time [s]</text>\n",
                            area_.left + area_.width / 2, bottom + 36);
        out_ += fmt::format(
            "<text class=\"sim-soft\" transform=\"translate(14 {:g}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
            area_.top + area_.height / 2, chart_.unit.empty() ? "number" : "[" + chart_.unit + "]");
    }

    [[nodiscard]] std::string polyline_points(const std::vector<double>& values) const {
        std::string text;
        for (std::size_t i = 0; i < values.size(); ++i)
            text += fmt::format("{}{:.1f},{:.1f}", i == 0 ? "" : " ", x(times_[i]), y(values[i]));
        return text;
    }

    template <class Low, class High>
    void draw_band(std::size_t series, double opacity, Low low, High high) {
        const std::vector<Quartiles>& all = chart_.series[series].all;
        std::string outline;
        for (std::size_t i = 0; i < all.size(); ++i)
            outline += fmt::format("{:.1f},{:.1f} ", x(times_[i]), y(high(all[i])));
        for (std::size_t i = all.size(); i-- > 0;)
            outline += fmt::format("{:.1f},{:.1f} ", x(times_[i]), y(low(all[i])));
        out_ += fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"{:g}\"/>\n", outline,
                            series_colour(series), opacity);
    }

    void draw_bands(std::size_t series) {
        if (trial_count() < 2) return;
        if (shows_full_band())
            draw_band(
                series, 0.16, [](const Quartiles& q) { return q.least; }, [](const Quartiles& q) { return q.most; });
        draw_band(
            series, 0.2, [](const Quartiles& q) { return q.lower; }, [](const Quartiles& q) { return q.upper; });
    }

    void draw_lines(std::size_t series) {
        const Series& plotted = chart_.series[series];
        std::vector<double> middles;
        for (const Quartiles& at : plotted.all) middles.push_back(at.middle);
        out_ += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n",
                            polyline_points(middles), series_colour(series), dashes.at(series % dashes.size()));
        if (!options_.trials || trial_count() < 2) return;
        for (std::size_t trial = 0; trial < plotted.trials.size(); ++trial)
            out_ += fmt::format(
                "<polyline class=\"sim-one sim-trial\" data-trial=\"{}\" stroke-width=\"1.2\"{} points=\"{}\"/>\n",
                trial, dashes.at(series % dashes.size()), polyline_points(plotted.trials[trial]));
    }

    /// A bracket along values at a time, or along times at a level.
    void mark_target(const Target& target) {
        const char* const dash = target.mean ? " stroke-dasharray=\"3 2\"" : "";
        if (target.low == target.high && target.from != target.to) {
            out_ += fmt::format(
                "<path class=\"sim-target\" stroke-width=\"1.5\"{0} d=\"M{1:.1f} {3:.1f}H{2:.1f}M{1:.1f} "
                "{4:.1f}v8M{2:.1f} {4:.1f}v8\"/>\n",
                dash, x(target.from), x(target.to), y(target.low), y(target.low) - 4);
            return;
        }
        const double high = y(std::min(target.high, range_.high));
        const double low = y(std::max(target.low, range_.low));
        out_ += fmt::format(
            "<path class=\"sim-target\" stroke-width=\"1.5\"{0} d=\"M{1:.1f} {2:.1f}V{3:.1f}M{4:.1f} {2:.1f}h8M{4:.1f} "
            "{3:.1f}h8\"/>\n",
            dash, x(target.from), high, low, x(target.from) - 4);
    }

    const Chart& chart_;
    const std::vector<double>& times_;
    const PlotOptions& options_;
    PlotArea area_;
    Legend legend_;
    double end_ = 1;
    Range range_;
    std::string out_;
};

}  // namespace

Plot draw_plot(const Chart& chart, const std::vector<double>& times, const PlotOptions& options) {
    return Plotter(chart, times, options).draw();
}

std::string plots_svg(const Scenario& scenario, const Charts& charts) {
    std::string body;
    double top = 10;
    for (const Chart& chart : charts.charts) {
        const Plot made = draw_plot(chart, charts.times);
        body += fmt::format("<g transform=\"translate(0 {:g})\">\n{}</g>\n", top, made.svg);
        top += made.height + 12;
    }
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 520 {0:g}\" width=\"520\" height=\"{0:g}\" "
        "role=\"img\" "
        "font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"12\">\n<title>{1}: measures over time</title>\n"
        "<style>{2}</style>\n<rect class=\"sim-paper\" width=\"520\" height=\"{0:g}\"/>\n{3}</svg>\n",
        top, xml_text(scenario.name.text), picture_style(), body);
}

}  // namespace robochart::simulation
