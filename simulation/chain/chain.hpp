// SPDX-License-Identifier: Apache-2.0
// Estimates a Markov chain of a swarm from trials and answers questions about it. An answer is a bound for every chain
// within the intervals, which hold jointly. The answer applies to the swarm only if the swarm is such a chain. Fresh
// trials may refute this assumption.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "base/diagnostics/diagnostic.hpp"
#include "base/statistics/chains.hpp"
#include "simulation/chain/states.hpp"
#include "simulation/report/claims.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// A question to a chain, as sets and values of the chain's states.
struct ChainAsked {
    enum class Kind { within, time, average };
    Kind kind = Kind::within;
    const Claim* claim = nullptr;  ///< the claim, if the question comes from a claim
    std::string text;              ///< as written
    double confidence = 0;
    std::vector<bool> goal;         ///< true for the states that satisfy the condition; empty for average
    std::uint64_t steps = 0;        ///< `within`: the bound in steps of the chain
    std::vector<double> low, high;  ///< average: the range of the measure in each state
    std::size_t distinction = 0;    ///< average: index of the distinction
};

/// Returns the questions of the scenario. Reports questions that its chain cannot answer (RC-M17).
[[nodiscard]] std::vector<ChainAsked> find_chain_questions(const Scenario&, const ChainStates&,
                                                           diagnostics::Diagnostics&);

/// The prediction for one time, and what fresh trials show at this time.
struct ChainCheck {
    double time = 0;
    statistics::Interval predicted;
    double seen = 0;                 ///< the fraction or the mean of the fresh trials
    statistics::Interval by_trials;  ///< interval of the true value, from the fresh trials alone
    bool contradicts = false;        ///< the intervals are disjoint
};

struct ChainAnswer {
    ChainAsked asked;
    double low = 0;
    double high = 0;                 ///< infinite if no bound was found
    std::vector<ChainCheck> checks;  ///< the checks at the times of the chain's states
    bool of_no_chain = false;        ///< the sequences refute the order of the chain, and so all answers

    /// True if trials contradict the chain, so that its bounds do not apply to the swarm.
    [[nodiscard]] bool is_refuted() const;
    /// Returns the verdict on the claim; `estimated` if there is no claim. Must not be called if the answer is refuted.
    [[nodiscard]] ClaimVerdict claim_verdict() const;
};

/// Evidence that the successor of a state depends on the state before it, so that the swarm is not a chain over these
/// states.
struct OrderFinding {
    double confidence = 0;
    statistics::OrderContradiction found;
};

/// Searches all sequences for a state whose successor depends on the state before it (statistics::order_contradiction).
/// The intervals of the search hold jointly at the greatest confidence of the questions. Returns no value if the
/// sequences show no such dependence. Throws diagnostics::LimitReached.
[[nodiscard]] std::optional<OrderFinding> order_finding(const std::vector<ChainAsked>&, const statistics::Permitted&,
                                                        const std::vector<statistics::StateSequence>&,
                                                        diagnostics::Budget* = nullptr);

/// A transition that occurred in a trial, although the robots' steps exclude it.
struct Excluded {
    std::uint32_t trial = 0;  ///< the index of the trial, from 0
    double time = 0;          ///< the time of the state after the transition, in s
    std::string from, to;
};

/// Returns the sequences of states in finished trials, beginning with the start state. If a sample belongs to no state,
/// or a transition is not permitted, the first such event of the trial is added to `excluded`.
[[nodiscard]] std::vector<statistics::StateSequence> sequences_of(const Scenario&, const ChainStates&,
                                                                  const statistics::Permitted&,
                                                                  const std::vector<TrialResult>&,
                                                                  std::vector<Excluded>& excluded);

/// Answers a question by a chain whose intervals are estimated from the first half of the sequences. Checks the answer
/// on the other half. Half of the question's error is used for the intervals, half for the checks. The sequences must
/// be those of the trials.
[[nodiscard]] ChainAnswer chain_answer(const Scenario&, const ChainAsked&, const statistics::Permitted&,
                                       const std::vector<statistics::StateSequence>&, const std::vector<TrialResult>&,
                                       diagnostics::Budget*);

}  // namespace robochart::simulation
