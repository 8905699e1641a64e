// SPDX-License-Identifier: Apache-2.0
// Writes the results of a chain as text, tables, JSON and plots.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostics/json.hpp"
#include "simulation/chain/chain.hpp"

namespace robochart::simulation {

/// The results of a chain's estimation, answers and checks.
struct ChainResult {
    std::vector<ChainAnswer> answers;  ///< one per question, in order; fewer if the run was interrupted
    std::size_t questions = 0;
    std::string proof;                  ///< the proof that excludes transitions, or the reason why there is none
    std::size_t transitions = 0;        ///< number of permitted transitions between states of the chain
    std::size_t excluded = 0;           ///< number of transitions that are excluded
    std::size_t seen = 0;               ///< number of transitions that occurred in the trials for estimation
    std::uint32_t trials = 0;           ///< the number of trials for estimation; as many are used for checks
    bool order_asked = false;           ///< true if the order was tested on all trials
    std::optional<OrderFinding> order;  ///< the refutation of the order, and so of the chain
    bool interrupted = false;
    double cpu_seconds = 0;

    [[nodiscard]] bool is_refuted() const;
    /// True if the order or an answer is refuted, or a claim fails.
    [[nodiscard]] bool has_failed() const;
    /// True if all questions are answered and none is open.
    [[nodiscard]] bool is_complete() const;
};

/// Returns the answer as a word: "holds", "FAILS", "open", "estimated" or "REFUTED".
[[nodiscard]] std::string answer_word(const ChainAnswer&);
/// Returns the result of the test of the chain's order, on one line.
[[nodiscard]] std::string order_text(const ChainStates&, const ChainResult&);
/// Returns, for each question, the answer, its bounds, and the check by fresh trials.
[[nodiscard]] std::string answers_text(const ChainResult&);
/// Describes how the chain was estimated.
[[nodiscard]] std::string study_text(const Scenario&, const ChainStates&, const ChainResult&);
/// Summarises the results on one line.
[[nodiscard]] std::string chain_summary(const ChainResult&);
/// Returns a table with a row for each permitted transition whose source state occurred. The row contains the counts,
/// and the interval at the confidence of the first question.
[[nodiscard]] std::string transitions_csv(const ChainStates&, const statistics::Permitted&,
                                          const statistics::TransitionCounts&, double error);
/// Returns a table with a row for each check of each answer.
[[nodiscard]] std::string checks_csv(const ChainResult&);
/// Draws the predictions over time, and the fresh trials with their intervals.
[[nodiscard]] std::string answer_svg(const ChainAnswer&);
/// Writes the results in the schema "robochart-verify/chain/1" (docs/cli.md).
[[nodiscard]] std::string chain_json(const Scenario&, const ChainStates&, const ChainResult&,
                                     const std::vector<std::string>& files, int exit);

}  // namespace robochart::simulation
