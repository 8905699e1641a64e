// SPDX-License-Identifier: Apache-2.0
#include "simulation/chain/chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/statistics/means.hpp"
#include "prism/markov/operators/robust.hpp"
#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

using markov::Direction;
using statistics::Interval;

namespace {

constexpr const char* not_said =
    "the states of the chain do not say whether it holds: it is about measures that are not "
    "distinguished, or values between levels";

/// Returns the index of the last state in a trial; the state at 0 s has index 0.
std::uint64_t last_step(const Scenario& scenario) {
    return scenario.step_count() / scenario.steps_between_samples();
}

class Asking {
public:
    Asking(const Scenario& scenario, const ChainStates& states, diagnostics::Diagnostics& diagnostics)
        : scenario_(scenario), states_(states), diagnostics_(diagnostics) {}

    std::vector<ChainAsked> operator()() {
        for (const Claim& claim : scenario_.claims) add_question(claim);
        for (const ChainQuestion& question : scenario_.chain_questions) add_question(question);
        return std::move(result_);
    }

private:
    void report_refusal(diagnostics::Span span, const std::string& why) {
        diagnostics_.report(rules::not_in_chain, span, {why});
    }

    void add_question(const Claim& claim) {
        if (claim.property.kind != Formula::Kind::within || std::isinf(claim.property.time))
            return report_refusal(claim.span, "a chain answers `CONDITION within TIME`");
        if (claim.indifference > 0)
            return report_refusal(claim.span, "a chain computes bounds, so it has no test with an indifference");
        if (claim.limited)
            return report_refusal(claim.span,
                                  "a chain uses the trials of the scenario, so `at most N trials` is not allowed");
        const double steps = claim.property.time / scenario_.abstraction->every;
        const double whole = std::round(steps);
        if (std::abs(steps - whole) > 1e-9 * std::max(1.0, steps))
            return report_refusal(claim.span, fmt::format("the chain has no state at {:g} s", claim.property.time));
        const auto goal = states_.states_satisfying(claim.property.parts.front());
        if (!goal) return report_refusal(claim.span, not_said);
        ChainAsked& chain_question = result_.emplace_back();
        chain_question.claim = &claim;
        chain_question.text = claim.text;
        chain_question.confidence = claim.confidence;
        chain_question.goal = *goal;
        chain_question.steps = static_cast<std::uint64_t>(whole);
    }

    void add_question(const ChainQuestion& question) {
        ChainAsked chain_question;
        chain_question.kind = question.time ? ChainAsked::Kind::time : ChainAsked::Kind::average;
        chain_question.text = question.text;
        chain_question.confidence = question.confidence;
        if (question.time) {
            const auto goal = states_.states_satisfying(question.condition);
            if (!goal) return report_refusal(question.span, not_said);
            chain_question.goal = *goal;
        } else if (!take_average(question, chain_question)) {
            return report_refusal(question.span, "the chain does not distinguish the measure of the average");
        }
        result_.push_back(std::move(chain_question));
    }

    bool take_average(const ChainQuestion& question, ChainAsked& chain_question) {
        const auto& distinctions = scenario_.abstraction->distinctions;
        const auto found = std::ranges::find_if(
            distinctions, [&](const Distinction& distinction) { return distinction.measure == question.measure; });
        if (found == distinctions.end()) return false;
        chain_question.distinction = static_cast<std::size_t>(found - distinctions.begin());
        for (std::size_t state = 0; state < states_.size(); ++state) {
            const auto values = states_.class_of_measure(state, question.measure);
            chain_question.low.push_back(values ? values->low : 0);
            chain_question.high.push_back(values ? values->high : 0);
        }
        return true;
    }

    const Scenario& scenario_;
    const ChainStates& states_;
    diagnostics::Diagnostics& diagnostics_;
    std::vector<ChainAsked> result_;
};

}  // namespace

std::vector<ChainAsked> find_chain_questions(const Scenario& scenario, const ChainStates& states,
                                             diagnostics::Diagnostics& diagnostics) {
    return Asking(scenario, states, diagnostics)();
}

bool ChainAnswer::is_refuted() const {
    return of_no_chain || std::ranges::any_of(checks, [](const ChainCheck& check) { return check.contradicts; });
}

ClaimVerdict ChainAnswer::claim_verdict() const {
    if (asked.claim == nullptr || asked.claim->estimate) return ClaimVerdict::estimated;
    const double probability = asked.claim->probability;
    if (asked.claim->at_least) {
        if (low >= probability) return ClaimVerdict::holds;
        return high < probability ? ClaimVerdict::fails : ClaimVerdict::open;
    }
    if (high <= probability) return ClaimVerdict::holds;
    return low > probability ? ClaimVerdict::fails : ClaimVerdict::open;
}

std::vector<statistics::StateSequence> sequences_of(const Scenario& scenario, const ChainStates& states,
                                                    const statistics::Permitted& permitted,
                                                    const std::vector<TrialResult>& trials,
                                                    std::vector<Excluded>& excluded) {
    std::vector<statistics::StateSequence> result;
    for (std::size_t trial = 0; trial < trials.size(); ++trial) {
        statistics::StateSequence& sequence = result.emplace_back();
        sequence.push_back(ChainStates::start);
        for (std::size_t at = 0; at < trials[trial].samples.size(); ++at) {
            const std::size_t next = states.find_state(trials[trial].samples[at]);
            if (next != ChainStates::none && permitted[sequence.back()][next]) {
                sequence.push_back(next);
                continue;
            }
            excluded.push_back(
                {static_cast<std::uint32_t>(trial), static_cast<double>(at) * scenario.abstraction->every,
                 states.state_text(sequence.back()),
                 next == ChainStates::none ? "a state that no robots are in together" : states.state_text(next)});
            break;
        }
    }
    return result;
}

std::optional<OrderFinding> order_finding(const std::vector<ChainAsked>& questions,
                                          const statistics::Permitted& permitted,
                                          const std::vector<statistics::StateSequence>& sequences,
                                          diagnostics::Budget* budget) {
    if (questions.empty()) return std::nullopt;
    double confidence = 0;
    for (const ChainAsked& question : questions) confidence = std::max(confidence, question.confidence);
    const auto found =
        statistics::order_contradiction(sequences, permitted, 1 - confidence, diagnostics::or_unlimited(budget));
    if (!found) return std::nullopt;
    return OrderFinding{confidence, *found};
}

namespace {

class Answering {
public:
    Answering(const Scenario& scenario, const ChainAsked& question, const statistics::Permitted& permitted,
              const std::vector<statistics::StateSequence>& sequences, const std::vector<TrialResult>& trials,
              diagnostics::Budget* budget)
        : scenario_(scenario),
          sequences_(sequences),
          trials_(trials),
          first_fresh_(sequences.size() / 2),
          error_((1 - question.confidence) / 2),
          budget_(budget) {
        answer_.asked = question;
        statistics::TransitionCounts counts(permitted.size());
        for (std::size_t i = 0; i < first_fresh_; ++i) counts.add(sequences[i]);
        const auto intervals = statistics::transition_intervals(counts, permitted, error_);
        for (const auto& row : intervals) {
            markov::UncertainRow& added = chain_.emplace_back();
            for (markov::State to = 0; to < row.size(); ++to)
                if (row[to].high > 0) added.push_back({to, row[to].low, row[to].high});
        }
    }

    ChainAnswer operator()() {
        if (answer_.asked.kind == ChainAsked::Kind::average)
            bound_average();
        else
            bound_reach();
        answer_.low = std::max(0.0, answer_.low);  // rounding may have produced -0
        return std::move(answer_);
    }

private:
    [[nodiscard]] std::size_t fresh_count() const { return sequences_.size() - first_fresh_; }
    [[nodiscard]] double error_of_check() const { return error_ / static_cast<double>(last_step(scenario_) + 1); }

    /// Bounds the probability to reach the goal. The first state of the swarm is one step after the start state, so
    /// steps are counted from there.
    void bound_reach() {
        const std::uint64_t steps = last_step(scenario_) + 1;
        const auto& goal = answer_.asked.goal;
        const auto least = markov::reach_bounds(chain_, goal, steps, Direction::minimum, budget_);
        const auto most = markov::reach_bounds(chain_, goal, steps, Direction::maximum, budget_);
        for (std::uint64_t step = 1; step <= steps; ++step)
            check_share(step, {std::max(0.0, least[step][ChainStates::start]), most[step][ChainStates::start]});
        if (answer_.asked.kind == ChainAsked::Kind::within) {
            answer_.low = least[answer_.asked.steps + 1][ChainStates::start];
            answer_.high = most[answer_.asked.steps + 1][ChainStates::start];
            return;
        }
        std::vector<double> cost(chain_.size(), scenario_.abstraction->every);
        cost[ChainStates::start] = 0;
        const std::uint64_t rounds = most_rounds();
        answer_.low = markov::cost_bounds(chain_, goal, cost, Direction::minimum, rounds, budget_)[ChainStates::start];
        answer_.high = markov::cost_bounds(chain_, goal, cost, Direction::maximum, rounds, budget_)[ChainStates::start];
    }

    /// Returns the number of rounds. Chains with more transitions get fewer rounds; a bound is correct even if it has
    /// not converged.
    [[nodiscard]] std::uint64_t most_rounds() const {
        std::uint64_t transitions = 0;
        for (const markov::UncertainRow& row : chain_) transitions += row.size();
        return std::clamp<std::uint64_t>(500'000'000 / transitions, 1'000, 100'000);
    }

    void bound_average() {
        const std::uint64_t steps = last_step(scenario_) + 1;
        const ChainAsked& question = answer_.asked;
        const auto least = markov::value_bounds(chain_, question.low, steps, Direction::minimum, budget_);
        const auto most = markov::value_bounds(chain_, question.high, steps, Direction::maximum, budget_);
        for (std::uint64_t step = 1; step <= steps; ++step)
            check_mean(step, {least[step][ChainStates::start], most[step][ChainStates::start]});
        const std::uint64_t rounds = most_rounds() / 10;
        answer_.low =
            markov::average_bound(chain_, ChainStates::start, question.low, Direction::minimum, rounds, budget_);
        answer_.high =
            markov::average_bound(chain_, ChainStates::start, question.high, Direction::maximum, rounds, budget_);
    }

    [[nodiscard]] double time_of(std::uint64_t step) const {
        return static_cast<double>(step - 1) * scenario_.abstraction->every;
    }

    /// Compares the fraction of fresh trials that have reached the goal with the prediction.
    void check_share(std::uint64_t step, const Interval& predicted) {
        std::uint64_t there = 0;
        for (std::size_t i = first_fresh_; i < sequences_.size(); ++i) {
            const auto begin = sequences_[i].begin();
            const auto end = begin + static_cast<std::ptrdiff_t>(std::min<std::size_t>(step + 1, sequences_[i].size()));
            if (std::any_of(begin, end, [&](std::size_t state) { return answer_.asked.goal[state]; })) ++there;
        }
        const double error = error_of_check();
        const Interval by_trials = statistics::clopper_pearson(there, fresh_count(), error);
        answer_.checks.push_back({time_of(step), predicted,
                                  static_cast<double>(there) / static_cast<double>(fresh_count()), by_trials,
                                  statistics::contradicts_prediction(there, fresh_count(), error, predicted)});
    }

    /// Compares the mean of a fraction over the fresh trials with the prediction, by Hoeffding's inequality.
    void check_mean(std::uint64_t step, const Interval& predicted) {
        double sum = 0;
        for (std::size_t i = first_fresh_; i < trials_.size(); ++i)
            sum += trials_[i].samples.at(step - 1).at(answer_.asked.distinction);
        const double mean = sum / static_cast<double>(fresh_count());
        const double away = statistics::hoeffding_epsilon(static_cast<double>(fresh_count()), error_of_check());
        const Interval by_trials{std::max(0.0, mean - away), std::min(1.0, mean + away)};
        answer_.checks.push_back({time_of(step), predicted, mean, by_trials,
                                  by_trials.low > predicted.high || predicted.low > by_trials.high});
    }

    const Scenario& scenario_;
    const std::vector<statistics::StateSequence>& sequences_;
    const std::vector<TrialResult>& trials_;
    const std::size_t first_fresh_;
    const double error_;  ///< error of the intervals together, and also of all checks together
    diagnostics::Budget* budget_;
    markov::UncertainChain chain_;
    ChainAnswer answer_;
};

}  // namespace

ChainAnswer chain_answer(const Scenario& scenario, const ChainAsked& question, const statistics::Permitted& permitted,
                         const std::vector<statistics::StateSequence>& sequences,
                         const std::vector<TrialResult>& trials, diagnostics::Budget* budget) {
    return Answering(scenario, question, permitted, sequences, trials, budget)();
}

}  // namespace robochart::simulation
