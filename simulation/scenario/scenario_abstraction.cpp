// SPDX-License-Identifier: Apache-2.0
// Parses `abstract` in scenarios: the states of a chain, and the questions that only a chain answers.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "simulation/scenario/rules.hpp"
#include "simulation/scenario/scenario_reader.hpp"

namespace robochart::simulation {

namespace {

constexpr std::size_t most_distinctions = 8;
constexpr std::size_t most_levels = 100;
constexpr double most_steps = 10'000;

}  // namespace

/// Parses `abstract by MEASURE in LEVEL, LEVEL, MEASURE every TIME`.
void ScenarioReader::parse_abstraction() {
    const diagnostics::Span begin = in_.last_span();
    Abstraction abstraction;
    in_.expect_word("by");
    while (parse_distinction(abstraction) && !in_.has_failed()) {
    }
    in_.expect_word("every");
    abstraction.every = in_.read_positive(Dimension::time, "the time between two states of the chain");
    abstraction.span = diagnostics::join_spans(begin, in_.last_span());
    if (in_.has_failed()) return;
    if (abstraction.distinctions.size() > most_distinctions)
        in_.report(rules::out_of_range, abstraction.span,
                   {fmt::format("a chain distinguishes at most {} measures", most_distinctions)});
    scenario_.abstraction = std::move(abstraction);
}

bool ScenarioReader::parse_distinction(Abstraction& abstraction) {
    const diagnostics::Span begin = in_.current_token().span;
    Distinction distinction;
    distinction.measure = measure_named();
    if (in_.has_failed() || distinction.measure >= scenario_.measures.size()) return false;
    const std::string name = scenario_.measures[distinction.measure].name.text;
    const Dimension dimension = dimension_of(distinction.measure);
    bool another = false;
    if (in_.take_word("in")) {
        do {
            distinction.levels.push_back(in_.read_quantity(dimension, "a level of this measure").value);
            another = in_.take_word(",");
        } while (!in_.has_failed() && another && in_.at_number());
    } else {
        another = in_.take_word(",");
    }
    if (in_.has_failed()) return false;
    const diagnostics::Span span = diagnostics::join_spans(begin, in_.last_span());
    const bool again = std::ranges::any_of(
        abstraction.distinctions, [&](const Distinction& other) { return other.measure == distinction.measure; });
    if (again) in_.report(rules::said_twice, span, {fmt::format("'{}'", name)});
    if (distinction.levels.empty() && dimension != Dimension::share)
        in_.report(rules::missing, span, {fmt::format("the levels of '{}' that the chain distinguishes", name)});
    if (distinction.levels.size() > most_levels)
        in_.report(rules::out_of_range, span, {fmt::format("a measure has at most {} levels", most_levels)});
    if (std::ranges::adjacent_find(distinction.levels, std::greater_equal<>()) != distinction.levels.end())
        in_.report(rules::out_of_range, span, {"the levels do not ascend"});
    abstraction.distinctions.push_back(std::move(distinction));
    return another;
}

void ScenarioReader::chain_question(diagnostics::Span begin) {
    ChainQuestion question;
    question.time = in_.take_word("time");
    if (question.time) {
        in_.expect_word("until");
        question.condition = parse_disjunction();
        if (question.condition.of_trial())
            in_.report(rules::wrong_instant, in_.last_span(), {"'time until' takes a condition at an instant"});
    } else {
        in_.expect_word("average");
        question.measure = measure_named();
        if (question.measure < scenario_.measures.size() && dimension_of(question.measure) != Dimension::share)
            in_.report(rules::out_of_range, in_.last_span(), {"a long-run average must be the average of a share"});
    }
    question.confidence = parse_confidence();
    question.span = diagnostics::join_spans(begin, in_.last_span());
    if (in_.has_failed()) return;
    question.text = in_.text_since(begin);
    scenario_.chain_questions.push_back(std::move(question));
}

void ScenarioReader::check_abstraction() {
    if (!scenario_.abstraction) {
        for (const ChainQuestion& question : scenario_.chain_questions)
            in_.report(rules::missing, question.span, {"the states of the chain (abstract by MEASURE every TIME)"});
        return;
    }
    const Abstraction& abstraction = *scenario_.abstraction;
    if (!scenario_.variations.empty())
        in_.report(rules::out_of_range, abstraction.span, {"a scenario has a chain, or something varies in it"});
    if (scenario_.has_others())
        in_.report(rules::out_of_range, abstraction.span,
                   {"a chain takes a scenario with one kind of robots and without an environment"});
    if (!scenario_.bands.empty())
        in_.report(rules::out_of_range, abstraction.span, {"a scenario has a chain, or bands"});
    if (scenario_.world.control_step > 0 && said_.contains("step"))
        (void)divide_evenly(abstraction.every, "the time between two states of the chain", scenario_.world.control_step,
                            "the control step", "abstract");
    if (scenario_.duration > 0 && abstraction.every > scenario_.duration)
        in_.report(rules::out_of_range, abstraction.span, {"the trials are shorter than a step of the chain"});
    if (scenario_.duration / abstraction.every > most_steps)
        in_.report(rules::out_of_range, abstraction.span,
                   {fmt::format("the trials are more than {:.0f} steps of the chain", most_steps)});
    if (scenario_.claims.empty() && scenario_.chain_questions.empty())
        in_.report(rules::missing, abstraction.span,
                   {"the queries to the chain (accept probability, estimate probability, time or average)"});
}

}  // namespace robochart::simulation
