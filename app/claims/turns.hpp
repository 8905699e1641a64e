// The order in which claims are decided: each gets a turn before any gets a long one, so that one that is never decided
// does not keep the others from their answers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/command/options.hpp"

namespace robochart::app {

/// A claim that waits for its answer.
struct WaitingClaim {
    std::string title;
    /// Decides it within limits that end with its turn (Options::turn_ends). Returns whether it has its answer.
    std::function<bool(const Options& turn)> decide;
};

/// Decides all, those that are not answered in their turn again in longer ones, until --assertion-timeout. Searches
/// that are kept in files or by several programs have one turn: they go on from what they know. Throws LimitReached
/// where a limit of the run is reached, with the claim whose turn it was.
void decide_in_turns(const std::vector<WaitingClaim>& claims, const Options& options);

/// What is said of a claim that --assertion-timeout left undecided, in place of the reason that it gives.
[[nodiscard]] std::string ended_turn(const std::string& reason, const Options& turn);

}  // namespace robochart::app
