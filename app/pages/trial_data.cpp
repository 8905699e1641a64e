// SPDX-License-Identifier: Apache-2.0
#include "app/pages/trial_data.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "simulation/report/series.hpp"

namespace robochart::app {
namespace {

using diagnostics::Json;

constexpr double last = 4095;
constexpr std::size_t most_robots = 1000;
constexpr std::size_t most_trials = 20;
/// If the data would be too large, trials are omitted before a trial is thinned to fewer frames than this.
constexpr std::size_t enough_frames = 120;

std::size_t scaled_share(double value, double low, double width) {
    return static_cast<std::size_t>(std::llround(last * std::clamp((value - low) / width, 0.0, 1.0)));
}

/// Returns the rank of a trial for the selection. Trials with lower ranks are selected first.
int rank_of_trial(const simulation::Scenario& scenario, const simulation::TrialResult& trial) {
    if (trial.stop) return 0;
    for (std::size_t b = 0; b < scenario.bands.size() && b < trial.statistics.size(); ++b) {
        const double value = trial.statistics[b];
        if (scenario.bands[b].each && !(scenario.bands[b].low <= value && value <= scenario.bands[b].high)) return 1;
    }
    return 2;
}

}  // namespace

ShownTrials shown_trials(const simulation::Scenario& scenario, const simulation::RunResult& result,
                         std::size_t machines, std::size_t most_letters) {
    ShownTrials shown;
    std::size_t recorded = 0;
    for (std::size_t t = 0; t < result.trials.size(); ++t) {
        if (result.trials[t].frames.empty()) continue;
        shown.trials.push_back(t);
        recorded = std::max(recorded, result.trials[t].frames.size());
    }
    shown.robots = std::min<std::size_t>(scenario.all_robots(), most_robots);
    const std::size_t letters = std::max<std::size_t>(1, shown.robots * (6 + 2 * machines));
    const std::size_t frames = std::max<std::size_t>(2, most_letters / letters);
    const std::size_t needed_frames = std::min(enough_frames, std::max<std::size_t>(recorded, 1));
    const std::size_t trials = std::clamp<std::size_t>(frames / needed_frames, 1, most_trials);
    std::ranges::stable_sort(shown.trials, [&](std::size_t a, std::size_t b) {
        return rank_of_trial(scenario, result.trials[a]) < rank_of_trial(scenario, result.trials[b]);
    });
    if (shown.trials.size() > trials) shown.trials.resize(trials);
    std::ranges::sort(shown.trials);
    const std::size_t frames_per_trial =
        std::max<std::size_t>(2, frames / std::max<std::size_t>(1, shown.trials.size()));
    shown.every = simulation::thinning_factor(recorded, frames_per_trial);
    return shown;
}

std::string two_letters(std::size_t number) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    return {letters[number / 64 % 64], letters[number % 64]};
}

std::string frame_letters(const simulation::View& view, const simulation::Frame& frame, std::size_t robots,
                          std::size_t machines) {
    std::string text;
    for (std::size_t r = 0; r < std::min(robots, frame.poses.size()); ++r) {
        const simulation::Pose& pose = frame.poses[r];
        const double turn = pose.heading / (2 * std::numbers::pi);
        text += two_letters(scaled_share(pose.at.x, view.left, view.width));
        text += two_letters(scaled_share(-pose.at.y, view.top, view.height));
        text += two_letters(static_cast<std::size_t>(std::llround(4096 * (turn - std::floor(turn)))) % 4096);
        for (std::size_t m = 0; m < machines; ++m)
            text += two_letters(std::min<std::size_t>(frame.robot_state(r, m), 4095));
    }
    return text;
}

Json trials_json(const simulation::View& view, const simulation::RunResult& result, const ShownTrials& shown,
                 std::size_t machines) {
    Json trials = Json::array();
    for (const std::size_t t : shown.trials) {
        const std::vector<simulation::Frame>& frames = result.trials[t].frames;
        Json letters = Json::array();
        Json times = Json::array();
        for (const std::size_t f : simulation::kept_indices(frames.size(), shown.every)) {
            letters.push_back(frame_letters(view, frames[f], shown.robots, machines));
            times.push_back(diagnostics::round_to_places(frames[f].time, 3));
        }
        trials.push_back({{"number", t + 1}, {"times", std::move(times)}, {"frames", std::move(letters)}});
    }
    return {{"view", {view.left, view.top, view.width, view.height}},
            {"robots", shown.robots},
            {"machines", machines},
            {"trials", std::move(trials)}};
}

}  // namespace robochart::app
