// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/turns.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <thread>
#include <utility>

#include "driver/settings/search_context.hpp"

namespace robochart::driver {
namespace {

using Clock = std::chrono::steady_clock;

/// Returns the length of the first turn in seconds. It is a fraction of the run's time limit, so that the last claim
/// gets a turn, too.
double first_turn(const SearchContext& search) {
    constexpr double usual = 10, parts = 10;
    return search.settings.limits.timeout_seconds > 0 ? std::min(usual, search.settings.limits.timeout_seconds / parts)
                                                      : usual;
}

/// Each turn of a claim is longer than its previous turn by this factor. A claim that starts again loses the work of
/// its previous turn, so a large factor keeps the loss small.
constexpr double longer = 8;

/// Returns a turn that ends after `seconds`. If `seconds` is 0, the turn ends with the run.
Turn turn_of(double seconds) {
    constexpr double for_ever = 1e9;
    if (seconds <= 0 || seconds >= for_ever) return {};
    return {Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)), {}};
}

/// Frees shared memory and waits until the budget has registered this. The budget measures memory a hundred times per
/// second.
void free_memory(const std::function<void()>& give_back) {
    constexpr std::chrono::milliseconds two_looks{20};
    if (give_back) give_back();
    malloc_trim(0);
    std::this_thread::sleep_for(two_looks);
}

}  // namespace

bool run_is_over(const diagnostics::Budget& budget) {
    const auto& deadline = budget.limits().deadline;
    return budget.is_interrupted() || (deadline && Clock::now() >= *deadline);
}

void decide_in_turns(const std::vector<WaitingClaim>& claims, const SearchContext& search,
                     const std::function<void()>& give_back) {
    const double most = search.settings.limits.assertion_seconds;
    std::vector<const WaitingClaim*> waiting;
    waiting.reserve(claims.size());
    for (const WaitingClaim& claim : claims) waiting.push_back(&claim);
    std::ranges::stable_sort(waiting, {}, &WaitingClaim::rank);
    for (double seconds = first_turn(search); !waiting.empty(); seconds *= longer) {
        std::vector<const WaitingClaim*> open;
        for (const WaitingClaim* const claim : waiting) {
            const bool alone = open.empty() && claim == waiting.back();
            const bool last = alone || (most > 0 && seconds >= most) || search.services.continues_searches();
            const Turn turn = turn_of(last ? most : seconds);
            const diagnostics::Budget::Phase phase(search.services.budget(), "deciding " + claim->title);
            const bool decided = claim->decide(turn);
            diagnostics::Budget& budget = search.services.budget();
            if (!budget.reached_limit().empty() && !run_is_over(budget)) free_memory(give_back);
            budget.check();
            if (!decided && !last && turn.is_over()) open.push_back(claim);
        }
        waiting = std::move(open);
    }
}

std::string ended_turn(const std::string& reason, const SearchContext& search) {
    constexpr std::string_view limit = "the time limit was reached";
    const double seconds = search.settings.limits.assertion_seconds;
    if (!search.turn.is_over() || seconds <= 0 || !reason.starts_with(limit)) return reason;
    return fmt::format("its time limit was reached (--assertion-timeout {}){}", seconds, reason.substr(limit.size()));
}

}  // namespace robochart::driver
