// SPDX-License-Identifier: Apache-2.0
// Parses scenarios: claims about probabilities, and the formulas in them and in `first`. The operators are those of
// bounded linear temporal logic over one run (Younes and Simmons, CAV 2002); `stays for` refers to the past.
#include <fmt/format.h>

#include <cmath>

#include "simulation/scenario/rules.hpp"
#include "simulation/scenario/scenario_reader.hpp"

namespace robochart::simulation {

namespace {

constexpr std::uint64_t most_claim_trials = 100'000;
constexpr std::size_t most_depth = 100;

}  // namespace

void ScenarioReader::estimate() {
    const diagnostics::Span word = in_.token().span;
    if (in_.at("time") || in_.at("average")) return chain_question(word);
    if (!in_.take("probability")) return in_.fail("'probability', 'time' or 'average'");
    claim(word, true);
}

double ScenarioReader::confidence() {
    in_.expect("with");
    in_.expect("confidence");
    const double confidence = in_.not_negative(Dimension::share, "the confidence");
    if (!in_.failed() && (confidence < 0.5 || confidence >= 1))
        in_.report(rules::out_of_range, in_.last_span(), {"the confidence is at least 50 % and less than 100 %"});
    return confidence;
}

void ScenarioReader::claim(diagnostics::Span begin, bool estimate) {
    Claim claim;
    claim.estimate = estimate;
    claim.property = either();
    if (!claim.property.of_trial()) claim.property = over(Formula::Kind::at, "at", std::move(claim.property), INFINITY);
    if (!estimate) {
        claim.at_least = in_.take(">=");
        if (!claim.at_least) in_.expect("<=");
        claim.probability = in_.not_negative(Dimension::share, "a probability");
    }
    claim.confidence = confidence();
    while (!estimate && in_.take(",")) {
        if (in_.take("indifference")) {
            claim.indifference = in_.positive(Dimension::share, "the indifference");
            if (claim.probability - claim.indifference <= 0 || claim.probability + claim.indifference >= 1)
                in_.report(rules::out_of_range, in_.last_span(),
                           {"the probability, more or less the indifference, is not between 0 and 100 %"});
        } else {
            in_.expect("at");
            in_.expect("most");
            claim.trials = static_cast<std::uint32_t>(in_.count(1, most_claim_trials, "the number of trials"));
            in_.expect("trials");
            claim.limited = true;
        }
    }
    claim.span = diagnostics::join(begin, in_.last_span());
    if (in_.failed()) return;
    claim.text = in_.text_since(begin);
    scenario_.claims.push_back(std::move(claim));
}

Formula ScenarioReader::either() {
    Formula left = both();
    while (in_.take("or")) left = joined(Formula::Kind::either, "or", std::move(left), both());
    return left;
}

Formula ScenarioReader::both() {
    Formula left = timed();
    while (in_.take("and")) left = joined(Formula::Kind::both, "and", std::move(left), timed());
    return left;
}

Formula ScenarioReader::joined(Formula::Kind kind, std::string_view word, Formula left, Formula right) {
    if (left.of_trial() != right.of_trial() && !in_.failed()) {
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

Formula ScenarioReader::over(Formula::Kind kind, std::string_view word, Formula part, double time) {
    if (part.of_trial() && !in_.failed()) {
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
    return in_.at("stays") || in_.at("within") || in_.at("until") || in_.at("at");
}

double ScenarioReader::time_limit(std::string_view what) {
    const double time = in_.not_negative(Dimension::time, what);
    times_.push_back({time, in_.last_span()});
    return time;
}

/// The operators that bind more tightly than `and`.
Formula ScenarioReader::timed() {
    const bool negated = in_.at("not");
    Formula formula = simple();
    if (negated && at_time_word()) in_.fail("parentheses that show what 'not' is about");
    while (!in_.failed() && at_time_word()) {
        if (in_.take("stays")) {
            in_.expect("for");
            formula = over(Formula::Kind::stays, "stays for", std::move(formula), time_limit("how long it stays"));
        } else if (in_.take("within")) {
            formula = over(Formula::Kind::within, "within", std::move(formula), time_limit("the time"));
        } else if (in_.take("at")) {
            const double time = in_.take("end") ? INFINITY : time_limit("the time");
            formula = over(Formula::Kind::at, "at", std::move(formula), time);
        } else {
            in_.expect("until");
            formula = over(Formula::Kind::until, "until", std::move(formula), INFINITY);
            Formula end = simple();
            if (end.of_trial())
                in_.report(rules::wrong_instant, in_.last_span(), {"'until' takes conditions at an instant"});
            if (in_.take("within")) formula.time = time_limit("the time");
            formula.parts.push_back(std::move(end));
        }
    }
    return formula;
}

Formula ScenarioReader::simple() {
    if (depth_ == most_depth)
        in_.fail(fmt::format("at most {} words 'not', 'always' or '(' in each other", most_depth));
    if (in_.failed()) return {};
    ++depth_;
    Formula formula;
    if (in_.take("not")) {
        formula.kind = Formula::Kind::negation;
        formula.parts.push_back(simple());
    } else if (in_.take("always")) {
        formula = over(Formula::Kind::always, "always", simple(), INFINITY);
    } else if (in_.take("(")) {
        formula = either();
        in_.expect(")");
    } else {
        formula = comparison();
    }
    --depth_;
    return formula;
}

Formula ScenarioReader::comparison() {
    Formula formula;
    formula.measure = measure_named();
    const double time = in_.take("at") ? time_limit("the time of a measure") : NAN;
    range(dimension_of(formula.measure), formula.low, formula.high);
    return std::isnan(time) ? formula : over(Formula::Kind::at, "at", std::move(formula), time);
}

}  // namespace robochart::simulation
