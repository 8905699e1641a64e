// SPDX-License-Identifier: Apache-2.0
#include "simulation/report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "base/diagnostics/json_values.hpp"

namespace robochart::simulation {

using diagnostics::Json;
using diagnostics::json_array;
using diagnostics::json_number;

namespace {

Dimension dimension_of(const Scenario& scenario, const Band& band) {
    if (band.statistic.kind == StatisticKind::first_time) return Dimension::time;
    return dimension_of(scenario.measures[band.statistic.measure].kind);
}

double simulated_time(const Scenario& scenario, const RunResult& result) {
    return static_cast<double>(result.steps) * scenario.world.control_step;
}

Json band_json(const Band& band, const BandResult& found, std::size_t index, const RunResult& result) {
    const auto value_in_trial = [&](const TrialResult& trial) { return json_number(trial.statistics.at(index)); };
    return Json{{"band", band.text},
                {"holds", found.holds},
                {"each", band.each},
                {"low", json_number(band.low)},
                {"high", json_number(band.high)},
                {"value", json_number(found.value)},
                {"trialsOutside", found.trials_outside},
                {"trials", json_array(result.trials, value_in_trial)}};
}

Json bands_json(const Scenario& scenario, const RunResult& result) {
    Json list = Json::array();
    for (std::size_t i = 0; i < result.bands.size(); ++i)
        list.push_back(band_json(scenario.bands[i], result.bands[i], i, result));
    return list;
}

Json claim_json(const Claim& claim, const ClaimResult& found) {
    Json json{{"claim", claim.text},
              {"verdict", verdict_word(found.verdict)},
              {"atLeast", claim.estimate ? Json() : Json(claim.at_least)},
              {"probability", claim.estimate ? Json() : json_number(claim.probability)},
              {"confidence", json_number(claim.confidence)},
              {"error", json_number(found.error)},
              {"trials", found.trial_count()},
              {"most", claim.trials},
              {"successes", found.successes},
              {"stopped", found.stopped_count()},
              {"steps", found.steps}};
    if (claim.indifference > 0) {
        json["method"] = "sequential test";
        json["indifference"] = json_number(claim.indifference);
    } else {
        json["method"] = "Clopper-Pearson";
        json["low"] = found.interval.low;
        json["high"] = found.interval.high;
        json["looked"] = found.looked;
    }
    return json;
}

Json claims_json(const Scenario& scenario, const RunResult& result) {
    Json list = Json::array();
    for (std::size_t c = 0; c < result.claims.size(); ++c)
        list.push_back(claim_json(scenario.claims[c], result.claims[c]));
    return list;
}

Json trial_json(const TrialResult& trial) {
    Json json{{"steps", trial.steps}, {"complete", trial.complete}};
    if (trial.stop)
        json["stop"] = Json{{"robot", trial.stop->environment ? Json() : Json(trial.stop->robot)},
                            {"time", json_number(trial.stop->time)},
                            {"cause", trial.stop->cause},
                            {"place", trial.stop->place}};
    return json;
}

}  // namespace

std::string value_text(const Scenario& scenario, const Band& band, double value) {
    if (std::isnan(value)) return "never";
    const Dimension dimension = dimension_of(scenario, band);
    const double factor = dimension == Dimension::share ? 100 : 1;
    const auto inside = [&](double candidate) { return band.low <= candidate && candidate <= band.high; };
    // The number of digits with which a value outside a band is not rounded to a value inside.
    constexpr int most_digits = 15;
    int digits = 1;
    std::string number = fmt::format("{:.{}f}", factor * value, digits);
    while (digits < most_digits && !inside(value) && inside(std::strtod(number.c_str(), nullptr) / factor))
        number = fmt::format("{:.{}f}", factor * value, ++digits);
    return number.append(printed_unit(dimension));
}

std::string bands_text(const Scenario& scenario, const RunResult& result) {
    std::string out;
    for (std::size_t i = 0; i < result.bands.size(); ++i) {
        const Band& band = scenario.bands[i];
        const BandResult& found = result.bands[i];
        const std::string value = value_text(scenario, band, found.value);
        std::string measured = fmt::format("{} {}", band.each ? "worst" : "mean", value);
        if (band.each && !found.holds)
            measured += fmt::format(", {} of {} trials outside", found.trials_outside, result.trials.size());
        out += fmt::format("  {:<8} {:<52} {}\n", found.holds ? "holds" : "FAILS", band.text, measured);
    }
    return out;
}

std::string summary_text(const RunResult& result) {
    const auto held = std::ranges::count_if(result.bands, [](const auto& b) { return b.holds; });
    const auto count = [&](ClaimVerdict verdict) {
        return std::ranges::count_if(result.claims, [&](const ClaimResult& claim) { return claim.verdict == verdict; });
    };
    const auto estimates = count(ClaimVerdict::estimated);
    const auto claims = static_cast<std::ptrdiff_t>(result.claims.size()) - estimates;
    if (result.bands.empty() && result.claims.empty()) return "nothing is claimed: `accept` says what is to hold";
    std::vector<std::string> parts;
    if (!result.bands.empty()) parts.push_back(fmt::format("{} of {} bands hold", held, result.bands.size()));
    if (claims > 0) parts.push_back(fmt::format("{} of {} claims hold", count(ClaimVerdict::holds), claims));
    if (estimates > 0) parts.push_back(fmt::format("{} estimated", estimates));
    if (count(ClaimVerdict::open) > 0) parts.push_back(fmt::format("{} open", count(ClaimVerdict::open)));
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string run_text(const Scenario& scenario, const RunResult& result) {
    const double seconds = simulated_time(scenario, result);
    const double steps = seconds / scenario.world.control_step * scenario.all_robots();
    return fmt::format(
        "{:.0f} s simulated in {:.2f} s: {:.0f} times real time; {:.2f} million robot-steps a CPU second\n", seconds,
        result.seconds, seconds / std::max(result.seconds, 1e-9), steps / std::max(result.cpu_seconds, 1e-9) / 1e6);
}

Json guard_json(const Guard* guard, bool complete) {
    if (guard == nullptr) return {};
    Json notes = Json::array();
    std::istringstream lines(guard->summary_lines());
    for (std::string line; std::getline(lines, line);) notes.push_back(line.substr(line.find_first_not_of(' ')));
    return {{"complete", complete}, {"notes", std::move(notes)}};
}

std::string result_json(const Scenario& scenario, const RunResult& result, Json guard,
                        const std::vector<std::string>& files, int exit) {
    const Json json{{"schema", "robochart-verify/simulation/1"},
                    {"scenario", scenario.name.text},
                    {"component", scenario.component.text},
                    {"robots", scenario.all_robots()},
                    {"trials", json_array(result.trials, trial_json)},
                    {"duration", json_number(scenario.duration)},
                    {"seed", scenario.seed},
                    {"interrupted", result.interrupted},
                    {"simulatedSeconds", json_number(simulated_time(scenario, result))},
                    {"seconds", json_number(result.seconds)},
                    {"cpuSeconds", json_number(result.cpu_seconds)},
                    {"bands", bands_json(scenario, result)},
                    {"claims", claims_json(scenario, result)},
                    {"world", world_lines(scenario)},
                    {"monitor", std::move(guard)},
                    {"files", files},
                    {"exit", exit}};
    return diagnostics::json_text(json) + "\n";
}

}  // namespace robochart::simulation
