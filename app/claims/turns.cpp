// SPDX-License-Identifier: Apache-2.0
#include "app/claims/turns.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <thread>
#include <utility>

#include "app/command/run.hpp"

namespace robochart::app {
namespace {

using Clock = std::chrono::steady_clock;

/// The length of the first turn in seconds: a fraction of the run's time limit, so that the last claim gets a turn,
/// too.
double first_turn(const Options& options) {
    constexpr double usual = 10, parts = 10;
    return options.timeout_seconds > 0 ? std::min(usual, options.timeout_seconds / parts) : usual;
}

/// A claim that starts again loses the work of its last turn. Each turn is so much longer that the loss is small.
constexpr double longer = 8;

bool keeps_searches(const Options& options) {
    return options.by_levels != nullptr || !options.checkpoint.empty() || !options.resume.empty() ||
           !options.disk.empty();
}

bool is_over(const Options& options) {
    return options.turn_ends && Clock::now() >= *options.turn_ends;
}

/// Options with which the turn of a claim ends after `seconds`; 0: the turn ends with the run.
Options with_turn(const Options& options, double seconds) {
    Options result = options;
    constexpr double for_ever = 1e9;
    if (seconds > 0 && seconds < for_ever)
        result.turn_ends =
            Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    return result;
}

/// The budget looks at memory a hundred times a second: what is free counts as free after this.
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

void decide_in_turns(const std::vector<WaitingClaim>& claims, const Options& options,
                     const std::function<void()>& give_back) {
    const double most = options.assertion_seconds;
    std::vector<const WaitingClaim*> waiting;
    for (const WaitingClaim& claim : claims) waiting.push_back(&claim);
    for (double seconds = first_turn(options); !waiting.empty(); seconds *= longer) {
        std::vector<const WaitingClaim*> open;
        for (const WaitingClaim* const claim : waiting) {
            const bool alone = open.empty() && claim == waiting.back();
            const bool last = alone || (most > 0 && seconds >= most) || keeps_searches(options);
            const Options turn = with_turn(options, last ? most : seconds);
            const diagnostics::Budget::Phase phase(options.run->budget(), "deciding " + claim->title);
            const bool decided = claim->decide(turn);
            diagnostics::Budget& budget = options.run->budget();
            if (!budget.reached_limit().empty() && !run_is_over(budget)) free_memory(give_back);
            budget.check();
            if (!decided && !last && is_over(turn)) open.push_back(claim);
        }
        waiting = std::move(open);
    }
}

std::string ended_turn(const std::string& reason, const Options& turn) {
    constexpr std::string_view limit = "the time limit was reached";
    if (!is_over(turn) || turn.assertion_seconds <= 0 || !reason.starts_with(limit)) return reason;
    return fmt::format("its time limit was reached (--assertion-timeout {}){}", turn.assertion_seconds,
                       reason.substr(limit.size()));
}

}  // namespace robochart::app
