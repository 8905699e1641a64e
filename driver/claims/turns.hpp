// SPDX-License-Identifier: Apache-2.0
// Determines the order in which claims are decided. Every claim gets a short turn before any claim gets a long one. So
// a claim that is never decided does not delay other claims.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// A claim that is not decided yet.
struct WaitingClaim {
    std::string title;
    /// Decides the claim within limits that end with its turn. Returns true if the claim has an answer.
    std::function<bool(const Turn&)> decide;
    int rank = 0;  ///< claims with a lower rank are decided first
};

/// Decides all claims, in the order of their ranks. A claim without an answer after its turn gets another, longer turn,
/// until --assertion-timeout. Searches that use files or several programs get only one turn, because they continue from
/// their stored states. If a claim reaches the memory limit, `give_back` frees the data that the claims share, and the
/// function decides the next claim. Throws LimitReached with the current claim if the run must end, or if `give_back`
/// does not free enough memory.
void decide_in_turns(const std::vector<WaitingClaim>& claims, const SearchContext& search,
                     const std::function<void()>& give_back = {});

/// Returns true if the run must end, because of its time limit or an interrupt. The memory limit is not considered,
/// because a single claim may have reached it.
[[nodiscard]] bool run_is_over(const diagnostics::Budget&);

/// Returns the reason for a claim that --assertion-timeout left undecided, in place of the reason `reason`.
[[nodiscard]] std::string ended_turn(const std::string& reason, const SearchContext&);

}  // namespace robochart::driver
