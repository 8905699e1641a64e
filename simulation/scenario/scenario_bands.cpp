// SPDX-License-Identifier: Apache-2.0
// Parses the measures and bands of scenarios.
#include "simulation/scenario/scenario_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

void ScenarioReader::parse_measure() {
    Measure measure;
    measure.name = new_name("a name for the measure");
    in_.expect_word("is");
    const Name kind = in_.name("a kind of measure");
    if (in_.has_failed()) return;
    if (kind.text == "cluster") {
        measure.kind = MeasureKind::cluster;
        in_.expect_word("(");
        measure.link = in_.read_positive(Dimension::length, "the length of a link");
        in_.expect_word(")");
    } else if (kind.text == "distance") {
        measure.kind = MeasureKind::distance;
        in_.expect_word("(");
        measure.light = light_named(in_.name("the name of a light"));
        in_.expect_word(")");
    } else if (kind.text == "reached") {
        measure.kind = MeasureKind::reached;
        in_.expect_word("(");
        measure.light = light_named(in_.name("the name of a light"));
        in_.expect_word(",");
        measure.link = in_.read_positive(Dimension::length, "the distance from the light");
        in_.expect_word(")");
    } else if (kind.text == "inside") {
        measure.kind = MeasureKind::inside;
        measure.region = parse_region();
    } else if (kind.text == "time") {
        measure.kind = MeasureKind::time;
    } else if (kind.text == "in_state") {
        measure.kind = MeasureKind::in_state;
        in_.expect_word("(");
        measure.state = in_.qualified_name("a state of the controller's first machine");
        in_.expect_word(")");
    } else if (kind.text == "working") {
        measure.kind = MeasureKind::working;
    } else if (kind.text == "kept") {
        measure.kind = MeasureKind::kept;
        in_.expect_word("(");
        measure.state = in_.name("a claim of the model");
        in_.expect_word(")");
    } else if (kind.text == "spread") {
        measure.kind = MeasureKind::spread;
    } else if (kind.text == "second_moment") {
        measure.kind = MeasureKind::second_moment;
    } else {
        in_.report(rules::unknown_part, kind.span, {"kind of measure", kind.text});
        return in_.fail_expecting(
            "'cluster', 'distance', 'in_state', 'inside', 'kept', 'reached', 'second_moment', 'spread', 'time' or "
            "'working'");
    }
    if (in_.at_word("of") && measure.kind != MeasureKind::time) {
        in_.take_word("of");
        measure.of = kind_of_measure(in_.name("the name of robots"));
    }
    scenario_.measures.push_back(measure);
}

std::size_t ScenarioReader::light_named(const Name& name) {
    for (std::size_t i = 0; i < scenario_.lights.size(); ++i)
        if (scenario_.lights[i].name.text == name.text) return i;
    std::vector<std::string> known;
    for (const Light& light : scenario_.lights) known.push_back(light.name.text);
    unknown_part("light", name, known);
    return 0;
}

Dimension ScenarioReader::dimension_of(std::size_t measure) const {
    return measure < scenario_.measures.size() ? simulation::dimension_of(scenario_.measures[measure].kind)
                                               : Dimension::number;
}

bool ScenarioReader::at_claim() const {
    return in_.at_word("claim") && std::ranges::none_of(scenario_.measures, [](const Measure& measure) {
               return measure.name.text == "claim";
           });
}

std::size_t ScenarioReader::claim_measure() {
    in_.expect_word("claim");
    Measure measure;
    measure.kind = MeasureKind::kept;
    measure.state = in_.name("a claim of the model");
    measure.name = {"claim " + measure.state.text, measure.state.span};
    for (std::size_t i = 0; i < scenario_.measures.size(); ++i)
        if (scenario_.measures[i].name.text == measure.name.text) return i;
    scenario_.measures.push_back(measure);
    return scenario_.measures.size() - 1;
}

std::size_t ScenarioReader::measure_named() {
    const Name name = in_.name("a measure");
    for (std::size_t i = 0; i < scenario_.measures.size(); ++i)
        if (scenario_.measures[i].name.text == name.text) return i;
    std::vector<std::string> known;
    for (const Measure& measure : scenario_.measures) known.push_back(measure.name.text);
    unknown_part("measure", name, known);
    return scenario_.measures.size();
}

void ScenarioReader::accept() {
    const diagnostics::Span word = in_.current_token().span;
    if (in_.take_word("probability")) return parse_claim(word, false);
    Band band;
    band.each = in_.take_word("each");
    if (!band.each && !in_.take_word("mean")) return in_.fail_expecting("'each', 'mean' or 'probability'");
    const diagnostics::Span begin = in_.current_token().span;
    if (band.each && at_claim()) {
        band.statistic.measure = claim_measure();
        band.low = 1;
        band.high = 1;
    } else {
        parse_range(parse_statistic(band.statistic), band.low, band.high);
    }
    band.span = diagnostics::join_spans(begin, in_.last_span());
    band.text = fmt::format("{} {}", band.each ? "each" : "mean", in_.has_failed() ? "" : in_.text_since(begin));
    const bool timed = band.statistic.kind == StatisticKind::first_time;
    if (timed || band.statistic.measure < scenario_.measures.size()) scenario_.bands.push_back(band);
}

void ScenarioReader::parse_range(Dimension dimension, double& low, double& high) {
    const diagnostics::Span begin = in_.current_token().span;
    low = -INFINITY;
    high = INFINITY;
    if (in_.take_word("<=")) {
        high = in_.read_quantity(dimension, "this measure").value;
    } else if (in_.take_word(">=")) {
        low = in_.read_quantity(dimension, "this measure").value;
    } else {
        in_.expect_word("in");
        low = in_.read_quantity(dimension, "this measure").value;
        in_.expect_word("to");
        high = in_.read_quantity(dimension, "this measure").value;
    }
    if (low > high)
        in_.report(rules::out_of_range, diagnostics::join_spans(begin, in_.last_span()), {"the band is empty"});
}

Dimension ScenarioReader::parse_statistic(Statistic& statistic) {
    if (in_.take_word("first")) {
        statistic.kind = StatisticKind::first_time;
        in_.expect_word("(");
        const diagnostics::Span begin = in_.current_token().span;
        statistic.condition = parse_disjunction();
        if (statistic.condition.of_trial())
            in_.report(rules::wrong_instant, diagnostics::join_spans(begin, in_.last_span()),
                       {"'first' takes a condition at an instant"});
        in_.expect_word(")");
        return Dimension::time;
    }
    if (in_.take_word("average")) {
        statistic.kind = StatisticKind::average;
        in_.expect_word("(");
        statistic.measure = measure_named();
        in_.expect_word(")");
        return dimension_of(statistic.measure);
    }
    statistic.measure = measure_named();
    if (in_.take_word("at")) {
        statistic.kind = StatisticKind::at_time;
        statistic.time = in_.not_negative(Dimension::time, "the time of a measure");
        times_.push_back({statistic.time, in_.last_span()});
    }
    return dimension_of(statistic.measure);
}

}  // namespace robochart::simulation
