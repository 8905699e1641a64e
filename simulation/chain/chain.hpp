// A Markov chain of a swarm, estimated from trials, what it answers, and whether fresh trials contradict it. An answer
// bounds every chain within intervals that hold jointly; it says something of the swarm only as far as the swarm is
// such a chain, which the fresh trials are there to refute.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "diagnostics/budget.hpp"
#include "diagnostics/diagnostic.hpp"
#include "simulation/chain/states.hpp"
#include "simulation/report/claims.hpp"
#include "simulation/trial/trial.hpp"
#include "statistics/chains.hpp"

namespace robochart::simulation {

/// What a chain is asked, in terms of its states.
struct ChainAsked {
    enum class Kind { within, time, average };
    Kind kind = Kind::within;
    const Claim* claim = nullptr;  ///< of `within`
    std::string text;              ///< as written
    double confidence = 0;
    std::vector<bool> goal;         ///< of each state; average: none
    std::uint64_t steps = 0;        ///< within: steps of the chain
    std::vector<double> low, high;  ///< average: of each state, of the measure
    std::size_t distinction = 0;    ///< average: which
};

/// What the scenario asks. Reports what its chain cannot answer (RC-M17).
[[nodiscard]] std::vector<ChainAsked> chain_asked(const Scenario&, const ChainStates&, diagnostics::Diagnostics&);

/// The prediction for one time beside fresh trials.
struct ChainCheck {
    double time = 0;
    statistics::Interval predicted;
    double seen = 0;                 ///< the share of fresh trials, or their mean
    statistics::Interval by_trials;  ///< where the true one is, by these trials alone
    bool contradicts = false;        ///< the intervals have nothing in common
};

struct ChainAnswer {
    ChainAsked asked;
    double low = 0;
    double high = 0;                 ///< may be infinite: none was found
    std::vector<ChainCheck> checks;  ///< at the times of the chain's states
    bool of_no_chain = false;        ///< the order of the chain is refuted, whatever is asked

    /// Trials contradict the chain: its bounds say nothing of the swarm.
    [[nodiscard]] bool refuted() const;
    /// Of what is claimed, `estimated` where nothing is. Not asked of what is refuted.
    [[nodiscard]] ClaimVerdict verdict() const;
};

/// What follows a state depends on the state before it: the swarm is no chain over these states.
struct OrderFinding {
    double confidence = 0;
    statistics::OrderContradiction found;
};

/// Looks for that in all sequences, at the greatest confidence of the questions, by intervals that hold jointly; none:
/// they do not tell (statistics::order_contradiction). Throws diagnostics::LimitReached.
[[nodiscard]] std::optional<OrderFinding> order_finding(const std::vector<ChainAsked>&, const statistics::Permitted&,
                                                        const std::vector<statistics::StateSequence>&,
                                                        diagnostics::Budget* = nullptr);

/// A transition that trials took although the robots' steps exclude it.
struct Excluded {
    std::uint32_t trial = 0;  ///< from 0 on
    double time = 0;          ///< s, of the state behind it
    std::string from, to;
};

/// The states of finished trials, behind the start. Of a trial with a sample of no state, or a transition that is not
/// permitted, the first is reported in `excluded`.
[[nodiscard]] std::vector<statistics::StateSequence> sequences_of(const Scenario&, const ChainStates&,
                                                                  const statistics::Permitted&,
                                                                  const std::vector<TrialResult>&,
                                                                  std::vector<Excluded>& excluded);

/// An answer by a chain that the first half of the sequences gives intervals for, checked on the other half. Half of
/// the question's error is that of the intervals, half that of the checks. Samples are those of the trials.
[[nodiscard]] ChainAnswer chain_answer(const Scenario&, const ChainAsked&, const statistics::Permitted&,
                                       const std::vector<statistics::StateSequence>&, const std::vector<TrialResult>&,
                                       diagnostics::Budget*);

}  // namespace robochart::simulation
