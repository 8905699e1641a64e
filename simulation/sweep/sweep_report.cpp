// SPDX-License-Identifier: Apache-2.0
// See sweep_report.hpp.
#include "simulation/sweep/sweep_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics/json_values.hpp"
#include "base/statistics/survival.hpp"
#include "simulation/report/percent.hpp"

namespace robochart::simulation {

using diagnostics::Json;
using diagnostics::json_array;

namespace {

std::uint32_t robots_at(const Scenario& scenario, const Point& point) {
    return scenario_at(scenario, point).robots;
}

template <class Count>
std::uint64_t sum_over_claims(const Scenario& scenario, const SweepResult& result, Count count) {
    std::uint64_t total = 0;
    for (const PointResult& point : result.points)
        for (const ClaimResult& claim : point.claims) total += count(claim) * robots_at(scenario, point.point);
    return total;
}

std::string interval_text(const Claim& claim, const ClaimResult& found) {
    if (claim.indifference > 0) return "tested";
    return found.looked == 0
               ? ""
               : fmt::format("{} to {}", percent_below(found.interval.low), percent_above(found.interval.high));
}

/// The values of the second variation, or a single empty value if there is none.
using Seconds = std::vector<std::optional<double>>;
Seconds seconds_of(const Scenario& scenario) {
    if (scenario.variations.size() < 2) return {std::nullopt};
    const std::vector<double>& values = scenario.variations[1].values;
    return {values.begin(), values.end()};
}

/// Returns runs of adjacent values of the first variation, such as "1 to 3, 5".
std::string runs_text(const Scenario& scenario, const SweepResult& result, std::size_t claim,
                      std::optional<double> second, const std::string& word) {
    const Variation& first = scenario.variations.front();
    std::vector<std::string> runs;
    std::optional<double> from;
    double last = 0;
    const auto close = [&] {
        if (!from) return;
        const std::string begin = value_text(first, *from);
        runs.push_back(*from == last ? begin : begin + " to " + value_text(first, last));
        from.reset();
    };
    for (const PointResult& point : result.points) {
        if (second && point.point.at(1) != *second) continue;
        if (point_word(point, claim) != word) {
            close();
            continue;
        }
        if (!from) from = point.point[0];
        last = point.point[0];
    }
    close();
    return runs.empty() ? "none" : fmt::format("{}", fmt::join(runs, ", "));
}

std::string sets_text(const Scenario& scenario, const SweepResult& result, std::size_t claim) {
    std::string out;
    for (const auto& second : scenario.claims[claim].estimate ? Seconds{} : seconds_of(scenario)) {
        const std::string at = second ? fmt::format(" ({} {})", name_of(scenario.variations[1]),
                                                    value_text(scenario.variations[1], *second))
                                      : "";
        for (const char* const word : {"proved", "refuted", "open", "not looked at"}) {
            const std::string runs = runs_text(scenario, result, claim, second, word);
            if (runs != "none" || word != std::string("not looked at"))
                out += fmt::format("  {:<10} {}{}\n", word, runs, at);
        }
    }
    return out;
}

std::string table_text(const Scenario& scenario, const SweepResult& result, std::size_t claim) {
    std::string out = "  ";
    for (const Variation& variation : scenario.variations) out += fmt::format("{:<9} ", name_of(variation));
    out += fmt::format("{:<9} {:>7} {:>9}  {:<22} {}\n", "answer", "trials", "successes", "jointly", "median time");
    for (const PointResult& point : result.points) {
        if (point.claims.empty()) continue;
        const ClaimResult& found = point.claims[claim];
        out += "  ";
        for (std::size_t v = 0; v < point.point.size(); ++v)
            out += fmt::format("{:<9} ", value_text(scenario.variations[v], point.point[v]));
        std::string line =
            fmt::format("{:<9} {:>7} {:>9}  {:<22} {}", point_word(point, claim), found.trial_count(), found.successes,
                        interval_text(scenario.claims[claim], found), median_text(scenario.claims[claim], found));
        if (found.stopped_count() > 0) line += fmt::format(" ({} stopped)", found.stopped_count());
        out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return out;
}

std::string csv_text(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

std::string csv_point(const Scenario& scenario, const Point& point) {
    std::string out;
    for (std::size_t v = 0; v < point.size(); ++v)
        out += (scenario.variations[v].what != Varied::robots ? fmt::format("{}", point[v])
                                                              : value_text(scenario.variations[v], point[v])) +
               ",";
    return out;
}

std::string csv_names(const Scenario& scenario) {
    std::string out;
    for (const Variation& variation : scenario.variations) out += csv_text(name_of(variation)) + ",";
    return out;
}

}  // namespace

std::uint64_t SweepResult::robot_steps(const Scenario& scenario) const {
    return sum_over_claims(scenario, *this, [](const ClaimResult& claim) { return claim.steps; });
}

std::uint64_t SweepResult::whole_robot_steps(const Scenario& scenario) const {
    return sum_over_claims(scenario, *this,
                           [&](const ClaimResult& claim) { return claim.trial_count() * scenario.step_count(); });
}

std::string point_word(const PointResult& point, std::size_t claim) {
    if (point.claims.empty()) return "not looked at";
    switch (point.claims.at(claim).verdict) {
        case ClaimVerdict::holds:
            return "proved";
        case ClaimVerdict::fails:
            return "refuted";
        case ClaimVerdict::estimated:
            return "estimated";
        case ClaimVerdict::open:
            break;
    }
    return "open";
}

std::string median_text(const Claim& claim, const ClaimResult& found) {
    if (claim.property.kind != Formula::Kind::within || found.outcomes.empty()) return "";
    const auto half = statistics::median_time(statistics::survival_curve(durations_of(found), 0.05));
    return half ? fmt::format("{:.1f} s", *half) : "never";
}

std::vector<std::string> least_lines(const Scenario& scenario, const SweepResult& result) {
    std::vector<std::string> lines;
    const Variation& first = scenario.variations.front();
    for (std::size_t c = 0; c < scenario.claims.size(); ++c)
        for (const auto& second : scenario.claims[c].estimate ? Seconds{} : seconds_of(scenario)) {
            const Least found = least_value(result.points, c, second);
            const std::string name = "least " + name_of(first);
            std::string line;
            if (!found.value)
                line = fmt::format("{}: none is proved", name);
            else if (found.certain)
                line = fmt::format("{}: {}", name, value_text(first, *found.value));
            else
                line = fmt::format("{}: at most {}", name, value_text(first, *found.value));
            if (second)
                line += fmt::format(", with {} {}", name_of(scenario.variations[1]),
                                    value_text(scenario.variations[1], *second));
            if (scenario.claims.size() > 1) line += fmt::format(", for claim {}", c + 1);
            lines.push_back(line);
        }
    return lines;
}

std::string sweep_text(const Scenario& scenario, const SweepResult& result) {
    std::string out;
    for (std::size_t c = 0; c < scenario.claims.size(); ++c)
        out += fmt::format("{}{}, jointly for {} points\n{}\n{}\n",
                           scenario.claims.size() > 1 ? fmt::format("{}: ", c + 1) : "", scenario.claims[c].text,
                           result.points.size(), table_text(scenario, result, c), sets_text(scenario, result, c));
    const auto steps = static_cast<double>(result.robot_steps(scenario));
    const auto whole = static_cast<double>(result.whole_robot_steps(scenario));
    if (whole > 0)
        out += fmt::format("{:.1f} million robot-steps; {:.1f} million if no trial had ended early\n", steps / 1e6,
                           whole / 1e6);
    return out;
}

std::string sweep_csv(const Scenario& scenario, const SweepResult& result) {
    std::string out =
        csv_names(scenario) +
        "claim,answer,trials,successes,low,high,pointwise_low,pointwise_high,stopped,robot_steps,median_s\n";
    for (const PointResult& point : result.points)
        for (std::size_t c = 0; c < point.claims.size(); ++c) {
            const ClaimResult& found = point.claims[c];
            const auto alone = pointwise_interval(scenario.claims[c], found);
            const std::string median = median_text(scenario.claims[c], found);
            out += fmt::format("{}{},{},{},{},{},{},{},{},{},{},{}\n", csv_point(scenario, point.point),
                               csv_text(scenario.claims[c].text), point_word(point, c), found.trial_count(),
                               found.successes, found.interval.low, found.interval.high,
                               alone ? fmt::format("{}", alone->low) : "", alone ? fmt::format("{}", alone->high) : "",
                               found.stopped_count(), found.steps * robots_at(scenario, point.point),
                               median.substr(0, median.find(' ')));
        }
    return out;
}

std::string sweep_trials_csv(const Scenario& scenario, const SweepResult& result) {
    std::string out = csv_names(scenario) + "claim,seed,holds,known_s,stopped\n";
    for (const PointResult& point : result.points)
        for (std::size_t c = 0; c < point.claims.size(); ++c)
            for (std::size_t trial = 0; trial < point.claims[c].outcomes.size(); ++trial) {
                const ClaimOutcome& outcome = point.claims[c].outcomes[trial];
                out += fmt::format("{}{},{},{},{:.10g},{}\n", csv_point(scenario, point.point), c + 1,
                                   scenario.seed + trial, outcome.holds ? 1 : 0, outcome.time, outcome.stopped ? 1 : 0);
            }
    return out;
}

Json values_json(const Scenario& scenario, const Point& point) {
    Json values = Json::object();
    for (std::size_t v = 0; v < point.size(); ++v) values[name_of(scenario.variations[v])] = point[v];
    return values;
}

std::string sweep_json(const Scenario& scenario, const SweepResult& result, Json comparison, Json guard,
                       const std::vector<std::string>& files, int exit) {
    const auto point_json = [&](const PointResult& point) -> Json {
        Json claims = Json::array();
        for (std::size_t c = 0; c < point.claims.size(); ++c) {
            const ClaimResult& found = point.claims[c];
            claims.push_back({{"answer", point_word(point, c)},
                              {"trials", found.trial_count()},
                              {"successes", found.successes},
                              {"low", found.interval.low},
                              {"high", found.interval.high},
                              {"stopped", found.stopped_count()},
                              {"steps", found.steps}});
        }
        return {{"values", values_json(scenario, point.point)}, {"claims", std::move(claims)}};
    };
    const Json json{{"schema", "robochart-verify/sweep/1"},
                    {"scenario", scenario.name.text},
                    {"component", scenario.component.text},
                    {"seed", scenario.seed},
                    {"duration", scenario.duration},
                    {"claims", json_array(scenario.claims, &Claim::text)},
                    {"points", json_array(result.points, point_json)},
                    {"least", least_lines(scenario, result)},
                    {"comparison", std::move(comparison)},
                    {"world", world_lines(scenario)},
                    {"monitor", std::move(guard)},
                    {"robotSteps", result.robot_steps(scenario)},
                    {"wholeRobotSteps", result.whole_robot_steps(scenario)},
                    {"earlier", result.earlier},
                    {"interrupted", result.interrupted},
                    {"seconds", diagnostics::round_to_places(result.seconds, 3)},
                    {"cpuSeconds", diagnostics::round_to_places(result.cpu_seconds, 3)},
                    {"files", files},
                    {"exit", exit}};
    return diagnostics::json_text(json) + "\n";
}

}  // namespace robochart::simulation
