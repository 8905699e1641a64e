// What a chain says, as text, tables, JSON and plots.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "diagnostics/json.hpp"
#include "simulation/chain/chain.hpp"

namespace robochart::simulation {

/// A whole study.
struct ChainResult {
    std::vector<ChainAnswer> answers;  ///< of each question, in order; fewer where the run was interrupted
    std::size_t questions = 0;
    std::string proof;                  ///< what excludes transitions, or why nothing does
    std::size_t transitions = 0;        ///< between states of the chain
    std::size_t excluded = 0;           ///< of them
    std::size_t seen = 0;               ///< of them, in the trials that estimate
    std::uint32_t trials = 0;           ///< that estimate; as many check
    bool order_asked = false;           ///< were all trials asked about the order?
    std::optional<OrderFinding> order;  ///< what refutes the chain whatever it is asked
    bool interrupted = false;
    double cpu_seconds = 0;

    [[nodiscard]] bool refuted() const;
    /// The order or an answer is refuted, or what it claims fails.
    [[nodiscard]] bool fails() const;
    /// All questions answered, none open.
    [[nodiscard]] bool complete() const;
};

/// "holds", "FAILS", "open", "estimated", "REFUTED".
[[nodiscard]] std::string answer_word(const ChainAnswer&);
/// What is known of the order of the chain, in a line.
[[nodiscard]] std::string order_text(const ChainStates&, const ChainResult&);
/// Of each question: the answer, its bounds, what fresh trials say.
[[nodiscard]] std::string answers_text(const ChainResult&);
/// How it was estimated, in lines.
[[nodiscard]] std::string study_text(const Scenario&, const ChainStates&, const ChainResult&);
/// One line.
[[nodiscard]] std::string chain_summary(const ChainResult&);
/// A row for each transition that is not excluded and was seen or leaves a state that was: counts, and the interval at
/// the confidence of the first question.
[[nodiscard]] std::string transitions_csv(const ChainStates&, const statistics::Permitted&,
                                          const statistics::TransitionCounts&, double error);
/// A row for each check of each answer.
[[nodiscard]] std::string checks_csv(const ChainResult&);
/// What the chain says over time, and the fresh trials with their intervals.
[[nodiscard]] std::string answer_svg(const ChainAnswer&);
/// Schema "robochart-verify/chain/1" (docs/cli.md).
[[nodiscard]] std::string chain_json(const Scenario&, const ChainStates&, const ChainResult&,
                                     const std::vector<std::string>& files, int exit);

}  // namespace robochart::simulation
