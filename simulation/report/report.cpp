#include "simulation/report/report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "diagnostics/json.hpp"

namespace robochart::simulation {

using diagnostics::json_string;

namespace {

Dimension dimension_of(const Scenario& scenario, const Band& band) {
    if (band.statistic.kind == StatisticKind::first_time) return Dimension::time;
    switch (scenario.measures[band.statistic.measure].kind) {
        case MeasureKind::cluster:
            return Dimension::share;
        case MeasureKind::second_moment:
            return Dimension::number;
        default:
            return Dimension::length;
    }
}

std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{:.6g}", value) : "null";
}

double simulated(const Scenario& scenario, const RunResult& result) {
    double seconds = 0;
    for (const TrialResult& trial : result.trials)
        seconds += static_cast<double>(trial.steps) * scenario.world.control_step;
    return seconds;
}

std::string bands_json(const Scenario& scenario, const RunResult& result) {
    std::string out;
    for (std::size_t i = 0; i < result.bands.size(); ++i) {
        const Band& band = scenario.bands[i];
        std::string values;
        for (const TrialResult& trial : result.trials)
            values += (values.empty() ? "" : ",") + number(trial.statistics.at(i));
        out += fmt::format(
            "{}{{\"band\":{},\"holds\":{},\"each\":{},\"low\":{},\"high\":{},\"value\":{},\"trialsOutside\":{},"
            "\"trials\":[{}]}}",
            out.empty() ? "" : ",", json_string(band.text), result.bands[i].holds, band.each, number(band.low),
            number(band.high), number(result.bands[i].value), result.bands[i].trials_outside, values);
    }
    return out;
}

std::string trials_json(const RunResult& result) {
    std::string out;
    for (const TrialResult& trial : result.trials) {
        out += fmt::format("{}{{\"steps\":{},\"complete\":{}", out.empty() ? "" : ",", trial.steps, trial.complete);
        if (trial.stop)
            out +=
                fmt::format(",\"stop\":{{\"robot\":{},\"time\":{},\"cause\":{},\"place\":{}}}", trial.stop->robot,
                            number(trial.stop->time), json_string(trial.stop->cause), json_string(trial.stop->place));
        out += "}";
    }
    return out;
}

}  // namespace

std::string value_text(const Scenario& scenario, const Band& band, double value) {
    if (std::isnan(value)) return "never";
    switch (dimension_of(scenario, band)) {
        case Dimension::time:
            return fmt::format("{:.1f} s", value);
        case Dimension::share:
            return fmt::format("{:.1f} %", 100 * value);
        case Dimension::length:
            return fmt::format("{:.1f} cm", value);
        default:
            return fmt::format("{:.1f}", value);
    }
}

std::string bands_text(const Scenario& scenario, const RunResult& result) {
    std::string out;
    for (std::size_t i = 0; i < result.bands.size(); ++i) {
        const Band& band = scenario.bands[i];
        const BandResult& found = result.bands[i];
        const std::string value = value_text(scenario, band, found.value);
        const std::string said =
            band.each ? fmt::format("worst {}{}", value,
                                    found.holds ? ""
                                                : fmt::format(", {} of {} trials outside", found.trials_outside,
                                                              result.trials.size()))
                      : fmt::format("mean {}", value);
        out += fmt::format("  {:<8} {:<52} {}\n", found.holds ? "holds" : "FAILS", band.text, said);
    }
    return out;
}

std::string run_text(const Scenario& scenario, const RunResult& result) {
    const double seconds = simulated(scenario, result);
    const double steps = seconds / scenario.world.control_step * scenario.robots;
    return fmt::format(
        "{:.0f} s simulated in {:.2f} s: {:.0f} times real time; {:.2f} million robot-steps a CPU second\n", seconds,
        result.seconds, seconds / std::max(result.seconds, 1e-9), steps / std::max(result.cpu_seconds, 1e-9) / 1e6);
}

std::string result_json(const Scenario& scenario, const RunResult& result, const std::vector<std::string>& files,
                        int exit) {
    std::string written;
    for (const std::string& file : files) written += (written.empty() ? "" : ",") + json_string(file);
    return fmt::format(
        "{{\"schema\":\"robochart-verify/simulation/1\",\"scenario\":{},\"component\":{},\"robots\":{},\"trials\":[{}],"
        "\"duration\":{},\"seed\":{},\"interrupted\":{},\"simulatedSeconds\":{},\"seconds\":{},\"cpuSeconds\":{},"
        "\"bands\":[{}],"
        "\"files\":[{}],\"exit\":{}}}\n",
        json_string(scenario.name.text), json_string(scenario.component.text), scenario.robots, trials_json(result),
        number(scenario.duration), scenario.seed, result.interrupted, number(simulated(scenario, result)),
        number(result.seconds), number(result.cpu_seconds), bands_json(scenario, result), written, exit);
}

}  // namespace robochart::simulation
