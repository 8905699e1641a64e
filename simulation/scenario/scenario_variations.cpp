// SPDX-License-Identifier: Apache-2.0
// Parses `vary` in scenarios: the values of a sweep.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostics/containers.hpp"
#include "simulation/scenario/rules.hpp"
#include "simulation/scenario/scenario_reader.hpp"

namespace robochart::simulation {

namespace {

constexpr std::size_t most_values = 1000;
constexpr std::size_t most_variations = 2;

}  // namespace

void ScenarioReader::parse_variation() {
    Variation variation;
    const diagnostics::Span begin = in_.current_token().span;
    if (in_.take_word("const")) {
        variation.what = Varied::constant;
        variation.constant = constant_named();
    } else if (in_.take_word("noise")) {
        variation.what = Varied::noise;
    } else if (in_.take_word("failures")) {
        variation.what = Varied::failed;
    } else if (in_.take_word("mean")) {
        in_.expect_word("time");
        variation.what = Varied::mean_time;
    } else if (!in_.take_word("robots")) {
        sensor_option(variation);
        if (in_.has_failed()) return;
    }
    in_.expect_word("in");
    parse_values(variation);
    if (scenario_.variations.empty() && in_.take_word("until")) {
        in_.expect_word("proved");
        variation.until_proved = true;
    }
    variation.span = diagnostics::join_spans(begin, in_.last_span());
    if (in_.has_failed()) return;
    // `pace` is the same as `leaders.pace` if the first kind of robots has this name.
    const auto subject = [&](const Variation& parameter) {
        const auto address =
            parameter.what == Varied::constant ? find_constant_address(scenario_, parameter.constant) : std::nullopt;
        return address ? std::pair(address->controller, address->constant)
                       : std::pair(std::size_t{0}, parameter.constant);
    };
    const auto same = [&](const Variation& other) {
        return other.what == variation.what && subject(other) == subject(variation) && other.option == variation.option;
    };
    if (std::ranges::any_of(scenario_.variations, same))
        in_.report(rules::said_twice, variation.span, {fmt::format("'{}'", in_.text_since(begin))});
    else if (scenario_.variations.size() == most_variations)
        in_.report(rules::out_of_range, variation.span, {fmt::format("at most {} things vary", most_variations)});
    else
        scenario_.variations.push_back(std::move(variation));
}

/// Reads the name of a constant: `pace` of the scenario's own component, `leaders.pace`, `environment.pace`.
std::string ScenarioReader::constant_named() {
    const Name first = in_.qualified_name("a constant of the model");
    if (!in_.take_word(".")) return first.text;
    if (!controller_named(scenario_, first.text)) unknown_part("kind of robots", first, controller_names(scenario_));
    return first.text + "." + in_.qualified_name("a constant of the model of these robots").text;
}

void ScenarioReader::sensor_option(Variation& variation) {
    variation.what = Varied::sensor;
    const bool known =
        std::ranges::any_of(scenario_.sensors, [&](const Sensor& sensor) { return in_.at_word(sensor.name.text); });
    if (!known) return in_.fail_expecting("'robots', 'noise', 'failures', 'mean time', 'const' or a sensor");
    variation.constant = in_.name("a sensor").text;
    in_.expect_word(".");
    const Name option = in_.name("an option of the sensor");
    variation.option = option.text;
    for (Sensor& sensor : scenario_.sensors)
        if (sensor.name.text == variation.constant && shares_of(sensor, option.text).empty())
            in_.report(rules::unknown_part, option.span,
                       {fmt::format("share of '{}' named", variation.constant), option.text});
}

/// Parses `LOW to HIGH by STEP`, or values separated by commas.
void ScenarioReader::parse_values(Variation& variation) {
    const diagnostics::Span begin = in_.current_token().span;
    std::vector<double>& values = variation.values;
    values.push_back(value_of(variation.what));
    if (in_.take_word("to")) {
        const double high = value_of(variation.what);
        double step = 1;
        const bool counts = variation.what == Varied::robots || variation.what == Varied::failed;
        if (!counts) in_.expect_word("by");
        if (!counts || in_.take_word("by")) step = value_of(variation.what);
        const double count = step > 0 ? std::floor((high - values[0]) / step + 1e-9) : -1;
        if (!in_.has_failed() && (count < 0 || count >= static_cast<double>(most_values)))
            in_.report(rules::out_of_range, diagnostics::join_spans(begin, in_.last_span()),
                       {fmt::format("a variation has 1 to {} values, in ascending order", most_values)});
        else
            for (double i = 1; i <= count; ++i) values.push_back(values[0] + i * step);
        return;
    }
    while (in_.take_word(",") && values.size() < most_values) values.push_back(value_of(variation.what));
    diagnostics::sort_unique(values);
}

double ScenarioReader::value_of(Varied what) {
    switch (what) {
        case Varied::robots:
            return static_cast<double>(in_.read_count(1, most_robots_, "a number of robots"));
        case Varied::failed:
            return static_cast<double>(in_.read_count(0, most_robots_, "a number of robots that fail"));
        case Varied::mean_time:
            return in_.read_positive(Dimension::time, "a mean time to a failure");
        case Varied::sensor: {
            const double share = in_.not_negative(Dimension::share, "an option of a sensor");
            if (share > 1) in_.report(rules::out_of_range, in_.last_span(), {"it is more than 100 %"});
            return share;
        }
        case Varied::noise:
            return in_.not_negative(Dimension::share, "the noise of the wheels");
        case Varied::constant:
            break;
    }
    return in_.read_quantity(Dimension::number, "the value of a constant").value;
}

}  // namespace robochart::simulation
