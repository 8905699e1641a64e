// SPDX-License-Identifier: Apache-2.0
// See sweep.hpp.
#include "simulation/sweep/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/diagnostics/json.hpp"
#include "simulation/report/percent.hpp"

namespace robochart::simulation {

using diagnostics::Json;

std::vector<Point> points_of(const Scenario& scenario) {
    std::vector<Point> points{{}};
    // The last variation is the outermost, so that the first changes fastest.
    for (auto variation = scenario.variations.rbegin(); variation != scenario.variations.rend(); ++variation) {
        std::vector<Point> more;
        for (const Point& rest : points)
            for (const double value : variation->values) {
                Point point{value};
                point.insert(point.end(), rest.begin(), rest.end());
                more.push_back(std::move(point));
            }
        points = std::move(more);
    }
    return points;
}

namespace {

void set_option(Scenario& scenario, const Variation& variation, double value) {
    for (Sensor& sensor : scenario.sensors)
        if (sensor.name.text == variation.constant)
            for (double* const share : shares_of(sensor, variation.option)) *share = value;
}

/// True if the values of the variation are fractions, which are written as percentages.
bool is_share(const Variation& variation) {
    return variation.what == Varied::noise || variation.what == Varied::sensor;
}

}  // namespace

Scenario scenario_at(const Scenario& scenario, const Point& point) {
    Scenario result = scenario;
    result.bands.clear();
    result.pictures.clear();
    for (std::size_t v = 0; v < point.size(); ++v) {
        const Varied what = scenario.variations[v].what;
        if (what == Varied::robots) result.set_robots(static_cast<std::uint32_t>(point[v]));
        if (what == Varied::noise) result.world.body.noise = point[v];
        for (Failure& failure : result.failures) {
            if (what == Varied::failed && failure.mean_time == 0) failure.robots = static_cast<std::uint32_t>(point[v]);
            if (what == Varied::mean_time && failure.mean_time > 0) failure.mean_time = point[v];
        }
        if (what == Varied::sensor) set_option(result, scenario.variations[v], point[v]);
    }
    return result;
}

std::vector<std::string> constants_at(const Scenario& scenario, const Point& point) {
    std::vector<std::string> result;
    for (std::size_t v = 0; v < point.size(); ++v)
        if (scenario.variations[v].what == Varied::constant)
            result.push_back(
                fmt::format("{}={}", scenario.variations[v].constant, value_text(scenario.variations[v], point[v])));
    return result;
}

std::string name_of(const Variation& variation) {
    switch (variation.what) {
        case Varied::robots:
            return "robots";
        case Varied::noise:
            return "noise";
        case Varied::failed:
            return "failures";
        case Varied::mean_time:
            return "mean time";
        case Varied::sensor:
            return variation.constant + "." + variation.option;
        case Varied::constant:
            break;
    }
    return variation.constant;
}

std::string value_text(const Variation& variation, double value) {
    if (is_share(variation)) return percent_text(value);
    const std::string text = fmt::format("{:.12f}", value);
    const std::size_t last = text.find_last_not_of('0');
    return text.substr(0, text[last] == '.' ? last : last + 1);
}

std::string point_text(const Scenario& scenario, const Point& point) {
    std::vector<std::string> parts;
    for (std::size_t v = 0; v < point.size(); ++v)
        parts.push_back(name_of(scenario.variations[v]) + " " + value_text(scenario.variations[v], point[v]));
    return fmt::format("{}", fmt::join(parts, ", "));
}

Least least_value(const std::vector<PointResult>& results, std::size_t claim, std::optional<double> second) {
    Least found;
    bool all_fail = true;
    for (const PointResult& result : results) {
        if (second && result.point.at(1) != *second) continue;
        const bool known = !result.claims.empty();
        const ClaimVerdict verdict = known ? result.claims.at(claim).verdict : ClaimVerdict::open;
        if (verdict == ClaimVerdict::holds && !found.value) {
            found.value = result.point.at(0);
            found.certain = all_fail;
            found.ended = true;
        }
        all_fail = all_fail && verdict == ClaimVerdict::fails;
    }
    const bool tried = std::ranges::all_of(results, [&](const PointResult& result) {
        return (second && result.point.at(1) != *second) || !result.claims.empty();
    });
    found.ended = found.ended || tried;
    return found;
}

std::optional<statistics::Interval> pointwise_interval(const Claim& claim, const ClaimResult& found) {
    if (claim.indifference > 0 || found.looked == 0 || found.looked != found.trial_count()) return std::nullopt;
    if (claim.estimate) return statistics::clopper_pearson(found.successes, found.looked, 1 - claim.confidence);
    return statistics::Looks(claim.trials, 1 - claim.confidence).interval_after(found.successes, found.looked);
}

std::vector<statistics::Duration> durations_of(const ClaimResult& found) {
    std::vector<statistics::Duration> durations;
    for (const ClaimOutcome& outcome : found.outcomes)
        durations.push_back({outcome.time, outcome.holds && !outcome.stopped});
    return durations;
}

std::string claims_to_text(const std::vector<ClaimResult>& claims) {
    Json list = Json::array();
    for (const ClaimResult& claim : claims) {
        Json outcomes = Json::array();
        for (const ClaimOutcome& outcome : claim.outcomes) {
            outcomes.push_back((outcome.holds ? 1 : 0) + (outcome.stopped ? 2 : 0));
            outcomes.push_back(outcome.time);
        }
        list.push_back({static_cast<int>(claim.verdict), claim.successes, claim.error, claim.interval.low,
                        claim.interval.high, claim.looked, claim.steps, std::move(outcomes)});
    }
    return list.dump();
}

namespace {

bool is_stored(const Json& claim) {
    const auto numbers = [](const Json& list) {
        return std::ranges::all_of(list, [](const Json& value) { return value.is_number(); });
    };
    if (!claim.is_array() || claim.size() != 8 || !claim[7].is_array() || !numbers(claim[7])) return false;
    return std::all_of(claim.begin(), claim.end() - 1, [](const Json& value) { return value.is_number(); });
}

}  // namespace

std::optional<std::vector<ClaimResult>> claims_from_text(std::string_view text, std::size_t claims) {
    const Json list = Json::parse(text, nullptr, false);
    if (!list.is_array() || list.size() != claims) return std::nullopt;
    std::vector<ClaimResult> results;
    for (const Json& stored : list) {
        if (!is_stored(stored)) return std::nullopt;
        ClaimResult claim;
        claim.verdict = static_cast<ClaimVerdict>(stored[0].get<int>());
        claim.successes = stored[1].get<std::uint64_t>();
        claim.error = stored[2].get<double>();
        claim.interval = {stored[3].get<double>(), stored[4].get<double>()};
        claim.looked = stored[5].get<std::uint64_t>();
        claim.steps = stored[6].get<std::uint64_t>();
        for (std::size_t i = 0; i + 1 < stored[7].size(); i += 2) {
            const int bits = stored[7][i].get<int>();
            claim.outcomes.push_back({(bits & 1) != 0, stored[7][i + 1].get<double>(), (bits & 2) != 0});
        }
        results.push_back(std::move(claim));
    }
    return results;
}

}  // namespace robochart::simulation
