// SPDX-License-Identifier: Apache-2.0
#include "simulation/trial/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

namespace {

/// Finds groups of robots (union-find with path halving).
class Groups {
public:
    explicit Groups(std::size_t count) : parent_(count), size_(count, 1), count_(count) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }
    void join_groups(std::uint32_t a, std::uint32_t b) {
        a = find_root(a);
        b = find_root(b);
        if (a == b) return;
        if (size_[a] < size_[b]) std::swap(a, b);
        parent_[b] = a;
        size_[a] += size_[b];
        --count_;
    }
    [[nodiscard]] Clusters result() const { return {count_, *std::ranges::max_element(size_)}; }

private:
    std::uint32_t find_root(std::uint32_t a) {
        while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
        return a;
    }
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint32_t> size_;
    std::size_t count_;
};

}  // namespace

Clusters count_clusters(const std::vector<Pose>& poses, double link) {
    if (poses.empty()) return {};
    // Sorted by x: only robots whose x differs by less than a link can be linked.
    std::vector<std::uint32_t> order(poses.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return poses[a].at.x < poses[b].at.x; });
    Groups groups(poses.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const Vector way = poses[order[j]].at - poses[order[i]].at;
            if (way.x > link) break;
            if (dot(way, way) <= link * link) groups.join_groups(order[i], order[j]);
        }
    return groups.result();
}

double largest_cluster(const std::vector<Pose>& poses, double link) {
    if (poses.empty()) return 0;
    return static_cast<double>(count_clusters(poses, link).largest) / static_cast<double>(poses.size());
}

double mean_distance(const std::vector<Pose>& poses) {
    if (poses.size() < 2) return 0;
    double sum = 0;
    for (std::size_t i = 0; i < poses.size(); ++i)
        for (std::size_t j = i + 1; j < poses.size(); ++j) sum += length(poses[i].at - poses[j].at);
    const auto count = static_cast<double>(poses.size());
    return sum / (count * (count - 1) / 2);
}

Vector centroid(const std::vector<Pose>& poses) {
    Vector sum;
    for (const Pose& pose : poses) sum = sum + pose.at;
    return poses.empty() ? sum : (1 / static_cast<double>(poses.size())) * sum;
}

double mean_spread(const std::vector<Pose>& poses) {
    const Vector centre = centroid(poses);
    double sum = 0;
    for (const Pose& pose : poses) sum += length(pose.at - centre);
    return poses.empty() ? 0 : sum / static_cast<double>(poses.size());
}

double second_moment(const std::vector<Pose>& poses, double radius) {
    const Vector centre = centroid(poses);
    double sum = 0;
    for (const Pose& pose : poses) sum += dot(pose.at - centre, pose.at - centre);
    return sum / (4 * radius * radius);
}

double share_within(const std::vector<Pose>& poses, Vector point, double distance) {
    const auto near =
        std::ranges::count_if(poses, [&](const Pose& pose) { return length(pose.at - point) <= distance; });
    return poses.empty() ? 0 : static_cast<double>(near) / static_cast<double>(poses.size());
}

double share_inside(const std::vector<Pose>& poses, const Region& region) {
    const auto there = std::ranges::count_if(poses, [&](const Pose& pose) {
        return region.low.x <= pose.at.x && pose.at.x <= region.high.x && region.low.y <= pose.at.y &&
               pose.at.y <= region.high.y;
    });
    return poses.empty() ? 0 : static_cast<double>(there) / static_cast<double>(poses.size());
}

LightNow light_at(const Scenario& scenario, const Frame& frame, std::size_t light) {
    return frame.lights.empty() ? LightNow{scenario.lights.at(light).position_at(frame.time)} : frame.lights.at(light);
}

Frame of_kind(const Scenario& scenario, std::size_t kind, const Frame& frame) {
    const auto first = static_cast<std::ptrdiff_t>(scenario.first_robot(kind));
    const auto last = static_cast<std::ptrdiff_t>(scenario.first_robot(kind + 1));
    Frame part;
    part.time = frame.time;
    part.lights = frame.lights;
    part.obstacles = frame.obstacles;
    part.kept = frame.kept;
    part.poses.assign(frame.poses.begin() + first, frame.poses.begin() + last);
    if (!frame.working.empty()) part.working.assign(frame.working.begin() + first, frame.working.begin() + last);
    const auto machines = static_cast<std::ptrdiff_t>(frame.states.size() / frame.poses.size());
    part.states.assign(frame.states.begin() + first * machines, frame.states.begin() + last * machines);
    return part;
}

double share_in(const Measure& measure, const Frame& frame) {
    if (frame.states.empty()) return 0;
    std::size_t there = 0;
    for (std::size_t robot = 0; robot < frame.poses.size(); ++robot)
        if (std::ranges::find(measure.states, frame.robot_state(robot)) != measure.states.end()) ++there;
    return static_cast<double>(there) / static_cast<double>(frame.poses.size());
}

namespace {

/// Returns the fraction of robots whose runs satisfy the claim; NaN if no claims are followed.
double kept_share(const Scenario& scenario, const Measure& measure, const Frame& frame) {
    const auto found =
        std::ranges::find(scenario.measures, measure.name.text, [](const Measure& other) { return other.name.text; });
    const auto number = static_cast<std::size_t>(found - scenario.measures.begin());
    return number < frame.kept.size() ? frame.kept[number] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double measure_value(const Scenario& scenario, const Measure& measure, const Frame& all) {
    const Frame part = measure.of ? of_kind(scenario, *measure.of, all) : Frame{};
    const Frame& frame = measure.of ? part : all;
    const std::vector<Pose>& poses = frame.poses;
    switch (measure.kind) {
        case MeasureKind::cluster:
            return largest_cluster(poses, measure.link);
        case MeasureKind::spread:
            return mean_spread(poses);
        case MeasureKind::second_moment:
            return second_moment(poses, scenario.world.body.radius);
        case MeasureKind::distance:
            return length(centroid(poses) - light_at(scenario, frame, measure.light).at);
        case MeasureKind::reached:
            return share_within(poses, light_at(scenario, frame, measure.light).at, measure.link);
        case MeasureKind::inside:
            return share_inside(poses, measure.region);
        case MeasureKind::time:
            return frame.time;
        case MeasureKind::in_state:
            return share_in(measure, frame);
        case MeasureKind::kept:
            return kept_share(scenario, measure, all);
        case MeasureKind::working:
            return frame.working.empty() ? 1
                                         : static_cast<double>(std::ranges::count(frame.working, true)) /
                                               static_cast<double>(frame.working.size());
    }
    return 0;
}

namespace {

/// Returns the states that a measure names: by their names in the machine, or by the name of a kind and their names, as
/// in the list of machines_of. If the measure is about one kind, returns only states of this kind.
std::vector<std::uint16_t> states_of(const Scenario& scenario, const Measure& measure, const Machines& machines) {
    if (measure.of && !scenario.others.empty())
        return states_named(machines,
                            fmt::format("{}::{}", scenario.kind_at(*measure.of).kind.text, measure.state.text));
    std::vector<std::uint16_t> states = states_named(machines, measure.state.text);
    for (std::size_t kind = 0; kind < scenario.kind_count() && !scenario.others.empty(); ++kind) {
        const std::string& name = scenario.kind_at(kind).kind.text;
        if (name.empty()) continue;
        const auto more = states_named(machines, fmt::format("{}::{}", name, measure.state.text));
        states.insert(states.end(), more.begin(), more.end());
    }
    return states;
}

/// True if the name may refer to states of several kinds, or if a kind has the same name.
bool is_ambiguous(const Scenario& scenario, const Measure& measure, const Machines& machines) {
    if (measure.of) return false;
    for (std::size_t kind = 0; kind < scenario.kind_count() && !scenario.others.empty(); ++kind)
        if (scenario.kind_at(kind).kind.text == measure.state.text) return true;
    std::set<std::string> names;
    return std::ranges::any_of(measure.states, [&](std::uint16_t state) {
        return !names.insert(machines.front().states[state]).second;  // also in an unnamed kind
    });
}

}  // namespace

void find_states(Scenario& scenario, const Machines& machines, diagnostics::Diagnostics& diagnostics) {
    for (Measure& measure : scenario.measures) {
        if (measure.kind != MeasureKind::in_state) continue;
        measure.states = states_of(scenario, measure, machines);
        if (measure.states.empty())
            diagnostics.report(rules::unknown_part, measure.state.span,
                               {"state of the first machine named", measure.state.text});
        else if (is_ambiguous(scenario, measure, machines))
            diagnostics.report(rules::unknown_part, measure.state.span,
                               {"state that is not called as a kind of robots is, named", measure.state.text});
    }
}

MeasureNow measures_now(const Scenario& scenario, const Frame& frame) {
    std::vector<double> known(scenario.measures.size(), std::numeric_limits<double>::quiet_NaN());
    return [&scenario, &frame, known = std::move(known)](std::size_t measure) mutable {
        double& value = known[measure];
        if (std::isnan(value)) value = measure_value(scenario, scenario.measures[measure], frame);
        return value;
    };
}

Statistics::Statistics(const Scenario& scenario) : scenario_(scenario), entries_(scenario.bands.size()) {
    for (std::size_t band = 0; band < entries_.size(); ++band)
        if (scenario.bands[band].statistic.kind == StatisticKind::first_time)
            entries_[band].condition.emplace(scenario.bands[band].statistic.condition, scenario.world.control_step);
}

bool Statistics::is_due(std::size_t band, std::uint64_t step) const {
    const Statistic& statistic = scenario_.bands[band].statistic;
    const double seconds = static_cast<double>(step) * scenario_.world.control_step;
    const auto at = [&](double time) {
        return step == static_cast<std::uint64_t>(std::llround(time / scenario_.world.control_step));
    };
    switch (statistic.kind) {
        case StatisticKind::at_time:
            return at(statistic.time);
        case StatisticKind::first_time:
            return !entries_[band].done;
        case StatisticKind::average:
            return at(std::round(seconds));
        case StatisticKind::final:
            return step == scenario_.step_count();
    }
    return false;
}

bool Statistics::is_due(std::uint64_t step) const {
    for (std::size_t band = 0; band < entries_.size(); ++band)
        if (is_due(band, step)) return true;
    return false;
}

void Statistics::take_samples(std::uint64_t step, const MeasureNow& now) {
    for (std::size_t band = 0; band < entries_.size(); ++band) {
        if (!is_due(band, step)) continue;
        const Statistic& statistic = scenario_.bands[band].statistic;
        Entry& entry = entries_[band];
        if (entry.condition) {
            entry.done = entry.condition->holds_after(step, now);
            entry.value = static_cast<double>(step) * scenario_.world.control_step;
        } else {
            entry.value += now(statistic.measure);
            ++entry.looks;
            entry.done = true;
        }
    }
}

std::vector<double> Statistics::band_values() const {
    std::vector<double> result;
    for (const Entry& entry : entries_) {
        const double looks = entry.looks > 0 ? static_cast<double>(entry.looks) : 1;
        result.push_back(entry.done ? entry.value / looks : std::numeric_limits<double>::quiet_NaN());
    }
    return result;
}

}  // namespace robochart::simulation
