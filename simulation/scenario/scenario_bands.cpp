// SPDX-License-Identifier: Apache-2.0
// Parses scenarios: measures and bands.
#include "simulation/scenario/scenario_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

void ScenarioReader::measure() {
    Measure measure;
    measure.name = new_name("a name for the measure");
    in_.expect("is");
    const Name kind = in_.name("a kind of measure");
    if (in_.failed()) return;
    if (kind.text == "cluster") {
        measure.kind = MeasureKind::cluster;
        in_.expect("(");
        measure.link = in_.positive(Dimension::length, "the length of a link");
        in_.expect(")");
    } else if (kind.text == "distance") {
        measure.kind = MeasureKind::distance;
        in_.expect("(");
        measure.light = light_named(in_.name("the name of a light"));
        in_.expect(")");
    } else if (kind.text == "reached") {
        measure.kind = MeasureKind::reached;
        in_.expect("(");
        measure.light = light_named(in_.name("the name of a light"));
        in_.expect(",");
        measure.link = in_.positive(Dimension::length, "the distance from the light");
        in_.expect(")");
    } else if (kind.text == "inside") {
        measure.kind = MeasureKind::inside;
        measure.region = region();
    } else if (kind.text == "time") {
        measure.kind = MeasureKind::time;
    } else if (kind.text == "in_state") {
        measure.kind = MeasureKind::in_state;
        in_.expect("(");
        measure.state = in_.qualified_name("a state of the controller's first machine");
        in_.expect(")");
    } else if (kind.text == "working") {
        measure.kind = MeasureKind::working;
    } else if (kind.text == "spread") {
        measure.kind = MeasureKind::spread;
    } else if (kind.text == "second_moment") {
        measure.kind = MeasureKind::second_moment;
    } else {
        in_.report(rules::unknown_part, kind.span, {"kind of measure", kind.text});
        return in_.fail(
            "'cluster', 'distance', 'in_state', 'inside', 'reached', 'second_moment', 'spread', 'time' or 'working'");
    }
    if (in_.at("of") && measure.kind != MeasureKind::time) {
        in_.take("of");
        measure.of = kind_of_measure(in_.name("the name of robots"));
    }
    scenario_.measures.push_back(measure);
}

std::size_t ScenarioReader::light_named(const Name& name) {
    for (std::size_t i = 0; i < scenario_.lights.size(); ++i)
        if (scenario_.lights[i].name.text == name.text) return i;
    std::vector<std::string> known;
    for (const Light& each : scenario_.lights) known.push_back(each.name.text);
    unknown_part("light", name, known);
    return 0;
}

Dimension ScenarioReader::dimension_of(std::size_t measure) const {
    return measure < scenario_.measures.size() ? simulation::dimension_of(scenario_.measures[measure].kind)
                                               : Dimension::number;
}

std::size_t ScenarioReader::measure_named() {
    const Name name = in_.name("a measure");
    for (std::size_t i = 0; i < scenario_.measures.size(); ++i)
        if (scenario_.measures[i].name.text == name.text) return i;
    std::vector<std::string> known;
    for (const Measure& each : scenario_.measures) known.push_back(each.name.text);
    unknown_part("measure", name, known);
    return scenario_.measures.size();
}

void ScenarioReader::accept() {
    const diagnostics::Span word = in_.token().span;
    if (in_.take("probability")) return claim(word, false);
    Band band;
    band.each = in_.take("each");
    if (!band.each && !in_.take("mean")) return in_.fail("'each', 'mean' or 'probability'");
    const diagnostics::Span begin = in_.token().span;
    range(statistic(band.statistic), band.low, band.high);
    band.span = diagnostics::join(begin, in_.last_span());
    band.text = fmt::format("{} {}", band.each ? "each" : "mean", in_.failed() ? "" : in_.text_since(begin));
    const bool timed = band.statistic.kind == StatisticKind::first_time;
    if (timed || band.statistic.measure < scenario_.measures.size()) scenario_.bands.push_back(band);
}

void ScenarioReader::range(Dimension dimension, double& low, double& high) {
    const diagnostics::Span begin = in_.token().span;
    low = -INFINITY;
    high = INFINITY;
    if (in_.take("<=")) {
        high = in_.quantity(dimension, "this measure").value;
    } else if (in_.take(">=")) {
        low = in_.quantity(dimension, "this measure").value;
    } else {
        in_.expect("in");
        low = in_.quantity(dimension, "this measure").value;
        in_.expect("to");
        high = in_.quantity(dimension, "this measure").value;
    }
    if (low > high) in_.report(rules::out_of_range, diagnostics::join(begin, in_.last_span()), {"the band is empty"});
}

Dimension ScenarioReader::statistic(Statistic& statistic) {
    if (in_.take("first")) {
        statistic.kind = StatisticKind::first_time;
        in_.expect("(");
        const diagnostics::Span begin = in_.token().span;
        statistic.condition = either();
        if (statistic.condition.of_trial())
            in_.report(rules::wrong_instant, diagnostics::join(begin, in_.last_span()),
                       {"'first' takes a condition at an instant"});
        in_.expect(")");
        return Dimension::time;
    }
    if (in_.take("average")) {
        statistic.kind = StatisticKind::average;
        in_.expect("(");
        statistic.measure = measure_named();
        in_.expect(")");
        return dimension_of(statistic.measure);
    }
    statistic.measure = measure_named();
    if (in_.take("at")) {
        statistic.kind = StatisticKind::at_time;
        statistic.time = in_.not_negative(Dimension::time, "the time of a measure");
        times_.push_back({statistic.time, in_.last_span()});
    }
    return dimension_of(statistic.measure);
}

}  // namespace robochart::simulation
