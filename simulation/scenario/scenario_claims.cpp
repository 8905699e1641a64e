// SPDX-License-Identifier: Apache-2.0
// Parses claims about probabilities in scenarios, and the formulas in them and in `first`. The operators are those of
// bounded linear temporal logic over one run (Younes and Simmons, CAV 2002). `stays for` refers to the past.
#include <fmt/format.h>

#include <cmath>

#include "simulation/scenario/rules.hpp"
#include "simulation/scenario/scenario_reader.hpp"

namespace robochart::simulation {

namespace {

constexpr std::uint64_t most_claim_trials = 100'000;
constexpr std::size_t most_depth = 100;

}  // namespace

void ScenarioReader::parse_estimate() {
    const diagnostics::Span word = in_.current_token().span;
    if (in_.at_word("time") || in_.at_word("average")) return chain_question(word);
    if (!in_.take_word("probability")) return in_.fail_expecting("'probability', 'time' or 'average'");
    parse_claim(word, true);
}

double ScenarioReader::parse_confidence() {
    in_.expect_word("with");
    in_.expect_word("confidence");
    const double confidence = in_.not_negative(Dimension::share, "the confidence");
    if (!in_.has_failed() && (confidence < 0.5 || confidence >= 1))
        in_.report(rules::out_of_range, in_.last_span(), {"the confidence is at least 50 % and less than 100 %"});
    return confidence;
}

void ScenarioReader::parse_claim(diagnostics::Span begin, bool estimate) {
    Claim claim;
    claim.estimate = estimate;
    claim.property = parse_disjunction();
    if (!claim.property.of_trial())
        claim.property = lift_to_trial(Formula::Kind::at, "at", std::move(claim.property), INFINITY);
    if (!estimate) {
        claim.at_least = in_.take_word(">=");
        if (!claim.at_least) in_.expect_word("<=");
        claim.probability = in_.not_negative(Dimension::share, "a probability");
    }
    claim.confidence = parse_confidence();
    while (!estimate && in_.take_word(",")) {
        if (in_.take_word("indifference")) {
            claim.indifference = in_.read_positive(Dimension::share, "the indifference");
            if (claim.probability - claim.indifference <= 0 || claim.probability + claim.indifference >= 1)
                in_.report(rules::out_of_range, in_.last_span(),
                           {"the probability, more or less the indifference, is not between 0 and 100 %"});
        } else {
            in_.expect_word("at");
            in_.expect_word("most");
            claim.trials = static_cast<std::uint32_t>(in_.read_count(1, most_claim_trials, "the number of trials"));
            in_.expect_word("trials");
            claim.limited = true;
        }
    }
    claim.span = diagnostics::join_spans(begin, in_.last_span());
    if (in_.has_failed()) return;
    claim.text = in_.text_since(begin);
    scenario_.claims.push_back(std::move(claim));
}

Formula ScenarioReader::parse_disjunction() {
    Formula left = parse_conjunction();
    while (in_.take_word("or")) left = join_formulas(Formula::Kind::either, "or", std::move(left), parse_conjunction());
    return left;
}

Formula ScenarioReader::parse_conjunction() {
    Formula left = parse_timed();
    while (in_.take_word("and")) left = join_formulas(Formula::Kind::both, "and", std::move(left), parse_timed());
    return left;
}

Formula ScenarioReader::join_formulas(Formula::Kind kind, std::string_view word, Formula left, Formula right) {
    if (left.of_trial() != right.of_trial() && !in_.has_failed()) {
        in_.report(rules::wrong_instant, in_.last_span(),
                   {fmt::format("'{}' joins a condition at an instant and a property of a trial", word)});
        return left;
    }
    // A chain of operators is one formula; only parentheses increase the depth.
    Formula formula;
    if (left.kind == kind) {
        formula = std::move(left);
    } else {
        formula.kind = kind;
        formula.parts.push_back(std::move(left));
    }
    formula.parts.push_back(std::move(right));
    return formula;
}

Formula ScenarioReader::lift_to_trial(Formula::Kind kind, std::string_view word, Formula part, double time) {
    if (part.of_trial() && !in_.has_failed()) {
        in_.report(rules::wrong_instant, in_.last_span(), {fmt::format("'{}' takes a condition at an instant", word)});
        return part;
    }
    Formula formula;
    formula.kind = kind;
    formula.time = time;
    formula.parts.push_back(std::move(part));
    return formula;
}

bool ScenarioReader::at_time_word() const {
    return in_.at_word("stays") || in_.at_word("within") || in_.at_word("until") || in_.at_word("at");
}

double ScenarioReader::time_limit(std::string_view what) {
    const double time = in_.not_negative(Dimension::time, what);
    times_.push_back({time, in_.last_span()});
    return time;
}

/// Parses the operators that bind more tightly than `and`.
Formula ScenarioReader::parse_timed() {
    const bool negated = in_.at_word("not");
    Formula formula = parse_simple();
    if (negated && at_time_word()) in_.fail_expecting("parentheses after 'not'");
    while (!in_.has_failed() && at_time_word()) {
        if (in_.take_word("stays")) {
            in_.expect_word("for");
            formula =
                lift_to_trial(Formula::Kind::stays, "stays for", std::move(formula), time_limit("the length of time"));
        } else if (in_.take_word("within")) {
            formula = lift_to_trial(Formula::Kind::within, "within", std::move(formula), time_limit("the time"));
        } else if (in_.take_word("at")) {
            const double time = in_.take_word("end") ? INFINITY : time_limit("the time");
            formula = lift_to_trial(Formula::Kind::at, "at", std::move(formula), time);
        } else {
            in_.expect_word("until");
            formula = lift_to_trial(Formula::Kind::until, "until", std::move(formula), INFINITY);
            Formula end = parse_simple();
            if (end.of_trial())
                in_.report(rules::wrong_instant, in_.last_span(), {"'until' takes conditions at an instant"});
            if (in_.take_word("within")) formula.time = time_limit("the time");
            formula.parts.push_back(std::move(end));
        }
    }
    return formula;
}

Formula ScenarioReader::parse_simple() {
    if (depth_ == most_depth)
        in_.fail_expecting(fmt::format("at most {} words 'not', 'always' or '(' in each other", most_depth));
    if (in_.has_failed()) return {};
    ++depth_;
    Formula formula;
    if (in_.take_word("not")) {
        formula.kind = Formula::Kind::negation;
        formula.parts.push_back(parse_simple());
    } else if (in_.take_word("always")) {
        formula = lift_to_trial(Formula::Kind::always, "always", parse_simple(), INFINITY);
    } else if (in_.take_word("(")) {
        formula = parse_disjunction();
        in_.expect_word(")");
    } else {
        formula = parse_comparison();
    }
    --depth_;
    return formula;
}

Formula ScenarioReader::parse_comparison() {
    Formula formula;
    if (at_claim()) {
        formula.measure = claim_measure();
        formula.low = 1;
        formula.high = 1;
        return lift_to_trial(Formula::Kind::always, "claim", std::move(formula), INFINITY);
    }
    formula.measure = measure_named();
    const double time = in_.take_word("at") ? time_limit("the time of a measure") : NAN;
    parse_range(dimension_of(formula.measure), formula.low, formula.high);
    return std::isnan(time) ? formula : lift_to_trial(Formula::Kind::at, "at", std::move(formula), time);
}

}  // namespace robochart::simulation
