// SPDX-License-Identifier: Apache-2.0
#include "simulation/report/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace robochart::simulation {

namespace {

/// Returns an axis from 0 (or the least value, if that is negative) to the greatest value. It includes targets that are
/// near.
Axis value_axis(const Chart& chart) {
    double low = 0;
    double high = 0;
    for (const Series& series : chart.series)
        for (const Quartiles& at : series.all) {
            low = std::min(low, at.least);
            high = std::max(high, at.most);
        }
    if (chart.most) high = *chart.most;
    for (const Target& target : chart.targets)
        for (const double value : {target.low, target.high})
            if (std::isfinite(value) && value <= 2 * high) high = std::max(high, value);
    if (!(high > low)) high = low + 1;
    if (!chart.most) high += 0.05 * (high - low);
    Axis axis = number_axis(chart.unit.empty() ? "number" : "[" + chart.unit + "]", low, high, 6);
    if (chart.whole)
        std::erase_if(axis.ticks, [](const Axis::Tick& tick) { return tick.value != std::floor(tick.value); });
    return axis;
}

class Plotter {
public:
    Plotter(const Chart& chart, const std::vector<double>& times, bool trial_lines)
        : chart_(chart),
          times_(times),
          several_(!chart.series.empty() && chart.series.front().trials.size() > 1),
          trial_lines_(trial_lines && several_),
          frame_(chart.title, legend_entries(), number_axis("time [s]", 0, times.empty() ? 0 : times.back(), 8),
                 value_axis(chart), 440, 180) {}

    ChartFrame draw() {
        for (std::size_t s = 0; several_ && s < chart_.series.size(); ++s) {
            if (shows_full_band()) draw_band(s, 0.16, &Quartiles::least, &Quartiles::most);
            draw_band(s, 0.2, &Quartiles::lower, &Quartiles::upper);
        }
        for (const Target& target : chart_.targets) mark_target(target);
        for (std::size_t s = 0; s < chart_.series.size(); ++s) draw_lines(s);
        return std::move(frame_);
    }

private:
    /// True for a single series. The bands of several series, each of all trials, would hide each other.
    [[nodiscard]] bool shows_full_band() const { return chart_.series.size() == 1; }

    [[nodiscard]] std::vector<LegendEntry> legend_entries() const {
        std::vector<LegendEntry> list;
        for (const Series& series : chart_.series) {
            std::string label = several_ ? "median of the trials" : "the trial";
            if (!series.name.empty()) label = several_ ? series.name + ", median" : series.name;
            list.push_back(line_entry(list.size(), label));
        }
        if (several_) {
            list.push_back(area_entry(0, 0.36, "the middle half"));
            if (shows_full_band()) list.push_back(area_entry(0, 0.16, "all trials"));
        }
        if (trial_lines_)
            list.push_back({"<path class=\"sim-one\" d=\"M-7 0H7\" stroke-width=\"1.2\"/>", "the trial shown"});
        for (const bool mean : {false, true})
            if (std::ranges::any_of(chart_.targets, [&](const Target& target) { return target.mean == mean; }))
                list.push_back({fmt::format("<path d=\"M-6 0H6M-6 -4V4M6 -4V4\" {}/>", target_style(mean)),
                                mean ? "accepted of the mean" : "accepted of each"});
        return list;
    }

    static std::string target_style(bool mean) {
        return fmt::format("class=\"sim-target\" stroke-width=\"1.5\"{}", mean ? " stroke-dasharray=\"3 2\"" : "");
    }

    [[nodiscard]] std::string line_points(const std::vector<double>& values) const {
        std::string text;
        for (std::size_t i = 0; i < values.size(); ++i) text += frame_.point(times_[i], values[i]);
        return text;
    }

    void draw_band(std::size_t series, double opacity, double Quartiles::*low, double Quartiles::*high) {
        const std::vector<Quartiles>& all = chart_.series[series].all;
        std::string outline;
        for (std::size_t i = 0; i < all.size(); ++i) outline += frame_.point(times_[i], all[i].*high);
        for (std::size_t i = all.size(); i-- > 0;) outline += frame_.point(times_[i], all[i].*low);
        frame_.add(fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"{:g}\"/>\n", outline,
                               series_colour(series), opacity));
    }

    void draw_lines(std::size_t series) {
        const Series& plotted = chart_.series[series];
        std::vector<double> middles;
        for (const Quartiles& at : plotted.all) middles.push_back(at.middle);
        frame_.add(fmt::format("<polyline points=\"{}\" {}/>\n", line_points(middles), line_style(series)));
        for (std::size_t trial = 0; trial_lines_ && trial < plotted.trials.size(); ++trial)
            frame_.add(fmt::format("<polyline class=\"sim-one sim-trial\" data-trial=\"{}\" points=\"{}\" {}/>\n",
                                   trial, line_points(plotted.trials[trial]), line_style(series)));
    }

    /// Draws a bracket along accepted values at a time, or along accepted times at a level.
    void mark_target(const Target& target) {
        const double from = frame_.x(target.from);
        const double low = frame_.y(target.low);
        const bool level = target.low == target.high && target.from != target.to;
        const std::string bracket = level ? fmt::format("M{0:.1f} {2:.1f}H{1:.1f}M{0:.1f} {3:.1f}v8M{1:.1f} {3:.1f}v8",
                                                        from, frame_.x(target.to), low, low - 4)
                                          : fmt::format("M{0:.1f} {1:.1f}V{2:.1f}M{3:.1f} {1:.1f}h8M{3:.1f} {2:.1f}h8",
                                                        from, frame_.y(target.high), low, from - 4);
        frame_.add(fmt::format("<path {} d=\"{}\"/>\n", target_style(target.mean), bracket));
    }

    const Chart& chart_;
    const std::vector<double>& times_;
    bool several_;      ///< there are several trials
    bool trial_lines_;  ///< draw a line per trial
    ChartFrame frame_;
};

}  // namespace

ChartFrame draw_plot(const Chart& chart, const std::vector<double>& times, bool trial_lines) {
    return Plotter(chart, times, trial_lines).draw();
}

std::string plots_svg(const Scenario& scenario, const Charts& charts) {
    std::vector<ChartFrame> drawn;
    for (const Chart& chart : charts.charts) drawn.push_back(draw_plot(chart, charts.times, false));
    return charts_svg(scenario.name.text + ": measures over time", drawn);
}

}  // namespace robochart::simulation
