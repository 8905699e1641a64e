// SPDX-License-Identifier: Apache-2.0
#include "simulation/report/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "simulation/trial/measures.hpp"

namespace robochart::simulation {

namespace {

/// A value of the whole swarm at one time.
using SwarmValue = std::function<double(const Frame&)>;

constexpr const char* gauci =
    "Gauci, Chen, Li, Dodd and Gross, Self-organized aggregation without computation, IJRR 33(8), 2014";

double at_rank(const std::vector<double>& sorted, double share) {
    const double rank = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

class ChartMaker {
public:
    ChartMaker(const Scenario& scenario, const std::vector<TrialResult>& trials, const Machines& machines,
               std::size_t most_times)
        : scenario_(scenario), machines_(machines) {
        for (const TrialResult& trial : trials)
            if (!trial.frames.empty()) trials_.push_back(&trial);
        if (!trials_.empty()) choose_times(std::max<std::size_t>(most_times, 2));
    }

    Charts make_charts() {
        if (trials_.empty() || scenario_.all_robots() == 0) return std::move(result_);
        if (scenario_.all_robots() > 1) {
            if (result_.distances) add_distance_chart();
            for (const double link : cluster_links()) cluster_series(link);
            result_.charts.push_back(std::move(largest_));
            result_.charts.push_back(std::move(count_));
        }
        for (std::size_t m = 0; m < scenario_.measures.size(); ++m)
            if (scenario_.measures[m].kind != MeasureKind::cluster || scenario_.measures[m].of) add_measure_chart(m);
        add_states_chart();
        return std::move(result_);
    }

private:
    /// Limits the number of times, so that examining all pairs of robots in all trials takes at most about a second.
    void choose_times(std::size_t most_times) {
        constexpr double most_pairs = 2e8;
        constexpr std::size_t least_times = 20;
        const double robots = scenario_.all_robots();
        const double pairs = std::max(1.0, robots * (robots - 1) / 2 * static_cast<double>(trials_.size()));
        const auto affordable = static_cast<std::size_t>(std::min(1e6, most_pairs / pairs));
        result_.distances = affordable >= least_times;
        const std::size_t most = std::min(most_times, std::max(affordable, least_times));
        const auto longest = *std::ranges::max_element(
            trials_, [](const auto* a, const auto* b) { return a->frames.size() < b->frames.size(); });
        const std::size_t count = longest->frames.size();
        result_.every = thinning_factor(count, most);
        kept_ = kept_indices(count, result_.every);
        for (const std::size_t frame : kept_) result_.times.push_back(longest->frames[frame].time);
    }

    Series make_series(std::string name, const SwarmValue& value) const {
        Series made{std::move(name), {}, {}};
        for (const TrialResult* trial : trials_) {
            made.trials.emplace_back();
            for (const std::size_t frame : kept_)
                if (frame < trial->frames.size()) made.trials.back().push_back(value(trial->frames[frame]));
        }
        for (std::size_t i = 0; i < kept_.size(); ++i) {
            std::vector<double> values;
            for (const auto& trial : made.trials)
                if (i < trial.size()) values.push_back(trial[i]);
            made.all.push_back(quartiles_of(std::move(values)));
        }
        return made;
    }

    void add_distance_chart() {
        Chart chart{"Mean distance between robots", "cm",
                    "The mean over all pairs of robots of the distance between their centres."};
        chart.series.push_back(make_series("", [](const Frame& frame) { return mean_distance(frame.poses); }));
        result_.charts.push_back(std::move(chart));
    }

    /// Returns the link lengths of the scenario's `cluster` measures, shortest first.
    [[nodiscard]] std::set<double> cluster_links() const {
        std::set<double> lengths;
        for (const Measure& measure : scenario_.measures)
            if (measure.kind == MeasureKind::cluster && !measure.of) lengths.insert(measure.link);
        if (lengths.empty()) lengths.insert(link_of(scenario_));
        return lengths;
    }

    void cluster_series(double link) {
        const std::string name = fmt::format("links of at most {:g} cm", link);
        const auto robots = static_cast<double>(scenario_.all_robots());
        largest_.series.push_back(make_series(name, [&](const Frame& frame) {
            return 100 * static_cast<double>(count_clusters(frame.poses, link).largest) / robots;
        }));
        count_.series.push_back(make_series(
            name, [&](const Frame& frame) { return static_cast<double>(count_clusters(frame.poses, link).count); }));
        for (std::size_t m = 0; m < scenario_.measures.size(); ++m)
            if (scenario_.measures[m].kind == MeasureKind::cluster && !scenario_.measures[m].of &&
                scenario_.measures[m].link == link)
                add_targets(m, 100, largest_.targets);
    }

    /// Adds the values that the scenario accepts for a measure, if they refer to times.
    void add_targets(std::size_t measure, double factor, std::vector<Target>& targets) const {
        for (const Band& band : scenario_.bands) {
            const Statistic& statistic = band.statistic;
            const double end = scenario_.duration;
            if (statistic.kind == StatisticKind::first_time) {
                const Formula& level = statistic.condition;
                if (level.kind != Formula::Kind::compare || level.measure != measure) continue;
                const double bound = factor * (std::isinf(level.low) ? level.high : level.low);
                targets.push_back(
                    {!band.each, std::clamp(band.low, 0.0, end), std::clamp(band.high, 0.0, end), bound, bound});
                continue;
            }
            if (statistic.measure != measure || statistic.kind == StatisticKind::average) continue;
            const double at = statistic.kind == StatisticKind::at_time ? statistic.time : end;
            targets.push_back({!band.each, at, at, factor * band.low, factor * band.high});
        }
    }

    void add_measure_chart(std::size_t number) {
        const Measure& measure = scenario_.measures[number];
        Chart chart;
        const auto describe_share = [&](std::string title, std::string definition) {
            chart = {std::move(title), "%", std::move(definition), false, 100.0};
        };
        switch (measure.kind) {
            case MeasureKind::time:
                return;
            case MeasureKind::reached:
                describe_share(
                    "Robots at " + scenario_.lights.at(measure.light).name.text,
                    fmt::format("The share of robots whose centres are at most {} cm from the light.", measure.link));
                break;
            case MeasureKind::cluster:
                describe_share("Largest cluster",
                               fmt::format("The share of these robots in the largest group of links of at most {} cm.",
                                           measure.link));
                break;
            case MeasureKind::in_state:
                describe_share("Robots in " + measure.state.text,
                               "The share of robots whose first machine is in this state.");
                break;
            case MeasureKind::inside:
                describe_share("Robots inside", "The share of robots whose centres are in the rectangle.");
                break;
            case MeasureKind::kept:
                describe_share("Robots that keep the claim",
                               "The share of robots whose runs have kept this claim of the model so far.");
                break;
            case MeasureKind::working:
                describe_share("Robots without failures", "The share of robots of which nothing has failed.");
                break;
            case MeasureKind::spread:
                chart.title = "Distance to the centroid";
                chart.unit = "cm";
                chart.definition = "The mean distance of the robots to their centroid.";
                break;
            case MeasureKind::distance:
                chart.title = "Distance to " + scenario_.lights.at(measure.light).name.text;
                chart.unit = "cm";
                chart.definition = "The distance of the robots' centroid to the light.";
                break;
            case MeasureKind::second_moment:
                chart.title = "Second moment";
                chart.definition = fmt::format(
                    "The sum of squared distances to the centroid in units of a robot's diameter squared (Graham "
                    "and Sloane, Penny-packing and two-dimensional codes, 1990; {}).",
                    gauci);
                break;
        }
        const double factor = chart.most ? 100 : 1;  // shares are shown in percent
        if (measure.of) chart.title += " of " + scenario_.kind_at(*measure.of).kind.text;
        chart.title += fmt::format(" ({})", measure.name.text);
        chart.series.push_back(
            make_series("", [&](const Frame& frame) { return factor * measure_value(scenario_, measure, frame); }));
        add_targets(number, factor, chart.targets);
        result_.charts.push_back(std::move(chart));
    }

    void add_states_chart() {
        constexpr std::size_t most_states = 8;
        if (machines_.empty() || machines_.front().states.size() < 2 || machines_.front().states.size() > most_states)
            return;
        Chart chart{"Robots in each state", "",
                    "The number of robots whose innermost active state, or the one whose action is running, is this."};
        if (!machines_.front().name.empty()) chart.title += " of " + machines_.front().name;
        chart.whole = true;
        for (std::size_t s = 0; s < machines_.front().states.size(); ++s)
            chart.series.push_back(make_series(machines_.front().states[s], [&](const Frame& frame) {
                double count = 0;
                for (std::size_t robot = 0; robot < frame.poses.size(); ++robot)
                    count += frame.robot_state(robot) == s ? 1 : 0;
                return count;
            }));
        result_.charts.push_back(std::move(chart));
    }

    const Scenario& scenario_;
    const Machines& machines_;
    std::vector<const TrialResult*> trials_;
    std::vector<std::size_t> kept_;  ///< indices of frames
    Chart largest_{"Largest cluster", "%",
                   fmt::format("The share of robots in the largest group of those linked, directly or by others, by at "
                               "most the given length between centres ({}).",
                               gauci),
                   false, 100.0};
    Chart count_{"Number of clusters", "",
                 "The number of groups of linked robots; a robot without a link is a group of its own.", true};
    Charts result_;
};

}  // namespace

Quartiles quartiles_of(std::vector<double> values) {
    std::ranges::sort(values);
    return {values.front(), at_rank(values, 0.25), at_rank(values, 0.5), at_rank(values, 0.75), values.back()};
}

std::size_t thinning_factor(std::size_t count, std::size_t most) {
    // There are count - 1 gaps between the first and the last time. They are divided into at most `most` - 1 steps.
    const std::size_t steps = std::max<std::size_t>(most, 2) - 1;
    return count < 2 ? 1 : (count - 1 + steps - 1) / steps;
}

std::vector<std::size_t> kept_indices(std::size_t count, std::size_t every) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < count; i += every) indices.push_back(i);
    if (count > 0 && indices.back() != count - 1) indices.push_back(count - 1);
    return indices;
}

double link_of(const Scenario& scenario) {
    for (const Measure& measure : scenario.measures)
        if (measure.kind == MeasureKind::cluster) return measure.link;
    return 4 * scenario.world.body.radius;
}

Charts charts_of(const Scenario& scenario, const std::vector<TrialResult>& trials, const Machines& machines,
                 std::size_t most_times) {
    return ChartMaker(scenario, trials, machines, most_times).make_charts();
}

}  // namespace robochart::simulation
